/**
 * The figures of the chapter "How many?" (Miyata, Itoh and Shimada, A Method for Generating Pavement Textures Using the Square
 * Packing Technique, 2000, section 4.3; Itoh, Miyata and Shimada, Generating Organic Textures with Controlled Anisotropy and
 * Directionality, 2003, section 5.1). All cells are round. A look at the population comes every ten steps, or as soon as all is
 * nearly still, up to step 100.
 */
import { AT_REST, lastOf, ofAll, OVER, restOf } from './crowds';
import type { Ask, Figure, Language, Plate, Seen, Stop, Trace } from './figure';
import { areAtRest, changesUpTo, isAtRest, leastRange, looksOf, looksUpTo, numberAt, restless } from './population';
import { start } from './rules';
import { AT_START, CELL_SIZE, CROWDED, LONELY, ROOM, RULE } from './how-many-handles';
import { inWords, number, sentence } from './words';

const ROUND = 'outline=polygon&size=256&kind=circle&damp=1';

/** A square outline with cells at random places. */
const IN_SQUARE = `${ROUND}&poly=0.05,0.05,0.95,0.05,0.95,0.95,0.05,0.95&cs=40&start=random`;

/** A honeycomb of 37 cells at rest in a hexagon, less one. */
const HONEYCOMB = `${ROUND}&poly=uh8BgggB3gOmpYrhcA3gOlpY4gOlpYshcA&cs=32&crowd=0.74&given=svIgggBA.q9Dq5GA.y9Do5GA.y9Dq5GA.j7HllbA.y9Dq5GA.y9Dq5GA.q9Do5GA.q9Dq5GA.l4Lt-hBA.y9Do5GA.q9Dq5GA.q9Dq5GA.y9Do5GA.y9Dq5GA.31P33oBA.q9Dq5GA.q9Do5GA.y9Dq5GA.y9Dq5GA.q9Do5GA.q9Dq5GA.31P33oBA.y9Dq5GA.y9Do5GA.06H0yNA.y9Do5GA.l4Lt-hBA.q9Dq5GA.q9Do5GA.y9Dq5GA.y9Dq5GA.j7HllbA.y9Dq5GA.y9Do5GA.q9Dq5GA`;

/** Outlines of the same area, 0.305 of the picture. */
const U_SHAPE = 'kgJkgJw3KAAoojB4wYAAnojBw3KAA4_tB3_tBA';
const L_SHAPE = '4oF4oF0rNAA8ioB8ioBAA0rNvu1BA';
const STAR = 'gggBkmEqkI2xTujVi2B1iQ-4Nq9EizUriSphLriSqhLq9EhzU1iQ94NujVh2B';
const SQUARE = 'qqOqqOsrjBAAsrjBrrjBA';

/** Round cells, few enough to be packed quickly. */
const isSmall = ({ points, value }: Trace): boolean =>
  value('kind') === 'circle' && value('outline') === 'polygon' && Number(value('size')) <= 256 && Number(value('cs')) >= 22 && Number(value('count')) <= 100 && points('given').length <= 60;

/** The steps of the first and of the last look that changes the population, and the step before the first one. */
const firstLook = (trace: Trace): number | undefined => looksOf(trace)[0]?.step;
const lastLook = (trace: Trace): number | undefined => looksOf(trace).at(-1)?.step;
const beforeLook = (trace: Trace): number | undefined => (firstLook(trace) ?? 0) - 1;

/** The earliest of the steps that the packings have. */
const ofAny = (find: (trace: Trace) => number | undefined): Stop['find'] => (traces) => {
  const steps = traces.flatMap((trace) => find(trace) ?? []).filter((step) => step >= 0);
  return steps.length ? Math.min(...steps) : undefined;
};

const START: Stop = { key: 'start', name: { en: 'Start', ja: '開始' }, find: start };
const BEFORE: Stop = { key: 'before', name: { en: 'Before the first look', ja: '最初の調査の前' }, find: ofAny(beforeLook) };
const LOOK: Stop = { key: 'look', name: { en: 'First look', ja: '最初の調査' }, find: ofAny(firstLook) };
const LAST_LOOK: Stop = { key: 'last-look', name: { en: 'Last change', ja: '最後の増減' }, find: ofAll(lastLook) };
const STOPS = [START, BEFORE, LOOK, LAST_LOOK, AT_REST, OVER];

const sentences = (language: Language, ...all: readonly string[]): string => all.filter(Boolean).join(language === 'ja' ? '' : ' ');

