/** The numbers of a cell, each with its name. */
import type { Probe } from '../module/types';
import { t } from '../words/look';
import { make } from '../base/dom';

export function cellNumbers({ size, wanted, aspect, angle, off, sides, neighbours, area }: Probe): [name: string, value: string][] {
  const rows: [string, string][] = [[t('cell_size'), t('cell_size_of', { size: size.toFixed(1), wanted: wanted.toFixed(1) })]];
  if (aspect > 1.005) rows.push([t('cell_aspect'), aspect.toFixed(2)]);
  if (angle !== null && off !== null) rows.push([t('cell_angle'), t('cell_angle_of', { angle: angle.toFixed(0), off: off.toFixed(1) })]);
  if (sides !== null) rows.push([t('cell_sides'), String(sides)]);
  if (neighbours !== null) rows.push([t('cell_neighbours'), String(neighbours)]);
  if (area !== null) rows.push([t('cell_area'), area.toFixed(0)]);
  return rows;
}

/** The same as rows of a card. */
export function cellRows(cell: Probe): HTMLElement[] {
  return cellNumbers(cell).map(([name, value]) => make('div', {}, make('span', {}, name), make('b', {}, value)));
}
