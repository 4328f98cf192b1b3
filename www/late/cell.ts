/** The numbers of a cell, of a body in a pile, or of a block, each with its name. */
import { t } from '../words/look';
import { make } from '../base/dom';

/** The measures of a cell by the words of its generator, as far as they are known. */
export type Figures = { [word in 'size' | 'wanted' | 'aspect' | 'angle' | 'off' | 'sides' | 'neighbours' | 'area' | 'type' | 'layer' | 'slid' | 'inwards' | 'outwards' | 'touches' | 'length' | 'height' | 'depth' | 'feature']?: number | null | undefined };

export function cellNumbers(figures: Figures): [name: string, value: string][] {
  const { size, wanted, aspect, angle, off, sides, neighbours, area } = figures;
  const rows: [string, string][] = [];
  if (is(size) && is(wanted)) rows.push([t('cell_size'), t('cell_size_of', { size: size.toFixed(1), wanted: wanted.toFixed(1) })]);
  if (is(aspect) && aspect > 1.005) rows.push([t('cell_aspect'), aspect.toFixed(2)]);
  if (is(angle) && is(off)) rows.push([t('cell_angle'), t('cell_angle_of', { angle: angle.toFixed(0), off: off.toFixed(1) })]);
  else if (is(off)) rows.push([t('cell_angle'), t('cell_off', { off: off.toFixed(1) })]);
  if (is(sides)) rows.push([t('cell_sides'), String(sides)]);
  if (is(neighbours)) rows.push([t('cell_neighbours'), String(neighbours)]);
  if (is(area)) rows.push([t('cell_area'), area.toFixed(0)]);
  return [...rows, ...piledNumbers(figures), ...blockNumbers(figures)];
}

/** Those of a body in a pile; lengths are in its diagonals. */
function piledNumbers({ type, layer, slid, inwards, outwards, touches }: Figures): [name: string, value: string][] {
  const rows: [string, string][] = [];
  if (is(type)) rows.push([t('body_type'), String(type)]);
  if (is(layer)) rows.push([t('body_layer'), String(layer)]);
  if (is(slid) && is(inwards) && is(outwards)) rows.push([t('body_slid'), t('body_slid_of', { slid: signed(slid), from: signed(inwards), to: signed(outwards) })]);
  if (is(touches)) rows.push([t('body_touches'), String(touches)]);
  return rows;
}

/** The words of the types of features. */
const FEATURES = ['feature_0', 'feature_1', 'feature_2'] as const;

/** Those of a block in a wall, in millimetres. */
function blockNumbers({ length, height, depth, feature }: Figures): [name: string, value: string][] {
  const rows: [string, string][] = [];
  if (is(length) && is(height) && is(depth)) rows.push([t('block_size'), t('block_size_of', { length, height, depth })]);
  if (is(feature)) rows.push([t('block_feature'), t(FEATURES[feature] ?? 'feature_2')]);
  return rows;
}

function signed(length: number): string {
  return length.toFixed(2).replace('-', '−');
}

function is(figure: number | null | undefined): figure is number {
  return typeof figure === 'number';
}

/** The same as rows of a card. */
export function cellRows(cell: Figures): HTMLElement[] {
  return cellNumbers(cell).map(([name, value]) => make('div', {}, make('span', {}, name), make('b', {}, value)));
}
