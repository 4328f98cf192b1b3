// `npm run hash -- '<link>'`: the digest of a link's planes, from the WebAssembly module under Node.
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { keepOutputForAnswer, start, Stop } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { buildWasm } from './lib/wasm.mjs';

await start(async () => {
  keepOutputForAnswer();
  const [link] = process.argv.slice(2);
  if (link === undefined) throw new Stop("Give a link or its fragment: npm run hash -- '<link>'.");
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  const folder = await buildWasm('nodejs', env);
  const { digest_of_link: digestOfLink } = createRequire(import.meta.url)(join(folder, 'bubblestone.js'));
  if (!digestOfLink) throw new Stop('The module exports no digest_of_link: see src/web.rs.');
  console.log(digestOfLink(link));
});
