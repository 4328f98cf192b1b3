/** The dialog that shares the picture: its link, the system's sheet, a QR code, and code for other pages. */
import { isEnd } from '../module/stages';
import { overlayIn } from '../words/look';
import { t } from '../words/take';
import { viewIn } from '../words/words';
import { make, say, wantsStill } from '../base/dom';
import type { Engine } from '../state/engine';
import { address, embedAddress, valuesIn } from '../state/link';
import { written } from '../state/asked-view';
import { joined, PACE, WHOLE, type Viewing } from '../state/viewing';
import type { Store } from '../state/store';
import { shown, takeDialog } from './dialog';
import { makeFilm, shared, shareFile, sharesFile } from './film';
import { codecsFor, type Codec, type Shape } from './files/codecs';
import { nameOf } from './name';
import { signedPng } from './origin';
import { MOST, qrCode } from './qr';

/** Sides of the embedded picture, in pixels. */
const SIDES = [320, 480, 640, 800];

/** A part of the dialog that contains the link and is updated with it. */
interface Linked {
  readonly element: HTMLElement;
  /** `state` is the whole fragment; `words` is the part of it that describes the view. */
  follow(state: string, words: string): void;
}

export function share(engine: Engine, store: Store, canvas: HTMLCanvasElement): void {
  const recipe = engine.link();
  const name = store.state.preset?.recipe === recipe ? store.state.preset.shown.title : t('own');
  const title = t('title', { name });
  const told = make('p', { class: 'take-told', role: 'status' });
  const picture = 'share' in navigator ? pictureOf(store.state.turn ? (document.querySelector<HTMLCanvasElement>('#turn canvas') ?? canvas) : canvas, address(recipe), nameOf(engine, store, { size: canvas.width, ending: 'png' })) : undefined;
  const parts = [linkOf(engine, picture, title, told), codeOf(), embedding(title, told)];
  const viewing = seen(engine, store);
  const words = written(viewing, engine.generator);
  const follow = (as: string): void => parts.forEach((part) => part.follow(joined(recipe, as), as));
  const [first, ...others] = parts.map(({ element }) => element);
  first?.append(asSeen(viewing, words, follow), told);
  const film = (shape: Shape, codecs: Codec[]): void => {
    dialog.close();
    void makeFilm(engine, store, shape, codecs);
  };
  // A film of the turntable shows one turn of it.
  const shapes: Shape[] = store.state.turn ? ['turn'] : engine.offers('forming') ? ['square', 'upright'] : [];
  const alone = picture ? [filesAlone(picture, shapes, film)] : [];
  const dialog = takeDialog('share-dialog', t('share'), ...(first ? [first] : []), ...alone, ...others);
  follow('');
  dialog.querySelector<HTMLElement>('#copy')?.focus();
}

async function pictureOf(canvas: HTMLCanvasElement, recipe: string, name: string): Promise<File | undefined> {
  const png = await signedPng(canvas, recipe);
  return png && new File([png], name, { type: png.type });
}

/** The view of the picture, without values that every visitor sees anyway. */
function seen(engine: Engine, store: Store): Viewing {
  const { view, overlays, pace, paused, stage, zoom, turn, camera, cut, body } = store.state;
  return {
    view,
    overlays,
    pace: pace === (wantsStill() ? PACE.still : PACE.usual) ? undefined : pace,
    step: paused && !isEnd(stage) && engine.offers('forming') ? engine.status().steps : undefined,
    zoom,
    camera: turn ? camera : undefined,
    cut: turn ? cut : undefined,
    body: turn ? body?.subject : undefined,
  };
}

/** The option of a link that restores the current view. */
function asSeen(viewing: Viewing, words: string, follow: (words: string) => void): HTMLElement {
  const check = make('input', { type: 'checkbox', id: 'share-seen', 'aria-describedby': 'share-sees' });
  check.disabled = words === '';
  check.addEventListener('change', () => follow(check.checked ? words : ''));
  const note = make('p', { class: 'take-note', id: 'share-sees' }, words === '' ? t('sees_nothing') : t('sees', { what: described(viewing) }));
  return make('div', { class: 'take-choice' }, check, make('label', { for: 'share-seen' }, t('as_seen')), note);
}

function described({ view = 'auto', overlays = [], pace, step, zoom = WHOLE, camera, cut, body }: Viewing): string {
  const speed = document.querySelector('#speed :checked + span')?.textContent;
  return [
    ...(view === 'auto' && !overlays.length ? [] : [[viewIn(view), ...overlays.map((word) => overlayIn(word)[0])].join(' + ')]),
    ...(pace === undefined ? [] : [speed ? t('sees_speed', { speed }) : t('sees_pace', { n: pace })]),
    ...(step === undefined ? [] : [t('sees_step', { n: step })]),
    ...(camera ? [t('sees_slant')] : []),
    ...(cut ? [t('sees_cut')] : []),
    ...(body ? [t('sees_body')] : []),
    ...(zoom.scale > 1 ? [`${Number(zoom.scale.toFixed(1))}×`] : []),
  ].join(t('listed'));
}

function section(...parts: HTMLElement[]): HTMLElement {
  return make('section', {}, ...parts);
}

/** The link, to be copied or given to the system, and a note on its content. */
function linkOf(engine: Engine, picture: Promise<File | undefined> | undefined, title: string, told: HTMLElement): Linked {
  const box = make('input', { id: 'share-link', type: 'text', readonly: '', spellcheck: 'false' });
  const copyLink = make('button', { type: 'button', class: 'key', id: 'copy' }, t('copy_link'));
  copyLink.addEventListener('click', () => void copied(box, told, t('copied_link')));
  box.addEventListener('focus', () => box.select());
  const row = make('div', { class: 'take-row' }, box, copyLink);
  if (picture) row.append(systemButton(() => box.value, title, picture, told));
  const note = make('p', { class: 'take-note', id: 'share-holds' });
  return {
    element: section(make('label', { for: 'share-link' }, t('link')), row, note),
    follow: (state, words) => {
      box.value = address(state);
      say(note, holds(engine, box.value, words));
      say(told, '');
    },
  };
}

