/** The choice of view and overlays, with a sentence about each, and of fine pictures. */
import { overlayIn, t } from '../words/look';
import { viewIn } from '../words/words';
import { byId, make } from '../base/dom';
import { chooseFine, isPicture, refinesBodies } from '../state/fine';
import type { Work } from '../state/work';
import type { View } from '../picture/view';
import '../styles/late/look.css';

export class Layers {
  private readonly work: Work;
  private readonly view: View;
  private readonly box = make('section', { class: 'layers-box', id: 'layers', 'aria-labelledby': 'layers-button' });
  private bases: HTMLInputElement[] = [];
  private overlays: HTMLInputElement[] = [];
  /** The words of the views and overlays that have a box. */
  private offered: readonly string[] = [];
  private readonly legend = make('dl', { class: 'layers-legend' });
  private readonly fine = make('input', { type: 'checkbox', id: 'fine', title: t('note_fine') });

  constructor(work: Work, view: View) {
    const { store } = work;
    this.work = work;
    this.view = view;
    const button = byId('layers-button');
    button.setAttribute('aria-controls', 'layers');
    for (const place of [this.box, button]) {
      place.addEventListener('keydown', ({ key }) => {
        if (key !== 'Escape' || !store.state.layers) return;
        button.focus();
        store.update({ layers: false });
      });
    }
    this.fine.addEventListener('change', () => chooseFine(store, this.fine.checked));
    byId('look-tools').after(this.box);
    store.on(['view', 'overlays', 'stage', 'paused', 'fine'], () => this.follow());
  }

  show(on: boolean): void {
    this.box.hidden = !on;
    this.follow();
  }

  /** Makes a box for each view and each overlay of the present generator. */
  private offer(): void {
    const { bases, overlays } = this.view;
    const offered = [...bases, ...overlays];
    if (offered.join() === this.offered.join()) return;
    this.offered = offered;
    this.bases = bases.map((word) => make('input', { type: 'radio', name: 'base', value: word }));
    this.overlays = overlays.map((word) => make('input', { type: 'checkbox', value: word }));
    const over = group(t('layers_over'), this.overlays, overlays.map((word) => overlayIn(word)[0]));
    over.hidden = !overlays.length;
    this.box.replaceChildren(over, group(t(overlays.length ? 'layers_base' : 'layers_alone'), this.bases, bases.map(viewIn)), group(t('layers_screen'), [this.fine], [t('fine')]), this.legend);
    for (const radio of this.bases) radio.addEventListener('change', () => this.work.store.update({ view: radio.value }));
    for (const check of this.overlays) {
      check.addEventListener('change', () => this.work.store.update({ overlays: this.overlays.filter(({ checked }) => checked).map(({ value }) => value) }));
    }
  }

  private follow(): void {
    if (this.box.hidden) return;
    this.offer();
    const { engine, store } = this.work;
    const { view, overlays } = store.state;
    const fine = engine.offers('frames') ? refinesBodies(store) : store.state.fine;
    const lone = view === 'potential';
    for (const radio of this.bases) radio.checked = radio.value === view;
    this.fine.checked = fine;
    for (const check of this.overlays) {
      check.checked = overlays.includes(check.value);
      check.disabled = lone;
    }
    const seen = [
      [view, viewIn(view), this.view.note || t(view === 'auto' ? 'note_auto' : 'note_picture')] as const,
      ...this.view.overlays.filter((word) => !lone && overlays.includes(word)).map((word) => [word, ...overlayIn(word)] as const),
      ...(fine && isPicture(this.view.words) ? [['fine', t('fine'), t('note_fine')] as const] : []),
    ];
    const absent = this.view.absences();
    this.legend.replaceChildren(...seen.map(([word, name, note]) => make('div', {}, make('dt', {}, name), make('dd', {}, [note, absent.get(word)].filter(Boolean).join(' ')))));
  }
}

function group(title: string, inputs: HTMLInputElement[], words: string[]): HTMLElement {
  const rows = inputs.map((input, k) => make('label', {}, input, make('span', {}, words[k] ?? '')));
  return make('fieldset', {}, make('legend', {}, title), ...rows);
}
