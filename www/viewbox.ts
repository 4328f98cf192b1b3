/** The buttons for looking closer, beside the canvas; what they do is loaded when it is first asked for. */
import { byId, say, walkByArrows } from './base/dom';
import { bindKeys } from './base/keys';
import { Later } from './base/later';
import type { Store } from './state/store';
import type { Work } from './state/work';
import type { View } from './view';
import { t } from './words/words';

/** What may stand beside or over the picture. */
type Tool = 'light' | 'layers' | 'compare' | 'plots';

interface Shown {
  /** Is called whenever the tool is shown or goes. */
  show(on: boolean): void;
}

const REPEATS = 3;

/** `leave` ends the editing on the picture. */
export function makeViewBox(work: Work, view: View, leave: () => void): void {
  const { store } = work;
  const hand = new Later(async () => new (await import('./look/hand')).Hand(work, view));
  const zoom = (by: number) => () => hand.ask((it) => it.glass.step(by));
  byId('zoom-in').addEventListener('click', zoom(1));
  byId('zoom-out').addEventListener('click', zoom(-1));
  byId('zoom-fit').addEventListener('click', zoom(0));
  const sheet = byId('sheet');
  for (const sign of ['pointerover', 'pointerdown', 'focusin']) sheet.addEventListener(sign, () => void hand.load(), { once: true, passive: true });
  // Wheel and double click may come before what answers them, and are kept for it.
  sheet.addEventListener(
    'wheel',
    (event) => {
      if (hand.here) return;
      // All the way out, the wheel scrolls the page.
      if (event.deltaY < 0 || event.ctrlKey) event.preventDefault();
      hand.ask((it) => it.glass.wheel(event));
    },
    { passive: false },
  );
  sheet.addEventListener('dblclick', (event) => hand.here || hand.ask((it) => it.glass.twice(event)));
  // The first tap comes before what answers it.
  sheet.addEventListener('click', (event) => hand.ask((it) => it.telling.tap(event)));
  // Two fingers zoom the picture, not the page.
  sheet.addEventListener('touchstart', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault(), { passive: false });

  tool(store, 'light', async () => new (await import('./look/light')).LightOnCanvas(work));
  tool(store, 'layers', async () => new (await import('./look/layers')).Layers(store, view));
  tool(store, 'compare', async () => new (await import('./look/compare')).Compare(work, view));
  tool(store, 'plots', async () => new (await import('./look/plots')).Plots(work.engine, view));

  const tiles = new Later(async () => new (await import('./look/tiles')).Tiles(store, view));
  byId('tile-button').addEventListener('click', () => {
    // Points are moved on one picture, and two are compared as one: what was asked for last goes on.
    leave();
    store.update({ compare: false, repeat: (store.state.repeat % REPEATS) + 1 });
  });
  store.on(['repeat'], ({ repeat }) => {
    say(byId('tile-word'), t('repeat_now', { n: repeat }));
    tiles.ask((it) => it.follow());
  });
  walkByArrows(byId('viewbox'));
  bind();
}

function bind(): void {
  const press = (id: string) => () => byId(id).click();
  bindKeys(
    { keys: ['+', '=', '-'], shown: ['+', '-'], word: 'key_zoom', act: (key) => byId(key === '-' ? 'zoom-out' : 'zoom-in').click(), repeats: true },
    { keys: ['f'], word: 'key_fit', act: press('zoom-fit') },
    { keys: ['l'], word: 'key_light', act: press('light-button') },
    { keys: ['o'], word: 'key_layers', act: press('layers-button') },
    { keys: ['t'], word: 'key_repeat', act: press('tile-button') },
    { keys: ['v'], word: 'key_compare', act: press('compare-button') },
    { keys: ['p'], word: 'key_plots', act: press('plots-button') },
  );
}

/** A button that shows and hides what its state says. */
function tool(store: Store, name: Tool, load: () => Promise<Shown>): void {
  const button = byId(`${name}-button`);
  const state = button.hasAttribute('aria-pressed') ? 'aria-pressed' : 'aria-expanded';
  const shown = new Later(load);
  button.addEventListener('click', () => store.update({ [name]: !store.state[name] }));
  store.on([name], (now) => {
    button.setAttribute(state, String(now[name]));
    shown.ask((it) => it.show(store.state[name]));
  });
}
