/**
 * The figures of chapter 4, "Why squares line up" (Miyata, Itoh and Shimada, A Method for Generating Pavement Textures Using the
 * Square Packing Technique, 2001, section 4.2, equation (4)). No walls, and no square comes or goes. A pair has a square of side
 * 64 held in the middle of a picture of side 256, so that a stable distance is a quarter of the picture.
 */
import { AT_REST, crowdAt, lastOf, ofAll, ofFirst, OVER, packedOf } from './crowds';
import type { Ask, Figure, Language, NumberHandle, Plate, PointHandle, Seen, Stop, Trace, Trial } from './figure';
import { edgesOf, isAtCorner, isAtEdge, isStill, neighbourAt, reachesEdge, restsAt, type Neighbour } from './neighbour';
import { REACH } from './rules';
import { DAMPING, inWords, number, sentence, TIME_STEP } from './words';

const OPEN = 'outline=square&size=256&kind=square&dir=constant&edge=open&pop=off&move=rk4&most=1000';

/** The weight and the radius of the papers' corner bubbles. */
const PAPERS = Math.SQRT2 - 1;
const MARKED = [{ value: PAPERS, name: '√2 − 1' }];

const WEIGHT: NumberHandle = {
  kind: 'number', key: 'cw', symbol: '', name: { en: 'Corner weight', ja: '隅の重み' }, unit: { en: '', ja: '' },
  from: 0, to: 1, stride: 0.05, fine: 0.01, coarse: 0.2, digits: 3, marks: MARKED,
};

const RADIUS: NumberHandle = {
  kind: 'number', key: 'cr', symbol: '', name: { en: 'Corner radius', ja: '隅の半径' }, unit: { en: 'r0', ja: 'r0' },
  from: 0.2, to: 0.8, stride: 0.05, fine: 0.01, coarse: 0.2, digits: 3, marks: MARKED,
};

const PLACE: PointHandle = {
  kind: 'point', key: 'given', name: { en: 'Second square', ja: '二つ目の正方形' }, unit: { en: 'stable distances', ja: '安定距離' },
  origin: [0.5, 0.5], scale: 0.25, from: -1.9, to: 1.9, stride: 0.05, fine: 0.01, coarse: 0.5, digits: 2, plates: [0], rows: [1],
};

const SEED: NumberHandle = {
  kind: 'number', key: 'seed', symbol: '', name: { en: 'Other start', ja: '別の始まり' }, unit: { en: '', ja: '' },
  from: 1, to: 99, stride: 1, fine: 1, coarse: 10, digits: 0,
};

const JOLT: NumberHandle = {
  kind: 'number', key: 'jolt', symbol: '', name: { en: 'Jolt', ja: '乱し方' }, unit: { en: 'sides', ja: '辺' },
  from: 0, to: 0.6, stride: 0.05, fine: 0.01, coarse: 0.2, digits: 2,
};

const START: Stop = { key: 'start', name: { en: 'Start', ja: '開始' }, find: () => 0 };
const EDGE: Stop = { key: 'edge', name: { en: 'Before an edge', ja: '辺の前' }, find: ofFirst(reachesEdge) };
const STILL: Stop = { key: 'rest', name: { en: 'Rest', ja: '静止' }, find: ofFirst(restsAt) };
const HALFWAY: Stop = { key: 'halfway', name: { en: 'On the way', ja: '途中' }, find: (traces) => Math.round((ofAll(lastOf)(traces) ?? 0) / 6) };

const weightOf = (trace: Trace): number => Number(trace.value('cw'));

/**
 * The trial of a square that was dropped at 45 degrees: whether it has left for an edge. Trials differ by their weight.
 */
