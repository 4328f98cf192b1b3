// `npm run setup`: installs everything that the other commands need, and nothing else.
import { start } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';

await start(() => {
  setup.checkGivens();
  setup.npmPackages();
  setup.rustLinters();
  setup.wasmClippy(setup.wasmRust());
  setup.wasmTools();
  setup.cargoDeny();
  setup.browser('chromium');
  setup.browser('firefox');
  console.log('\nAll is set up.');
});
