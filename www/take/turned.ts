/** Exports of the turntable: pictures of its bodies, the data planes of these, and a film of one turn. */
import { t } from '../words/take';
import { make } from '../base/dom';
import type { Work } from '../state/work';
import { row, select } from './dialog';
import { FILES, makeFilm } from './film';
import type { Kind } from './file-name';
import { codecsFor, type Codec } from './files/codecs';
import type { Job } from './files/job.worker';
import type { Backdrop } from './files/turn';
import { seenNow } from './seen';

/** Pixels along the side of a picture, and its factors. */
const SIDE = 1024;
const SCALES = [1, 2, 3, 4];

const PLANES = ['depth', 'normal', 'id'] as const;

/** The last choices. */
const chosen: { scale: string; backdrop: string; blur: string } = { scale: '1', backdrop: 'floor', blur: '0' };

type Offer = (id: string, word: string, kind: () => Kind, job: () => Job) => HTMLElement;

/** The row of the dialog. `offer` makes a button for a file; `close` closes the dialog. */
export function turned({ engine, store }: Work, offer: Offer, close: () => void): HTMLElement {
  const sizes = Object.fromEntries(SCALES.map((scale) => [scale, t('turned_scale', { scale, n: SIDE * scale })]));
  const size = select('turn-size', t('turned_size'), sizes, chosen.scale);
  const behind = select('turn-backdrop', t('backdrop'), { floor: t('floor'), sky: t('sky'), nothing: t('nothing') }, chosen.backdrop);
  const blur = select('turn-blur', t('blur'), { 0: t('blur_none'), 0.03: t('blur_little'), 0.08: t('blur_much') }, chosen.blur);
  blur.addEventListener('change', () => (chosen.blur = blur.value));
  size.addEventListener('change', () => (chosen.scale = size.value));
  behind.addEventListener('change', () => (chosen.backdrop = behind.value));
  const job = (plane: (typeof PLANES)[number] | undefined) => (): Job => {
    const scale = Number(size.value);
    return { file: 'turn', plane, side: SIDE * scale, scale, backdrop: behind.value as Backdrop, aperture: Number(blur.value), ...seenNow(engine, store) };
  };
  const kind = (variant: string[]) => (): Kind => ({ size: SIDE * Number(size.value), variant: ['turn', ...variant], ending: 'png' });
  return row(
    t(engine.offers('frames') ? 'picture' : 'turned'),
    t('turned_note'),
    size,
    behind,
    blur,
    offer('save-turn', 'PNG', kind([]), job(undefined)),
    ...PLANES.map((plane) => offer(`save-turn-${plane}`, t(plane), kind([plane]), job(plane))),
    film((codecs) => {
      close();
      void makeFilm(engine, store, 'turn', codecs);
    }),
  );
}

/**
 * The button of the film. It makes the best file that the browser can encode, or an animation, which all browsers can
 * make.
 */
function film(makeIt: (codecs: Codec[]) => void): HTMLElement {
  const key = make('button', { type: 'button', class: 'key', id: 'save-turn-film', disabled: '' }, t('turned_film', { file: FILES.mp4 }));
  void codecsFor('turn').then((codecs) => {
    key.textContent = t('turned_film', { file: codecs[0] ? FILES[codecs[0].file] : 'GIF' });
    key.disabled = false;
    key.addEventListener('click', () => makeIt(codecs));
  });
  return key;
}
