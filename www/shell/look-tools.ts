/** The buttons for inspecting, beside the canvas. */
import { t } from '../words/words';
import { byId, say, walkByArrows } from '../base/dom';
import { bindKeys } from '../base/keys';
import type { Later } from '../base/later';
import type { Store } from '../state/store';
import type { PageParts } from './parts';

/** Tools that appear beside or over the picture. */
type Tool = 'light' | 'layers' | 'compare' | 'plots' | 'turn';

interface Shown {
  /** Called whenever the tool is shown or hidden. */
  show(on: boolean): void;
}

const REPEATS = 3;

/** `leave` ends the editing on the picture. */
export function makeLookTools(store: Store, parts: PageParts, leave: () => void): void {
  forward(parts, store);
  store.on(['zoom'], () => void parts.pointer.load());
  tool(store, 'light', parts.light);
  tool(store, 'layers', parts.layers);
  tool(store, 'compare', parts.compare);
  tool(store, 'plots', parts.plots);
  tool(store, 'turn', parts.turn);
  store.on(['turn'], ({ turn }) => {
    if (!turn) return;
    leave();
    store.update({ compare: false, repeat: 1 });
  });
  byId('tile-button').addEventListener('click', () => {
    // Editing and comparing need a single picture. The mode chosen last ends the other modes.
    leave();
    store.update({ compare: false, turn: false, repeat: (store.state.repeat % REPEATS) + 1 });
  });
  store.on(['repeat'], ({ repeat }) => {
    say(byId('tile-word'), t('repeat_now', { n: repeat }));
    parts.tiles.ask((it) => it.follow());
  });
  walkByArrows(byId('look-tools'));
  bind();
}

/** Passes events on the picture to parts that are loaded on demand; early events are kept for them. */
function forward({ pointer, turn }: PageParts, store: Store): void {
  const zoom = (by: number) => () => (store.state.turn ? turn.ask((it) => it.step(by)) : pointer.ask((it) => it.zoom.step(by)));
  byId('zoom-in').addEventListener('click', zoom(1));
  byId('zoom-out').addEventListener('click', zoom(-1));
  byId('zoom-fit').addEventListener('click', zoom(0));
  const sheet = byId('sheet');
  for (const sign of ['pointerover', 'pointerdown', 'focusin']) sheet.addEventListener(sign, () => void pointer.load(), { once: true, passive: true });
  sheet.addEventListener(
    'wheel',
    (event) => {
      if (pointer.here) return;
      // Fully zoomed out, the wheel scrolls the page.
      if (event.deltaY < 0 || event.ctrlKey) event.preventDefault();
      pointer.ask((it) => it.zoom.wheel(event));
    },
    { passive: false },
  );
  sheet.addEventListener('dblclick', (event) => pointer.here || pointer.ask((it) => it.zoom.twice(event)));
  sheet.addEventListener('click', (event) => pointer.ask((it) => it.probe.tap(event)));
  // Two fingers zoom the picture, not the page.
  sheet.addEventListener('touchstart', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault(), { passive: false });
}

function bind(): void {
  const press = (id: string) => () => byId(id).click();
  const turn = (): void => {
    // The focus moves to the button, so that further keys go on from there.
    byId('turn-button').focus();
    byId('turn-button').click();
  };
  bindKeys(
    { keys: ['+', '=', '-'], shown: ['+', '-'], word: 'zoom', act: (key) => byId(key === '-' ? 'zoom-out' : 'zoom-in').click(), repeats: true },
    { keys: ['f'], word: 'fit', act: press('zoom-fit') },
    { keys: ['l'], word: 'light', act: press('light-button') },
    { keys: ['o'], word: 'layers', act: press('layers-button') },
    { keys: ['g'], word: 'slant', part: 'turn', act: turn },
    { keys: ['t'], word: 'repeat', part: 'tiles', act: press('tile-button') },
    { keys: ['v'], word: 'compare', part: 'compare', act: press('compare-button') },
    { keys: ['p'], word: 'plots', part: 'plots', act: press('plots-button') },
  );
}

/** A button that toggles a tool in the state. */
function tool(store: Store, name: Tool, part: Later<Shown>): void {
  const button = byId(`${name}-button`);
  const state = button.hasAttribute('aria-pressed') ? 'aria-pressed' : 'aria-expanded';
  button.addEventListener('click', () => button.hidden || store.update({ [name]: !store.state[name] }));
  // A tool that did not load is off, so that the next press shows it. Without a button, it stays wanted.
  const follow = (): void => part.ask((it) => it.show(store.state[name]), () => button.hidden || store.update({ [name]: false }));
  store.on([name], (now) => {
    button.setAttribute(state, String(now[name]));
    if (now[name] || part.here) follow();
  });
  if (store.state[name]) follow();
}
