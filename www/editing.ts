/** The way to the editor over the canvas, which is loaded when it is first used. */
import type { Desk } from './editor/desk';
import { alertOf } from './messages';
import type { Work } from './work';
import { t } from './words';

export class Editing {
  private readonly work: Work;
  private desk: Desk | undefined;
  private coming: Promise<Desk | undefined> | undefined;

  constructor(work: Work) {
    this.work = work;
  }

  /** Loads the editor, once; tells where that failed, so that it can be tried again. */
  load(): Promise<Desk | undefined> {
    this.coming ??= import('./editor/desk').then(
      ({ Desk }) => (this.desk = new Desk(this.work)),
      () => {
        this.coming = undefined;
        alertOf('outline', t('lost_editor'));
        return undefined;
      },
    );
    return this.coming;
  }

  /** At once where the editor is loaded. */
  private with(act: (desk: Desk) => void): void {
    if (this.desk) act(this.desk);
    else void this.load().then((desk) => desk && act(desk));
  }

  /** Ends the editing of this sort, or begins it, with a first figure where there is none. */
  toggle(word?: string): void {
    this.with((desk) => desk.toggle(word));
  }

  /** Shows handles on figures of this sort. */
  begin(word: string): void {
    this.with((desk) => desk.begin(word));
  }

  /** A tool of the box was chosen, by the keyboard or not. */
  use(tool: string, byKey: boolean): void {
    this.with((desk) => desk.use(tool, byKey));
  }

  /** An outline comes from a file or from the clipboard. */
  take(from: File | string): void {
    this.with((desk) => (typeof from === 'string' ? desk.paste(from) : void desk.takeFile(from)));
  }

  follow(): void {
    this.desk?.follow();
  }

  end(): void {
    this.desk?.close();
  }
}
