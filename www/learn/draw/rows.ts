/** Lists of numbers as the module gives them, parted into rows and polygons. */

export function inRows(numbers: Float64Array, width: number): number[][] {
  return Array.from({ length: numbers.length / width }, (_, k) => Array.from(numbers.subarray(k * width, (k + 1) * width)));
}

/** Polygons stand one after the other, each with its id and the number of its corners before them: the ids with the corners' x and y. */
export function polygonsIn(numbers: Float64Array): (readonly [id: number, corners: Float64Array])[] {
  const polygons = [];
  for (let from = 0; from < numbers.length; ) {
    const [id = 0, corners = 0] = numbers.subarray(from, from + 2);
    const end = from + 2 + 2 * corners;
    polygons.push([id, numbers.subarray(from + 2, end)] as const);
    from = end;
  }
  return polygons;
}
