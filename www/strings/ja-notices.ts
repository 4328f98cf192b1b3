/** The Japanese for the module's notices. */
import notices from 'virtual:notices-ja';
import type { NoticeArg } from '../module/types';
import type { Foreign } from './foreign';

/** The text of a notice. `parameters` has the names of parameters and of their choices. */
export const said: Foreign['said'] = ({ code, args, text }, parameters) => notices[code]?.replace(/\{(\w+)\}/g, (_, name: string) => valueOf(args[name], parameters)) ?? text;

function valueOf(arg: NoticeArg | undefined, parameters: Foreign['parameters']): string {
  if (arg === undefined || typeof arg === 'string') return arg ?? '';
  if (Array.isArray(arg)) return `${arg.map((one) => valueOf(one, parameters)).join('、')}のどれか`;
  if ('code' in arg) return said(arg, parameters) ?? '';
  const own = parameters[arg.key];
  return 'word' in arg ? `${own?.choices?.[arg.word] ?? arg.label} (${arg.word})` : `${own?.name ?? arg.name} (${arg.key})`;
}
