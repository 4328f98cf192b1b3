/** Numbers and sentences that the figures of all chapters share. */
import type { Ask, ChoiceHandle, Language, Moment, NumberHandle, Seen, Stop, Words } from './figure';
import { REACH, start } from './rules';

/** A number with a true minus. */
export function number(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}

/** A number of quarter turns; hundredths only where it is not whole. */
export const inQuarters = (value: number): string => number(value, Math.abs(value - Math.round(value)) < 0.005 ? 0 : 2);

/** The sentence in a language. */
export const inWords = (language: Language, en: string, ja: string): string => (language === 'ja' ? ja : en);

/** The sentence of a question: how its values are read from what is seen, the widest values that there can be, and its words. */
export function sentence<Values extends readonly unknown[]>(read: (seen: Seen) => Values | undefined, widest: readonly Values[], says: (language: Language, ...values: Values) => string): Pick<Ask, 'seen' | 'longest'> {
  return {
    seen: (seen, language) => {
      const values = read(seen);
      return values && says(language, ...values);
    },
    longest: (language) => widest.map((values) => says(language, ...values)),
  };
}

/** The answer that was chosen, which comes before what happened; '' without one. */
export function expected({ answers }: Ask, value: string, language: Language): string {
  const answer = answers[value]?.[language];
  return answer ? inWords(language, `You expected that ${answer}. `, `あなたの予想は「${answer}」。`) : '';
}

const LENGTH: Words = { en: 'stable distances', ja: '安定距離' };
const NONE: Words = { en: '', ja: '' };

/** Two bubbles cannot be given one place. */
export const DISTANCE: NumberHandle = {
  kind: 'number', key: 'w', symbol: 'w', name: { en: 'Distance', ja: '距離' }, unit: LENGTH,
  from: 0.01, to: 2.2, stride: 0.01, fine: 0.001, coarse: 0.1, digits: 3, plates: [0, 1],
};

export const MARK: NumberHandle = {
  kind: 'number', key: 'mark', symbol: '', name: { en: 'Your mark', ja: 'あなたの印' }, unit: LENGTH,
  from: 0, to: 1.5, stride: 0.01, fine: 0.001, coarse: 0.1, digits: 3, plates: [1],
};

export const HELD: ChoiceHandle = {
  kind: 'choice', key: 'held', name: { en: 'Left bubble', ja: '左のバブル' },
  choices: [{ word: '1', name: { en: 'held', ja: '留める' } }, { word: '0', name: { en: 'free', ja: '自由' } }],
};

export const DAMPING: NumberHandle = {
  kind: 'number', key: 'damp', symbol: 'c', name: { en: 'Damping', ja: '減衰' }, unit: { en: 'in √(m k₀) / l₀', ja: '√(m k₀) / l₀' },
  from: 0, to: 4, stride: 0.05, fine: 0.05, coarse: 0.5, digits: 2,
};

export const MASS: NumberHandle = {
  kind: 'number', key: 'mass', symbol: 'm', name: { en: 'Mass', ja: '質量' }, unit: NONE,
  from: 0.1, to: 10, stride: 0.1, fine: 0.1, coarse: 1, digits: 1,
};

export const STIFFNESS: NumberHandle = {
  kind: 'number', key: 'stiff', symbol: 'k₀', name: { en: 'Stiffness', ja: 'ばね定数' }, unit: NONE,
  from: 0.1, to: 10, stride: 0.1, fine: 0.1, coarse: 1, digits: 1,
};

export const TIME_STEP: NumberHandle = {
  kind: 'number', key: 'dt', symbol: 'Δt', name: { en: 'Time step', ja: '時間刻み' }, unit: { en: 'in l₀ √(m / k₀)', ja: 'l₀ √(m / k₀)' },
  from: 0.01, to: 2, stride: 0.05, fine: 0.01, coarse: 0.2, digits: 2,
};

export const INTEGRATOR: ChoiceHandle = {
  kind: 'choice', key: 'move', name: { en: 'Integrator', ja: '積分法' },
  choices: [
    { word: 'rk4', name: { en: 'Runge–Kutta', ja: 'ルンゲ・クッタ' } },
    { word: 'semi', name: { en: 'semi-implicit', ja: '半陰的' } },
    { word: 'euler', name: { en: 'explicit Euler', ja: '陽的オイラー' } },
  ],
};

export const START: Stop = { key: 'start', name: { en: 'Start', ja: '開始' }, find: start };

export function joined(language: Language, ...sentences: string[]): string {
  return sentences.filter(Boolean).join(language === 'ja' ? '' : ' ');
}

/** Whether the two push, pull or leave each other alone. */
export function way({ force }: Moment): 'push' | 'pull' | 'none' {
  return Math.abs(force) < 5e-4 ? 'none' : force > 0 ? 'push' : 'pull';
}

/** The distance and the force of a moment, as a sentence. */
export function stands(moment: Moment, language: Language): string {
  const [w, force, kind] = [number(moment.w, 3), number(Math.abs(moment.force), 3), way(moment)];
  if (language === 'ja') {
    const now = kind === 'push' ? `${force}の力で押し合っています` : kind === 'pull' ? `${force}の力で引き合っています` : moment.w >= REACH ? '遠すぎて力は働きません' : '力は0です';
    return `距離はw = ${w}。${now}。`;
  }
  const now = kind === 'push' ? `they push each other with ${force}` : kind === 'pull' ? `they pull each other with ${force}` : moment.w >= REACH ? 'they are too far apart: no force' : 'no force';
  return `Distance w = ${w}: ${now}.`;
}

/** How the distance changes, as a sentence. */
export function moves({ speed }: Moment, language: Language): string {
  const text = number(Math.abs(speed), 3);
  if (Math.abs(speed) < 5e-4) return language === 'ja' ? '止まっています。' : 'They are still.';
  if (language === 'ja') return `速さ${text}で${speed > 0 ? '離れていきます' : '近づいていきます'}。`;
  return speed > 0 ? `They move apart at ${text}.` : `They come nearer at ${text}.`;
}
