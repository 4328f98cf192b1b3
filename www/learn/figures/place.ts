/** A place in a picture or on a plate: x to the right, y down. Its unit is a share of a side, or a pixel of the plate. */
export type Place = readonly [x: number, y: number];

/** A direction with a length, in the same axes. */
export type Vector = readonly [x: number, y: number];
