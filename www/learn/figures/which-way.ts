/**
 * The figures of chapter 5, "Which way?" (Miyata, Itoh and Shimada 2000, section 4.1, equation (1), and 2001, section 4). They
 * need the fields of a recipe alone. Places are in shares of the picture's side.
 */
import { asSquare, degreesOf, STEPS } from './directions';
import type { Ask, Figure, Hand, Language, Plate, Seen, Stop, Trace } from './figure';
import { ANGLE, angleIn, CENTRE, HEIGHT, IN_ROAD, OUTLINE, PIECES, POWER, ROUND, roadOf, STROKES, strokesAt, WALK_RADIUS } from './which-way-handles';
import { inQuarters, inWords, joined, number, sentence } from './words';

const whole = (value: number): string => number(value, 0);

function quarterTurns(value: number, language: Language): string {
  const turns = inQuarters(value);
  return inWords(language, `${turns} quarter ${/^−?1$/.test(turns) ? 'turn' : 'turns'}`, `90°の${turns}回分`);
}

const OF_FIELDS = { packings: [{}], last: 0, opens: 0, steps: 'walk', stops: [], more: [], asks: [] } as const;

/** The angle at which squares stand at a place, and its certainty. */
function standsAt(trace: Trace, place: readonly number[]): { readonly degrees: number; readonly certainty: number } {
  const { along, certainty } = trace.directions.at(place);
  return { degrees: asSquare(degreesOf(along)), certainty };
}

// A square that is turned.

const angleOf = (trace: Trace): number => Number(trace.value('angle'));

function fourFold({ traces: [trace] }: Seen): Hand[] {
  const degrees = trace ? angleOf(trace) : 0;
  const ghost: Hand = { degrees: 0, length: 1, kind: 'ghost', name: '' };
  return [ghost, { degrees: 4 * degrees, length: 1, kind: 'sum', name: `4 × ${whole(degrees)}° = ${whole(4 * degrees)}°` }];
}

function toldSquare({ traces: [trace] }: Seen, language: Language): string {
  if (!trace) return '';
  const degrees = angleOf(trace);
  const isAlike = degrees % 90 === 0;
  const now = inWords(language, `The square and its arrow are turned by ${whole(degrees)}°, the four-fold arrow by ${whole(4 * degrees)}°.`, `正方形と矢印は${whole(degrees)}°、四倍角の矢印は${whole(4 * degrees)}°回っています。`);
  const alike = isAlike
    ? inWords(language, 'The square looks as at 0°, wells and all, and the four-fold arrow is where it was.', '正方形は井戸も含めて0°のときと同じに見え、四倍角の矢印も元の位置にあります。')
    : inWords(language, 'The square does not look as at 0°, and the four-fold arrow is elsewhere, too.', '正方形は0°のときとは違って見え、四倍角の矢印も別の位置にあります。');
  const arrow = isAlike && degrees !== 0 ? inWords(language, 'The plain arrow is not.', 'ふつうの矢印は違います。') : '';
  const hint = isAlike && degrees !== 0 ? inWords(language, 'Try 45°, too.', '45°でも試してみてください。') : inWords(language, 'Turn it on to 90°.', '90°まで回してみてください。');
  return joined(language, now, alike, arrow, hint);
}

// A road.

/** The middle half of the road. */
const MIDDLE_HALF = 0.225;

/** A sum below this share of its terms' lengths points nowhere. */
const NOWHERE = 0.02;

const isInMiddle = ([x = 0]: readonly number[]): boolean => Math.abs(x - 0.5) <= MIDDLE_HALF;

function wayOf([x, y]: readonly [number, number], share: number, language: Language): string {
  if (share < 0.0005) return inWords(language, 'it points nowhere', 'どこも向きません');
  return Math.abs(x) > Math.abs(y) ? inWords(language, 'it points along the road', '道に沿う向きです') : inWords(language, 'it points across the road', '道を横切る向きです');
}

