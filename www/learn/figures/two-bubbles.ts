/**
 * The figures of chapter 1, "Two bubbles" (Miyata, Itoh and Shimada, A Method for Generating Pavement Textures Using the
 * Square Packing Technique, 2001, sections 4.2 and 4.3, equations (2), (3) and (5)). All packings have circles of side 64 in
 * a picture of side 256, without walls; no cell comes or goes, and no run ends by itself.
 */
import type { Ask, Figure, Language, Moment, Seen, Stop, Trace } from './figure';
import { between, isPair, nearest, parting, REACH, rest, touch, trialOf, turn } from './rules';
import { DAMPING, DISTANCE, HELD, INTEGRATOR, inWords, joined, MARK, MASS, moves, number, sentence, START, STIFFNESS, stands, TIME_STEP, way } from './words';

const PAIR = 'outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&fend=0&mend=0&most=1000';

/** The left bubble at a quarter of the picture, and the right one this many stable distances from it. */
const pair = (w: number, values: string): string => `${PAIR}&given=0.25,0.5,1;${0.25 + w / 4},0.5,0&${values}`;

/** A stop of the first pair. */
const ofPair = (find: (moments: readonly Moment[]) => number | undefined): Stop['find'] => ([trace]) => find(trace?.moments ?? []);

const TOUCH: Stop = { key: 'touch', name: { en: 'First touch', ja: '最初に接する' }, find: ofPair(touch) };
const TURN: Stop = { key: 'turn', name: { en: 'Turning', ja: '折り返し' }, find: ofPair(turn) };
const REST: Stop = { key: 'rest', name: { en: 'Rest', ja: '静止' }, find: ofPair(rest) };
const PARTED: Stop = { key: 'parted', name: { en: 'Apart for good', ja: '離れきる' }, find: ofPair(parting) };
const END: Stop = { key: 'end', name: { en: 'Last step', ja: '最後' }, find: ofPair((moments) => moments.at(-1)?.step) };

/** The question on a pair that starts beyond the reach of the force. */
const far: Ask = {
  key: 'far',
  answers: { a: { en: 'it drifts off', ja: '離れていく' }, b: { en: 'it stays', ja: 'そのまま止まっている' }, c: { en: 'it comes back', ja: '戻ってくる' } },
  ...sentence<[w: string, force: string]>(
    ({ traces, step }) => {
      const moments = traces[0]?.moments ?? [];
      const [first, then] = [moments[0], moments[10]];
      if (!first || !then || step < 10 || first.w <= REACH || Math.abs(then.w - first.w) > 0.01) return undefined;
      return [number(then.w, 3), number(then.force, 3)];
    },
    [['0.000', '0.000']],
    (language, w, force) =>
      inWords(
        language,
        `It stayed: at w = ${w} the force is ${force}, and ten steps later it is still there. From 1.5 on nothing pulls and nothing pushes.`,
        `そのまま止まっていました。w = ${w}での力は${force}で、10ステップ後もそこにいます。1.5より遠くでは引く力も押す力も0だからです。`,
      ),
  ),
};

/** Two starts that are less than this apart answer the question on starts without damping. */
const CLOSE = 0.02;

const near: Ask = {
  key: 'near',
  showsZero: true,
  answers: {},
  ...sentence<[parted: string, kept: string, own: string, level: string]>(
    ({ trials, at, zero }) => {
      const [parted, kept] = between(trials, CLOSE) ?? [];
      if (parted === undefined || kept === undefined) return undefined;
      // A mark that was not set stands at 0.
      const own = at[0] ? number(at[0], 3) : '';
      return [number(parted, 3), number(kept, 3), own, number(zero, 3)];
    },
    [['0.000', '0.000', '0.000', '0.000']],
    (language, parted, kept, own, level) =>
      inWords(
        language,
        `${own ? `Your mark is at ${own}.` : 'You set no mark.'} From ${parted} it parted for good, from ${kept} it came back. Ψ is 0 in between, at w = ${level}: without damping no energy is lost, so a start above 0 leaves the valley.`,
        `${own ? `あなたの印は${own}。` : '印はありません。'}${parted}からは離れきり、${kept}からは戻りました。その間のw = ${level}でΨは0です。減衰がなければエネルギーは減らず、0より上から始めると谷を出ていきます。`,
      ),
  ),
};

