// `npm run build`: the static site in dist/, which works from any folder of any static host.
import { start } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { buildSite } from './lib/site.mjs';
import { buildModules } from './lib/wasm.mjs';

await start(async () => {
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  await buildModules(env);
  await buildSite();
});
