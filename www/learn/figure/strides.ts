/** The keys of handles: an arrow goes one stride, with Shift a finer one, Page a coarser one. */
import type { NumberHandle, PointHandle } from '../figures/figure';

const WAYS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 1, PageDown: -1 };

/** The ways of keys in the plane; Home and End are the coarse ones to the left and to the right. */
const PLANE: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1], End: [1, 0], Home: [-1, 0], PageUp: [0, -1], PageDown: [0, 1],
};

type Strides = Pick<NumberHandle | PointHandle, 'from' | 'to' | 'stride' | 'fine' | 'coarse'> & Pick<NumberHandle, 'marks'>;

function strideOf({ stride, fine, coarse }: Strides, { key, shiftKey }: KeyboardEvent): number {
  return key.startsWith('Arrow') ? (shiftKey ? fine : stride) : coarse;
}

/** The value after a key; Home and End give the limits. `undefined` if handles do not use the key. */
export function afterKey(handle: Strides, value: number, event: KeyboardEvent): number | undefined {
  if (event.key === 'Home') return handle.from;
  if (event.key === 'End') return handle.to;
  const way = WAYS[event.key];
  return way === undefined ? undefined : within(handle, value + way * strideOf(handle, event));
}

/** The point after a key; `undefined` if handles do not use the key. */
export function pointAfterKey(handle: PointHandle, [x, y]: readonly [number, number], event: KeyboardEvent): readonly [number, number] | undefined {
  const way = PLANE[event.key];
  const stride = strideOf(handle, event);
  return way && [within(handle, x + way[0] * stride), within(handle, y + way[1] * stride)];
}

/** The nearest value that the handle can have: a mark, or a whole number of fine strides. */
export function within({ from, to, fine, marks }: Strides, value: number): number {
  const mark = marks?.find((one) => Math.abs(one.value - value) <= fine / 2);
  if (mark) return mark.value;
  const near = Math.round(value / fine) * fine;
  return Number(Math.max(from, Math.min(to, near)).toFixed(6));
}
