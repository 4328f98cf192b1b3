/**
 * The figures of chapter 2, "Many bubbles" (Miyata, Itoh and Shimada, A Method for Generating Pavement Textures Using the
 * Square Packing Technique, 2001, sections 2.2 and 6; 2000, section 4.3; Itoh, Miyata and Shimada, Generating Organic Textures
 * with Controlled Anisotropy and Directionality, 2003, section 5.1). Circles of side 36 in a picture of side 256; no cell comes
 * or goes, and the time step is so short that the sum of all energies falls at every step.
 */
import { AT_REST, countOf, crowdAt, energyOf, nearestTo, ofFirst, OVER, packedOf, restOf } from './crowds';
import type { Ask, Bar, Crowd, Figure, Language, Line, NumberHandle, PackedCell, PointHandle, Seen, Stop, Trace, Trial, Words } from './figure';
import { DAMPING, inWords, joined, number, sentence, START } from './words';

const CORNERS = 6;

const OUTLINE = 'outline=polygon&poly=0.08,0.18,0.46,0.05,0.91,0.12,0.95,0.62,0.66,0.94,0.12,0.84';
const CROWD = `${OUTLINE}&size=256&kind=circle&pop=off&move=rk4&fend=0.01&mend=0.003`;

/** At random places, as many as have room. */
const AT_RANDOM = `${CROWD}&cs=33&start=random&count=40&dt=0.3&most=200`;

/** In rows, and then shaken. */
const SHAKEN = `${CROWD}&start=stream&most=200`;

const SHARES: Words = { en: 'picture sides', ja: '（画像の一辺を1とする）' };

const point = { kind: 'point', unit: SHARES, origin: [0, 0], scale: 1, from: 0, to: 1, stride: 0.01, fine: 0.002, coarse: 0.1, digits: 3, plates: [0] } as const;

const LOOK: PointHandle = { ...point, key: 'at', name: { en: 'Look at', ja: '見るところ' } };
const BEND: PointHandle = { ...point, key: 'poly', name: { en: 'Corner', ja: '輪郭の角' }, from: 0.02, to: 0.98 };

const counted = { kind: 'number', unit: { en: '', ja: '' }, symbol: '', stride: 1, fine: 1, coarse: 10, digits: 0 } as const;
const FIRST: NumberHandle = { ...counted, key: 'seed', name: { en: 'First places no.', ja: '初期位置の番号' }, from: 1, to: 99 };

const JOLT: NumberHandle = {
  kind: 'number', key: 'jolt', symbol: '', name: { en: 'Jolt', ja: '揺さぶり' }, unit: { en: 'sizes', ja: '（大きさを1とする）' },
  from: 0, to: 1, stride: 0.05, fine: 0.01, coarse: 0.25, digits: 2,
};

/** Whether a recipe has a fixed number of circles of this size, in an outline with the same number of corners. */
function fits({ value, points }: Trace): boolean {
  const isCrowd = value('kind') === 'circle' && value('pop') === 'off' && value('outline') === 'polygon';
  return isCrowd && Number(value('cs')) >= 28 && Number(value('size')) === 256 && Number(value('count')) <= 80 && points('poly').length === CORNERS;
}

const atOf = ({ traces, step }: Seen, packing = 0): Crowd | undefined => traces[packing] && crowdAt(traces[packing], step);

/** The cells of the first packing at this step. */
function cellsOf(seen: Seen): PackedCell[] {
  const [trace, now] = [seen.traces[0], atOf(seen)];
  return trace && now ? packedOf(now, trace.side) : [];
}

const largest = (cells: readonly PackedCell[]): number => Math.max(0, ...cells.map(({ force }) => Math.hypot(...force)));

/** Whether a packing is at rest at this step. */
const isAtRest = (trace: Trace | undefined, step: number): boolean => trace !== undefined && step >= (restOf(trace) ?? Infinity);

const energyNote = (packing: number) => (seen: Seen): string => {
  const now = atOf(seen, packing);
  return now ? `E = ${number(energyOf(now), 3)} k₀` : '';
};

