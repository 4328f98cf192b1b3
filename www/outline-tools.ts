/** Free outlines: the buttons of the panel, files, and the editor over the canvas. */
import type { Controls } from './controls';
import { byId, make, say } from './dom';
import { Editor } from './editor';
import type { Engine } from './engine';
import { alertOf, notice } from './messages';
import { readOutline } from './outline-file';
import { simplify } from './simplify';
import type { Ring } from './types';

/** Points of a built-in outline that is made free, and of a free one that is edited, at most. */
const FROM_BUILT_IN = 36;
const FROM_FREE = 300;

export class OutlineTools {
  private readonly engine: Engine;
  private readonly changed: () => void;
  private readonly editor: Editor;
  private readonly edit = make('button', { type: 'button', class: 'wide', id: 'edit-outline', 'aria-keyshortcuts': 'E' });
  private readonly file = make('input', { type: 'file', accept: '.json,application/json', 'aria-label': 'Outline file' });

  constructor(engine: Engine, controls: Controls, changed: () => void) {
    this.engine = engine;
    this.changed = changed;
    this.editor = new Editor(byId('editor'), byId('editor-bar'), {
      side: () => engine.side(),
      change: (rings) => this.take(rings),
      closed: () => this.show(),
    });
    this.edit.addEventListener('click', () => this.toggle());
    const load = make('button', { type: 'button', class: 'wide', id: 'load-outline', title: 'A JSON file with “outer” and “holes”; it may also be dropped on the canvas' }, 'Load outline…');
    load.addEventListener('click', () => this.file.click());
    this.file.hidden = true;
    this.file.addEventListener('change', () => {
      const file = this.file.files?.[0];
      if (file) void this.read(file);
      this.file.value = '';
    });
    controls.append('Outline', make('div', { class: 'tools' }, this.edit, load, this.file));
    this.dropOn(byId('sheet'));
    this.show();
  }

  toggle(): void {
    if (this.editor.active) {
      this.editor.close();
      this.edit.focus();
    } else {
      this.begin();
      this.editor.focus();
    }
  }

  /** Turns the outline in use into a free one, of few points, and shows its handles. */
  begin(): void {
    const free = this.engine.get('outline') === 'polygon';
    const rings = simplify(this.engine.outline(), this.engine.side(), free ? FROM_FREE : FROM_BUILT_IN);
    if (!free) this.take(rings);
    this.editor.open(rings);
    this.show();
  }

  /** The outline was changed by other ways: handles only on a free one. */
  follow(): void {
    if (this.engine.get('outline') === 'polygon') this.begin();
    else this.editor.close();
    this.show();
  }

  /** Gives the outline to the engine; false where it was refused. */
  private take(rings: Ring[]): boolean {
    const { refused, sentence } = this.engine.setOutline(rings);
    if (refused) alertOf('outline', `${sentence} The last good outline stays.`);
    else notice('outline', ...(sentence ? [sentence] : []));
    this.changed();
    return !refused;
  }

  private async read(file: File): Promise<void> {
    try {
      const rings = await readOutline(file, this.engine.side());
      if (this.take(rings)) this.follow();
    } catch (error) {
      alertOf('outline', error instanceof Error ? error.message : String(error));
    }
  }

  private dropOn(sheet: HTMLElement): void {
    const over = (event: DragEvent): void => {
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      sheet.classList.add('dropping');
    };
    sheet.addEventListener('dragenter', over);
    sheet.addEventListener('dragover', over);
    sheet.addEventListener('dragleave', () => sheet.classList.remove('dropping'));
    sheet.addEventListener('drop', (event) => {
      event.preventDefault();
      sheet.classList.remove('dropping');
      const file = event.dataTransfer?.files[0];
      if (file) void this.read(file);
    });
  }

  private show(): void {
    say(this.edit, this.editor.active ? 'Hide the points' : 'Edit outline');
    this.edit.title = this.editor.active ? 'The outline stays as it is (E or Escape)' : 'Shows points to drag (E); another shape becomes a free outline';
  }
}