/** The number of cells, and who came and went so far. */
function counted(trace: Trace, step: number, language: Language): string {
  const [now, first] = [numberAt(trace, step), numberAt(trace, 0)];
  const { came, went } = changesUpTo(trace, step);
  return language === 'ja' ? `開始時${first}個、増えた${came}個、去った${went}個、いま${now}個` : `${first} at the start, ${came} came, ${went} went: ${now} now`;
}

const note = (packing: number): NonNullable<Plate['note']> => ({ traces, step }, language) => {
  const trace = traces[packing];
  const count = trace ? numberAt(trace, step) : 0;
  return language === 'ja' ? `${count}個` : `${count} cells`;
};

/** A plate of cells with a strip of its looks. */
const cells = (packing: number, en: string, ja: string, isAhead = false): Plate => ({ draw: 'population', packing, title: { en, ja }, note: note(packing), isAhead });

/**
 * Whether a number at the start is too small or too large, by all of its run; '' if that tells neither, as it does not rest
 * and cells both came and went.
 */
function verdict(trace: Trace, language: Language): string {
  const { came, went } = changesUpTo(trace, lastOf(trace) ?? 0);
  const [missing, rests] = [came - went, restOf(trace) !== undefined];
  if (!rests && (came > 0) === (went > 0)) return '';
  if (missing === 0) return inWords(language, ', just right', '、ちょうどよい');
  return missing > 0 ? inWords(language, ', too few', '、少なすぎる') : inWords(language, ', too many', '、多すぎる');
}

/** How many cells a run began with, whether they were too few or too many, and how many there are. */
const startNote = (packing: number): NonNullable<Plate['note']> => ({ traces, step }, language) => {
  const trace = traces[packing];
  if (!trace) return '';
  const [first, now] = [numberAt(trace, 0), numberAt(trace, step)];
  return inWords(language, `${first} at first${verdict(trace, language)}; now ${now}`, `初め${first}個${verdict(trace, language)}。いま${now}個`);
};

/** A plate of cells whose note tells how well its run began. */
const started = (packing: number, en: string, ja: string): Plate => ({ ...cells(packing, en, ja, true), note: startNote(packing) });

function toldCrowded(seen: Seen, language: Language): string {
  const { traces, step } = seen;
  const names = language === 'ja' ? ['一つ目：', '二つ目：'] : ['First: ', 'Second: '];
  const rows = traces.map((trace, k) => `${names[k] ?? ''}${counted(trace, step, language)}${language === 'ja' ? '。' : '.'}`);
  return sentences(language, ...rows, hintOnBoth(seen, language));
}

function hintOnBoth(seen: Seen, language: Language): string {
  if (areAtRest(seen)) return inWords(language, 'Both are at rest. Try another number at the start.', 'どちらも静止しました。個数を変えて試してください。');
  const isOver = seen.step >= Math.max(...seen.traces.map((trace) => lastOf(trace) ?? Infinity));
  if (isOver) return inWords(language, 'They have not come to rest. Try other thresholds.', '静止しないまま終わりました。しきい値を変えて試してください。');
  return inWords(language, 'Go from stop to stop and watch both lines come together.', '見どころを順に見て、二つの線が近づくのを確かめてください。');
}

/** A value at which the papers' rule brings cells, with room or without. */
const LOWER = 0.97;

function hintAtHole(papers: Trace, step: number, language: Language): string {
  if (step < 10) return inWords(language, 'Go on to the end.', '最後まで進めてみてください。');
  if (Number(papers.value('room')) > LOWER) return inWords(language, `Try a value of ${LOWER} for the papers’ rule.`, `論文の値を${LOWER}に下げるとどうなるでしょう。`);
  if (papers.value('pop') === 'opposite') return inWords(language, 'By the papers’ rule they come with room or without.', '論文の規則では、空きがあってもなくても増えます。');
  return changesUpTo(papers, step).came > 0 ? '' : inWords(language, 'By the papers’ rule no place has room.', '論文の規則で調べる場所に、空きはありません。');
}