function toldRoad(hint: { readonly en: string; readonly ja: string }) {
  return ({ traces: [trace], at }: Seen, language: Language): string => {
    if (!trace) return '';
    const { printed, share } = trace.directions.terms(at);
    const { degrees, certainty } = standsAt(trace, at);
    const [x, y] = [number(at[0] ?? 0, 3), number(at[1] ?? 0, 3)];
    const count = Number(trace.value('pieces'));
    const cut = count > 1 ? inWords(language, `The upper side is cut into ${count} pieces.`, `上の辺は${count}個に切ってあります。`) : '';
    const sum = inWords(language, `At (${x}, ${y}) the printed sum has ${number(share, 3)} of its terms’ lengths: ${wayOf(printed, share, language)}.`, `点(${x}, ${y})で、論文の式による和は各項の長さの合計の${number(share, 3)}で、${wayOf(printed, share, language)}。`);
    const ours = inWords(language, `The four-fold sum has ${number(certainty, 3)}: squares stand at ${whole(degrees)}°.`, `四倍角の和は${number(certainty, 3)}で、正方形の向きは${whole(degrees)}°です。`);
    return joined(language, cut, sum, ours, hint[language]);
  };
}

const shareNote = ({ traces: [trace], at }: Seen, language: Language): string => (trace ? inWords(language, `sum ${number(trace.directions.terms(at).share, 3)}`, `和 ${number(trace.directions.terms(at).share, 3)}`) : '');

const certaintyNote = ({ traces: [trace], at }: Seen, language: Language): string => (trace ? inWords(language, `certainty ${number(standsAt(trace, at).certainty, 3)}`, `確かさ ${number(standsAt(trace, at).certainty, 3)}`) : '');

const ROAD_PLATES: readonly Plate[] = [
  { draw: 'arrows', packing: 0, title: { en: 'As printed', ja: '論文の式' }, note: shareNote },
  { draw: 'four-fold', packing: 0, title: { en: 'At four times the angle', ja: '角度を四倍して' }, note: certaintyNote },
];

const isRoad = (trace: Trace): boolean => trace.value('outline') === 'polygon' && trace.value('kind') === 'square' && trace.points('poly').length >= 4 && trace.points('poly').length <= 13;

const middle: Ask = {
  key: 'middle',
  answers: { a: { en: 'it points along the road', ja: '道に沿う' }, b: { en: 'it points across the road', ja: '道を横切る' }, c: { en: 'it points nowhere', ja: 'どこも向かない' } },
  ...sentence<[left: string, certainty: string, isRest: boolean]>(
    ({ traces: [trace], at }) => {
      if (!trace || !isInMiddle(at)) return undefined;
      const { printed, share } = trace.directions.terms(at);
      if (share >= NOWHERE) return undefined;
      return [number(share, 3), number(standsAt(trace, at).certainty, 2), share >= 0.0005 && Math.abs(printed[1]) > Math.abs(printed[0])];
    },
    [['0.000', '0.00', true]],
    (language, left, certainty, isRest) =>
      joined(
        language,
        isRest
          ? inWords(language, `In the middle ${left} of the arrows’ lengths is left, next to nothing. The small rest comes from the ends and points across.`, `真ん中では、矢印の長さの合計の${left}しか残りません。わずかな残りは両端の分で、道を横切る向きです。`)
          : inWords(language, `In the middle ${left} of the arrows’ lengths is left: the sum points nowhere.`, `真ん中では、矢印の長さの合計の${left}しか残らず、和はどこも向きません。`),
        inWords(language, `Its four-fold neighbour has certainty ${certainty}, along the road.`, `四倍角の和は確かさ${certainty}で、道に沿っています。`),
      ),
  ),
};

const MOST_PIECES = 10;

const pieces: Ask = {
  key: 'pieces',
  answers: { a: { en: 'neither changes', ja: 'どちらも変わらない' }, b: { en: 'the printed one changes', ja: '論文の式による和' }, c: { en: 'both change', ja: '両方' } },
  ...sentence<[before: string, now: string, turn: string, printed: readonly [number, number]]>(
    ({ traces: [trace, uncut], at }) => {
      if (!trace || !uncut || Number(trace.value('pieces')) !== MOST_PIECES || !isInMiddle(at)) return undefined;
      const left = (one: Trace): string => number(one.directions.terms(at).share, 2);
      const turn = Math.abs(asSquare(standsAt(trace, at).degrees - standsAt(uncut, at).degrees));
      return [left(uncut), left(trace), number(turn, 1), trace.directions.terms(at).printed];
    },
    [['0.00', '0.00', '00.0', [1, 0]], ['0.00', '0.00', '00.0', [0, 1]]],
    (language, before, now, turn, printed) =>
      inWords(
        language,
        `The same shape, and yet the printed sum went from ${before} to ${now} of its arrows’ lengths: ${wayOf(printed, 1, language)}. The four-fold direction changed by ${turn}°.`,
        `形は同じなのに、論文の式による和は、矢印の長さの合計の${before}から${now}になり、${wayOf(printed, 1, language)}。四倍角の向きの変化は${turn}°です。`,
      ),
  ),
};

