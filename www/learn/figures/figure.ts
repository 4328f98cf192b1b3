/**
 * A figure as data. The drawing (`learn/draw`) and the runtime (`learn/figure`) follow it, and have no code for any single
 * figure. The state of a figure is its recipe, a step, and the place that is looked at; nothing else is kept.
 */
import type { Directions } from './directions';
import type { Flip, JoinedCells } from './joined';

export type Language = 'en' | 'ja';
export type Words = Readonly<Record<Language, string>>;

/** A packing at a step, as the engine gives it. */
export interface Crowd {
  readonly step: number;
  /** The numbers of all cells by rising ids, a row of `ROW` numbers for each: see `packedOf`. */
  readonly rows: Float64Array;
  /** The energy of the pairs, of the walls, and of the motion, in units of the mean k0. */
  readonly pairs: number;
  readonly walls: number;
  readonly motion: number;
  /** The largest move of the step that led here, in sizes. */
  readonly move: number;
}

/** A cell of a crowd. Places and the size are in shares of the picture's side, y down; speed and force in sizes, energy in k0. */
export interface PackedCell {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly size: number;
  readonly isHeld: boolean;
  readonly speed: readonly [x: number, y: number];
  readonly force: readonly [x: number, y: number];
  readonly energy: number;
  /** The smallest w to a neighbour; 0 without neighbours. */
  readonly least: number;
}

/** A neighbour of a cell: how far it is, and its force on the cell. */
export interface NearCell {
  readonly id: number;
  readonly w: number;
  readonly force: readonly [x: number, y: number];
}

/** A cell that came or went at a step. */
export interface Coming {
  readonly step: number;
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly came: boolean;
}

/** Two bubbles at a step. Lengths are in stable distances, energies in k0, both as the engine gives them. */
export interface Moment {
  readonly step: number;
  /** The place of the left bubble, from its first place. */
  readonly left: number;
  /** The distance between the centres. */
  readonly w: number;
  /** How fast the distance grows. */
  readonly speed: number;
  /** The force on the right bubble: a push is positive. */
  readonly force: number;
  /** The energy of the pair, and that of its motion. */
  readonly energy: number;
  readonly motion: number;
}

/** A bubble of a pavement and the cell that was made of it, in shares of the picture's side. */
export interface Cell {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly outline: readonly number[];
}

/** A place on a line from a square's centre, by its distance w, and the energy of a second square there, in k0. */
export interface Lowest {
  readonly w: number;
  readonly energy: number;
}

/** The potential around a held square, on a grid of columns and rows that count from its centre, in k0. */
export interface Landscape {
  readonly at: (column: number, row: number) => number;
  /** The lowest place straight beyond an edge, and straight beyond a corner: between two wells lies a pass. */
  readonly well: Lowest;
  readonly pass: Lowest;
  /** A quarter of the ground for drawings: the paths of its bands, from the lowest, and of its lines. */
  readonly ground: { readonly bands: readonly string[]; readonly lines: string };
}

/** The lists of a recipe whose rows are points: given bubbles, and the corners of the outline. */
export type PointList = 'given' | 'poly';

/** These lists, and the one whose rows are the ends of strokes. */
export type PlaceList = PointList | 'strokes';

/** The numbers of one packing at all its steps, as far as they are made; the cells of a pavement, once it is finished. */
export interface Trace {
  /** The steps up to the end of the run, or to the figure's last. */
  readonly steps: readonly Crowd[];
  /** Whether the run has ended by itself. */
  readonly isOver: boolean;
  readonly comings: readonly Coming[];
  /** The steps as those of a pair; empty unless there are exactly two cells. */
  readonly moments: readonly Moment[];
  readonly cells: readonly Cell[];
  /** Pixels along the picture's side, the unit of places in rows. */
  readonly side: number;
  /** The words of the recipe. */
  readonly link: string;
  /** The value of a parameter in the recipe; that of `held` is 1 if the first given bubble is held, else 0. */
  readonly value: (key: string) => string;
  /** The potential around a held square, for figures that show it. */
  readonly landscape: Landscape | undefined;
  /** The directions in its fields. */
  readonly directions: Directions;
  /** The rings of the outline, in shares of the picture's side: x, y, x, y, ... */
  readonly outline: readonly (readonly number[])[];
  /** The points of a list, in shares of the picture's side. */
  readonly points: (list: PlaceList) => readonly (readonly [x: number, y: number])[];
  /** The neighbours of a cell at a step, by rising ids. */
  readonly neighbours: (step: number, id: number) => readonly NearCell[];
  /** The outlines of all cells at a step by rising ids, in shares of the picture's side: x, y, x, y, ... */
  readonly shapes: (step: number) => readonly (readonly number[])[];
  readonly hashAt: (step: number) => string;
  /** The cells of a step as a mesh and as polygons; those of the last step if the figure has layers. */
  readonly joined: (step: number) => JoinedCells;
  /** The last flip of an edge by hand, for figures that look for it. */
  readonly flip: Flip | undefined;
}

