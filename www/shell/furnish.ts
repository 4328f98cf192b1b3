/**
 * The controls of the present generator: panel, dice, presets and the tools of the editor. They are built after the
 * first cells are shown.
 */
import type { Parameter, Preset } from '../module/types';
import { frame } from '../base/dom';
import { RETOLD } from '../base/language';
import { withValues } from '../state/link';
import { isLocked } from '../state/locks';
import type { State } from '../state/store';
import type { Work } from '../state/work';
import type { PictureHost } from '../picture/host';
import { SIDE } from '../panel/control';
import { Dice } from '../panel/dice';
import { Panel } from '../panel/panel';
import { Presets } from '../panel/presets';
import { Scaling } from '../panel/scaling';
import { SEED } from '../panel/seed';
import { EditTools } from './edit-tools';
import type { PageParts } from './parts';

/** The objects that the controls act on. */
interface House {
  readonly host: PictureHost;
  readonly work: Work;
  readonly parts: PageParts;
  /** Makes the next change an entry of its own in the browser's history. */
  push(): void;
  /** Opens a preset by one of its links, in its view. */
  openPreset(preset: Preset, link: string): void;
}

/** Builds the controls, and builds them again for each other generator. */
export async function furnish(house: House): Promise<void> {
  const { host, work, parts } = house;
  const { engine, store } = work;
  const scaling = new Scaling(work);
  const panel = panelOf(house, scaling);
  const tools = new EditTools(work, parts.editor, parts.take);
  const dice = new Dice(work, () => house.push());
  const presets = presetsOf(house);
  const mark = ({ recipe, preset }: State): void => presets.mark(preset?.recipe === recipe ? preset.shown.name : undefined);
  /** The generators that the panel and the rail were built for. */
  let made = '';
  let listed = '';
  const build = async (): Promise<void> => {
    const { make: word } = store.state;
    if (word === made) return;
    made = '';
    await panel.build();
    for (const part of [tools, dice, scaling]) part.build(panel);
    panel.refresh();
    panel.attach();
    host.loop.spare();
    await frame();
    if (word !== listed) presets.build(engine.presets);
    listed = word;
    mark(store.state);
    made = word;
  };
  // Builds run one after the other, because they share the panel.
  let building = Promise.resolve();
  const follow = (): Promise<void> => (building = building.catch(() => undefined).then(build));
  store.on(['make'], () => void follow());
  // Whether a choice is a list or a row of buttons depends on its words.
  addEventListener(RETOLD, () => {
    presets.retell();
    made = '';
    void follow();
  });
  store.on(['recipe'], (state) => {
    if (state.make !== made) return;
    panel.refresh();
    mark(state);
  });
  store.on(['preset'], mark);
  await follow();
}

function panelOf(house: House, scaling: Scaling): Panel {
  const { engine } = house.work;
  const { editor, space } = house.parts;
  const panel = new Panel(
    engine,
    (key, text, done) => {
      change(house, scaling, key, text, done);
      // The visitor has not chosen a file yet, so the control shows the old value again.
      if (fileFor(house, key, text)) panel.refresh();
    },
    ({ key, item }) => (item === 'file' ? space.ask((part) => part.choose(key)) : editor.ask((part) => part.toggle(key))),
  );
  return panel;
}

/** Handles a moved control. */
function change(house: House, scaling: Scaling, key: string, text: string, done: boolean): void {
  const { work, parts } = house;
  const role = fileFor(house, key, text);
  if (key === 'outline' && text === 'polygon') parts.editor.ask((editor) => editor.free());
  else if (role) parts.space.ask((space) => space.wanted(role.key));
  else if (key === SIDE) scaling.set(text, !done);
  else work.set(key, text, !done);
}

/** The parameter of the file that a value needs, if the recipe does not name the file yet. */
function fileFor({ work: { engine } }: House, key: string, text: string): Parameter | undefined {
  const files = engine.schema.filter(({ item }) => item === 'file');
  return files.find(({ key: file, shownFor }) => shownFor?.key === key && shownFor.words.includes(text) && engine.get(file) === '');
}

function presetsOf(house: House): Presets {
  const { work, parts } = house;
  const { engine, store } = work;
  return new Presets((preset) => {
    parts.editor.here?.close();
    house.push();
    store.update({ paused: false });
    house.openPreset(preset, isLocked(store, SEED) ? withValues(preset.link, [[SEED, engine.get(SEED)]]) : preset.link);
  });
}
