/** The Japanese for the first module's notices, and the way to put any notice together. */
import notices from 'virtual:notices-ja/words';
import type { NoticeArg } from '../module/types';
import type { Foreign, NoticeWords } from './foreign';

export { notices };

/** The text of a notice. */
export const said: Foreign['said'] = ({ code, args, text }, words) => words.notices[code]?.replace(/\{(\w+)\}/g, (_, name: string) => valueOf(args[name], words)) ?? text;

function valueOf(arg: NoticeArg | undefined, words: NoticeWords): string {
  if (arg === undefined || typeof arg === 'string') return arg ?? '';
  if (Array.isArray(arg)) return `${arg.map((one) => valueOf(one, words)).join('、')}のどれか`;
  if ('code' in arg) return said(arg, words) ?? '';
  const own = words.parameters[arg.key];
  return 'word' in arg ? `${own?.choices?.[arg.word] ?? arg.label} (${arg.word})` : `${own?.name ?? arg.name} (${arg.key})`;
}
