// The costs of tests. A step measures the seconds of its test files and tests, and `npm test` prints the slowest at
// its end.

/** @typedef {{ name: string, seconds: number }} Cost */

/** The number of tests that are printed for each step. */
const SHOWN = 10;

/**
 * Reports the slowest files and tests of a step, to `npm test` if that runs the step.
 * @param {Cost[]} costs
 */
export async function tellCosts(costs) {
  const slowest = costs.toSorted((a, b) => b.seconds - a.seconds).slice(0, SHOWN);
  if (process.send) await new Promise((resolve) => process.send?.(slowest, resolve));
  else console.log(`\nSlowest:\n${linesOf(slowest, '')}`);
}

/** @param {Cost[]} costs @param {string} indent */
export const linesOf = (costs, indent) => costs.map(({ name, seconds }) => `${indent}${seconds.toFixed(1).padStart(8)} s  ${name}`).join('\n');
