/** Makes one file in a worker, which ends with the file. So the page is never blocked. */
import { studioFor } from '../../module/given';
import { loadModule, loadWhole } from '../../module/load';
import { generatorOf } from '../../module/run';
import type { Notice } from '../../module/types';
import { serve } from '../../late/worker';
import type { FilmJob } from './film';
import { formingGif, type GifJob } from './forming';
import { mapsZip, type MapsJob } from './maps-zip';
import { meshFile, type MeshJob } from './mesh-file';
import { pictureFile } from './picture';
import { given, Refusal } from './refusal';
import { slabFile, type Slab } from './slab';
import { turnFile, type TurnJob } from './turn';
import type { TurnFilmJob } from './turn-film';
import { workedOut, type Progress } from './worked';

/** The file to make; `scale` multiplies the picture's side. */
export type Job =
  | { file: 'svg' }
  | { file: 'places' }
  | { file: 'building' }
  | GifJob
  | FilmJob
  | TurnJob
  | TurnFilmJob
  | MeshJob
  | { file: 'stl'; slab: Slab }
  | { file: 'picture'; scale: number }
  | MapsJob;

/** The message to the worker: the recipe and the file to make from it. */
export type JobRequest = [link: string, job: Job];

/** The worker's answer: the file, or the reason why there is none. */
export type JobResult = { file: Blob } | { refused: Notice };

serve(async ([link, job]: JobRequest, progress): Promise<JobResult> => {
  try {
    return { file: await made(link, job, progress) };
  } catch (error) {
    if (error instanceof Refusal) return { refused: error.notice };
    throw error;
  }
});

async function made(link: string, job: Job, progress: Progress): Promise<Blob> {
  if (job.file === 'turn') return turnFile(link, job, progress);
  if (job.file === 'turn-film') {
    const { turnFilm } = await import('./turn-film');
    return turnFilm(link, job, progress);
  }
  // The module of a first visit writes no meshes, and no SVG files.
  const module = 'detail' in job || job.file === 'svg' ? await loadWhole() : await loadModule(link);
  const studio = await studioFor(module, link);
  const generator = generatorOf(module, studio);
  if (job.file === 'gif') return formingGif(studio, generator, job, progress);
  if (job.file === 'film') {
    // Only films load the code for films.
    const { formingFilm } = await import('./film');
    return formingFilm(studio, generator, job, progress);
  }
  // The share of the work that the picture takes.
  const part = 'scale' in job && job.scale > 1 ? 1 / job.scale ** 2 : 0.8;
  const rest = (done: number): void => progress(part + (1 - part) * done);
  workedOut(studio, generator, (done) => progress(part * done));
  switch (job.file) {
    case 'svg':
      return new Blob([studio.svg()], { type: 'image/svg+xml' });
    case 'building':
      return new Blob([studio.building()], { type: 'application/json' });
    case 'places':
      return new Blob([studio.places()], { type: 'text/csv' });
    case 'picture':
      return pictureFile(studio, job.scale, rest);
    case 'maps':
      return mapsZip(studio, job, rest);
    case 'stl':
      return slabFile(job.slab, given(studio.map('height-float')), studio.get('tile') === '1', rest);
    default:
      return meshFile(studio, job);
  }
}
