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
  /** What it stands under on the page. */
  group: string;
  /** The figure of the paper, or ''. */
  figure: string;
  note: string;
  link: string;
  /** How long it took in the paper, where that is printed. */
  timing: Timing | null;
}

export interface Timing {
  /** What it was measured on. */
  machine: string;
  /** The paper's parts of the work, and the stages here that do the same. */
  parts: { name: string; stages: string[]; seconds: number }[];
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

/** A map for other programs: rows from the top, values of 16 bits with the high byte first. */
export interface PixelMap {
  side: number;
  /** 1 of grey, or 3 of red, green, blue. */
  channels: number;
  bits: number;
  bytes: Uint8Array;
}

/** What a slice of work gave of a mesh file. */
export interface MeshSlice {
  /** The file begins with these parts: those before are of another one. */
  begun: boolean;
  parts: BlobPart[];
  done: boolean;
}

/** What a slice of work gave of a bigger picture. */
export interface PictureSlice {
  /** The picture begins with these rows: those before are of another one. */
  begun: boolean;
  done: boolean;
  /** How much of the work is done, about, 0..1. */
  progress: number;
  /** Pixels along the picture's side. */
  side: number;
  /** Red, green, blue of the next pixels: whole rows from the top, mostly none yet. */
  rows: Uint8Array;
}

/** Rings of an outline in picture units, y down, the outer ring first; not closed. */
export type Point = [number, number];
export type Ring = Point[];

/** Something with points to move: a ring, a line, a spot (its middle and a point of its rim), or the seed of a part. */
export interface Figure {
  points: Point[];
  /** Of a spot its factor or ratio, of a seed the place of its kind among the kinds. */
  value: number;
}

/** A sort of figures. */
export interface Sort {
  /** 'outline', or the key of a list. */
  word: string;
  label: string;
  /** What one of them is called. */
  figure: string;
  form: 'ring' | 'line' | 'spot' | 'seed';
  /** A figure has at least so many points. */
  least: number;
  /** What a figure's point is called. */
  name(figure: number, index: number, of: Figure): string;
  /** What the value of a figure is; `words` where it is one of some words. */
  value?: { label: string; min: number; max: number; first: number; words?: string[]; shown(value: number): string } | undefined;
}

/** The stages in their order, with the page's words for them. */
export const STAGES: readonly { word: string; label: string }[] = [
  { word: 'domain', label: 'Outline' },
  { word: 'fields', label: 'Fields' },
  { word: 'packing', label: 'Packing' },
  { word: 'mesh', label: 'Mesh' },
  { word: 'cells', label: 'Cells' },
  { word: 'solids', label: 'Relief' },
  { word: 'planes', label: 'Surface' },
  { word: 'shading', label: 'Light' },
];
