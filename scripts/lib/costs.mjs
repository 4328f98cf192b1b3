// What tests cost: a step notes the seconds of its test files and tests, and `npm test` prints the slowest at its end.

/** @typedef {{ name: string, seconds: number }} Cost */

/** As many of each step are printed. */
const SHOWN = 10;

/**
 * Tells the slowest files and tests of a step, to `npm test` where that runs the step.
 * @param {Cost[]} costs
 */
export async function tellCosts(costs) {
  const slowest = costs.toSorted((a, b) => b.seconds - a.seconds).slice(0, SHOWN);
  if (process.send) await new Promise((resolve) => process.send?.(slowest, resolve));
  else console.log(`\nSlowest:\n${linesOf(slowest, '')}`);
}

/** @param {Cost[]} costs @param {string} indent */
export const linesOf = (costs, indent) => costs.map(({ name, seconds }) => `${indent}${seconds.toFixed(1).padStart(8)} s  ${name}`).join('\n');
