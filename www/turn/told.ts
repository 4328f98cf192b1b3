/** Sentences that describe the view of the turntable. */
import { isWord, t } from '../words/turn';
import type { Camera } from '../state/viewing';
import type { Engine } from '../state/engine';
import type { Sort } from '../picture/frames/sort';
import type { Bodies } from '../picture/frames/source';

/** A camera this high, in degrees, looks from above. */
const ABOVE = 80;

/** The frame is near if it shows fewer sides of the picture than `near`, and far if it shows more than `far`. */
const FAR = { near: 0.6, far: 2.4 };

const SIDES = ['side_0', 'side_1', 'side_2', 'side_3', 'side_4', 'side_5', 'side_6', 'side_7'] as const;

/** The words for these sides if the generator is seen by frames only. */
const AROUND = ['around_0', 'around_1', 'around_2', 'around_3', 'around_4', 'around_5', 'around_6', 'around_7'] as const;

/** The words for several bodies of a sort. Views that show other things have words of their own. */
const MANY = { stone: 'stones', scale: 'scales', body: 'bodies', block: 'blocks', feature: 'blocks', cell: 'stones', element: 'stones', dart: 'bodies' } as const satisfies Record<Sort, string>;

/** A sentence on the bodies, or on the other content of the view, and on the camera. */
export function seen({ count, sort, what: view }: Bodies, [angle, height, distance, lens]: Camera, isFramed = false): string {
  const drawn = `shown_${view}`;
  const what = t(isWord(drawn) ? drawn : MANY[sort], { n: count });
  const wide = 2 * distance * Math.tan((lens * Math.PI) / 360);
  const far = t(wide < FAR.near ? 'near' : wide > FAR.far ? 'far' : 'middle');
  if (height >= ABOVE) return t('seen_above', { what, far });
  const side = t((isFramed ? AROUND : SIDES)[Math.round(angle / 45) % 8] ?? 'side_0');
  return t(height < 0 ? 'seen_below' : 'seen', { what, side, height: Math.abs(Math.round(height)), far });
}

/** A note on a view that is seen by frames; '' if it needs none. */
export function noteOf(engine: Engine, view: string): string {
  const key = `note_${view}`;
  return [isWord(key) ? t(key) : '', engine.caption(view)].filter(Boolean).join(' ');
}

/** The name of a step in the making of a body; its own word if it has no name. */
export function stepName(step: string): string {
  const [, word = step, n = ''] = /^([a-z]+?)(\d*)$/.exec(step) ?? [];
  const key = `step_${word}`;
  return isWord(key) ? t(key, { n }) : step;
}

/** Whether these are the states of a face's map. */
export function areOfMap(steps: readonly string[]): boolean {
  return steps.includes('before');
}

/** Whether these are the steps in the making of a block. */
export function areOfBlock(steps: readonly string[]): boolean {
  return steps.includes('claim');
}

/**
 * A sentence that is whole without the source at its end, or ''. It is on a state of a face's map, on a step in the
 * making of a block, or on a step that no paper describes in the making of a body that ends up on a surface.
 */
export function ownNote(step: string, steps: readonly string[]): string {
  const key = `own_${step}`;
  const hasOwn = steps.includes('bent') || areOfMap(steps) || areOfBlock(steps);
  return hasOwn && isWord(key) ? t(key) : '';
}

/** A sentence on a step that a paper describes, with the recipe's numbers; '' if there is none. */
export function stepNote(step: string, get: (key: string) => string): string {
  const form = get('stone');
  const word = step.replace(/\d+$/, '');
  const key = [`${form}_${word}`, `${form === 'skin' ? 'skin' : 'stone'}_${word}`].find(isWord);
  const values = ['sv', 'hs', 'sr', 'sc', 'tc', 'dr', 'bh', 'bv', 'af', 'fd'].map((name) => [name, get(name)]);
  return key === undefined ? '' : t(key, Object.fromEntries(values) as Record<string, string>);
}
