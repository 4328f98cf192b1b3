/** The parts of the page that are loaded on demand, by name. */
import { Later } from '../base/later';
import type { Work } from '../state/work';
import type { PictureHost } from '../picture/host';
import type { View } from '../picture/view';

/** Parts that only some generators need, with the elements that open them. */
export const OFFERED = [
  ['outline', 'edit-tools'],
  ['probe', 'cells'],
  ['tiles', 'tile-button'],
  ['compare', 'compare-button'],
  ['turn', 'turn-button'],
  ['plots', 'plots-button'],
] as const;

export type PageParts = ReturnType<typeof partsOf>;

/** `leave` ends the slow pace of a watched forming, and the pause that a link asked for. */
export function partsOf(work: Work, view: View, host: PictureHost, leave: () => void) {
  const { engine, store } = work;
  const take = (file: File, role?: string): void => given.ask((it) => void it.take(file, role));
  const editor = new Later(async () => new (await import('../editor/editor')).Editor(work, take));
  const turn = new Later(async () => new (await import('../turn/page')).PageTurntable(work, host, view));
  const space = new Later(async () => new (await import('../space/space')).Space(work, turn, { again: () => host.changed(), take }));
  const given = new Later(async () => new (await import('./given')).GivenFiles(work, editor, space));
  return {
    editor,
    pointer: new Later(async () => new (await import('../look/pointer')).Pointer(work, view)),
    light: new Later(async () => new (await import('../look/light')).LightOnCanvas(work)),
    layers: new Later(async () => new (await import('../look/layers')).Layers(work, view)),
    compare: new Later(async () => new (await import('../look/compare')).Compare(work, view, host.loop)),
    plots: new Later(async () => new (await import('../look/plots')).Plots(engine, view)),
    timeline: new Later(async () => new (await import('../look/timeline')).Timeline(work, host, leave)),
    turn,
    space,
    take,
    tiles: new Later(async () => new (await import('../look/tiles')).Tiles(store, view)),
    linked: new Later(() => import('../look/linked')),
    share: new Later(() => import('../take/share')),
    save: new Later(() => import('../take/save')),
  };
}
