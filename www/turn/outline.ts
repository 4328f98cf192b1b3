/** The outline of the picked body, over the frame. It is drawn for frames with all pixels only. */
import { make } from '../base/dom';

export class Outline {
  readonly element = make('canvas', { class: 'turn-outline', 'aria-hidden': 'true', width: '0', height: '0' });
  private readonly ask: (id: number) => Promise<ImageData | undefined>;
  private id: number | undefined;
  /** Whether the frame that is shown has all pixels, and whether its outline is drawn or asked for. */
  private whole = false;
  private done = false;
  /** Counts the changes; a late answer is ignored. */
  private changes = 0;

  constructor(ask: (id: number) => Promise<ImageData | undefined>) {
    this.ask = ask;
  }

  /** Outlines another body. Without a number, no body is outlined. */
  of(id: number | undefined): void {
    if (id !== this.id) this.clear();
    this.id = id;
    void this.draw();
  }

  /** Another frame is shown. Further samples of a whole frame keep the outline. */
  framed(whole: boolean): void {
    this.whole = whole;
    if (!whole) this.clear();
    void this.draw();
  }

  private clear(): void {
    this.changes += 1;
    this.done = false;
    this.element.width = this.element.height = 0;
  }

  private async draw(): Promise<void> {
    const { element, changes, id } = this;
    if (id === undefined || !this.whole || this.done) return;
    this.done = true;
    const image = await this.ask(id);
    if (!image || changes !== this.changes) return;
    [element.width, element.height] = [image.width, image.height];
    element.getContext('2d')?.putImageData(image, 0, 0);
  }
}
