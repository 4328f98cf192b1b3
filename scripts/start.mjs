// `npm start`: sets up what is missing, builds the module and the site, and serves the site. The tests open the same files.
import { start } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { keepBuilt, serveSite } from './lib/site.mjs';
import { buildModules } from './lib/wasm.mjs';

/** The first port to try. */
const PORT = 5173;

await start(async () => {
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  await buildModules(env);
  await keepBuilt();
  const { address } = await serveSite(PORT);
  console.log(`\nBubblestone is at ${address} (Ctrl+C ends it)`);
});
