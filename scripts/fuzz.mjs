// `npm run fuzz -- SECONDS [SEED]`: broken model files and links, natively, for some time; examples/fuzz.rs says how they
// are judged.
import { nativeEnv } from './lib/rust.mjs';
import { run, start, Stop } from './lib/run.mjs';

await start(() => {
  const [seconds, seed = '1'] = process.argv.slice(2);
  if (!/^\d+$/.test(seconds ?? '')) throw new Stop('Say for how many seconds: npm run fuzz -- 600.');
  run('cargo', ['run', '--release', '--example', 'fuzz', '--', seconds ?? '', seed], { env: nativeEnv() });
});