function toldCrowd(seen: Seen, language: Language): string {
  const cells = cellsOf(seen);
  const [n, most] = [cells.length, number(largest(cells), 3)];
  const isStill = isAtRest(seen.traces[0], seen.step);
  const first = language === 'ja' ? `${n}個のバブル。力の和は、最も大きいもので${most}です。` : `${n} bubbles. The largest net force is ${most}.`;
  return joined(language, first, toldOne(seen, cells, language), hint(seen.step, isStill, language));
}

/** The neighbours of the cell that is looked at. */
function toldOne({ traces, step, at }: Seen, cells: readonly PackedCell[], language: Language): string {
  const [trace, own] = [traces[0], nearestTo(cells, at)];
  if (!trace || !own) return '';
  const near = trace.neighbours(Math.min(step, trace.steps.length - 1), own.id);
  const pushes = near.filter(({ w }) => w < 1).length;
  const pulls = near.filter(({ w }) => w >= 1 && w < 1.5).length;
  const sum = number(Math.hypot(...own.force), 3);
  return language === 'ja'
    ? `印のバブルを押す隣は${pushes}個、引く隣は${pulls}個で、合力は${sum}です。`
    : `The marked one has ${pushes} ${pushes === 1 ? 'neighbour that pushes' : 'neighbours that push'} and ${pulls} that ${pulls === 1 ? 'pulls' : 'pull'}; the net force on it is ${sum}.`;
}

function hint(step: number, isStill: boolean, language: Language): string {
  if (isStill) return language === 'ja' ? '静止しました。輪郭の角を動かすと、また落ち着くまで動きます。' : 'They are at rest. Move a corner of the outline, and they settle anew.';
  if (step === 0) return language === 'ja' ? '「再生」で放すか、ほかのバブルを見てください。' : 'Press play to let go, or look at another bubble.';
  return language === 'ja' ? '合力のいちばん大きいバブルが、いちばん速くなっていきます。' : 'Whoever has the largest net force gains speed the fastest.';
}

function toldTwo(seen: Seen, language: Language): string {
  const isBegun = seen.step > 0;
  const parts = seen.traces.map((trace, k) => {
    const [now, name] = [atOf(seen, k), (language === 'ja' ? ['左', '右'] : ['Left', 'Right'])[k] ?? ''];
    const energy = number(now ? energyOf(now) : 0, 3);
    const still = isAtRest(trace, seen.step);
    if (language === 'ja') return `${name}の群れはエネルギー${energy}${still ? 'で静止しました' : isBegun ? 'で、動いています' : 'です'}。`;
    return `${name}: energy ${energy}${still ? ', at rest' : isBegun ? ', still moving' : ''}.`;
  });
  const n = cellsOf(seen).length;
  const other = language === 'ja' ? '輪郭か、左の初期位置を変えてみてください。' : 'Bend the outline, or change the first places on the left.';
  const play = language === 'ja' ? '「再生」で放してください。' : 'Press play to let go.';
  const on = language === 'ja' ? '「再生」で続きを見てください。' : 'Press play to go on.';
  const isOver = seen.traces.every(({ steps }) => seen.step >= steps.length - 1);
  return joined(language, language === 'ja' ? `どちらも${n}個です。` : `${n} bubbles in each.`, ...parts, isOver ? other : isBegun ? on : play);
}

/** The change of the energies in the step that led here. */
function changes({ traces, step }: Seen): { readonly pairs: number; readonly sum: number } | undefined {
  const steps = traces[0]?.steps ?? [];
  const [before, now] = [steps[step - 1], steps[step]];
  return before && now && { pairs: now.pairs - before.pairs, sum: energyOf(now) - energyOf(before) };
}

function toldEnergy(seen: Seen, language: Language): string {
  const now = atOf(seen);
  const by = changes(seen);
  if (!now) return '';
  const [pairs, sum] = [number(now.pairs, 3), number(energyOf(now), 3)];
  const stand = language === 'ja' ? `対のエネルギーは${pairs}、全部の和は${sum}です。` : `The pairs have an energy of ${pairs}, all together ${sum}.`;
  if (!by) return joined(language, stand, language === 'ja' ? '一歩ずつ進めてください。' : 'Step on.');
  const [p, s] = [signed(by.pairs), signed(by.sum)];
  const last = language === 'ja' ? `この一歩で、対は${p}、和は${s}変わりました。` : `In this step the pairs changed by ${p}, the sum by ${s}.`;
  return joined(language, stand, last, language === 'ja' ? '一歩ずつ進め、対の符号を見てください。' : 'Go on step by step, and watch the sign of the pairs.');
}

