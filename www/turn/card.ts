/** A card with the facts about a body, beside the place that was pointed at. */
import { t } from '../words/turn';
import { make } from '../base/dom';
import { cellNumbers, cellRows, featureName } from '../late/cell';
import type { Sort } from '../picture/frames/sort';
import type { BodyInfo } from '../picture/frames/source';

/** The distance from the pointer to the card, in pixels. */
const GAP = 18;

/** The acts of a picked body's card. */
interface CardActs {
  /** Opens the view of how a body is made. */
  how(body: BodyInfo): void;
  /** The act that turns the bricks of a corner or an edge; undefined if the body is of another feature. */
  flip(body: BodyInfo): (() => void) | undefined;
  /** Outlines the picked body. Without a number, no body is outlined. */
  outline(id: number | undefined): void;
  /** The pixels at the top of the frame that hold tools; no card covers them. */
  tools(): number;
  /** Takes the camera home, as a double click on the frame does. */
  home(): void;
}

export class Card {
  readonly element = make('div', { class: 'cell-card turn-card' });
  private readonly acts: CardActs;
  /** The body that was clicked or picked by a key: its card stays. */
  picked: BodyInfo | undefined;
  /** The presses on the card that is shown. */
  private presses = 0;
  /** The place that the card is beside, in fractions of the frame's sides. */
  private at: readonly [number, number] = [0, 0];

  constructor(acts: CardActs) {
    this.acts = acts;
    this.element.hidden = true;
    this.element.addEventListener('pointerdown', () => (this.presses += 1));
    // In a small frame the card may come under the pointer that picks the body. A click, or a double click, that began
    // before is not for the card's buttons, but for the frame.
    this.element.addEventListener('click', (event) => this.presses < event.detail && event.stopPropagation(), { capture: true });
    this.element.addEventListener('dblclick', () => this.presses < 2 && acts.home());
    for (const sign of ['click', 'dblclick', 'pointerdown', 'pointermove', 'touchstart']) this.element.addEventListener(sign, (event) => event.stopPropagation());
  }

  /**
   * Shows a body's card at a place, in fractions of the frame's sides. The card of a `picked` body has a button for
   * more.
   */
  show(body: BodyInfo, sort: Sort, x: number, y: number, picked: boolean): void {
    const { element } = this;
    this.picked = picked ? body : undefined;
    this.acts.outline(this.picked?.id);
    element.toggleAttribute('data-picked', picked);
    element.parentElement?.toggleAttribute('data-carded', picked);
    this.presses = 0;
    const name = called(body, sort);
    element.replaceChildren(make('strong', {}, name), ...cellRows(body.figures, body.words, name));
    if (picked && hasSteps(body, sort)) this.offer('turn-how', t('how'), () => this.acts.how(body));
    const flip = picked ? this.acts.flip(body) : undefined;
    if (flip) this.offer('turn-flip', t('flip'), flip);
    element.hidden = false;
    this.at = [x, y];
    this.put();
  }

  /** Puts the card beside its place, within the frame. */
  put(): void {
    const { element, picked, at: [x, y] } = this;
    const [wide, high] = [element.parentElement?.clientWidth ?? 0, element.parentElement?.clientHeight ?? 0];
    const along = (part: number, room: number, own: number, least: number): number => {
      const after = part * room + GAP;
      return Math.max(least, after + own <= room ? after : part * room - GAP - own);
    };
    const { offsetWidth, offsetHeight } = element;
    const top = this.acts.tools();
    element.style.left = `${along(x, wide, offsetWidth, 0)}px`;
    // A narrow frame has no room beside a body: the card is at the edge away from it.
    const away = y * high > (top + high) / 2 ? top : Math.max(top, high - offsetHeight);
    element.style.top = `${picked && wide < 2 * (offsetWidth + GAP) ? away : along(y, high, offsetHeight, top)}px`;
  }

  private offer(id: string, name: string, act: () => void): void {
    const button = make('button', { type: 'button', class: 'key wordy', id }, name);
    button.addEventListener('click', act);
    this.element.append(button);
  }

  hide(): void {
    this.element.parentElement?.removeAttribute('data-carded');
    this.picked = undefined;
    this.acts.outline(undefined);
    this.element.hidden = true;
  }
}

/** The card's text as a sentence. */
export function sentence(body: BodyInfo, sort: Sort): string {
  const name = called(body, sort);
  const numbers = cellNumbers(body.figures, body.words, name).map((row) => row.join(' '));
  return [[name, ...numbers].join(', '), ...(hasSteps(body, sort) ? [t('how_key')] : [])].join('. ');
}

/** Whether the making of a body can be shown in steps. An element of a mesh has none. */
export function hasSteps({ steps }: BodyInfo, sort: Sort): boolean {
  return steps.length > 0 && sort !== 'element';
}

function called({ id, figures }: BodyInfo, sort: Sort): string {
  return sort === 'feature' ? featureName(figures) : t(sort, { id });
}
