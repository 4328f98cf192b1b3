// The npm package: the full module, unpacked, with the code that loads it and makes pictures, and an element for other pages.
import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { digest } from './digest.mjs';
import { root, run, say } from './run.mjs';
import { targetDir } from './rust.mjs';
import { wholeModule } from './wasm.mjs';

/** The folder of its files. */
export const packageFolder = join(targetDir, 'package');

/** Files that wasm-pack makes, and files of the project. */
const MADE = ['bubblestone.js', 'bubblestone.d.ts', 'bubblestone_bg.wasm', 'bubblestone_bg.wasm.d.ts'];
const SOURCES = ['package/index.ts', 'package/element.ts', 'package/tsconfig.json', 'package.json', 'scripts/lib/package.mjs'];
const GIVEN = ['LICENSE-MIT', 'LICENSE-APACHE', 'package/README.md'];

/** Puts the package together from the built module. Returns the path of its tarball. */
export function buildPackage() {
  const about = manifest();
  const tarball = join(targetDir, `${about.name}-${about.version}.tgz`);
  const stamp = join(targetDir, '.package-made-from');
  const source = digest([...MADE.map((file) => join(wholeModule, file)), ...[...GIVEN, ...SOURCES].map((file) => join(root, file))]);
  if (existsSync(tarball) && existsSync(stamp) && readFileSync(stamp, 'utf8') === source) return tarball;
  say('Putting the npm package together');
  rmSync(packageFolder, { recursive: true, force: true });
  mkdirSync(packageFolder, { recursive: true });
  run(process.execPath, [join(root, 'node_modules', 'typescript', 'bin', 'tsc'), '-p', join(root, 'package'), '--outDir', packageFolder]);
  for (const file of MADE) copyFileSync(join(wholeModule, file), join(packageFolder, file));
  // Projects with older JavaScript libraries do not know the symbol that ends a `using`.
  const types = join(packageFolder, 'bubblestone.d.ts');
  writeFileSync(types, `/// <reference lib="esnext.disposable" />\n${readFileSync(types, 'utf8')}`);
  for (const file of GIVEN) copyFileSync(join(root, file), join(packageFolder, file.replace(/^.*\//, '')));
  writeFileSync(join(packageFolder, 'package.json'), `${JSON.stringify(about, undefined, 2)}\n`);
  run('npm', ['pack', '--silent', '--pack-destination', targetDir], { cwd: packageFolder });
  writeFileSync(stamp, source);
  return tarball;
}

function manifest() {
  const { name, version, description, license } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const entry = (/** @type {string} */ file) => ({ types: `./${file}.d.ts`, default: `./${file}.js` });
  return {
    name,
    version,
    description,
    license,
    type: 'module',
    types: './index.d.ts',
    exports: { '.': entry('index'), './element': entry('element'), './bubblestone_bg.wasm': './bubblestone_bg.wasm', './package.json': './package.json' },
    // Bundlers must keep a script that only defines an element.
    sideEffects: ['./element.js'],
  };
}
