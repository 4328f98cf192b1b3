// `npm start`: sets up what is missing, builds the module, serves the page.
import { say, start } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { buildWasm } from './lib/wasm.mjs';

await start(async () => {
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  await buildWasm('web', env);
  await serve();
});

async function serve() {
  say('Serving the page');
  const { createServer } = await import('vite');
  const server = await createServer({ clearScreen: false });
  await server.listen();
  const [address] = server.resolvedUrls?.local ?? [];
  console.log(`\nBubblestone is at ${address} (Ctrl+C ends it)`);
}