// A walk.

/** The count of a whole walk; `undefined` if it leaves the outline. */
const countOf = (trace: Trace, at: readonly number[]): number | undefined => trace.directions.walk(at).at(-1)?.quarters;

const surrounds = (trace: Trace, [x = 0, y = 0, radius = 0]: readonly number[]): boolean => trace.directions.singular().every(({ place }) => Math.hypot(place[0] - x, place[1] - y) < radius);

const turns: Ask = {
  key: 'turns',
  answers: { a: { en: 'it would not turn', ja: '0回' }, b: { en: 'it would turn by one quarter', ja: '1回' }, c: { en: 'it would turn by four quarters', ja: '4回' } },
  ...sentence<[]>(
    ({ traces: [trace], at, step }) => {
      const isWhole = trace && step === STEPS && trace.value('outline') === 'polygon' && surrounds(trace, at);
      return isWhole && countOf(trace, at) === 4 ? [] : undefined;
    },
    [[]],
    (language) =>
      inWords(language, 'At the end the cross has turned by 360°: four quarter turns. All singular points together count four: index 1.', '一周すると、十字は360°、つまり90°を4回分回りました。特異点は合わせて4回分、指数は1です。'),
  ),
};

/** The quarter turns around all that is singular in the fork, which has six square corners. */
const ALL_IN_FORK = -2;

const fork: Ask = {
  key: 'fork',
  answers: {},
  ...sentence<[count: number]>(
    ({ traces: [trace], at, step }) => {
      const count = trace && step === STEPS ? countOf(trace, at) : undefined;
      return count ? [Math.round(count)] : undefined;
    },
    [[-2], [-1]],
    (language, count) =>
      count === ALL_IN_FORK
        ? inWords(language, 'Done: −2, two quarter turns against the walk. 4 − 6 = −2: all there is.', 'できました。−2回、道筋と逆に90°を2回分です。4 − 6 = −2で、これがすべてです。')
        : inWords(
            language,
            `Done: ${whole(count)}, as the walk divides what lies in the middle. 4 − 6 = −2: a walk around all of it counts two quarter turns against it.`,
            `できました。${whole(count)}回です。道筋が真ん中を分けているからです。4 − 6 = −2ですから、全体を囲む道筋なら、逆向きに90°を2回分数えます。`,
          ),
  ),
};

const leastOf = (trace: Trace, at: readonly number[]): number => Math.min(...trace.directions.walk(at).map(({ certainty }) => certainty));

function toldWalk({ traces: [trace], at, step }: Seen, language: Language): string {
  if (!trace) return '';
  const [x, y, radius] = at.map((value) => number(value, 3));
  const way = inWords(language, `A walk round (${x ?? ''}, ${y ?? ''}) with radius ${radius ?? ''}.`, `中心(${x ?? ''}, ${y ?? ''})、半径${radius ?? ''}の道筋です。`);
  const now = trace.directions.walk(at)[step];
  if (!now) return joined(language, way, inWords(language, 'It leaves the outline, or runs over a singular point: it counts nothing.', '輪郭の外に出るか、特異点の上を通るので、数えません。'), inWords(language, 'Move it inside.', '内側へ動かしてください。'));
  const turned = inWords(language, `After ${whole((360 * step) / STEPS)}° the cross has turned by ${number(90 * now.quarters, 0)}°, ${quarterTurns(now.quarters, language)}.`, `${whole((360 * step) / STEPS)}°進んで、十字は${number(90 * now.quarters, 0)}°（${quarterTurns(now.quarters, language)}）回りました。`);
  const least = inWords(language, `The certainty on it is at least ${number(leastOf(trace, at), 3)}.`, `途中の確かさは${number(leastOf(trace, at), 3)}以上です。`);
  return joined(language, way, turned, least, Number(at[2]) < WALK_RADIUS.to ? inWords(language, 'Move it, or make it larger.', '動かすか、大きくしてみてください。') : inWords(language, 'Move it, or make it smaller.', '動かすか、小さくしてみてください。'));
}

const turnedNote = ({ traces: [trace], at, step }: Seen, language: Language): string => {
  const now = trace?.directions.walk(at)[step];
  return now ? quarterTurns(now.quarters, language) : inWords(language, 'no count', '数えない');
};

