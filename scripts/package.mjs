// `npm run package`: the npm package as a tarball, from the very module that the page gets.
import { buildPackage } from './lib/package.mjs';
import { start } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { buildWasm } from './lib/wasm.mjs';

await start(async () => {
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  await buildWasm('web', env);
  console.log(`\n${buildPackage()}`);
});