const signed = (value: number): string => `${value > 0 ? '+' : ''}${number(value, 4)}`;

function toldBest(seen: Seen, language: Language): string {
  const now = atOf(seen);
  if (!now) return '';
  const [n, energy, still] = [countOf(now), number(energyOf(now), 3), isAtRest(seen.traces[0], seen.step)];
  const isBegun = seen.step > 0;
  if (language === 'ja') return `${n}個のバブルが${isBegun ? '' : '初期位置にあり、'}エネルギー${energy}で${still ? '静止しています' : isBegun ? '動いています' : '動き出すところです'}。これまでに試した始め方は${seen.trials.length}通りです。${still ? '別の初期位置でも試してください。' : '静止するまで進めてください。'}`;
  return `${n} bubbles ${still ? 'at rest' : isBegun ? 'on the move' : 'at their first places'}, with an energy of ${energy}. Starts tried so far: ${seen.trials.length}. ${still ? 'Try other first places.' : 'Go on until they rest.'}`;
}

function toldQuiet(seen: Seen, language: Language): string {
  const [trace, now] = [seen.traces[0], atOf(seen)];
  if (!trace || !now) return '';
  const [c, move] = [trace.value('damp'), number(now.move, 3)];
  const rest = restOf(trace);
  const damped = inWords(language, `Damping c = ${c}.`, `減衰c = ${c}。`);
  if (seen.step === 0) return joined(language, damped, inWords(language, 'They are still. Press play to let go.', 'まだ動いていません。「再生」で放してください。'));
  const stand = joined(language, damped, inWords(language, `In this step the fastest bubble moved ${move} sizes.`, `この一歩で最も大きく動いたバブルの移動量は、大きさの${move}倍です。`));
  if (!isAtRest(trace, seen.step)) return joined(language, stand, language === 'ja' ? 'まだ動いています。減衰を変えてみてください。' : 'They are still moving. Try another damping.');
  return joined(language, stand, language === 'ja' ? `${rest ?? 0}ステップで静止しました。` : `They came to rest after ${rest ?? 0} steps.`);
}

const same: Ask = {
  key: 'same',
  answers: {
    a: { en: 'both end as the same picture', ja: '同じ絵が二つ' },
    b: { en: 'the pictures differ, with the same energy', ja: '絵は違うが、エネルギーは同じ' },
    c: { en: 'pictures and energies differ', ja: '絵もエネルギーも違う' },
  },
  ...sentence<[left: string, right: string]>(
    ({ traces: [one, other], step }) => {
      if (!one || !other || !isAtRest(one, step) || !isAtRest(other, step)) return undefined;
      if (one.hashAt(step) === other.hashAt(step)) return undefined;
      const energy = (trace: Trace): string => number(energyOf(crowdAt(trace, step) as Crowd), 3);
      return [energy(one), energy(other)];
    },
    [['−0.000', '−0.000']],
    (language, left, right) =>
      inWords(
        language,
        `Both are at rest. The places differ, and so do the energies: ${left} on the left, ${right} on the right. Each went downhill from its own start and stayed in the first valley. The difference is small: either packing is good.`,
        `どちらも静止しました。並び方は違い、エネルギーも左が${left}、右が${right}です。それぞれ、初めの場所から坂を下り、最初に着いた谷で止まりました。差は小さく、どちらもよい充填です。`,
      ),
  ),
};

/** The least change of an energy that shows in the printed digits. */
const CLEAR = 5e-4;

