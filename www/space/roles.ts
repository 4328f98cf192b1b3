/** The roles of files in a recipe, which are the keys of their parameters: a file may move from one role to another. */
import type { Parameter } from '../module/types';
import { withValues } from '../state/link';

/** The roles of a component, and of the shape that components are heaped on. */
const COMPONENT = 'file1';
const SHAPE = 'model';

const JSON_NAME = /\.json$/i;

/** The number of bent versions of components, and other types in a link, which share it with the first one. */
const VARIANTS = 'variants';
const OTHER_TYPES = /&c[2-4]=/;

/** The parameters of a file: the one that names it, the choice and word that make it count, the upright axis, and the unit. */
interface FileRows {
  readonly file: Parameter;
  readonly choice: string;
  readonly word: string;
  readonly up: Parameter | undefined;
  readonly unit: Parameter | undefined;
}

/** The word of the button that moves a file away from its role; undefined if no other role can take it. */
export function moveOf(schema: readonly Parameter[], role: string): 'as_shape' | 'as_component' | undefined {
  if (!placeOf(schema, otherThan(role))) return undefined;
  return role === COMPONENT ? 'as_shape' : role === SHAPE ? 'as_component' : undefined;
}

/** The rows of a file's upright axis and unit. A building in JSON tells both itself. */
export function readingOf(schema: readonly Parameter[], { role, name }: { role: string; name: string }): Pick<FileRows, 'up' | 'unit'> {
  const place = JSON_NAME.test(name) ? undefined : placeOf(schema, role);
  return { up: place?.up, unit: place?.unit };
}

/** The values that go with a file in a role: a thing of one's own is heaped as it is, not bent, if it is the only component. */
export function unbent(link: string, role: string): readonly (readonly [key: string, value: string])[] {
  return role === COMPONENT && !OTHER_TYPES.test(link) ? [[VARIANTS, '1']] : [];
}

/**
 * The link with the file in its other role. A file that had that role before is dropped, and the first role becomes
 * free.
 */
export function moved(link: string, schema: readonly Parameter[], role: string): string {
  const [from, to] = [placeOf(schema, role), placeOf(schema, otherThan(role))];
  if (!from || !to) return link;
  const pieces = link.split('&');
  const valueOf = (key: string): string | undefined => pieces.find((piece) => piece.startsWith(`${key}=`))?.slice(key.length + 1);
  const left = [from.file.key, from.choice, from.up?.key, to.up?.key].filter((key) => key !== undefined);
  // The things that take the file's place as the component are bent as usual.
  const unlike = unbent(link, role).map((pair) => pair.join('='));
  const rest = pieces.filter((piece) => !unlike.includes(piece) && !left.some((key) => piece.startsWith(`${key}=`))).join('&');
  const up = from.up && valueOf(from.up.key);
  return withValues(rest, [[to.choice, to.word], [to.file.key, valueOf(from.file.key) ?? ''], ...unbent(rest, to.file.key), ...(to.up && up ? [[to.up.key, up] as const] : [])]);
}

function otherThan(role: string): string {
  return role === COMPONENT ? SHAPE : COMPONENT;
}

function placeOf(schema: readonly Parameter[], role: string): FileRows | undefined {
  const file = schema.find(({ key, item }) => key === role && item === 'file');
  const [choice, word] = [file?.shownFor?.key, file?.shownFor?.words[0]];
  if (!file || choice === undefined || word === undefined) return undefined;
  const row = (start: string): Parameter | undefined => schema.find(({ key, shownFor }) => key.startsWith(start) && shownFor?.key === choice && shownFor.words.includes(word));
  return { file, choice, word, up: row('up'), unit: row('unit') };
}