/** The number of singular points, once the question on them is answered, if there is one. */
const countedNote = (after?: string) => ({ traces: [trace], answered }: Seen, language: Language): string => {
  if (after !== undefined && !answered.has(after)) return '';
  const count = trace?.directions.singular().length ?? 0;
  return inWords(language, `${count} singular ${count === 1 ? 'point' : 'points'} ◆`, `特異点 ◆ ${count}個`);
};

const walkPlates = (ground: string, after?: string): readonly Plate[] => [
  { draw: 'walk', packing: 0, ground, ...(after === undefined ? {} : { after }), title: { en: 'A walk', ja: '道筋' }, note: countedNote(after) },
  { draw: 'turns', packing: 0, title: { en: 'The cross has turned by', ja: '十字の回った角度' }, note: turnedNote },
];

const reached = (share: number): Stop['find'] => () => STEPS * share;

const WALK_STOPS: readonly Stop[] = [
  { key: 'start', name: { en: 'Start', ja: '出発' }, find: reached(0) },
  { key: 'quarter', name: { en: 'A quarter', ja: '四分の一' }, find: reached(0.25) },
  { key: 'half', name: { en: 'Half', ja: '半周' }, find: reached(0.5) },
  { key: 'end', name: { en: 'Once around', ja: '一周' }, find: reached(1) },
];

const WALK = { packings: [{}], last: STEPS, opens: STEPS, steps: 'walk', across: 18, stops: WALK_STOPS, told: toldWalk } as const;

// Two strokes.

/** Half the way from one stroke to the other. */
const HALFWAY = [0.5, 0.5];

const bothAngles = (trace: Trace): readonly [number, number] => [angleIn(trace.points('strokes'), 0), angleIn(trace.points('strokes'), 1)];

const halfway: Ask = {
  key: 'halfway',
  answers: { a: { en: 'squares stand at 45°', ja: '45°' }, b: { en: 'squares stand at 0°, which is also 90°', ja: '0°（90°でも同じ）' }, c: { en: 'squares stand in any direction', ja: '決まらない' } },
  ...sentence<[degrees: string, small: number, large: number, certainty: string]>(
    ({ traces: [trace] }) => {
      if (!trace) return undefined;
      const [one, other] = bothAngles(trace);
      const { degrees, certainty } = standsAt(trace, HALFWAY);
      const apart = Math.abs(one - other);
      return apart < 60 || apart > 80 || Math.abs(degrees) > 3 ? undefined : [number(degrees, 1), Math.min(one, other), Math.max(one, other), number(certainty, 2)];
    },
    [['−0.0', 10, 88, '0.00']],
    (language, degrees, small, large, certainty) => {
      const [alike, mean] = [whole(large - 90), meanOf(small, large - 90)];
      return inWords(
        language,
        `To a square ${large}° is ${alike}°, and the mean of ${small}° and ${alike}° is ${mean}°. So halfway squares stand at ${degrees}°, with certainty ${certainty}.`,
        `正方形にとって${large}°は${alike}°と同じで、${small}°と${alike}°の平均は${mean}°です。だから中間の正方形の向きは${degrees}°、確かさは${certainty}です。`,
      );
    },
  ),
};

/** The mean of two whole angles, with its half if it has one. */
const meanOf = (one: number, other: number): string => number((one + other) / 2, (one + other) % 2 ? 1 : 0);

function toldStrokes({ traces: [trace] }: Seen, language: Language): string {
  if (!trace) return '';
  const [one, other] = bothAngles(trace);
  const { degrees, certainty } = standsAt(trace, HALFWAY);
  const strokes = inWords(language, `The lower stroke is at ${one}°, the upper one at ${other}°; their mean as numbers is ${number((one + other) / 2, 1)}°.`, `下の線は${one}°、上の線は${other}°で、数としての平均は${number((one + other) / 2, 1)}°です。`);
  const stand = inWords(language, `Halfway squares stand at ${number(degrees, 1)}°, with certainty ${number(certainty, 2)}.`, `中間で正方形の向きは${number(degrees, 1)}°、確かさは${number(certainty, 2)}です。`);
  const unsure = certainty < 0.1 ? inWords(language, 'That is hardly decided: the strokes are 45° apart.', 'ほとんど決まりません。二本の線は45°離れています。') : '';
  return joined(language, strokes, stand, unsure, inWords(language, 'Turn a stroke.', '線を回してみてください。'));
}

