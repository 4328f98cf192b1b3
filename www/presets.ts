/** The rail of presets: the house's own and the papers' figures, each a small picture. */
import { byId, make } from './dom';
import type { Preset } from './types';

/** Sides of the small pictures, in their own pixels. */
export const THUMB = 144;

export class Presets {
  private readonly buttons = new Map<string, HTMLButtonElement>();
  readonly thumbs: { preset: Preset; canvas: HTMLCanvasElement }[] = [];

  constructor(presets: Preset[], chosen: (preset: Preset) => void) {
    const rail = byId('rail');
    rail.replaceChildren();
    for (const title of new Set(presets.map(({ group }) => group))) {
      const list = make('ul');
      for (const preset of presets) {
        if (preset.group === title) list.append(make('li', {}, this.button(preset, chosen)));
      }
      rail.append(make('h2', {}, title), list);
    }
  }

  /** Marks the preset that is shown. */
  mark(name: string | undefined): void {
    for (const [key, button] of this.buttons) {
      if (key === name) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
    }
  }

  private button(preset: Preset, chosen: (preset: Preset) => void): HTMLButtonElement {
    const canvas = make('canvas', { width: String(THUMB), height: String(THUMB), 'aria-hidden': 'true' });
    const button = make(
      'button',
      { type: 'button', title: preset.note ? `${preset.figure || preset.title}: ${preset.note}` : preset.title, 'data-preset': preset.name },
      canvas,
      make('span', {}, preset.figure ? short(preset.figure) : preset.title),
    );
    if (preset.figure) button.setAttribute('aria-label', preset.figure);
    button.addEventListener('click', () => chosen(preset));
    this.buttons.set(preset.name, button);
    this.thumbs.push({ preset, canvas });
    return button;
  }
}

/** "Fig. 13 (1b) of 2000, Fig. 12 (1b) of 2001" as it fits under a small picture: the first paper's number. */
function short(figure: string): string {
  return /\d+\s*(\(\w+\))?/.exec(figure)?.[0] ?? figure;
}
