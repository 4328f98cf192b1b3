/** The Japanese for the module's notices. */
import notices from 'virtual:notices-ja';
import type { Notice, NoticeArg } from '../module/types';
import type { Foreign } from './foreign';

/** `parameters` has the names of parameters and of their choices. */
export function japanese(parameters: Foreign['parameters']): Foreign['said'] {
  const value = (arg: NoticeArg | undefined): string => {
    if (arg === undefined || typeof arg === 'string') return arg ?? '';
    if (Array.isArray(arg)) return `${arg.map(value).join('、')}のどれか`;
    if ('code' in arg) return said(arg);
    const own = parameters[arg.key];
    return 'word' in arg ? `${own?.choices?.[arg.word] ?? arg.label} (${arg.word})` : `${own?.name ?? arg.name} (${arg.key})`;
  };
  const said = ({ code, args, text }: Notice): string => notices[code]?.replace(/\{(\w+)\}/g, (_, name: string) => value(args[name])) ?? text;
  return said;
}
