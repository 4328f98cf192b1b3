/** Measures the stroke width of painted letters. */

/**
 * A pixel is in the middle of a stroke where the distance to the boundary grows by less than this per pixel. Beside
 * the middle it grows by 1, towards a corner by 0.7.
 */
const MIDDLE = 0.5;

/** Larger than any squared distance. */
const FAR = 1e12;

/** The median stroke width, in pixels, where numbers are above 0; 0 where none are. */
export function strokeWidth(values: Float32Array, columns: number): number {
  const far = distances(values, columns);
  const widths: number[] = [];
  for (let k = columns + 1; k < far.length - columns - 1; k += 1) {
    const own = far[k] ?? 0;
    if (own <= 0) continue;
    const [dx, dy] = [(far[k + 1] ?? 0) - (far[k - 1] ?? 0), (far[k + columns] ?? 0) - (far[k - columns] ?? 0)];
    if (Math.hypot(dx, dy) / 2 < MIDDLE) widths.push(2 * own);
  }
  return widths.sort((a, b) => a - b)[widths.length >> 1] ?? 0;
}

/**
 * The distance from each pixel inside to the boundary, which lies half a pixel before the nearest pixel outside
 * (Felzenszwalb and Huttenlocher, 2012: rows, then columns).
 */
function distances(values: Float32Array, columns: number): Float32Array {
  const rows = values.length / columns;
  const squares = Float64Array.from(values, (value) => (value > 0 ? FAR : 0));
  const pass = new Pass(Math.max(rows, columns));
  for (let row = 0; row < rows; row += 1) pass.along(squares, row * columns, 1, columns);
  for (let column = 0; column < columns; column += 1) pass.along(squares, column, columns, rows);
  return Float32Array.from(squares, (square) => (square > 0 ? Math.sqrt(square) - 0.5 : 0));
}

/** The lower envelope of parabolas, one at each number of a row. */
class Pass {
  private readonly line: Float64Array;
  private readonly bottoms: Int32Array;
  private readonly begins: Float64Array;

  constructor(longest: number) {
    this.line = new Float64Array(longest);
    this.bottoms = new Int32Array(longest);
    this.begins = new Float64Array(longest + 1);
  }

  along(squares: Float64Array, from: number, step: number, count: number): void {
    const { line, bottoms, begins } = this;
    for (let k = 0; k < count; k += 1) line[k] = squares[from + k * step] as number;
    let last = 0;
    bottoms[0] = 0;
    begins[0] = -Infinity;
    begins[1] = Infinity;
    for (let k = 1; k < count; k += 1) {
      let meet = this.meeting(bottoms[last] as number, k);
      while (meet <= (begins[last] as number)) meet = this.meeting(bottoms[(last -= 1)] as number, k);
      bottoms[(last += 1)] = k;
      begins[last] = meet;
      begins[last + 1] = Infinity;
    }
    for (let k = 0, at = 0; k < count; k += 1) {
      while ((begins[at + 1] as number) < k) at += 1;
      const bottom = bottoms[at] as number;
      squares[from + k * step] = (k - bottom) ** 2 + (line[bottom] as number);
    }
  }

  private meeting(a: number, b: number): number {
    return ((this.line[b] as number) + b * b - (this.line[a] as number) - a * a) / (2 * (b - a));
  }
}