function toldHole({ traces, step }: Seen, language: Language): string {
  const [papers, ours] = traces;
  if (!papers || !ours) return '';
  const [least, most] = (leastRange(papers, step) ?? []).map((w) => number(w, 3));
  const room = number(Number(papers.value('room')), 2);
  const counts = traces.map((trace) => numberAt(trace, step));
  const hint = hintAtHole(papers, step, language);
  if (language === 'ja') {
    return `論文の規則：${counts[0] ?? 0}個。最も近い隣までのwは${least ?? ''}から${most ?? ''}で、${room}以上のセルのそばにだけ増えます。本プログラムの規則：${counts[1] ?? 0}個。空いた場所を探します。${hint}`;
  }
  return `The papers’ rule: ${counts[0] ?? 0} cells, each with its nearest neighbour at w = ${least ?? ''} to ${most ?? ''}; only from ${room} on a cell comes beside it. Our rule: ${counts[1] ?? 0} cells; it looks for the empty place itself. ${hint}`;
}

const hole: Ask = {
  key: 'hole',
  answers: { a: { en: 'one comes', ja: '一つ増える' }, b: { en: 'none comes', ja: '増えない' } },
  ...sentence<[theirs: number, own: number, most: string]>(
    (seen) => {
      const [papers, ours] = seen.traces;
      if (!papers || !ours || !areAtRest(seen) || changesUpTo(papers, seen.step).came > 0) return undefined;
      return [numberAt(papers, seen.step), numberAt(ours, seen.step), number(leastRange(papers, seen.step)?.[1] ?? 0, 3)];
    },
    [[10, 10, '0.000']],
    (language, theirs, own, most) =>
      inWords(
        language,
        `Both are at rest: ${theirs} cells by the papers’ rule, ${own} by ours. The cells around the hole touch others on their far side. No nearest neighbour is beyond w = ${most}, so no cell counts as far from its nearest.`,
        `両方とも静止しました。論文の規則では${theirs}個のまま、本プログラムの規則では${own}個です。穴のまわりのセルにも反対側に隣がいて、最も近い隣までのwは最大で${most}です。どのセルも「遠い」とは言えません。`,
      ),
  ),
};

function toldNever({ traces: [trace], step }: Seen, language: Language): string {
  if (!trace) return '';
  const [crowd, room] = ['crowd', 'room'].map((key) => number(Number(trace.value(key)), 2));
  const [least, most] = (leastRange(trace, step) ?? []).map((w) => number(w, 3));
  const look = looksUpTo(trace, step).at(-1);
  const isCrossed = Number(trace.value('crowd')) > Number(trace.value('room'));
  const rests = isAtRest(trace, step);
  const ends = step >= (lastOf(trace) ?? Infinity);
  if (language === 'ja') {
    const last = look ? `ステップ${look.step}の調査で${look.came.length}個増え、${look.went.length}個去りました。` : '';
    const hint = isCrossed ? 'しきい値が逆転しています。調査のたびに何が起きるか見てください。' : rests ? '静止しました。しきい値を逆転させてみてください。' : ends ? '静止しないまま終わりました。' : '最後まで進めてみてください。';
    return `${numberAt(trace, step)}個。最も近い隣までのwが${crowd ?? ''}未満なら去り、${room ?? ''}以上ならそばにもう一つ増えます。${least && most ? `いまは${least}から${most}です。` : 'いまはどれにも隣がありません。'}${last}${hint}`;
  }
  const last = look ? `Step ${look.step}: ${look.came.length} came, ${look.went.length} went.` : '';
  const hint = isCrossed ? 'The thresholds cross: watch each look.' : rests ? 'It is at rest. Let the thresholds cross.' : ends ? 'It has not come to rest.' : 'Go on to the end.';
  return sentences(language, `${numberAt(trace, step)} cells. A cell goes if its nearest neighbour is below w = ${crowd ?? ''}, and another comes beside it from ${room ?? ''} on; ${least && most ? `now it is ${least} to ${most}` : 'now none has a neighbour'}.`, last, hint);
}