/** The strokes at four times their angles, and the sum halfway, as long as it is certain. */
function strokeHands({ traces: [trace] }: Seen, language: Language): Hand[] {
  if (!trace) return [];
  const terms = bothAngles(trace).map((degrees): Hand => ({ degrees: 4 * degrees, length: 1, kind: 'term', name: `4 × ${degrees}°` }));
  const { degrees, certainty } = standsAt(trace, HALFWAY);
  return [...terms, { degrees: 4 * degrees, length: certainty, kind: 'sum', name: `${inWords(language, 'sum', '和')}: 4 × ${number(degrees, 1)}° = ${whole(4 * degrees)}°` }];
}

const halfwayNote = ({ traces: [trace] }: Seen, language: Language): string => (trace ? inWords(language, `halfway ${number(standsAt(trace, HALFWAY).degrees, 1)}°`, `中間 ${number(standsAt(trace, HALFWAY).degrees, 1)}°`) : '');

const sureNote = ({ traces: [trace] }: Seen, language: Language): string => (trace ? inWords(language, `certainty ${number(standsAt(trace, HALFWAY).certainty, 2)}`, `確かさ ${number(standsAt(trace, HALFWAY).certainty, 2)}`) : '');

export const WHICH_WAY: readonly Figure[] = [
  {
    ...OF_FIELDS, name: 'quarter', fits: (trace) => trace.value('kind') === 'square' && trace.value('dir') === 'constant' && trace.value('cs') === '64' && trace.side === 256, at: [], hasLandscape: true,
    recipe: 'outline=square&size=256&kind=square&dir=constant&cs=64&edge=open&pop=off&given=0.5,0.5,1&angle=30',
    plates: [
      { draw: 'turned', packing: 0, ground: 'quarter', title: { en: 'A square with its wells', ja: '正方形と井戸' }, note: ({ traces: [trace] }) => (trace ? `${whole(angleOf(trace))}°` : '') },
      { draw: 'dial', packing: 0, hands: fourFold, title: { en: 'Its four-fold arrow', ja: '四倍角の矢印' }, note: ({ traces: [trace] }) => (trace ? `${whole(4 * angleOf(trace))}°` : '') },
    ],
    handles: [ANGLE], told: toldSquare,
  },
  {
    ...OF_FIELDS, name: 'road', fits: isRoad, at: [0.5, 0.455], recipe: `outline=polygon&size=256&kind=square&poly=${roadOf(1)}`, across: 20, plates: ROAD_PLATES, handles: [IN_ROAD], more: [POWER], asks: [middle],
    told: toldRoad({ en: 'Move the point to the middle of the road, and along it.', ja: '点を道の真ん中へ、さらに道に沿って動かしてください。' }),
  },
  {
    ...OF_FIELDS, name: 'pieces', fits: isRoad, at: [0.5, 0.5], recipe: `outline=polygon&size=256&kind=square&poly=${roadOf(1)}`, packings: [{}, { poly: roadOf(1) }], across: 20, plates: ROAD_PLATES, handles: [IN_ROAD, PIECES], more: [POWER], asks: [pieces],
    told: toldRoad({ en: 'Cut the upper side, or move the point.', ja: '上の辺を切るか、点を動かしてください。' }),
  },
  {
    ...WALK, name: 'walk', fits: (trace) => OUTLINE.choices.some(({ word }) => word === trace.value('outline')) && trace.value('kind') === 'square', at: [0.7, 0.5, 0.1], recipe: `outline=polygon&size=256&kind=square&poly=${ROUND}`,
    plates: walkPlates('walk', turns.key), handles: [CENTRE, WALK_RADIUS, OUTLINE], more: [HEIGHT], asks: [turns],
  },
  {
    ...OF_FIELDS, name: 'halfway', fits: (trace) => trace.points('strokes').length === 4 && trace.value('dir') === 'strokes' && trace.value('kind') === 'square', at: [], recipe: `outline=square&size=256&kind=square&dir=strokes&strokes=${strokesAt(10, 30)}`, across: 18,
    plates: [
      { draw: 'strokes', packing: 0, title: { en: 'Between two strokes', ja: '二本の線の間' }, note: halfwayNote },
      { draw: 'dial', packing: 0, hands: strokeHands, title: { en: 'At four times the angle', ja: '角度を四倍して' }, note: sureNote },
    ],
    handles: STROKES, asks: [halfway], told: toldStrokes,
  },
  {
    ...WALK, name: 'fork', fits: (trace) => trace.value('outline') === 'y_fork' && trace.value('kind') === 'square', at: [0.5, 0.72, 0.08], recipe: 'outline=y_fork&size=256&kind=square',
    plates: walkPlates('fork'), handles: [CENTRE, WALK_RADIUS], more: [], asks: [fork],
  },
];