function dropped(trace: Trace, step: number): Trial | undefined {
  const [first, now] = [neighbourAt(trace, 0), neighbourAt(trace, step)];
  if (!first || !now || !isAtCorner(first) || first.w < 0.85 || first.w > 1.3) return undefined;
  const value = weightOf(trace);
  if (isAtEdge(now)) return { start: `${value} edge`, value, parted: true };
  const isStaying = step === lastOf(trace) && value === 0 && isAtCorner(now) && isStill(now);
  return isStaying ? { start: `${value} corner`, value, parted: false } : undefined;
}

/** A drop with at most this weight shows that a small weight is enough. */
const LITTLE = 0.05;

const from: Ask = {
  key: 'from',
  answers: { a: { en: 'there are four wells from 0.41 on', ja: '0.41から' }, b: { en: 'there are four wells from 0.2 on', ja: '0.2から' }, c: { en: 'any weight above 0 makes four wells', ja: '0より大きければいくつでも' } },
  ...sentence<[weight: string, barrier: string]>(
    ({ traces: [trace], trials }) => {
      const land = trace?.landscape;
      const slid = trials.find(({ value, parted }) => parted && value > 0 && value <= LITTLE);
      if (!slid || !trials.some(({ value, parted }) => !parted && value === 0)) return undefined;
      return [number(slid.value, 2), land && weightOf(trace) === slid.value ? number(land.pass.energy - land.well.energy, 4) : ''];
    },
    [['0.00', '0.0000']],
    (language, weight, barrier) =>
      inWords(
        language,
        `At weight 0 it stayed near 45°; at ${weight} it slid to an edge. ${barrier ? `The pass at 45° is only ${barrier} k₀ higher than the wells, but it is higher. ` : ''}Any weight above 0 makes four wells out of the ring.`,
        `重み0では45°の近くにとどまり、重み${weight}では辺へ滑りました。${barrier ? `45°の峠は井戸よりわずか${barrier} k₀高いだけですが、それで十分です。` : ''}0より大きければ、どんな重みでも輪は四つの井戸に分かれます。`,
      ),
  ),
};

const bump: Ask = {
  key: 'bump',
  answers: { a: { en: 'it rests farther away', ja: 'もっと遠く' }, b: { en: 'it rests nearer', ja: 'もっと近く' }, c: { en: 'it rests at w = 1, as before', ja: '前と同じw = 1' } },
  ...sentence<[w: string, weight: string, deep: string]>(
    ({ traces: [trace], step }) => {
      const now = trace && neighbourAt(trace, step);
      const isPapers = Math.abs(Number(trace?.value('cr')) - PAPERS) < 1e-3;
      if (!trace || !now || weightOf(trace) < 0.9 || !isPapers || step === 0 || !isAtEdge(now)) return undefined;
      return [number(now.w, 3), number(weightOf(trace), 2), number(-now.energy, 3)];
    },
    [['0.000', '0.00', '0.000']],
    (language, w, weight, deep) =>
      inWords(
        language,
        `With a weight of ${weight} it rests at w = ${w}, as before: the well is deeper, ${deep} k₀, and has not moved. Corners that bump would push it away. Now change the radius.`,
        `重み${weight}でも、前と同じw = ${w}で静止します。井戸は${deep} k₀と深くなっただけです。角がぶつかるなら遠ざかるはずです。次は半径を変えてください。`,
      ),
  ),
};

/** The least distance of a slide into the left well, in stable distances. */
const SLIDE = 0.5;

const slide: Ask = {
  key: 'slide',
  answers: {},
  ...sentence<[x: string, y: string, step: number]>(
    ({ traces: [trace], step }) => {
      const [first, now] = trace ? [neighbourAt(trace, 0), neighbourAt(trace, step)] : [];
      // Without corner bubbles there is a ring, and no well.
      if (!trace || weightOf(trace) === 0 || !first || !now || !isAtEdge(now) || now.x > -0.5 || Math.hypot(first.x - now.x, first.y - now.y) < SLIDE) return undefined;
      // As the number boxes show its place: y down.
      return [number(first.x, 2), number(-first.y, 2), step];
    },
    [['−0.00', '−0.00', 100]],
    (language, x, y, step) =>
      inWords(
        language,
        `Done: from x = ${x}, y = ${y} it slid into the well on the left, after ${step} steps at the latest. The borders between the wells are the diagonals.`,
        `できました。x = ${x}、y = ${y}から左の井戸へ、${step}ステップまでに滑り込みました。井戸どうしの境は、対角線です。`,
      ),
  ),
};

