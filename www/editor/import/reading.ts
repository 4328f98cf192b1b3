/** Reads outlines from files and texts in a worker. Stopping it frees all its memory. */
import { t, type EditorWord } from '../../words/editor';
import { language } from '../../words/words';
import { notice } from '../../base/messages';
import { stoppable, type Task } from '../../late/task';
import { answerOf } from '../../late/worker';
import { LEFT, type Count, type RefusalReason } from '../svg/refusal';
import type { Try } from './read';
import type { ReadRequest, ReadResult } from './read.worker';

/** The reading that goes on now. */
let now: AbortController | undefined;

/**
 * The outlines in a text, of which the caller uses the first that the engine accepts. Returns undefined if the
 * visitor stopped it. Throws an Error with a sentence if the text cannot be read.
 */
export async function read(text: string, name: string, side: number): Promise<Try[] | undefined> {
  now?.abort();
  const stopping = (now = new AbortController());
  try {
    return await stoppable({ topic: 'outline', sentence: t('import_reading', { name }), name, stop: t('import_stop') }, stopping, (task) => triesOf([text, side], name, task));
  } catch (error) {
    if (!stopping.signal.aborted) throw error;
    // Otherwise another file has replaced this one, and its own message is shown.
    if (stopping === now) notice('outline', t('kept', { sentence: t('import_stopped', { name }) }));
    return undefined;
  }
}

async function triesOf(order: ReadRequest, name: string, task: Task): Promise<Try[]> {
  const worker = new Worker(new URL('./read.worker.ts', import.meta.url), { type: 'module' });
  const answer = await answerOf<ReadResult>(worker, order, task);
  if ('tries' in answer) return answer.tries;
  if ('broken' in answer) throw new Error(t('import_trouble', { name, reason: answer.broken }));
  throw new Error([sentence(answer.refused, name), ...leftOut(answer.left, 'left_besides')].join(' '));
}

function sentence({ word, values }: RefusalReason, name: string): string {
  return t(word, { name, ...Object.fromEntries(Object.entries(values).map(([key, value]) => [key, number(value)])) });
}

/** The sentences about an outline that was taken. */
export function remarks({ rings, left, coarse }: Try): string[] {
  return [...leftOut(left, 'left_out'), ...(coarse ? [t('coarse', { n: number(rings.flat().length), before: number(coarse) })] : [])];
}

/** A sentence with the counts of features that were left out, if there are any. */
function leftOut(left: Count, word: EditorWord): string[] {
  const parts = LEFT.filter((what) => left[what]).map((what) => t(left[what] === 1 ? `left_${what}_one` : `left_${what}`, { n: number(left[what] ?? 0) }));
  return parts.length ? [t(word, { list: new Intl.ListFormat(language()).format(parts) })] : [];
}

function number(value: string | number): string {
  return typeof value === 'number' ? value.toLocaleString(language()) : value;
}
