/** Edits figures over the canvas, by pointer (gestures.ts), by keyboard, and by the bar's buttons. */
import type { Point } from '../module/types';
import { byId, isShown } from '../base/dom';
import { ARROWS } from '../late/arrows';
import { EditorBar } from './bar';
import { EditedFigures, type FigureNeeds } from './edited';
import { drawn, type Figure, type FigurePoint, type Sort } from './geometry/figures';
import { Gestures } from './gestures';

/** An arrow key moves a point by this many units of the picture; with Shift, ten times as far. */
const NUDGE = 1;

interface FigureEditorNeeds extends FigureNeeds {
  /** All sorts that can be edited now. */
  sorts(): Sort[];
  /** The visitor chose another sort in the bar. */
  choose(word: string): void;
  /** The outline that the figures make, if they are not the outline themselves. */
  rim(): Point[][];
  closed(): void;
}

export class FigureEditor {
  readonly figures: EditedFigures;
  private readonly bar: EditorBar;
  private readonly needs: FigureEditorNeeds;
  /** The elements that hold the points and the buttons. */
  private readonly places: readonly HTMLElement[];
  private readonly gestures: Gestures;
  /** The element that had the focus when the editor was opened. */
  private opener: Element | null = null;

  /** `layer` lies over the canvas; `bar` takes the buttons for the marked point. */
  constructor(layer: HTMLElement, bar: HTMLElement, needs: FigureEditorNeeds) {
    this.needs = needs;
    this.places = [layer, bar];
    const disarmed = (): void => {
      this.gestures.reset();
      needs.disarmed();
    };
    const figures = (this.figures = new EditedFigures(layer, { ...needs, disarmed }, { follow: () => this.showBar(), focus: () => this.focus() }));
    this.gestures = new Gestures(figures);
    this.bar = new EditorBar(bar, {
      choose: (word) => needs.choose(word),
      addFigure: () => figures.addFigure(),
      addPoint: () => figures.addAfter(figures.at),
      remove: () => figures.take(figures.at),
      turnOver: () => figures.turnOver(figures.at),
      value: (value, last) => figures.setValue(value, last),
      finish: () => this.gestures.finish(),
      cancel: () => this.gestures.cancel(),
      close: () => this.close(),
    });
    this.listen(layer);
  }

  private listen(layer: HTMLElement): void {
    const { figures } = this;
    for (const place of this.places) place.addEventListener('keydown', (event) => this.keyAnywhere(event));
    // After a click on a tool its button has the keyboard focus.
    byId('edit-tools').addEventListener('keydown', (event) => this.open && event.key === 'Escape' && this.keyAnywhere(event));
    document.body.addEventListener('keydown', (event) => this.open && event.target === document.body && this.keyAnywhere(event));
    layer.addEventListener('focusin', ({ target }) => {
      const part = figures.sheet.part(target);
      if (part.part === 'point') figures.mark(part.place);
    });
    layer.addEventListener('keydown', (event) => {
      const part = figures.sheet.part(event.target);
      if (part.part === 'point') this.key(event, part.place);
    });
    layer.addEventListener('keyup', () => figures.drop());
  }

  get open(): boolean {
    return !this.figures.sheet.layer.hidden;
  }

  /** Shows handles on these figures. `armed`: the next drag draws a ring. */
  show(sort: Sort, figures: Figure[], armed = false): void {
    this.figures.drop();
    if (!this.open) this.opener = document.activeElement;
    const same = this.figures.sort?.word === sort.word && this.open;
    const focused = this.figures.sheet.layer.contains(document.activeElement);
    this.gestures.reset();
    this.figures.begin(sort, figures, armed);
    if (focused && same) this.focus();
  }

  /** Moves the keyboard focus to the marked point. Where there is none, adds a figure if `fresh` allows it. */
  start(fresh: boolean): void {
    if (this.figures.isEmpty && fresh) this.figures.addFigure();
    else this.focus();
  }

  /** Ends a drag whose figures are no longer those of the recipe. */
  abandon(): void {
    this.gestures.reset();
    this.figures.abandon();
  }

  close(): void {
    if (!this.open) return;
    const { opener } = this;
    const focused = this.places.some((place) => place.contains(document.activeElement));
    this.gestures.reset();
    this.figures.drop();
    this.figures.sheet.layer.hidden = true;
    this.bar.hide();
    this.needs.closed();
    // A point or a button that is hidden would lose the focus.
    if (focused && opener instanceof HTMLElement && isShown(opener)) opener.focus({ preventScroll: true });
  }

  private focus(): void {
    if (!this.figures.focus()) this.bar.focus();
  }

  private showBar(): void {
    const { sort, sheet, marked, smooth, removable, armed } = this.figures;
    if (!sort) return;
    sheet.rim(this.needs.rim().map((ring) => drawn('ring', ring)).join(''));
    this.bar.show(this.needs.sorts(), sort, { marked, smooth, removable, drawing: this.gestures.drawing, armed });
  }

  /** Escape leaves the editor. While a figure is being drawn, it only cancels that. */
  private keyAnywhere(event: KeyboardEvent): void {
    if (event.target instanceof HTMLElement && event.target.matches('input, select') && event.key !== 'Escape') return;
    if (this.gestures.key(event)) return event.preventDefault();
    if (event.key === 'Escape') this.close();
  }

  private key(event: KeyboardEvent, place: FigurePoint): void {
    if (event.defaultPrevented) return;
    const { figures } = this;
    const arrow = ARROWS[event.key];
    if (arrow) {
      const step = NUDGE * (event.shiftKey ? 10 : 1);
      figures.nudge(place, [arrow[0] * step, arrow[1] * step], event.ctrlKey || event.metaKey, event.repeat);
    } else if (event.key === 'Delete' || event.key === 'Backspace') figures.take(place);
    else if (event.key === 'Insert') figures.addAfter(place);
    else if (event.key === 'Enter') figures.turnOver(place);
    else return;
    event.preventDefault();
  }
}