/** The place of the second square, in words. */
function standsAt({ w, aside }: Neighbour, language: Language): string {
  const [far, turned] = [number(w, 3), number(aside, 0)];
  return inWords(language, `The second square is at w = ${far}, ${turned}° from the middle of the nearest edge.`, `二つ目の正方形はw = ${far}、いちばん近い辺の真ん中から${turned}°のところにあります。`);
}

function movesTo(now: Neighbour, step: number, language: Language): string {
  if (step > 0 && isAtEdge(now) && now.w < REACH) return inWords(language, 'It rests before an edge.', '辺の前で静止しています。');
  if (step > 0 && isStill(now) && Math.hypot(...now.force) < 0.01) return inWords(language, 'It rests there.', 'そこで静止しています。');
  const [force, speed] = [number(Math.hypot(...now.force), 3), number(now.speed, 3)];
  return step === 0
    ? inWords(language, `The force on it is ${force}.`, `受ける力は${force}です。`)
    : inWords(language, `It slides at ${speed}; the force on it is ${force}.`, `速さ${speed}で滑り、受ける力は${force}です。`);
}

/** The landscape in words: a ring, or wells with passes between them. */
function landIn(trace: Trace, language: Language): string {
  const { landscape: land } = trace;
  if (!land) return '';
  const [weight, deep, high] = [number(weightOf(trace), 3), number(-land.well.energy, 4), number(land.pass.energy - land.well.energy, 4)];
  if (weightOf(trace) === 0) return inWords(language, `Without corner bubbles all places at w = 1 are alike: a ring, ${deep} k₀ deep.`, `隅のバブルがなければ、w = 1の場所はどこも同じで、深さ${deep} k₀の輪になります。`);
  return inWords(language, `With a corner weight of ${weight} there are four wells at w = ${number(land.well.w, 2)}, ${deep} k₀ deep, and a barrier of ${high} k₀ between two.`, `隅の重み${weight}では、w = ${number(land.well.w, 2)}に深さ${deep} k₀の井戸が四つあり、間の障壁は${high} k₀です。`);
}

function toldPair(hint: { readonly en: string; readonly ja: string }, found: (seen: Seen, language: Language) => string = () => '') {
  return (seen: Seen, language: Language): string => {
    const { traces: [trace], step } = seen;
    const now = trace && neighbourAt(trace, step);
    if (!trace || !now) return '';
    const end = found(seen, language) || `${movesTo(now, step, language)}${inWords(language, ' ', '')}${hint[language]}`;
    return [landIn(trace, language), standsAt(now, language), end].join(language === 'ja' ? '' : ' ');
  };
}

/** The weights that were tried at 45 degrees so far, and the one to try next. The weight that the figure opens with is not the reader's. */
function toldWeights({ traces: [trace], trials, step, answered }: Seen, language: Language): string {
  if (!trace || trials.length < 2 || !dropped(trace, step) || answered.has('from')) return '';
  const least = Math.min(...trials.filter(({ parted }) => parted).map(({ value }) => value));
  const weight = number(least, 2);
  const hasStayed = trials.some(({ parted, value }) => !parted && value === 0);
  if (hasStayed) return inWords(language, `At weight 0 it stayed near 45°, at ${weight} it slid to an edge. Try a smaller weight.`, `重み0では45°の近くにとどまり、${weight}では辺へ滑りました。もっと小さい重みでも試してください。`);
  if (least >= PAPERS) return '';
  return inWords(language, `At weight ${weight} it still slid to an edge. Try less, down to 0.`, `重み${weight}でも辺へ滑りました。もっと小さく、0までの重みで試してください。`);
}

