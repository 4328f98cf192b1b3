/** What the WebAssembly module hands over, as the page sees it. */

/** One row of the parameter schema. */
export interface Parameter {
  key: string;
  /** The papers' symbol, or ''. */
  symbol: string;
  name: string;
  kind: 'number' | 'int' | 'choice' | 'flag' | 'text';
  min: number;
  max: number;
  step: number;
  default: string;
  unit: string;
  help: string;
  group: string;
  stage: string;
  choices: { word: string; label: string }[];
  /** The parameter applies only while another one has one of these words. */
  shownFor?: { key: string; words: string[] } | undefined;
}

export interface Preset {
  name: string;
  title: string;
  /** The figure of the paper, or ''. */
  figure: string;
  note: string;
  link: string;
  /** The paper's seconds, where it prints any. */
  packingSeconds: number | null;
  textureSeconds: number | null;
}

export interface Status {
  cells: number;
  steps: number;
  /** In cell sizes. */
  largestMove: number;
  energy: number;
  added: number;
  removed: number;
  converged: boolean;
  stones: number;
  /** Milliseconds by the word of the stage. */
  ms: Record<string, number>;
}

/** Rings of an outline in picture units, y down, the outer ring first; not closed. */
export type Point = [number, number];
export type Ring = Point[];

/** The stages in their order, with the page's words for them. */
export const STAGES: readonly { word: string; label: string }[] = [
  { word: 'domain', label: 'Outline' },
  { word: 'fields', label: 'Fields' },
  { word: 'packing', label: 'Packing' },
  { word: 'mesh', label: 'Mesh' },
  { word: 'cells', label: 'Cells' },
  { word: 'solids', label: 'Stones' },
  { word: 'planes', label: 'Surface' },
  { word: 'shading', label: 'Light' },
];
