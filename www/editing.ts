/** The way to the editor over the canvas, which is loaded when it is first used. */
import { Later } from './base/later';
import type { Desk } from './editor/desk';
import type { Work } from './state/work';

export class Editing {
  private readonly desk: Later<Desk>;

  constructor(work: Work) {
    this.desk = new Later(async () => new (await import('./editor/desk')).Desk(work));
  }

  /** The editor will be wanted soon. */
  load(): void {
    void this.desk.load();
  }

  /** Ends the editing of this sort, or begins it, with a first figure where there is none; without a word what was edited last is just looked at. */
  toggle(word?: string): void {
    this.desk.ask((desk) => desk.toggle(word));
  }

  /** The outline becomes a free one, whose points are shown. */
  free(): void {
    this.desk.ask((desk) => desk.free());
  }

  /** A tool of the box was chosen, by the keyboard or not. */
  use(tool: string, byKey: boolean): void {
    this.desk.ask((desk) => desk.use(tool, byKey));
  }

  /** An outline comes from a file or from the clipboard. */
  take(from: File | string): void {
    this.desk.ask((desk) => (typeof from === 'string' ? desk.paste(from) : void desk.takeFile(from)));
  }

  follow(): void {
    this.desk.here?.follow();
  }

  end(): void {
    this.desk.here?.close();
  }
}
