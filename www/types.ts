/** What the WebAssembly module hands over, as the page sees it. */

/** One row of the parameter schema. */
export interface Parameter {
  key: string;
  /** The papers' symbol, or ''. */
  symbol: string;
  name: string;
  kind: 'number' | 'int' | 'choice' | 'text';
  min: number;
  max: number;
  step: number;
  default: string;
  unit: string;
  help: string;
  group: string;
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

/** Why something of a view shows nothing. */
export type Absence = 'not_yet' | 'at_rest' | 'no_point' | 'no_mesh' | 'one_size' | 'all_even';

/** A cell, as found at a place of the picture: lengths in picture units, angles in degrees, y down. */
export interface Probe {
  /** Its place in the list of cells, from 0; while they are packed, in that of the packing. */
  cell: number;
  x: number;
  y: number;
  kind: 'square' | 'rectangle' | 'circle' | 'ellipse';
  size: number;
  /** What the size field asks for there. */
  wanted: number;
  /** Length over width, at least 1. */
  aspect: number;
  /** 0..90 of squares, 0..180 of rectangles and ellipses; null of circles. */
  angle: number | null;
  /** Off the direction field: 0..45 of squares, else 0..90; null of circles. */
  off: number | null;
  /** Its polygon as x, y, x, y, ..., not closed; of a packed cell its shape. */
  outline: Float64Array;
  /** The following only once the cells have polygons. */
  area: number | null;
  sides: number | null;
  /** Cells on the other side of its sides. */
  neighbours: number | null;
}

/** How the packing went so far: lists of the same length, by rising steps. */
export interface Series {
  step: Float64Array;
  energy: Float64Array;
  /** The largest move of the step, in cell sizes. */
  move: Float64Array;
}

/** Counts of equal classes; those beyond count in the outermost. No classes where there is nothing to count. */
export interface Histogram {
  from: number;
  to: number;
  counts: Uint32Array;
}

/** Of all cells: sizes over the wanted ones, and degrees off the direction field. */
export interface Histograms {
  size: Histogram;
  angle: Histogram;
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
  parts: BlobPart[];
  done: boolean;
}

/** What a slice of work gave of a bigger picture. */
export interface PictureSlice {
  done: boolean;
  /** How much of the work is done, about, 0..1. */
  progress: number;
  /** Pixels along the picture's side. */
  side: number;
  /** Red, green, blue of the next pixels: whole rows from the top, mostly none yet. */
  rows: Uint8Array;
}

/** Rings of an outline in picture units, y down, an outer ring first, then islands and holes; not closed. */
export type Point = [number, number];
export type Ring = Point[];

/** The stages in their order. */
export const STAGES = ['domain', 'fields', 'packing', 'mesh', 'cells', 'planes', 'weather', 'shading'] as const;