/** How many neighbours share an edge. */
function sharing(trace: Trace | undefined, step: number): { readonly edges: number; readonly neighbours: number } {
  const crowd = trace && crowdAt(trace, step);
  const { edges, neighbours } = edgesOf(crowd ? packedOf(crowd, trace.side) : []);
  return { edges: edges.length, neighbours };
}

const noteOf = (packing: number) => ({ traces, step }: Seen, language: Language): string => {
  const { edges, neighbours } = sharing(traces[packing], step);
  return inWords(language, `${edges} of ${neighbours} pairs edge to edge`, `隣り合う${neighbours}組のうち${edges}組が辺を共有`);
};

function toldCrowd({ traces, step }: Seen, language: Language): string {
  const [without, corners] = [0, 1].map((packing) => sharing(traces[packing], step));
  const count = traces[0]?.steps[0] ? packedOf(traces[0].steps[0], traces[0].side).length : 0;
  if (!without || !corners) return '';
  const start = inWords(language, `${count} squares, twice, from the same places.`, `${count}個の正方形を、同じ場所から二通りに動かします。`);
  const now = inWords(
    language,
    `Without corner bubbles ${without.edges} of ${without.neighbours} neighbouring pairs share an edge now, with them ${corners.edges} of ${corners.neighbours}.`,
    `今、辺を共有するのは、隅のバブルなしでは隣り合う${without.neighbours}組のうち${without.edges}組、ありでは${corners.neighbours}組のうち${corners.edges}組です。`,
  );
  const hint = step === 0 ? inWords(language, 'Press play.', '「再生」を押してください。') : inWords(language, 'Try another start, or step through it.', '別の始まりを試すか、一歩ずつ見てください。');
  return [start, now, hint].join(language === 'ja' ? '' : ' ');
}

/** Columns and rows of places, this many sides apart, around the middle. */
function block(columns: number, rows: number, apart: number, side: number): string {
  const place = (k: number, count: number): string => (0.5 + ((k - (count - 1) / 2) * apart * side) / 256).toFixed(4);
  return Array.from({ length: columns * rows }, (_, k) => `${place(k % columns, columns)},${place(Math.floor(k / columns), rows)},0`).join(';');
}

const CROWD_PLATES: Figure['plates'] = [
  { draw: 'squares', packing: 0, title: { en: 'Without corner bubbles', ja: '隅のバブルなし' }, note: noteOf(0) },
  { draw: 'squares', packing: 1, title: { en: 'With corner bubbles', ja: '隅のバブルあり' }, note: noteOf(1) },
];

const isBlock = (count: number) => (trace: Trace): boolean => trace.points('given').length === count && trace.value('pop') === 'off' && trace.value('kind') === 'square' && trace.value('dir') === 'constant';

/** A square held in the middle, and a second one of the same size. */
const isPair = (trace: Trace): boolean => isBlock(2)(trace) && trace.value('held') === '1' && trace.value('edge') === 'open' && trace.value('cs') === '64' && trace.side === 256;

/** The second square at this place from the first, in stable distances, y down. */
const pair = (x: number, y: number, values: string): string => `${OPEN}&cs=64&fend=0&mend=0&damp=0.6&dt=0.6&given=0.5,0.5,1;${0.5 + x / 4},${0.5 + y / 4},0&${values}`;

const PAIR = { fits: isPair, at: [], packings: [{}], steps: 'step', hasLandscape: true, stops: [START, EDGE, STILL, OVER] } as const;

