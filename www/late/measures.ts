/**
 * The rows of the card with the measures of a cell or a body, in their order. A generator gives each measure as a
 * number with a word, and some texts. A row is shown if all its numbers are known.
 */
import type { LookWord } from '../words/look';

export interface MeasureRow {
  readonly name: LookWord;
  /** The numbers of the row, each with its decimals. */
  readonly numbers: Readonly<Record<string, number>>;
  /** The word of the value, or one for each value of the first number; without it, the value is that number. */
  readonly value?: LookWord | readonly LookWord[];
  /** The word of a text that stands for the number where it is given. */
  readonly text?: string;
  /** A row with this value is left out. */
  readonly usual?: string;
}

/** A corner, an edge or a face, with its number. */
export const FEATURE: MeasureRow = { name: 'block_feature', numbers: { feature: 0, number: 0 }, value: ['feature_0', 'feature_1', 'feature_2'] };

/** If two rows have one name, only the first with all its numbers is shown. */
export const ROWS: readonly MeasureRow[] = [
  { name: 'cell_size', numbers: { size: 1, wanted: 1 }, value: 'cell_size_of' },
  { name: 'cell_aspect', numbers: { aspect: 2 }, usual: '1.00' },
  { name: 'cell_angle', numbers: { angle: 0, off: 1 }, value: 'cell_angle_of' },
  { name: 'cell_angle', numbers: { off: 1 }, value: 'cell_off' },
  { name: 'cell_sides', numbers: { sides: 0 } },
  { name: 'cell_neighbours', numbers: { neighbours: 0 } },
  { name: 'cell_area', numbers: { area: 0 } },
  { name: 'body_type', numbers: { type: 0 }, text: 'type' },
  { name: 'body_layer', numbers: { layer: 0 } },
  { name: 'body_slid', numbers: { slid: 2, inwards: 2, outwards: 2 }, value: 'body_slid_of' },
  { name: 'body_touches', numbers: { touches: 0 } },
  { name: 'block_kind', numbers: { sort: 0 }, value: ['kind_0', 'kind_1', 'kind_2', 'kind_3', 'kind_4', 'kind_5', 'kind_6', 'kind_7'] },
  { name: 'block_size', numbers: { length: 0, height: 0, depth: 0 }, value: 'block_size_of' },
  { name: 'block_course', numbers: { course: 0 } },
  FEATURE,
  { name: 'block_taken', numbers: { before: 1, after: 1 }, value: 'block_taken_of' },
];

/** The names of texts, by their words. */
export const TEXTS = { labels: 'block_labels', node: 'block_node' } as const satisfies Record<string, LookWord>;
