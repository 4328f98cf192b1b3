/** The page's own buttons and keys. */
import { language, t } from '../words/words';
import { byId, byIdAs, enable, say } from '../base/dom';
import { bindKeys, listenToKeys } from '../base/keys';
import { speak } from '../base/language';
import { tellLost } from '../base/later';
import { clear } from '../base/messages';
import type { History } from '../state/history';
import type { State } from '../state/store';
import type { Work } from '../state/work';
import type { Forming } from '../picture/forming';
import type { PictureHost } from '../picture/host';
import type { View } from '../picture/view';
import { copyLink } from './copy';
import type { PageParts } from './parts';

/** The objects that the buttons act on. */
interface House {
  readonly host: PictureHost;
  readonly work: Work;
  readonly parts: PageParts;
  readonly view: View;
  readonly history: History;
  readonly forming: Forming;
  /** Restarts the forming. */
  again(): void;
}

export function bindButtons(house: House): void {
  const { host, work, parts, view, history, forming } = house;
  const { engine, store } = work;
  bindAllKeys(house);
  for (const id of ['share', 'save']) onClick(id, () => forming.leave());
  onClick('share', () => parts.share.ask(({ share }) => share(engine, store, view.canvas)));
  onClick('save', () => parts.save.ask(({ SaveDialog }) => new SaveDialog(work, view.canvas, parts.take)));
  onClick('your-model', () => parts.space.ask((space) => space.yours()));
  for (const near of ['pointerover', 'focusin']) byId('your-model').addEventListener(near, () => void parts.space.load(), { once: true });
  onClick('undo', () => history.undo());
  onClick('redo', () => history.redo());
  onClick('about-button', () => {
    byId('about').scrollIntoView({ behavior: host.still ? 'auto' : 'smooth' });
    byId('about').focus({ preventScroll: true });
  });
  const select = byIdAs('language', HTMLSelectElement);
  select.value = language();
  let isLost = false;
  select.addEventListener('change', () => {
    const lose = (): void => {
      isLost = true;
      select.value = language();
      tellLost();
    };
    const isSpoken = (): void => {
      if (isLost) clear('part');
      isLost = false;
      host.loop.redraw();
    };
    void speak(select.value).then(isSpoken, lose);
  });
  store.on(['past', 'future', 'stored', 'own'], showHistory);
  showHistory(store.state);
}

function bindAllKeys(house: House): void {
  const { work: { engine, store }, parts, view } = house;
  const press = (id: string) => () => byId(id).click();
  bindKeys(
    { keys: [' '], shown: ['Space'], word: 'play', act: press('play') },
    { keys: ['s', '.'], word: 'step', act: press('step'), repeats: true },
    { keys: [','], word: 'back', act: () => parts.timeline.ask((timeline) => timeline.goBack()), repeats: true },
    { keys: ['r'], word: 'restart', act: () => house.again() },
    { keys: ['d'], word: 'dice', act: press('dice') },
    { keys: ['x'], word: 'throw', act: press('throw') },
    { keys: ['ctrl+z'], shown: ['Ctrl+Z'], word: 'undo', act: press('undo'), repeats: true },
    { keys: ['ctrl+shift+z', 'ctrl+y'], shown: ['Ctrl+Shift+Z', 'Ctrl+Y'], word: 'redo', act: press('redo'), repeats: true },
    { keys: ['c'], word: 'copy', act: () => void copyLink(engine.link()) },
    { keys: '0123456789'.split(''), shown: ['0', '–', '9'], word: 'view', act: (key) => store.update({ view: view.bases[Number(key)] ?? 'auto' }) },
    { keys: ['e'], word: 'edit', part: 'outline', act: () => parts.editor.ask((editor) => editor.toggle()) },
  );
  listenToKeys();
}

function showHistory({ past, future, stored, own }: State): void {
  enable(byIdAs('undo', HTMLButtonElement), past.length > 0);
  enable(byIdAs('redo', HTMLButtonElement), future.length > 0);
  const note = byId('stored');
  const text = stored && own ? t('stored') : '';
  // Screen readers announce it only the first time.
  if (!text && note.textContent) note.ariaLive = 'off';
  say(note, text);
}

function onClick(id: string, act: () => void): void {
  byId(id).addEventListener('click', act);
}