const never: Ask = {
  key: 'never',
  answers: { a: { en: 'it rests after the first look', ja: '一度の調査で落ち着く' }, b: { en: 'it rests with more cells', ja: 'セルが増えて落ち着く' }, c: { en: 'cells come and go at every look', ja: '調査のたびに増えたり減ったりする' } },
  ...sentence<[looks: readonly (readonly [step: number, came: number, went: number])[], crowd: number, room: number]>(
    ({ traces: [trace], step }) => {
      const looks = trace && restless(trace, step);
      return looks && [looks.map((look) => [look.step, look.came.length, look.went.length]), Number(trace.value('crowd')), Number(trace.value('room'))];
    },
    [[[[10, 10, 10], [10, 10, 10]], 0.9, 0.8], [[[10, 10, 10], [10, 10, 10]], 0.8, 0.9]],
    (language, looks, crowd, room) => {
      const [below, from] = [number(crowd, 2), number(room, 2)];
      const isCrossed = crowd > room;
      if (language === 'ja') {
        const rows = looks.map(([step, came, went], k) => `${k ? '' : 'ステップ'}${step}で+${came}と−${went}`).join('、');
        const why = isCrossed ? `wが${from}から${below}のセルは、過密であり、しかも孤立してもいます。` : `静止したセルのwは${below}から${from}の間に収まりきりません。`;
        return `静止しませんでした。増減は${rows}でした。${why}調査がステップ100で終わるまで続きます。`;
      }
      const rows = looks.map(([step, came, went]) => `${came} came and ${went} went at step ${step}`).join(', ');
      const why = isCrossed ? `A cell between w = ${from} and ${below} is crowded and lonely at once.` : `The cells of a packing at rest do not all fit between w = ${below} and ${from}.`;
      return `It never rests: ${rows}. ${why} Only the end of all looks, at step 100, stops it.`;
    },
  ),
};

/** The area of the outline over the square of the size. */
function shareOf(trace: Trace): number {
  const points = trace.points('poly');
  const twice = points.reduce((sum, [x, y], k) => {
    const [a, b] = points[(k + 1) % points.length] ?? [0, 0];
    return sum + x * b - a * y;
  }, 0);
  const size = Number(trace.value('cs')) / trace.side;
  return Math.abs(twice) / 2 / (size * size);
}

const barsOf = (packing: number): NonNullable<Plate['bars']> => ({ traces, step }, language) => {
  const trace = traces[packing];
  if (!trace) return [];
  return [
    { name: language === 'ja' ? 'セルの個数' : 'cells', value: numberAt(trace, step), isMarked: true },
    { name: language === 'ja' ? '面積 / 大きさ²' : 'area / size²', value: shareOf(trace) },
  ];
};

function toldCount(seen: Seen, language: Language): string {
  const [one, other] = seen.traces;
  if (!one || !other) return '';
  const [left, right] = [numberAt(one, seen.step), numberAt(other, seen.step)];
  const [share, size] = [number(shareOf(one), 1), number(Number(one.value('cs')), 0)];
  const rest = areAtRest(seen);
  if (language === 'ja') return `面積は同じ、セルの大きさも同じ${size}です。輪郭には${left}個、正方形には${right}個入ります。面積を大きさの2乗で割ると、どちらも${share}です。${rest ? '大きさを変えてみてください。' : 'まだ静止していません。'}`;
  return `The same area, the same cell size of ${size}. The outline holds ${left} cells, the square ${right}; area over size squared is ${share} for both. ${rest ? 'Try another size.' : 'They are not yet at rest.'}`;
}

const count: Ask = {
  key: 'count',
  answers: { a: { en: 'both hold just as many', ja: '同じ数' }, b: { en: 'the U holds more', ja: '正方形より多い' }, c: { en: 'the U holds fewer', ja: '正方形より少ない' } },
  ...sentence<[size: string, left: number, right: number, share: string]>(
    (seen) => {
      const [one, other] = seen.traces;
      if (!one || !other || !areAtRest(seen) || one.value('poly') !== U_SHAPE) return undefined;
      const [left, right] = [numberAt(one, seen.step), numberAt(other, seen.step)];
      return left <= right ? undefined : [number(Number(one.value('cs')), 0), left, right, number(shareOf(one), 1)];
    },
    [['00', 10, 10, '00.0']],
    (language, size, left, right, share) =>
      inWords(
        language,
        `At size ${size} the U holds ${left}, the square ${right}; the formula says ${share} for both. Arms take whole rows of cells: as soon as one more row fits, the number jumps.`,
        `大きさ${size}ではU字形が${left}個、正方形が${right}個になりました。計算では、どちらも${share}です。細い腕に入るのは列まるごとです。もう一列入る大きさになると、個数は一度に増えます。`,
      ),
  ),
};

function toldRight({ traces: [trace], step }: Seen, language: Language): string {
  if (!trace) return '';
  const { came, went } = changesUpTo(trace, step);
  const rest = isAtRest(trace, step);
  const hint = !rest ? (language === 'ja' ? '静止するまで進めてください。' : 'Go on until it rests.') : came + went === 0 ? '' : language === 'ja' ? (came > went ? '少なすぎたようです。' : '多すぎたようです。') : came > went ? 'That was too few.' : 'That was too many.';
  return sentences(language, language === 'ja' ? `${counted(trace, step, language)}。` : `${counted(trace, step, language)}.`, hint);
}

