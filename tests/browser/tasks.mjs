// Measures how long tasks block the page, in Chromium, which reports their cost.
import { kind } from './browsers.mjs';

/** The reason to skip tests that need `longestTask`; false in Chromium. */
export const skip = kind !== 'chromium' && 'only Chromium tells what tasks cost';

/**
 * The longest task on the page's own thread during an action, as a multiple of 50 milliseconds, or of the time of a fixed task
 * if that is longer: a slow machine needs longer for both. Only processor time counts, so other programs do not matter.
 * @param {import('puppeteer-core').Page} page
 * @param {() => Promise<unknown>} act
 */
export async function longestTask(page, act) {
  await page.tracing.start({ categories: ['toplevel', 'blink.user_timing'] });
  await page.evaluate(yardstick);
  await act();
  const trace = (await page.tracing.stop()) ?? new Uint8Array();
  /** @type {{ traceEvents: { name: string, ph: string, pid: number, tid: number, ts: number, dur: number, tdur?: number }[] }} */
  const { traceEvents } = JSON.parse(Buffer.from(trace).toString());
  const mark = traceEvents.find(({ name }) => name === 'yardstick');
  const tasks = traceEvents.filter(({ name, ph, pid, tid }) => name.endsWith('RunTask') && ph === 'X' && pid === mark?.pid && tid === mark.tid);
  const measure = tasks.find(({ ts, dur }) => mark && ts <= mark.ts && mark.ts <= ts + dur);
  if (!measure || tasks.length < 20) throw new Error(`Of ${tasks.length} tasks none can be measured.`);
  return Math.max(...tasks.filter((task) => task !== measure).map(({ tdur = 0 }) => tdur)) / Math.max(measure.tdur ?? 0, 50_000);
}

function yardstick() {
  return new Promise((resolve) => {
    setTimeout(() => {
      performance.mark('yardstick');
      let sum = 0;
      for (let k = 0; k < 17e6; k += 1) sum += Math.sqrt(k);
      resolve(sum);
    });
  });
}
