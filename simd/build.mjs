// Compiles the kernels to WebAssembly, and puts them into src/solver/simd-code.ts: node simd/build.mjs
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import asc from 'assemblyscript/asc';

const root = fileURLToPath(new URL('..', import.meta.url));
const target = new URL('../src/solver/simd-code.ts', import.meta.url);

/** The text of src/solver/simd-code.ts. */
export async function compile() {
  const options = '--runtime stub --enable simd --importMemory --noAssert -O3 --converge --disableWarning AS112';
  let code;
  const { error, stderr } = await asc.main(
    ['simd/index.ts', '--baseDir', root, '--outFile', 'kernels.wasm', ...options.split(' ')],
    { writeFile: (_, contents) => (code = contents) },
  );
  if (error !== null) {
    throw new Error(stderr.toString(), { cause: error });
  }
  const text = Buffer.from(code).toString('hex');
  return `/** The kernels of \`simd\`, compiled by \`npm run simd\`: WebAssembly, in hexadecimal digits. */\nexport const CODE =\n  '${text}';\n`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  writeFileSync(target, await compile());
}
