// Builds the documentation site into docs/site: node docs/build.mjs, after `npm run build`.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { publicDeclarations } from './declarations.mjs';

const docs = dirname(fileURLToPath(import.meta.url));
const { projectDocuments } = JSON.parse(readFileSync(join(docs, 'typedoc.json'), 'utf8'));

execFileSync(process.execPath, [join(docs, 'node_modules/typedoc/bin/typedoc')], { cwd: docs, stdio: 'inherit' });
writeFileSync(join(docs, 'site/llms.txt'), llms());

/** The guide and all public declarations, as one text. */
function llms() {
  const page = (name) => readFileSync(join(docs, name), 'utf8').replace(/^---[\s\S]*?---\n/, '');
  return [
    page('index.md'),
    ...projectDocuments.map(page),
    `# API\n\n\`\`\`ts\n${publicDeclarations().trimEnd()}\n\`\`\`\n`,
  ].join('\n');
}
