// `npm run package`: the npm package as a tarball, with the page's full module.
import { buildPackage } from './lib/package.mjs';
import { start } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { buildModules } from './lib/wasm.mjs';

await start(async () => {
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  await buildModules(env);
  console.log(`\n${buildPackage()}`);
});