const falls: Ask = {
  key: 'falls',
  answers: { a: { en: 'it falls at every step', ja: 'はい、どのステップでも減る' }, b: { en: 'at some steps it rises', ja: 'いいえ、増えるステップもある' } },
  ...sentence<[step: number, pairs: string, sum: string]>(
    (seen) => {
      // A run that was played stands beyond the steps at which the pairs gain: take the last one before it.
      for (let step = seen.isStill ? seen.step : 0; step > 0; step--) {
        const by = changes({ ...seen, step });
        if (by && by.pairs >= CLEAR && by.sum < 0) return [step, signed(by.pairs), signed(by.sum)];
      }
      return undefined;
    },
    [[100, '+0.0000', '−0.0000']],
    (language, step, pairs, sum) =>
      inWords(
        language,
        `At step ${step} the energy of the pairs changed by ${pairs}, the sum by ${sum}. Moving bubbles ran up the next slope and turned motion into energy of pairs. Only the sum falls at every step.`,
        `ステップ${step}で、対のエネルギーは${pairs}、和は${sum}変わりました。動くバブルが勢いで次の坂を上り、運動のエネルギーが対のエネルギーになったのです。必ず減るのは和だけです。`,
      ),
  ),
};

/** How much less energy a packing must have to be called better. */
const BETTER = 0.005;

const best: Ask = {
  key: 'best',
  answers: { a: { en: 'it is the best one', ja: '最良である' }, b: { en: 'another start ends lower', ja: '別の初期位置から、もっと低い谷に着く' } },
  ...sentence<[own: string, lower: string, gain: string]>(
    ({ trials: [first, ...others] }) => {
      const low = others.reduce((least, { value }) => Math.min(least, value), Infinity);
      if (!first || low > first.value - BETTER) return undefined;
      return [number(first.value, 3), number(low, 3), number(100 * (low / first.value - 1), 1)];
    },
    [['−0.000', '−0.000', '00.0']],
    (language, own, lower, gain) =>
      inWords(
        language,
        `The first packing had ${own}, another one ${lower}: the first was not the best. Each start ends in the first valley on its way. The gain is ${gain} %, which no eye sees: good enough, and quick.`,
        `最初の充填のエネルギーは${own}、別の充填は${lower}で、最初のものは最良ではありませんでした。どの始め方も、最初に着いた谷で止まります。差は${gain} %で目には見えず、これで十分です。`,
      ),
  ),
};

/** The exercise asks for rest within this many steps. */
const SOON = 40;

const quiet: Ask = {
  key: 'quiet',
  answers: {},
  ...sentence<[c: string, rest: number]>(
    ({ traces: [trace], step }) => {
      const rest = trace && restOf(trace);
      if (!trace || rest === undefined || rest > SOON || step < rest || Number(trace.value('jolt')) < 0.2) return undefined;
      return [trace.value('damp'), rest];
    },
    [['0.00', SOON]],
    (language, c, rest) =>
      inWords(
        language,
        `Done: with c = ${c} the crowd is at rest after ${rest} steps. With less it swings on, with much more it creeps.`,
        `できました。減衰c = ${c}では${rest}ステップで静止します。小さすぎるとバブルは揺れ続け、大きすぎると水あめの中のようにのろくなります。`,
      ),
  ),
};

const lineOf = (name: Words, of: (crowd: Crowd) => number, packing = 0): Line => ({ name, packing, of });

const SUM: Line = { ...lineOf({ en: 'sum', ja: '和' }, energyOf), symbol: 'E' };
const PAIRS = lineOf({ en: 'pairs', ja: '対' }, ({ pairs }) => pairs);
const WALLS = lineOf({ en: 'walls', ja: '壁' }, ({ walls }) => walls);
const MOTION = lineOf({ en: 'motion', ja: '運動' }, ({ motion }) => motion);
const MOVE = lineOf({ en: 'largest move', ja: '最大の移動量' }, ({ move }) => move);

const ENERGY: Words = { en: 'Energy in k₀', ja: 'エネルギー（単位k₀）' };

/** The first packing at rest and those that were tried since; the lowest is marked. */
function levels({ trials }: Seen): Bar[] {
  const low = Math.min(...trials.map(({ value }) => value));
  return trials.map(({ value }, k) => ({ name: String(k + 1), value, isMarked: value === low }));
}

/** The energy at rest, by the number of the first places. */
function trial(trace: Trace, step: number): Trial | undefined {
  const now = crowdAt(trace, step);
  if (!now || !isAtRest(trace, step)) return undefined;
  return { start: [trace.value('seed'), trace.value('jolt'), trace.value('damp')].join(' / '), value: energyOf(now) };
}