/** The time step as the texts write it: 0.55, 1.0. */
function timeStep(trace: Trace | undefined): string {
  const value = Number(trace?.value('dt'));
  return number(value, Number.isInteger(value * 10) ? 1 : 2);
}

const broken: Ask = {
  key: 'broken',
  answers: { a: { en: 'it rests', ja: '静止する' }, b: { en: 'it swings for ever', ja: '揺れつづける' }, c: { en: 'it flies apart', ja: '飛び離れる' } },
  ...sentence<[dt: string, away: string, stays: string]>(
    ({ traces, step }) => {
      const [euler, kutta] = traces.map(({ moments }) => moments[step]);
      if (!euler || !kutta || step < 20 || euler.w <= REACH || Math.abs(kutta.w - 1) > 0.02) return undefined;
      return [timeStep(traces[0]), number(euler.w, 3), number(kutta.w, 3)];
    },
    [['0.00', '00.000', '0.000']],
    (language, dt, away, stays) =>
      inWords(
        language,
        `With a step of ${dt}, explicit Euler has thrown the bubble to w = ${away}; Runge–Kutta has it at rest at w = ${stays}. The force is the same, but Euler goes on for the whole long step with the force at its beginning.`,
        `刻み${dt}では、陽的オイラー法のバブルはw = ${away}まで飛び離れ、ルンゲ・クッタ法ではw = ${stays}で静止しました。力は同じですが、オイラー法は長い刻みの間、初めの力のまま進むからです。`,
      ),
  ),
};

const still: Ask = {
  key: 'still',
  answers: {},
  ...sentence<[c: string, at: number]>(
    ({ traces: [trace], step }) => {
      const moments = trace?.moments ?? [];
      const at = rest(moments);
      const isFar = (moments[0]?.w ?? 1) < 0.9;
      if (!trace || !isFar || step < 30 || at === undefined || at > 30 || moments.some(({ w }) => w > 1.01)) return undefined;
      return [trace.value('damp'), at];
    },
    [['0.00', 30]],
    (language, c, at) =>
      inWords(
        language,
        `Done: with c = ${c} it is at rest after ${at} steps and never swings past. Much less than 2 swings past, much more is slow.`,
        `できました。減衰c = ${c}では、行き過ぎずに${at}ステップで静止します。2より小さいと行き過ぎ、大きいとのろくなります。`,
      ),
  ),
};

const made: Ask = {
  key: 'made',
  answers: { a: { en: 'stones came first, cut one by one', ja: '一つずつ切り出した石' }, b: { en: 'bubbles came first', ja: '押し合い、引き合うバブル' }, c: { en: 'a photograph came first', ja: '目地に沿って切り抜いた写真' } },
  ...sentence<[n: number]>(
    ({ step, traces }) => (step < 4 ? undefined : [traces[0]?.cells.length ?? 0]),
    [[10]],
    (language, n) =>
      inWords(
        language,
        `Each of the ${n} stones was made around a bubble. The bubbles found their places by pushing and pulling each other. Between two of them one curve decides.`,
        `${n}個の石は、一つずつバブルから作られました。バブルは押し合い、引き合って自分の場所を見つけます。二つの間の力は、一つの曲線で決まります。`,
      ),
  ),
};

/** How the starts without damping have ended so far, and where to start next. Two that lie close together answer the question. */
function toldStarts({ trials, answered }: Seen, language: Language): string {
  if (answered.has('near')) return '';
  const [parted, kept] = nearest(trials).map((w) => (w === undefined ? undefined : number(w, 3)));
  if (parted && kept) {
    return inWords(
      language,
      `From ${parted} it parted for good, from ${kept} it came back. Start in between, until two such starts are less than ${CLOSE} apart.`,
      `${parted}からは離れきり、${kept}からは戻りました。その間から放して、差が${CLOSE}より小さい二つを見つけてください。`,
    );
  }
  if (parted) return inWords(language, `From ${parted} it parted for good. Start a little farther apart.`, `${parted}からは離れきりました。もう少し離して放してみてください。`);
  return kept ? inWords(language, `From ${kept} it came back. Start a little nearer.`, `${kept}からは戻りました。もう少し近づけて放してみてください。`) : '';
}

