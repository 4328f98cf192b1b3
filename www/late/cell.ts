/** The numbers of a cell, of a body in a pile, or of a block, each with its name. */
import { t } from '../words/look';
import { make } from '../base/dom';

/** The measures of a cell by the words of its generator, as far as they are known. */
export type Figures = { [word in 'size' | 'wanted' | 'aspect' | 'angle' | 'off' | 'sides' | 'neighbours' | 'area' | 'type' | 'layer' | 'slid' | 'inwards' | 'outwards' | 'touches' | 'length' | 'height' | 'depth' | 'sort' | 'course' | 'feature' | 'number' | 'before' | 'after']?: number | null | undefined };

/** Words that tell what numbers cannot, by the word of their kind. */
export type CellWords = { [kind in 'labels' | 'node']?: string | undefined };

/** Without those that only say the cell's `title`. */
export function cellNumbers(figures: Figures, words: CellWords = {}, title = ''): [name: string, value: string][] {
  const { size, wanted, aspect, angle, off, sides, neighbours, area } = figures;
  const rows: [string, string][] = [];
  if (is(size) && is(wanted)) rows.push([t('cell_size'), t('cell_size_of', { size: size.toFixed(1), wanted: wanted.toFixed(1) })]);
  if (is(aspect) && aspect > 1.005) rows.push([t('cell_aspect'), aspect.toFixed(2)]);
  if (is(angle) && is(off)) rows.push([t('cell_angle'), t('cell_angle_of', { angle: angle.toFixed(0), off: off.toFixed(1) })]);
  else if (is(off)) rows.push([t('cell_angle'), t('cell_off', { off: off.toFixed(1) })]);
  if (is(sides)) rows.push([t('cell_sides'), String(sides)]);
  if (is(neighbours)) rows.push([t('cell_neighbours'), String(neighbours)]);
  if (is(area)) rows.push([t('cell_area'), area.toFixed(0)]);
  return [...rows, ...piledNumbers(figures), ...blockNumbers(figures, words)].filter(([, value]) => value !== title);
}

/** The measures of a body in a pile; lengths are in its diagonals. */
function piledNumbers({ type, layer, slid, inwards, outwards, touches }: Figures): [name: string, value: string][] {
  const rows: [string, string][] = [];
  if (is(type)) rows.push([t('body_type'), String(type)]);
  if (is(layer)) rows.push([t('body_layer'), String(layer)]);
  if (is(slid) && is(inwards) && is(outwards)) rows.push([t('body_slid'), t('body_slid_of', { slid: signed(slid), from: signed(inwards), to: signed(outwards) })]);
  if (is(touches)) rows.push([t('body_touches'), String(touches)]);
  return rows;
}

/** The words of the types of features, and of the kinds of blocks. */
const FEATURES = ['feature_0', 'feature_1', 'feature_2'] as const;
const KINDS = ['kind_0', 'kind_1', 'kind_2', 'kind_3', 'kind_4', 'kind_5', 'kind_6', 'kind_7'] as const;

/** The name of a corner, an edge or a face. */
export function featureName({ feature, number }: Figures): string {
  return t(FEATURES[feature ?? 2] ?? 'feature_2', { n: number ?? 0 });
}

/** The measures of a block in a wall, in millimetres, and of the feature that it was laid for; or those of a face's map. */
function blockNumbers({ length, height, depth, sort, course, feature, number, before, after }: Figures, { labels, node }: CellWords): [name: string, value: string][] {
  const rows: [string, string][] = [];
  if (is(sort)) rows.push([t('block_kind'), t(KINDS[sort] ?? 'kind_5')]);
  if (is(length) && is(height) && is(depth)) rows.push([t('block_size'), t('block_size_of', { length, height, depth })]);
  if (is(course)) rows.push([t('block_course'), String(course)]);
  if (is(feature)) rows.push([t('block_feature'), featureName({ feature, number })]);
  if (is(before) && is(after)) rows.push([t('block_taken'), t('block_taken_of', { before: before.toFixed(1), after: after.toFixed(1) })]);
  if (labels) rows.push([t('block_labels'), labels]);
  if (node) rows.push([t('block_node'), node]);
  return rows;
}

function signed(length: number): string {
  return length.toFixed(2).replace('-', '−');
}

function is(figure: number | null | undefined): figure is number {
  return typeof figure === 'number';
}

/** The same as rows of a card. */
export function cellRows(cell: Figures, words: CellWords = {}, title = ''): HTMLElement[] {
  return cellNumbers(cell, words, title).map(([name, value]) => make('div', {}, make('span', {}, name), make('b', {}, value)));
}