/** The QR code of the link, unless the link is too long. */
function codeOf(): Linked {
  const element = section();
  return {
    element,
    follow: (state) => {
      const link = address(state);
      if (link.length > MOST) return element.replaceChildren(make('p', { class: 'take-note', id: 'qr-long' }, t('qr_long', { n: shown(link.length), most: shown(MOST) })));
      const said = make('div', {}, make('h3', {}, t('qr')), make('p', { class: 'take-note' }, t('qr_note')));
      const place = make('div', { class: 'take-qr' }, said);
      place.prepend(qrCode(link, t('qr_label')));
      element.replaceChildren(place);
    },
  };
}

/** A sentence on the length and content of the link. */
function holds(engine: Engine, link: string, words: string): string {
  const values = valuesIn(engine.link()).length;
  const parts = [values === 0 ? t('holds_nothing') : values === 1 ? t('holds_one') : t('holds_values', { n: values })];
  if (engine.get('outline') === 'polygon' && engine.get('tile') !== '1') {
    parts.push(t('holds_points', { n: engine.outline().reduce((sum, ring) => sum + ring.length, 0) }));
  }
  if (words !== '') parts.push(t('holds_view'));
  return t('holds', { n: shown(link.length), what: parts.join(t('and')) });
}

async function copied(box: HTMLInputElement | HTMLTextAreaElement, told: HTMLElement, sentence: string): Promise<void> {
  say(told, '');
  try {
    await navigator.clipboard.writeText(box.value);
    say(told, sentence);
  } catch {
    box.focus();
    box.select();
    say(told, t('not_copied'));
  }
}

/**
 * The button of the system's sheet. The sheet gets the link and, where it takes files, the picture, which carries the
 * recipe's link.
 */
function systemButton(urlNow: () => string, title: string, picture: Promise<File | undefined>, told: HTMLElement): HTMLElement {
  const button = make('button', { type: 'button', class: 'key', id: 'share-system' }, t('system'));
  // The file is made beforehand, because a sheet opens only right after a click.
  let file: File | undefined;
  void picture.then((made) => (file = made));
  button.addEventListener('click', () => {
    const plain: ShareData = { title, url: urlNow() };
    void shared(file && sharesFile(file) ? { ...plain, files: [file] } : plain).then((failed) => say(told, failed));
  });
  return button;
}

/** The picture and its film as files alone, if the system's sheet takes files. */
function filesAlone(picture: Promise<File | undefined>, shapes: readonly Shape[], film: (shape: Shape, codecs: Codec[]) => void): HTMLElement {
  const told = make('p', { class: 'take-told', role: 'status' });
  const row = make('div', { class: 'take-row' });
  const element = make('section', { hidden: '', id: 'share-alone' }, make('h3', {}, t('alone')), make('p', { class: 'take-note' }, t('alone_note')), row, told);
  const add = (id: string, word: string, act: () => void): void => {
    const key = make('button', { type: 'button', class: 'key', id }, word);
    key.addEventListener('click', act);
    row.append(key);
    element.hidden = false;
  };
  const fill = async (): Promise<void> => {
    const file = await picture;
    if (file && sharesFile(file)) add('share-picture', t('picture'), () => void shareFile(file).then((failed) => say(told, failed)));
    for (const shape of shapes) {
      const codecs = await codecsFor(shape);
      const file = codecs[0]?.file;
      if (file && sharesFile(new File([], `film.${file}`, { type: `video/${file}` }))) add(`share-${shape}`, t(`film_${shape}`), () => film(shape, codecs));
    }
  };
  void fill();
  return element;
}

/** HTML code that shows the picture alone in another page. */
function embedding(title: string, told: HTMLElement): Linked {
  let state = '';
  const sizes = (id: string, full: boolean): HTMLSelectElement => {
    const select = make('select', { id }, ...SIDES.map((side) => make('option', { value: String(side) }, t('pixels', { n: side }))));
    if (full) select.append(make('option', { value: '100%' }, t('full_width')));
    select.value = '480';
    return select;
  };
  const width = sizes('embed-width', true);
  const height = sizes('embed-height', false);
  const code = make('textarea', { id: 'embed-code', readonly: '', rows: '3', spellcheck: 'false' });
  const write = (): void => {
    const attribute = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
    code.value = `<iframe src="${attribute(embedAddress(state))}" title="${attribute(title)}" width="${width.value}" height="${height.value}" style="border:0" loading="lazy"></iframe>`;
  };
  width.addEventListener('change', write);
  height.addEventListener('change', write);
  code.addEventListener('focus', () => code.select());
  const copy = make('button', { type: 'button', class: 'key', id: 'copy-code' }, t('copy_code'));
  copy.addEventListener('click', () => void copied(code, told, t('copied_code')));
  const element = section(
    make('h3', {}, t('embed')),
    make('p', { class: 'take-note' }, t('embed_note')),
    make('div', { class: 'take-row' }, sized(t('width'), width), sized(t('height'), height), copy),
    make('label', { class: 'said', for: 'embed-code' }, t('code')),
    code,
  );
  return {
    element,
    follow: (now) => {
      state = now;
      write();
    },
  };
}

/** A choice that stays on one line with its name. */
function sized(name: string, select: HTMLSelectElement): HTMLElement {
  return make('span', { class: 'take-sized' }, make('label', { for: select.id }, name), select);
}
