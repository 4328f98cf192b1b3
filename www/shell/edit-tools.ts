/**
 * The editor's tools beside the canvas, the panel's button for the outline, and files that are dropped or pasted.
 */
import { t } from '../words/words';
import { byId, isShown, make, say, walkByArrows } from '../base/dom';
import { isModel } from '../base/files';
import type { Engine } from '../state/engine';
import { toolApplies } from '../state/rules';
import type { Work } from '../state/work';
import type { Panel } from '../panel/panel';
import type { PageParts } from './parts';

/** The type of links, and of pictures of other pages, that are dragged. */
const LINK = 'text/uri-list';

export class EditTools {
  private readonly engine: Engine;
  private readonly work: Work;
  private readonly editor: PageParts['editor'];
  private readonly tools = [...byId('edit-tools').querySelectorAll<HTMLButtonElement>('[data-tool]')];
  private readonly more = byId('more-tools');
  private readonly take: (file: File) => void;
  private readonly edit = make('button', { type: 'button', class: 'wide', id: 'edit-outline', 'aria-keyshortcuts': 'E' });

  /** `take` opens a file. */
  constructor(work: Work, editor: PageParts['editor'], take: PageParts['take']) {
    this.take = take;
    this.engine = work.engine;
    this.work = work;
    this.editor = editor;
    this.edit.addEventListener('click', () => editor.ask((it) => it.toggle('outline')));
    for (const tool of this.tools) {
      // A click without a place comes from the keyboard.
      tool.addEventListener('click', (event) => editor.ask((it) => it.use(tool.dataset['tool'] ?? '', event.detail === 0)));
    }
    const box = byId('edit-tools');
    walkByArrows(box);
    this.foldRare(box);
    for (const near of ['pointerover', 'focusin']) box.addEventListener(near, () => void editor.load(), { once: true });
    this.receive();
    work.store.on(['editing', 'recipe'], () => this.show());
    this.show();
  }

  /** Adds the panel's button for the outline. */
  build(panel: Panel): void {
    panel.append('Outline', make('div', { class: 'tools' }, this.edit));
    this.show();
  }

  /** On small screens a button shows and hides the rare tools; choosing one hides them, too. */
  private foldRare(box: HTMLElement): void {
    const { more } = this;
    const rare = byId('rare-tools');
    const isOpen = (): boolean => more.getAttribute('aria-expanded') === 'true';
    const open = (on: boolean): void => {
      // If the toolbar's Tab stop becomes hidden, the button takes its place.
      const stop = rare.querySelector<HTMLElement>('[tabindex="0"]');
      if (!on && stop && isShown(more)) [stop.tabIndex, more.tabIndex] = [-1, 0];
      more.setAttribute('aria-expanded', String(on));
      // In a column that scrolls, the rare tools may be out of sight.
      if (on) rare.scrollIntoView({ block: 'nearest' });
    };
    more.addEventListener('click', () => open(!isOpen()));
    rare.addEventListener('click', () => open(false));
    box.addEventListener('keydown', ({ key }) => {
      if (key !== 'Escape' || !isOpen()) return;
      open(false);
      more.focus();
    });
  }

  /**
   * Outlines can be pasted; files and outlines can be dropped anywhere. The whole page takes them, because a browser
   * would open a file or a link that is dropped beside the picture, and leave the page.
   */
  private receive(): void {
    const sheet = byId('sheet');
    const page = document.documentElement;
    let isOwn = false;
    page.addEventListener('dragstart', () => (isOwn = true));
    page.addEventListener('dragend', () => (isOwn = false));
    const over = (event: DragEvent): void => {
      const { dataTransfer } = event;
      if (!dataTransfer || isForField(event, dataTransfer)) return;
      event.preventDefault();
      // The page's own pictures and links are no gifts.
      if (isOwn) dataTransfer.dropEffect = 'none';
      else sheet.classList.toggle('dropping', dataTransfer.types.includes('Files'));
    };
    page.addEventListener('dragenter', over);
    page.addEventListener('dragover', over);
    page.addEventListener('dragleave', ({ relatedTarget }) => {
      if (!(relatedTarget instanceof Node)) sheet.classList.remove('dropping');
    });
    page.addEventListener('drop', (event) => {
      const { dataTransfer } = event;
      sheet.classList.remove('dropping');
      if (!dataTransfer || isForField(event, dataTransfer)) return;
      event.preventDefault();
      if (isOwn) return;
      // The result is seen on the page, which a dialog covers.
      document.querySelector<HTMLDialogElement>('dialog[open]')?.close();
      const files = [...dataTransfer.files];
      // Takes the first file that may be an outline, a recipe, a building or a model.
      const file = files.find(({ name }) => /\.(svg|json|png)$/i.test(name) || isModel(name)) ?? files[0];
      const text = dataTransfer.getData('text/plain');
      if (file) this.take(file);
      else if (dataTransfer.types.includes(LINK)) this.editor.ask((it) => it.refuseLink());
      else this.editor.ask((it) => it.paste(text));
    });
    document.addEventListener('paste', ({ target, clipboardData }) => {
      if (target instanceof Element && target.matches('input, textarea')) return;
      const file = clipboardData?.files[0];
      const text = clipboardData?.getData('text/plain');
      if (file) this.take(file);
      else if (text) this.editor.ask((it) => it.paste(text));
    });
  }

  private show(): void {
    const { editing } = this.work.store.state;
    const active = editing === 'outline' || editing === 'hole';
    say(this.edit, t(active ? 'outline_leave' : 'outline_edit'));
    this.edit.title = t(active ? 'outline_leave_title' : 'outline_edit_title');
    this.edit.hidden = !toolApplies(this.engine, 'outline');
    for (const tool of this.tools) {
      const word = tool.dataset['tool'] ?? '';
      tool.hidden = !toolApplies(this.engine, word);
      if (tool.hasAttribute('aria-pressed')) tool.setAttribute('aria-pressed', String(editing === word));
    }
    this.more.toggleAttribute('data-active', this.tools.some((tool) => tool.matches('.rare [aria-pressed=true]')));
    const shown = this.tools.filter((tool) => !tool.hidden);
    if (!shown.some((tool) => tool.tabIndex === 0)) shown.slice(0, 1).forEach((tool) => (tool.tabIndex = 0));
  }
}

/** Whether text that is dragged is for the field under the pointer. Fields take no files, and those for numbers no links. */
function isForField({ target }: DragEvent, { types }: DataTransfer): boolean {
  const numbers = types.includes(LINK) ? '' : ', input[type=number]';
  return !types.includes('Files') && target instanceof Element && target.matches(`input[type=text], textarea${numbers}`);
}