/** The heights of the wells and of the passes, with their signs on the map; without corner bubbles that of the ring. */
function heights({ traces: [trace] }: Seen, language: Language): string {
  const { well, pass } = trace?.landscape ?? {};
  if (!trace || !well || !pass) return '';
  if (weightOf(trace) === 0) return inWords(language, `ring ${number(well.energy, 4)} k₀`, `輪 ${number(well.energy, 4)} k₀`);
  const [low, high] = [number(well.energy, 4), number(pass.energy, 4)];
  return inWords(language, `+ well ${low}, × pass ${high} k₀`, `＋井戸 ${low}、×峠 ${high} k₀`);
}

function barrier({ traces: [trace] }: Seen, language: Language): string {
  const { well, pass } = trace?.landscape ?? {};
  if (!trace || !well || !pass) return '';
  return weightOf(trace) === 0 ? inWords(language, 'no barrier', '障壁なし') : `${inWords(language, 'barrier', '障壁')} ${number(pass.energy - well.energy, 4)} k₀`;
}

const mapOf = (ground: string): Plate => ({ draw: 'landscape', packing: 0, ground, title: { en: 'From above', ja: '真上から' }, note: heights });

const mapped = (ground: string): Figure['plates'] => [mapOf(ground), { draw: 'relief', packing: 0, ground, title: { en: 'As a relief in light', ja: '光を当てた模型' }, note: barrier }];

export const SQUARES: readonly Figure[] = [
  {
    name: 'nine', fits: isBlock(9), at: [], recipe: `${OPEN}&cs=56&damp=0.6&dt=0.3&fend=0.004&mend=0.001&jolt=0.35&seed=4&given=${block(3, 3, 1.1, 56)}`,
    packings: [{ cw: '0' }, { cw: String(PAPERS) }], last: 160, opens: 160, steps: 'step', plates: CROWD_PLATES,
    stops: [START, HALFWAY, AT_REST], handles: [JOLT, SEED], more: [DAMPING, TIME_STEP], asks: [], told: toldCrowd,
  },
  {
    name: 'wells', ...PAIR, recipe: pair(0.92, -0.86, `cw=${PAPERS}`), last: 200, opens: 200, plates: mapped('wells'),
    handles: [PLACE, WEIGHT], more: [RADIUS, DAMPING], trial: dropped, asks: [from],
    told: toldPair({ en: 'Drop the square elsewhere, or change the weight.', ja: '別の場所に置くか、重みを変えてみてください。' }, toldWeights),
  },
  {
    name: 'sixty', fits: isBlock(60), at: [], recipe: `${OPEN}&cs=22&damp=0.6&dt=0.4&fend=0.004&mend=0.002&jolt=0.45&seed=7&given=${block(10, 6, 1.1, 22)}`,
    packings: [{ cw: '0' }, { cw: String(PAPERS) }], last: 240, opens: 240, steps: 'step', plates: CROWD_PLATES,
    stops: [START, HALFWAY, AT_REST, OVER], handles: [JOLT, SEED], more: [DAMPING, TIME_STEP], asks: [], told: toldCrowd,
  },
  {
    name: 'bump', ...PAIR, recipe: pair(1.3, -0.25, `cw=${PAPERS}`), last: 100, opens: 100, plates: [mapOf('bump'), { draw: 'section', packing: 0, title: { en: 'Along two lines', ja: '二つの直線に沿って' }, note: barrier }],
    handles: [WEIGHT, RADIUS, PLACE], more: [DAMPING], asks: [bump],
    told: toldPair({ en: 'Change the weight, then the radius, and compare.', ja: '重みを変え、次に半径を変えて、比べてください。' }),
  },
  {
    name: 'slide', ...PAIR, recipe: pair(0.65, -1.1, 'cw=0.2'), last: 120, opens: 120, plates: mapped('slide'),
    handles: [PLACE, WEIGHT], more: [RADIUS, DAMPING], asks: [slide],
    told: toldPair({ en: 'Drop it where it slides into the well on the left.', ja: '左の井戸に滑り込む場所に置いてください。' }),
  },
];