/** A step with a name. */
export interface Stop {
  readonly key: string;
  readonly name: Words;
  /** The step, if there is one in these packings. */
  readonly find: (traces: readonly Trace[]) => number | undefined;
}

/** A number that the points of a list have: how it is read, and the words of the recipe that it changes. */
export interface Listed {
  readonly list: PlaceList;
  readonly read: (points: readonly (readonly [x: number, y: number])[]) => number;
  readonly write: (value: number, points: readonly (readonly [x: number, y: number])[]) => Readonly<Record<string, string>>;
}

/** A number with a slider, a box and, on some plates, a grip. `key` is a parameter's, or `w`, or a mark's: see `markAt`. */
export interface NumberHandle {
  readonly kind: 'number';
  readonly key: string;
  readonly name: Words;
  readonly symbol: string;
  readonly unit: Words;
  readonly from: number;
  readonly to: number;
  /** Strides: by arrow, finer with Shift, coarser by Page. */
  readonly stride: number;
  readonly fine: number;
  readonly coarse: number;
  readonly digits: number;
  /** Values with a name, which the handle takes exactly. */
  readonly marks?: readonly { readonly value: number; readonly name: string }[];
  /** The plates that have a grip for it. */
  readonly plates?: readonly number[];
  /** How a list stores it, if it is no parameter. */
  readonly listed?: Listed;
}

export interface ChoiceHandle {
  readonly kind: 'choice';
  readonly key: string;
  readonly name: Words;
  readonly choices: readonly { readonly word: string; readonly name: Words }[];
}

/**
 * Points with a grip each on plates and two number boxes: those of a list of the recipe, or `at`, the place looked at. A given
 * bubble that is moved at a later step starts a new run from the places of that step. Coordinates are shown from `origin` in
 * units of `scale` shares of the picture's side, and so are limits and strides. A tap on a plate moves the grip that was
 * tapped before, or else the nearest one of the first handle there.
 */
export interface PointHandle {
  readonly kind: 'point';
  readonly key: PointList | 'at';
  readonly name: Words;
  readonly unit: Words;
  readonly origin: readonly [x: number, y: number];
  readonly scale: number;
  readonly from: number;
  readonly to: number;
  readonly stride: number;
  readonly fine: number;
  readonly coarse: number;
  readonly digits: number;
  readonly plates: readonly number[];
  /** The rows of the list that can be moved; all if it is left out. */
  readonly rows?: readonly number[];
  /** Closer limits of both coordinates. */
  readonly area?: readonly [left: number, top: number, right: number, bottom: number];
  /** The height of a line that a drag finds, though it ends a little beside it. */
  readonly line?: number;
}

export type Handle = NumberHandle | ChoiceHandle | PointHandle;

/** A number over steps. */
export interface Line {
  readonly name: Words;
  readonly symbol?: string;
  readonly packing: number;
  readonly of: (crowd: Crowd) => number;
}

/** A bar with its name and its number. */
export interface Bar {
  readonly name: string;
  readonly value: number;
  /** Whether it stands out from the others. */
  readonly isMarked?: boolean;
}

/**
 * An arrow of a dial: its angle clockwise from the right, and its length in radii. A ghost shows where an arrow was.
 */
export interface Hand {
  readonly degrees: number;
  readonly length: number;
  readonly kind: 'ghost' | 'term' | 'sum';
  readonly name: string;
}

/** Counts of smallest angles: those of a packing at a step, or at the present one. */
export interface AngleRow {
  readonly name: Words;
  /** The letter of the reader's mark. */
  readonly letter: string;
  readonly packing: number;
  readonly always?: number;
}

