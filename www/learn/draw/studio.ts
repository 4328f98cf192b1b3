/** The part of the module that figures use. The build and the page both bring the module itself. */

/** One packing in the module; see `Bubblestone` there. */
export interface Studio {
  free(): void;
  get(key: string): string;
  set(key: string, text: string): { readonly refused: boolean };
  link(): string;
  list(key: string): { readonly numbers: Float64Array };
  outline(): { readonly points: Float64Array; readonly rings: Uint32Array };
  side(): number;
  hold(step?: number | null): void;
  reach(budget: number): boolean;
  tick(budget: number, steps: number): boolean;
  stage(): string;
  packedCells(): Float64Array;
  energyParts(): Float64Array;
  populationChanges(): Float64Array;
  neighbours(id: number): Float64Array;
  status(): { readonly steps: number; readonly largestMove: number; readonly converged: boolean };
  stateHash(): string;
  joinCells(budget: number): boolean;
  joined(part: string): Float64Array;
  segmentTerms(x: number, y: number): Float64Array;
  directionAt(x: number, y: number): Float64Array;
  directionsAlong(walk: Float64Array): Float64Array;
  singularPoints(): Float64Array;
  probe(x: number, y: number): { readonly outline: Float64Array } | undefined;
}

export interface Bubbles {
  readonly Bubblestone: new (link: string) => Studio;
  /** The force (eq. (2)) and the potential (eq. (3)) at a distance. */
  readonly bubbleCurve: (w: number) => Float64Array;
}

/** The distance below 1 at which the potential is 0, found by halving. */
export function zeroOf(module: Bubbles): number {
  let [low, high] = [0, 1];
  while (high - low > 1e-9) {
    const middle = (low + high) / 2;
    if ((module.bubbleCurve(middle)[1] ?? 0) > 0) low = middle;
    else high = middle;
  }
  return low;
}
