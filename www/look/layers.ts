/** What is drawn below and what over it, with a sentence for each about what one sees. */
import { t } from '../words/look';
import { byId, make } from '../base/dom';
import type { Store } from '../state/store';
import { VIEWS, type View } from '../picture/view';
import '../styles/late/look.css';

/** In the order in which they are drawn. */
const OVERLAYS = ['size', 'packed', 'energy', 'cells', 'mesh', 'anisotropy', 'direction', 'forces', 'singularities'] as const;

export class Layers {
  private readonly store: Store;
  private readonly view: View;
  private readonly box = make('section', { class: 'layers-box', id: 'layers', 'aria-label': t('layers_over') });
  private readonly bases: HTMLInputElement[];
  private readonly overlays: HTMLInputElement[];
  private readonly legend = make('dl', { class: 'layers-legend' });

  constructor(store: Store, view: View) {
    this.store = store;
    this.view = view;
    this.bases = VIEWS.map((word) => make('input', { type: 'radio', name: 'base', value: word }));
    this.overlays = OVERLAYS.map((word) => make('input', { type: 'checkbox', value: word }));
    this.box.append(
      group(t('layers_over'), this.overlays, OVERLAYS.map((word) => t(`over_${word}`))),
      group(t('layers_base'), this.bases, VIEWS.map((word) => t(`view_${word}`))),
      this.legend,
    );
    for (const radio of this.bases) radio.addEventListener('change', () => store.update({ view: radio.value }));
    for (const check of this.overlays) {
      check.addEventListener('change', () => store.update({ overlays: this.overlays.filter(({ checked }) => checked).map(({ value }) => value) }));
    }
    const button = byId('layers-button');
    button.setAttribute('aria-controls', 'layers');
    for (const place of [this.box, button]) {
      place.addEventListener('keydown', ({ key }) => {
        if (key !== 'Escape' || !store.state.layers) return;
        button.focus();
        store.update({ layers: false });
      });
    }
    byId('look-tools').after(this.box);
    store.on(['view', 'overlays', 'stage', 'paused'], () => this.follow());
  }

  show(on: boolean): void {
    this.box.hidden = !on;
    this.follow();
  }

  private follow(): void {
    if (this.box.hidden) return;
    const { view, overlays } = this.store.state;
    const lone = view === 'potential';
    for (const radio of this.bases) radio.checked = radio.value === view;
    for (const check of this.overlays) {
      check.checked = overlays.includes(check.value);
      check.disabled = lone;
    }
    const seen = [
      ...VIEWS.filter((word) => word === view).map((word) => [word, t(`view_${word}`), this.view.note || t(word === 'auto' ? 'note_auto' : 'note_picture')] as const),
      ...OVERLAYS.filter((word) => !lone && overlays.includes(word)).map((word) => [word, t(`over_${word}`), t(`note_over_${word}`)] as const),
    ];
    const absent = this.view.absences();
    this.legend.replaceChildren(...seen.map(([word, name, note]) => make('div', {}, make('dt', {}, name), make('dd', {}, [note, absent.get(word)].filter(Boolean).join(' ')))));
  }
}

function group(title: string, inputs: HTMLInputElement[], words: string[]): HTMLElement {
  const rows = inputs.map((input, k) => make('label', {}, input, make('span', {}, words[k] ?? '')));
  return make('fieldset', {}, make('legend', {}, title), ...rows);
}
