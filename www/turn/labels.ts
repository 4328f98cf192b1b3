/** The labels of a view, over the frame. They are shown on frames with all pixels only. */
import { make } from '../base/dom';
import type { PlacedLabel } from '../picture/frames/source';

/** The pixels kept free around a label. */
const ROOM = 3;

/** A rectangle in pixels of the page. */
type Edges = Pick<DOMRect, 'left' | 'right' | 'top' | 'bottom'>;

export class Labels {
  readonly element = make('div', { class: 'turn-labels', 'aria-hidden': 'true' });
  private readonly ask: () => Promise<readonly PlacedLabel[]>;
  /** Counts the frames; a late answer is ignored. */
  private frames = 0;

  constructor(ask: () => Promise<readonly PlacedLabel[]>) {
    this.ask = ask;
  }

  /** Another frame is shown. The labels of the last one stay until those of this one are known. */
  framed(whole: boolean): void {
    this.frames += 1;
    if (whole) void this.show(this.frames);
    else this.element.replaceChildren();
  }

  private async show(frame: number): Promise<void> {
    const labels = await this.ask();
    if (frame !== this.frames) return;
    const all = labels.map(({ text, at: [u, v] }) => {
      const label = make('span', { class: 'turn-label' }, text);
      label.style.left = `${100 * u}%`;
      label.style.top = `${100 * v}%`;
      return label;
    });
    this.element.replaceChildren(...all);
    for (const label of hidden(all)) label.remove();
  }
}

/** The labels that would lie on an earlier one. */
function hidden(labels: readonly HTMLElement[]): HTMLElement[] {
  const kept: Edges[] = [];
  const boxes = labels.map((label) => label.getBoundingClientRect());
  return labels.filter((_, k) => {
    const box = boxes[k];
    if (!box || kept.some((other) => meet(box, other))) return true;
    kept.push(box);
    return false;
  });
}

function meet(a: Edges, b: Edges): boolean {
  return a.left < b.right + ROOM && b.left < a.right + ROOM && a.top < b.bottom + ROOM && b.top < a.bottom + ROOM;
}
