/** The page's first state: from its address, and from the last work, whose history goes on. */
import type { Engine } from './engine';
import { wantsFine } from './fine';
import { fragment, isReload } from './link';
import { keptLocks } from './locks';
import type { LastWork } from './memory';
import type { State } from './store';
import { PACE, parted, WHOLE } from './viewing';
import { presetOf } from './work';

/**
 * The recipe and the view in the address. After a reload the address may be a step behind; then the last work counts.
 */
export function askedFor(last: LastWork | undefined): { recipe: string; words: string } {
  const asked = parted(fragment());
  const isBehind = last && isReload() && asked.recipe !== last.recipe && [...last.past, ...last.future].includes(asked.recipe);
  return isBehind ? { recipe: last.recipe, words: '' } : asked;
}

/** The preset *Mossy lane*, with which the page opens. The module's default recipe is another one: links rely on it. */
export const FIRST = 'v=1&outline=road_s&ow=1.25&cs=26&vs=0.15&hs=28&dr=0.4&palette=mossy&ground=moss&az=240&el=36&amb=1.1&diff=1.25';

/** The recipe to open. If the address has none, it is the visitor's own last work, or the first picture of a visit. */
export function openedFirst(asked: string, last: LastWork | undefined): string {
  if (asked !== '') return asked;
  return last?.own ? last.recipe : FIRST;
}

/** The first state. The engine already has the recipe. */
export function firstState(engine: Engine, asked: string, last: LastWork | undefined): State {
  const recipe = engine.link();
  const same = last?.recipe === recipe;
  return {
    recipe,
    make: engine.generator.word,
    coming: '',
    held: false,
    past: last ? (same ? last.past : [...last.past, last.recipe]) : [],
    future: last && same ? last.future : [],
    preset: presetOf(engine.presets, recipe),
    own: same && last.own && (asked === '' || asked === recipe),
    stored: same,
    pace: PACE.usual,
    paused: false,
    view: 'auto',
    overlays: [],
    zoom: WHOLE,
    repeat: 1,
    fine: wantsFine(),
    light: false,
    layers: false,
    compare: false,
    beside: false,
    other: 'done',
    plots: false,
    turn: false,
    camera: undefined,
    cut: undefined,
    body: undefined,
    asked: '',
    locks: keptLocks(),
    editing: undefined,
    stage: '',
  };
}
