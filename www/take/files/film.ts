/**
 * The film of the forming. It shows the finished picture, then how it was made, then the finished picture again, so
 * that it loops.
 *
 * The picture is made twice. The first run counts the steps and keeps the final picture; the second run makes the
 * frames. So all films have about the same length, and frames depend on steps, never on a clock.
 */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { Generator, PixelMap } from '../../module/types';
import type { Codec, FormingShape } from './codecs';
import { bigger } from './bigger';
import { FilmEncoder, quickest } from './encoder';
import { framesOf, showForming, type Show } from './frames';
import { frame, lookOf } from './look';
import { workedOut, type Progress } from './worked';
import { contextOf, FilmSheet, type SheetTexts } from './sheet';
import type { SceneStudio } from '../../module/scene';
import type { Seen } from './turn';

/** The order for a film. */
export interface FilmJob extends Seen {
  file: 'film';
  codecs: Codec[];
  shape: FormingShape;
  words: SheetTexts;
}

/** The progress at which the picture is done, and at which the enlarged picture is done; frames take the rest. */
const FIRST = 0.12;
const SECOND = 0.2;

/** Pixels along a side of the frames that show the forming. */
const MOVING = 720;

/** The most times that a picture is enlarged. */
const MOST = 4;

/** Throws a Refusal if there is no picture. */
export async function formingFilm(studio: Bubblestone, generator: Generator, { codecs, shape, words, ...seen }: FilmJob, progress: Progress): Promise<Blob> {
  const sheet = new FilmSheet(shape, words);
  workedOut(studio, generator, (done) => progress(FIRST * done));
  const status = studio.status();
  const finished = generator.offers.includes('frames') ? framedPicture(studio as SceneStudio, seen, sheet.side) : await largePicture(studio, sheet.side, (done) => progress(FIRST + (SECOND - FIRST) * done));
  sheet.lay(finished);
  const codec = await quickest(codecs, shape, sheet.frame(finished, finished, 0));
  const encoder = await FilmEncoder.of(codec, shape);
  const whole = framesOf(status.steps);
  let made = 0;
  const show: Show = async (one, other = one, share = 0, times = 1) => {
    await encoder.add(sheet.frame(one, other, share), times);
    made += times;
    progress(SECOND + (1 - SECOND) * (made / whole));
  };
  await showForming(studio, generator, lookOf(studio, generator, seen, Math.min(sheet.side, MOVING)), finished, status, show);
  return encoder.finish();
}

/** The finished bodies, as a frame. */
function framedPicture(studio: SceneStudio, seen: Seen, side: number): OffscreenCanvas {
  const context = contextOf(side, side);
  context.putImageData(frame(studio, seen, side, 'fine'), 0, 0);
  return context.canvas;
}

/** The finished picture, with as many pixels as the sheet shows of it, up to MOST times its own. */
async function largePicture(studio: Bubblestone, side: number, progress: Progress): Promise<OffscreenCanvas> {
  const scale = Math.min(MOST, Math.ceil(side / studio.side()));
  const context = contextOf(scale * studio.side(), scale * studio.side());
  let row = 0;
  const lay = ([rows]: PixelMap[]): void => {
    if (!rows?.bytes.length) return;
    const { side, bytes } = rows;
    const image = context.createImageData(side, bytes.length / 3 / side);
    const { data } = image;
    for (let from = 0, to = 0; to < data.length; to += 1) data[to] = (to & 3) === 3 ? 255 : (bytes[from++] ?? 0);
    context.putImageData(image, 0, row);
    row += image.height;
  };
  await bigger(studio, scale, [], lay, progress);
  studio.stopFile();
  return context.canvas;
}
