// `npm run hash -- '<link>'`: the digest of a link's planes, from the WebAssembly module under Node.
import { moduleIn } from './lib/headless.mjs';
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
  const { digest_of_link: digestOfLink } = await moduleIn(await buildWasm('house', env));
  if (!digestOfLink) throw new Stop('The module exports no digest_of_link: see src/web.rs.');
  console.log(digestOfLink(link));
});