/** The text under the figure with the marks: after a start without damping, how the starts have ended. */
function toldTrials(seen: Seen, language: Language): string {
  const { traces: [trace], step } = seen;
  const moment = trace?.moments[step];
  const starts = trace && moment && trialOf(trace, step) ? toldStarts(seen, language) : '';
  return moment && starts ? joined(language, stands(moment, language), starts) : told(seen, language);
}

/** The text under a figure with one pair. */
function told({ traces, step }: Seen, language: Language): string {
  const [trace] = traces;
  const moment = trace?.moments[step];
  if (!trace || !moment) return '';
  const isHeld = trace.value('held') === '1';
  const who = language === 'ja' ? (isHeld ? 'バブルが二つ。左は留めてあります。' : 'バブルが二つ。どちらも自由に動けます。') : isHeld ? 'Two bubbles, the left one held.' : 'Two bubbles, both free.';
  return joined(language, who, stands(moment, language), isAtRest(trace, step) ? '' : moves(moment, language), hint(trace, step, language));
}

const isAtRest = ({ moments }: Trace, step: number): boolean => step > 0 && step >= (rest(moments) ?? Infinity);

/** A hint at something to try next. */
function hint(trace: Trace, step: number, language: Language): string {
  if (step === 0) return language === 'ja' ? '右のバブルを動かすか、「再生」で放してください。' : 'Move the right bubble, or press play to let go.';
  if (isAtRest(trace, step)) return atRest(trace.moments[step], language);
  return language === 'ja' ? '一歩ずつ進めたり戻したりして、力の向きを見てください。' : 'Step on or back and watch which way the force points.';
}

/** A pair at rest: no force is left, or so little that nothing moves. */
function atRest(moment: Moment | undefined, language: Language): string {
  const isLeft = moment !== undefined && way(moment) !== 'none';
  return inWords(
    language,
    `${isLeft ? 'So little force is left that they are at rest.' : 'They are at rest.'} Try another start.`,
    `${isLeft ? '力はほとんど残っておらず、' : ''}静止しています。ほかの距離からも試してください。`,
  );
}

function toldTwice({ traces, step }: Seen, language: Language): string {
  const names = language === 'ja' ? ['陽的オイラー法', 'ルンゲ・クッタ法'] : ['Explicit Euler', 'Runge–Kutta'];
  const parts = traces.map(({ moments }, k) => `${names[k] ?? ''}: w = ${number(moments[step]?.w ?? 0, 3)}`);
  const dt = timeStep(traces[0]);
  const same = language === 'ja' ? `力も減衰も同じ、時間刻みも同じ${dt}です。` : `The same force, the same damping, the same time step of ${dt}.`;
  const tryIt = language === 'ja' ? '刻みを0.2、0.55、1.0に変えてみてください。' : 'Try steps of 0.2, 0.55 and 1.0.';
  return joined(language, same, language === 'ja' ? `${parts.join('、')}。` : `${parts.join('; ')}.`, tryIt);
}

const LAYERS: readonly { readonly key: string; readonly en: string; readonly ja: string }[] = [
  { key: 'across', en: 'From stones to bubbles', ja: '石からバブルへ' },
  { key: 'stones', en: 'Stones', ja: '石' },
  { key: 'cells', en: 'Cells', ja: 'セル' },
  { key: 'bubbles', en: 'Bubbles', ja: 'バブル' },
  { key: 'two', en: 'Two bubbles', ja: '二つのバブル' },
];

