// Shows an example that is a page: node examples/serve.mjs rollback, or worker. Needs a build of the package.
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const root = fileURLToPath(new URL('..', import.meta.url));
const TYPES = { '.html': 'text/html', '.js': 'text/javascript' };

/** A file of an example: pages as they are, scripts built from their sources, with what they import. */
export async function readExample(name, file) {
  const folder = join(root, 'examples', name);
  if (extname(file) === '.html') {
    return readFileSync(join(folder, file), 'utf8');
  }
  const { outputFiles } = await build({
    entryPoints: [join(folder, file)],
    bundle: true,
    format: 'esm',
    write: false,
    alias: {
      phys2d: join(root, 'dist/phys2d.js'),
      'phys2d/debug': join(root, 'dist/debug.js'),
      'phys2d/runner': join(root, 'dist/runner.js'),
      'phys2d/state': join(root, 'dist/state.js'),
    },
  });
  return outputFiles[0].text;
}

/** What lets pages share memory with workers. */
export const HEADERS = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [, , name = 'rollback', port = '8080'] = process.argv;
  if (!existsSync(join(root, 'examples', name, 'index.html'))) {
    console.error(`There is no page examples/${name}/index.html.`);
    process.exit(1);
  }
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const file = pathname === '/' ? 'index.html' : pathname.slice(1);
    try {
      if (!/^[\w-]+\.(?:html|js)$/.test(file)) {
        throw new Error(`there is no ${file}`);
      }
      const text = await readExample(name, file);
      response.writeHead(200, { ...HEADERS, 'Content-Type': TYPES[extname(file)] }).end(text);
    } catch (error) {
      response.writeHead(404).end(String(error));
    }
  });
  server.on('error', ({ message }) => {
    console.error(`${message}: node examples/serve.mjs ${name} 8081 takes another port.`);
    process.exit(1);
  });
  server.listen(Number(port), '127.0.0.1', () => {
    console.log(`examples/${name}: http://127.0.0.1:${port}/`);
  });
}