/** The thresholds of the exercise, and its rule. Its question is on the number alone. */
const OF_EXERCISE = { crowd: 0.7, room: 0.7, pop: 'slots' } as const;

const isOfExercise = (trace: Trace): boolean => Number(trace.value('crowd')) === OF_EXERCISE.crowd && Number(trace.value('room')) === OF_EXERCISE.room && trace.value('pop') === OF_EXERCISE.pop;

const right: Ask = {
  key: 'right',
  answers: {},
  ...sentence<[all: number, step: number]>(
    ({ traces: [trace], step }) => (!trace || !isOfExercise(trace) || !isAtRest(trace, step) || trace.comings.length > 0 ? undefined : [numberAt(trace, step), lastOf(trace) ?? step]),
    [[10, 100]],
    (language, all, step) =>
      inWords(
        language,
        `Done: from ${all} cells nobody came and nobody went, and all were at rest at step ${step}. For most outlines nobody can say this number beforehand; so the program looks on the way.`,
        `できました。${all}個で始めると、一つも増えず、一つも減らずに、ステップ${step}で静止します。多くの輪郭では、この数を前もって言うことはできません。そこで調査が要るのです。`,
      ),
  ),
};

const base = { fits: isSmall, at: [], steps: 'step' } as const;

export const HOW_MANY: readonly Figure[] = [
  {
    ...base, name: 'crowded', recipe: `${IN_SQUARE}&seed=7&count=12&crowd=0.84&room=0.68`, packings: [{}, { count: '60' }], last: 100, opens: 29,
    plates: [started(0, 'First run', '一つ目の計算'), started(1, 'Second run', '二つ目の計算')],
    stops: STOPS, handles: [AT_START, CROWDED, ROOM], more: [], asks: [], told: toldCrowded,
  },
  {
    ...base, name: 'hole', recipe: `${HONEYCOMB}&pop=opposite&room=1.02`, packings: [{}, { pop: 'slots', room: '0.63' }], last: 100, opens: 9,
    plates: [{ ...cells(0, 'The papers’ rule: far from the nearest', '論文の規則：最も近い隣から遠い'), isAsked: true }, { ...cells(1, 'Our rule: an empty place', '本プログラムの規則：空いた場所'), isAsked: true }],
    stops: STOPS, handles: [LONELY, RULE], more: [], asks: [hole], told: toldHole,
  },
  {
    ...base, name: 'never', recipe: `${IN_SQUARE}&seed=7&count=34&pop=opposite&crowd=0.8&room=1.05&most=100`, packings: [{}], last: 100, opens: 100,
    plates: [cells(0, 'Cells', 'セル'), { draw: 'thresholds', packing: 0, title: { en: 'Each cell’s nearest neighbour', ja: '各セルの最も近い隣' } }],
    stops: STOPS, handles: [{ ...CROWDED, plates: [1] }, { ...LONELY, plates: [1] }, AT_START], more: [], asks: [never], told: toldNever,
  },
  {
    ...base, name: 'count', recipe: `${ROUND}&poly=${U_SHAPE}&cs=34`, packings: [{}, { poly: SQUARE }], last: 120, opens: 120,
    plates: [
      { draw: 'held', packing: 0, bars: barsOf(0), title: { en: 'One outline', ja: '一つの輪郭' }, note: note(0) },
      { draw: 'held', packing: 1, bars: barsOf(1), title: { en: 'A square of the same area', ja: '同じ面積の正方形' }, note: note(1) },
    ],
    stops: [START, AT_REST, OVER],
    handles: [CELL_SIZE, { kind: 'choice', key: 'poly', name: { en: 'Outline', ja: '輪郭' }, choices: [{ word: U_SHAPE, name: { en: 'U', ja: 'U字' } }, { word: L_SHAPE, name: { en: 'L', ja: 'L字' } }, { word: STAR, name: { en: 'star', ja: '星' } }] }],
    more: [], asks: [count], told: toldCount,
  },
  {
    ...base, name: 'right-number', recipe: `${IN_SQUARE}&seed=5&count=26&crowd=${OF_EXERCISE.crowd}&room=${OF_EXERCISE.room}`, packings: [{}], last: 100, opens: 100,
    plates: [cells(0, 'Choose the number', '個数を選ぶ')],
    stops: STOPS, handles: [AT_START], more: [], asks: [right], told: toldRight,
  },
];
