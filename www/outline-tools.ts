/** Free outlines: the buttons of the panel, and files. */
import type { Controls } from './controls';
import { byId, make, say } from './dom';
import type { Editing } from './editing';
import type { Engine } from './engine';
import type { Work } from './work';
import { alertOf } from './messages';
import { readOutline } from './outline-file';

export class OutlineTools {
  private readonly work: Work;
  private readonly engine: Engine;
  private readonly editing: Editing;
  private readonly edit = make('button', { type: 'button', class: 'wide', id: 'edit-outline', 'aria-keyshortcuts': 'E' });
  private readonly file = make('input', { type: 'file', accept: '.json,application/json', 'aria-label': 'Outline file' });

  constructor(work: Work, controls: Controls, editing: Editing) {
    const { engine, store } = work;
    this.work = work;
    this.engine = engine;
    this.editing = editing;
    this.edit.addEventListener('click', () => {
      editing.toggle('outline');
      if (!editing.word) this.edit.focus();
    });
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
    store.on(['editing', 'recipe'], () => this.show());
    this.show();
  }

  private async read(file: File): Promise<void> {
    try {
      if (await (await import('./take/save')).openRecipe(this.work, file)) return;
      const rings = await readOutline(file, this.engine.side());
      if (this.editing.takeRings(rings)) this.editing.begin('outline');
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

  /** Says what the button does now. */
  show(): void {
    const active = this.editing.word === 'outline';
    say(this.edit, active ? 'Hide the points' : 'Edit outline');
    this.edit.title = active ? 'The outline stays as it is (E or Escape)' : 'Shows points to drag (E); another shape becomes a free outline';
    this.edit.hidden = this.engine.get('tile') === '1';
  }
}
