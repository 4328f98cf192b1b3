/** The film of the forming: how the page orders it and hands it over. */
import { t } from '../words/take';
import { make } from '../base/dom';
import { notice, offerOf } from '../base/messages';
import { offer } from '../late/download';
import type { ToldTask } from '../late/task';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';
import type { Codec, Shape } from './files/codecs';
import { finished } from './finished';
import { fileOf } from './job';
import { nameOf } from './name';
import { seenNow } from './seen';
import { working } from './working';

/** Names of film files on the page. */
export const FILES = { mp4: 'MP4', webm: 'WebM' };

/** Makes a film of the finished picture, or of a turn of the turntable, and hands it over. */
export function makeFilm(engine: Engine, store: Store, shape: Shape, codecs: Codec[]): Promise<void> {
  const { preset, recipe } = store.state;
  const style = getComputedStyle(document.body);
  const words = { title: preset?.recipe === recipe ? preset.shown.title : '', font: style.getPropertyValue('--serif'), latin: style.getPropertyValue('--latin') };
  const work = async (task: ToldTask): Promise<Blob> => {
    const seen = seenNow(engine, store);
    if (shape === 'turn') return fileOf(engine.link(), { file: 'turn-film', codecs, ...seen }, task);
    await finished(engine, store, task);
    return fileOf(engine.link(), { file: 'film', codecs, shape, words, ...seen }, task);
  };
  return working(nameOf(engine, store, { variant: [shape], ending: codecs[0]?.file ?? 'gif' }), work, handOver);
}

/**
 * Where the system can share files, offers to share or to save the film. The system's sheet opens only right after a
 * click.
 */
function handOver(film: Blob, name: string): boolean {
  const file = new File([film], name, { type: film.type });
  if (!sharesFile(file)) return false;
  const share = make('button', { type: 'button', id: 'share-film' }, t('system'));
  const save = make('button', { type: 'button', id: 'keep-film' }, t('save'));
  share.addEventListener('click', () => void shareFile(file).then((failed) => failed && notice('trouble', failed)));
  save.addEventListener('click', () => offer(film, name));
  offerOf('files', t('film_made', { name }), share, save);
  return true;
}

/** Whether the system can share such a file. */
export function sharesFile(file: File): boolean {
  return 'canShare' in navigator && navigator.canShare({ files: [file] });
}

/**
 * Opens the system's sheet for a file alone: many programs accept a file or a link, not both. Returns an error as a
 * sentence; '' without an error or if the visitor cancelled.
 */
export function shareFile(file: File): Promise<string> {
  return shared({ files: [file] });
}

/** Opens the system's sheet for any data, and answers like `shareFile`. */
export async function shared(data: ShareData): Promise<string> {
  try {
    await navigator.share(data);
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'AbortError')) return t('system_failed', { reason: String(error) });
  }
  return '';
}
