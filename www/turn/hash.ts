/** The hash of a frame, for scripts. */
import { answerOf } from '../late/worker';
import { cameraWords, homeOf } from '../state/asked-view';
import type { Camera } from '../state/viewing';
import type { HashRequest, HashResult } from './hash.worker';

/**
 * The hash of a frame of a recipe's bodies. `from` is a camera in the words of a link or as the store has it; without
 * it, the usual one. `home` is the generator's own camera.
 */
export async function hashOf(link: string, from: string | Camera | undefined, home: string): Promise<string> {
  const worker = new Worker(new URL('./hash.worker.ts', import.meta.url), { type: 'module' });
  const camera = typeof from === 'string' || from === undefined ? (from ?? '') : cameraWords(from, homeOf({ home }));
  const order: HashRequest = [link, camera];
  const answer = await answerOf<HashResult>(worker, order, { progress: () => undefined, signal: new AbortController().signal });
  if ('broken' in answer) throw new Error(answer.broken);
  return answer.hash;
}
