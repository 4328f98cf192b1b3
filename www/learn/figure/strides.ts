/** The keys of a handle: an arrow goes one stride, with Shift a finer one, Page a coarser one, Home and End to the ends. */
import type { NumberHandle } from '../figures/figure';

const WAYS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 1, PageDown: -1 };

/** The value after a key; `undefined` if the key is no handle's. */
export function afterKey(handle: NumberHandle, value: number, { key, shiftKey }: KeyboardEvent): number | undefined {
  if (key === 'Home') return handle.from;
  if (key === 'End') return handle.to;
  const way = WAYS[key];
  if (way === undefined) return undefined;
  const stride = key.startsWith('Page') ? handle.coarse : shiftKey ? handle.fine : handle.stride;
  return within(handle, value + way * stride);
}

/** The nearest value that the handle can have. */
export function within({ from, to, fine }: NumberHandle, value: number): number {
  const near = Math.round(value / fine) * fine;
  return Number(Math.max(from, Math.min(to, near)).toFixed(6));
}
