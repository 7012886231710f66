// Compiles the kernels to WebAssembly, and puts them into src/solver/simd-code.ts: node simd/build.mjs
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import asc from 'assemblyscript/asc';

const root = fileURLToPath(new URL('..', import.meta.url));
const target = new URL('../src/solver/simd-code.ts', import.meta.url);

/** The text of src/solver/simd-code.ts. */
export async function compile() {
  const options =
    '--runtime stub --enable simd --importMemory --noAssert -O3 --converge --runPasses reorder-locals --disableWarning AS112';
  let code;
  const { error, stderr } = await asc.main(
    ['simd/index.ts', '--baseDir', root, '--outFile', 'kernels.wasm', ...options.split(' ')],
    { writeFile: (_, contents) => (code = contents) },
  );
  if (error !== null) {
    throw new Error(stderr.toString(), { cause: error });
  }
  return `/** The kernels of \`simd\`, compiled by \`npm run simd\`: WebAssembly, as \`decode\` in \`simd.ts\` reads it. */\nexport const CODE =\n  '${encode(code)}';\n`;
}

/** Bytes as printable signs. 16 is added to each, so that fewest of them need two. */
function encode(bytes) {
  const signs = Array.from(bytes, (byte) => {
    const number = (byte + 16) % 256;
    const rest = number % 86;
    const sign = String.fromCharCode(40 + rest + (rest > 51 ? 1 : 0));
    return ['', '#', '$'][Math.floor(number / 86)] + sign;
  });
  return signs.join('');
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  writeFileSync(target, await compile());
}