function toldLayer({ traces, step }: Seen, language: Language): string {
  const n = traces[0]?.cells.length ?? 0;
  const en = [
    `A pavement of ${n} stones, taken apart from left to right: stones, cells, bubbles, and two of them. Step through it.`,
    `${n} stones. No two are alike, and the joints fit.`,
    `${n} cells: each stone fills one.`,
    `${n} bubbles, one in each cell. They touch, and they overlap a little.`,
    'Two neighbours, alone. All that follows is about these two.',
  ];
  const ja = [
    `${n}個の石からなる石畳を、左から右へ、石、セル、バブル、そのうちの二つへとほどきました。一歩ずつ進めてください。`,
    `石は${n}個。同じ形は一つもなく、目地はぴったり合っています。`,
    `セルは${n}個。石は一つずつセルに収まっています。`,
    `バブルは${n}個。セルごとに一つあり、触れ合って、少し重なっています。`,
    '隣り合う二つだけが残りました。これからは、この二つの話です。',
  ];
  return (language === 'ja' ? ja : en)[step] ?? '';
}

/** Whether a pavement is small enough to be made quickly. */
const isSmall = ({ value }: Trace): boolean => Number(value('cs')) >= 20 && Number(value('size')) <= 512;

const NO_PHYSICS = { handles: [], more: [] };
const PHYSICS = [MASS, STIFFNESS, TIME_STEP, INTEGRATOR];

export const TWO_BUBBLES: readonly Figure[] = [
  {
    name: 'top', fits: isSmall, at: [], recipe: 'outline=square&size=256&kind=circle&cs=32&seed=3', packings: [{}], last: 4, opens: 0, steps: 'layer',
    plates: [{ draw: 'pavement', packing: 0 }],
    stops: LAYERS.map(({ key, en, ja }, k) => ({ key, name: { en, ja }, find: (): number => k })),
    ...NO_PHYSICS, asks: [made], told: toldLayer,
  },
  {
    name: 'pair', fits: isPair, at: [], recipe: pair(0.7, 'damp=0.5&move=rk4&dt=0.1'), packings: [{}], last: 160, opens: 0, steps: 'step',
    plates: [{ draw: 'force', packing: 0 }, { draw: 'valley', packing: 0 }],
    stops: [START, TOUCH, TURN, REST], handles: [DISTANCE, HELD], more: [DAMPING, ...PHYSICS], asks: [], told,
  },
  {
    name: 'let-go', fits: isPair, at: [0], recipe: pair(0.6, 'damp=0.6&move=rk4&dt=0.1'), packings: [{}], last: 200, opens: 200, steps: 'step',
    plates: [{ draw: 'track', packing: 0 }, { draw: 'valley', packing: 0 }],
    stops: [START, TOUCH, TURN, PARTED, REST, END], handles: [{ ...DISTANCE, plates: [0] }, DAMPING, MARK, HELD], more: PHYSICS,
    trial: trialOf, asks: [far, near], told: toldTrials,
  },
  {
    name: 'not-so', fits: isPair, at: [], recipe: pair(0.9, 'damp=0.5&move=euler&dt=0.55'), packings: [{}, { move: 'rk4' }], last: 100, opens: 60, steps: 'step',
    plates: [
      { draw: 'track', packing: 0, title: { en: 'Explicit Euler', ja: '陽的オイラー法' } },
      { draw: 'track', packing: 1, title: { en: 'Runge–Kutta', ja: 'ルンゲ・クッタ法' } },
    ],
    stops: [START, TOUCH, TURN, PARTED, REST, END], handles: [TIME_STEP, { ...DISTANCE, plates: [0] }, DAMPING], more: [MASS, STIFFNESS], asks: [broken], told: toldTwice,
  },
  {
    name: 'exercise', fits: isPair, at: [], recipe: pair(0.8, 'damp=0.3&move=rk4&dt=0.2'), packings: [{}], last: 60, opens: 40, steps: 'step',
    plates: [{ draw: 'track', packing: 0 }, { draw: 'valley', packing: 0 }],
    stops: [START, TOUCH, TURN, REST, END], handles: [DAMPING, { ...DISTANCE, plates: [0] }], more: PHYSICS, asks: [still], told,
  },
];
