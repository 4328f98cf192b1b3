/** The dialog that shares the picture: its link, the system's way, a QR code, and code for other pages. */
import { t } from '../words/take';
import { make, say } from '../base/dom';
import type { Engine } from '../state/engine';
import { address, embedAddress, valuesIn } from '../state/link';
import type { Store } from '../state/store';
import { takeDialog } from './dialog';
import { signedPng } from './origin';
import { MOST, qrCode } from './qr';

/** Sides in pixels that the embedded picture may have. */
const SIDES = [320, 480, 640, 800];

export function share(engine: Engine, store: Store, canvas: HTMLCanvasElement): void {
  const state = engine.link();
  const link = address(state);
  const name = store.state.preset?.recipe === state ? store.state.preset.shown.title : t('own');
  const told = make('p', { class: 'take-told', role: 'status' });
  const box = make('input', { id: 'share-link', type: 'text', readonly: '', value: link, spellcheck: 'false' });
  const copyLink = make('button', { type: 'button', class: 'key', id: 'copy' }, t('copy_link'));
  copyLink.addEventListener('click', () => void copied(box, told, t('copied_link')));
  const row = make('div', { class: 'take-row' }, box, copyLink);
  if ('share' in navigator) row.append(systemButton(link, t('title', { name }), canvas, told));
  const dialog = takeDialog(
    'share-dialog',
    t('share'),
    section(make('label', { for: 'share-link' }, t('link')), row, make('p', { class: 'take-note', id: 'share-holds' }, holds(engine, link, state)), told),
    section(link.length > MOST ? make('p', { class: 'take-note', id: 'qr-long' }, t('qr_long', { n: shown(link.length), most: shown(MOST) })) : codeOf(link)),
    embedding(engine.link(), t('title', { name }), told),
  );
  box.addEventListener('focus', () => box.select());
  dialog.querySelector<HTMLElement>('#copy')?.focus();
}

function section(...parts: HTMLElement[]): HTMLElement {
  return make('section', {}, ...parts);
}

function codeOf(link: string): HTMLElement {
  const place = make('div', { class: 'take-qr' }, make('div', {}, make('h3', {}, t('qr')), make('p', { class: 'take-note' }, t('qr_note'))));
  place.prepend(qrCode(link, t('qr_label')));
  return place;
}

/** How long the link is, and what it holds. */
function holds(engine: Engine, link: string, state: string): string {
  const values = valuesIn(state).length;
  const parts = [values === 0 ? t('holds_nothing') : values === 1 ? t('holds_one') : t('holds_values', { n: values })];
  if (engine.get('outline') === 'polygon' && engine.get('tile') !== '1') {
    parts.push(t('holds_points', { n: engine.outline().reduce((sum, ring) => sum + ring.length, 0) }));
  }
  return t('holds', { n: shown(link.length), what: parts.join(t('and')) });
}

function shown(count: number): string {
  return count.toLocaleString(document.documentElement.lang);
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

/** The system's own sheet, with the picture where it takes files. */
function systemButton(url: string, title: string, canvas: HTMLCanvasElement, told: HTMLElement): HTMLElement {
  const button = make('button', { type: 'button', class: 'key', id: 'share-system' }, t('system'));
  // Made beforehand: a sheet opens only right after a click.
  let picture: File | undefined;
  void signedPng(canvas, url).then((blob) => (picture = blob && new File([blob], 'bubblestone.png', { type: blob.type })));
  button.addEventListener('click', () => {
    const plain: ShareData = { title, url };
    const whole: ShareData = picture ? { ...plain, files: [picture] } : plain;
    const data = 'canShare' in navigator && navigator.canShare(whole) ? whole : plain;
    navigator.share(data).catch((error: unknown) => {
      if (!(error instanceof DOMException && error.name === 'AbortError')) say(told, t('system_failed', { reason: String(error) }));
    });
  });
  return button;
}

function embedding(state: string, title: string, told: HTMLElement): HTMLElement {
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
  write();
  width.addEventListener('change', write);
  height.addEventListener('change', write);
  code.addEventListener('focus', () => code.select());
  const copy = make('button', { type: 'button', class: 'key', id: 'copy-code' }, t('copy_code'));
  copy.addEventListener('click', () => void copied(code, told, t('copied_code')));
  return section(
    make('h3', {}, t('embed')),
    make('p', { class: 'take-note' }, t('embed_note')),
    make('div', { class: 'take-row' }, sized(t('width'), width), sized(t('height'), height), copy),
    make('label', { class: 'said', for: 'embed-code' }, t('code')),
    code,
  );
}

/** A choice that stays beside its name. */
function sized(name: string, select: HTMLSelectElement): HTMLElement {
  return make('span', { class: 'take-sized' }, make('label', { for: select.id }, name), select);
}