const FIRST_REST: Stop = { key: 'one', name: { en: 'Left at rest', ja: '左が静止' }, find: ofFirst(restOf) };

/** At this step the falling energies of the two crowds meet, so that either may end lower. */
const EVEN = 8;

const BOTH: Words[] = [{ en: 'One start', ja: 'ある初期位置' }, { en: 'Another start', ja: '別の初期位置' }];

export const MANY_BUBBLES: readonly Figure[] = [
  {
    name: 'crowd', fits, at: [0.5, 0.5], recipe: `${SHAKEN}&cs=32&jolt=0.6&seed=2&dt=0.3&damp=1`, packings: [{}], last: 200, opens: 0, steps: 'step',
    plates: [
      { draw: 'crowd', packing: 0, forces: true, title: { en: 'The net force on each', ja: 'それぞれに働く合力' }, note: energyNote(0) },
      { draw: 'lens', packing: 0, title: { en: 'The forces on one', ja: '一つに働く力' }, note: (_, language) => (language === 'ja' ? '数字：距離 w' : 'numbers: distance w') },
    ],
    stops: [START, AT_REST, OVER], handles: [LOOK, BEND, FIRST], more: [DAMPING, JOLT], asks: [], told: toldCrowd,
  },
  {
    name: 'two-starts', fits, at: [], recipe: `${AT_RANDOM}&seed=1&damp=1`, packings: [{}, { seed: '6' }], last: 200, opens: EVEN, steps: 'step',
    plates: [
      { draw: 'crowd', packing: 0, title: BOTH[0] as Words, note: energyNote(0) },
      { draw: 'crowd', packing: 1, title: BOTH[1] as Words, note: energyNote(1) },
      { draw: 'plot', packing: 0, title: ENERGY, digits: 3, lines: [lineOf({ en: 'left', ja: '左' }, energyOf), lineOf({ en: 'right', ja: '右' }, energyOf, 1)] },
    ],
    stops: [START, FIRST_REST, AT_REST, OVER], handles: [BEND, FIRST], more: [DAMPING, JOLT], asks: [same], told: toldTwo,
  },
  {
    name: 'energy', fits, at: [], recipe: `${SHAKEN}&cs=32&jolt=0.5&seed=2&dt=0.2&damp=0.2`, packings: [{}], last: 40, opens: 6, steps: 'step',
    plates: [
      { draw: 'crowd', packing: 0, forces: true, title: { en: 'Shaken, and let go', ja: '揺さぶって放した群れ' } },
      { draw: 'plot', packing: 0, title: ENERGY, digits: 3, lines: [SUM, PAIRS, WALLS, MOTION] },
    ],
    stops: [START, AT_REST, OVER], handles: [DAMPING, JOLT, FIRST, BEND], more: [], asks: [falls], told: toldEnergy,
  },
  {
    name: 'best', fits, at: [], recipe: `${AT_RANDOM}&seed=3&damp=1`, packings: [{}], last: 200, opens: 200, steps: 'step',
    plates: [
      { draw: 'crowd', packing: 0, title: { en: 'The best packing?', ja: 'これが最良の充填か' }, note: energyNote(0) },
      { draw: 'levels', packing: 0, title: { en: 'Energies at rest', ja: '静止したときのエネルギー' }, digits: 3, bars: levels },
    ],
    stops: [START, AT_REST, OVER], handles: [FIRST, JOLT, DAMPING], more: [], trial, asks: [best], told: toldBest,
  },
  {
    name: 'quiet', fits, at: [], recipe: `${SHAKEN}&cs=34&jolt=0.3&seed=1&dt=0.3&damp=0.1`, packings: [{}], last: 100, opens: 100, steps: 'step',
    plates: [
      { draw: 'crowd', packing: 0, title: { en: 'Shaken, and let go', ja: '揺さぶって放した群れ' } },
      { draw: 'plot', packing: 0, title: { en: 'Largest move in sizes', ja: '最大の移動量（大きさを1とする）' }, digits: 3, lines: [MOVE] },
    ],
    stops: [START, AT_REST, OVER], handles: [DAMPING, BEND], more: [], asks: [quiet], told: toldQuiet,
  },
];