/** A drawing of a figure, and the packing that it shows. */
export interface Plate {
  readonly draw: 'force' | 'track' | 'valley' | 'pavement' | 'crowd' | 'lens' | 'plot' | 'levels' | 'population' | 'thresholds' | 'held' | 'landscape' | 'relief' | 'section' | 'squares' | 'dual' | 'mesh' | 'angles' | 'delaunay' | 'facing' | 'inscribed' | 'turned' | 'dial' | 'arrows' | 'four-fold' | 'walk' | 'turns' | 'strokes';
  readonly packing: number;
  readonly title?: Words;
  /** A short text beside the title, made of the numbers at this step. */
  readonly note?: (seen: Seen, language: Language) => string;
  /** A crowd: whether each cell has an arrow for the net force on it. */
  readonly forces?: boolean;
  /** A plot: its lines, told apart by dash and name, the name of its axis, and digits of its numbers. */
  readonly lines?: readonly Line[];
  readonly axis?: Words;
  readonly digits?: number;
  /** A walk: the key of the question whose answer its singular points give away; they are shown once it is answered. */
  readonly after?: string;
  /** The name of its ground, which is drawn once, and used by its other layers and by other plates of the figure. */
  readonly ground?: string;
  readonly bars?: (seen: Seen, language: Language) => readonly Bar[];
  /** A dial: its arrows. */
  readonly hands?: (seen: Seen, language: Language) => readonly Hand[];
  /** A mesh: the step that it always shows, if it is not the present one. */
  readonly always?: number;
  /** Smallest angles: their rows, from the top. */
  readonly angles?: readonly AngleRow[];
  /** Points by hand: whether the edge that is looked at is marked, or the triangle with the smallest angle. */
  readonly marked?: 'edge' | 'smallest';
  /** A population: whether the steps that are still to come are shown, too. */
  readonly isAhead?: boolean;
  /** A population: whether the signs of who comes and goes next are left out, as a question asks for them. */
  readonly isAsked?: boolean;
}

/** A start that was let go of, and how it ended. */
export interface Trial {
  /** A text that differs between any two starts. */
  readonly start: string;
  readonly value: number;
  readonly parted?: boolean;
}

/** All that a rule may look at. */
export interface Seen {
  readonly traces: readonly Trace[];
  readonly step: number;
  readonly trials: readonly Trial[];
  /** The place looked at: a number for each mark on a curve, or two for a point of the picture; see `markAt`. */
  readonly at: readonly number[];
  /** The distance below 1 at which the potential is 0. */
  readonly zero: number;
  /** Whether the reader has stopped at this step. */
  readonly isStill: boolean;
  /** The keys of the questions that are answered. */
  readonly answered: ReadonlySet<string>;
}

/** All that a drawing may show. */
export interface View extends Seen {
  /** The last step of the longest run, and the furthest one that was seen. */
  readonly last: number;
  readonly furthest: number;
  /** The distance, the force, the potential. */
  readonly curve: readonly (readonly [w: number, force: number, potential: number])[];
  /** Whether the place where the potential is 0 is shown. */
  readonly isZeroShown: boolean;
  /** The stops on the way, with their steps. */
  readonly stops: readonly { readonly name: Words; readonly step: number }[];
  readonly language: Language;
}

/** A question that the figure answers by its numbers. */
export interface Ask {
  readonly key: string;
  /** The answers in words, by the values of their buttons. */
  readonly answers: Readonly<Record<string, Words>>;
  /** The sentences on what happened and why, once it has happened. */
  readonly seen: (seen: Seen, language: Language) => string | undefined;
  /** These sentences with the widest numbers that they can have: the page keeps room for the longest. */
  readonly longest: (language: Language) => readonly string[];
  /** Whether the place where the potential is 0 is shown from then on. */
  readonly showsZero?: boolean;
}

export interface Figure {
  readonly name: string;
  /** Whether a recipe from elsewhere is one that the figure can show. */
  readonly fits: (trace: Trace) => boolean;
  /** The words of the recipe, and what each packing has of its own. */
  readonly recipe: string;
  readonly packings: readonly Readonly<Record<string, string>>[];
  /**
   * The last step of the longest run, the step that the figure opens at (the run's end if that comes earlier), and the
   * kind of its steps. A walk needs only the fields, and no step of a packing. A figure whose last step is 0 has no
   * timeline.
   */
  readonly last: number;
  readonly opens: number;
  readonly steps: 'step' | 'layer' | 'walk';
  readonly plates: readonly Plate[];
  readonly stops: readonly Stop[];
  readonly handles: readonly Handle[];
  /** Handles that are folded away at first. */
  readonly more: readonly Handle[];
  readonly at: readonly number[];
  /** For plates that show the field: the number of its places along the picture's side. */
  readonly across?: number;
  /** Whether plates show the potential around the first cell. */
  readonly hasLandscape?: boolean;
  /** Whether the cells of the first step are joined in slices, before the figure is shown. */
  readonly joinsFirst?: boolean;
  /** Whether flips of edges are looked for. */
  readonly hasFlips?: boolean;
  /** How a start ended, as soon as that is seen; kept for questions on several starts. */
  readonly trial?: (trace: Trace, step: number) => Trial | undefined;
  readonly asks: readonly Ask[];
  readonly told: (seen: Seen, language: Language) => string;
}
