/** Makes one file. Nothing here blocks the page: it is a worker, which ends with the file. */
import { Bubblestone } from '../../pkg/bubblestone.js';
import { loadModule } from '../module/load';
import { formingGif } from './forming';
import type { Job, Order, Said } from './job';
import { mapsZip } from './maps-zip';
import { meshFile } from './mesh-file';
import { pavement, type Progress } from './pavement';
import { pictureFile } from './picture';
import { Refusal } from './refusal';

const say = (said: Said): void => postMessage(said);

addEventListener('message', ({ data: [link, job] }: MessageEvent<Order>) => {
  made(link, job, (progress) => say({ progress })).then(
    (file) => say({ file }),
    (error: unknown) => say({ trouble: error instanceof Refusal ? error.notice : error instanceof Error ? error.message : String(error) }),
  );
});

async function made(link: string, job: Job, progress: Progress): Promise<Blob> {
  await loadModule();
  const studio = new Bubblestone(link);
  if (job.file === 'gif') return formingGif(studio, progress);
  // The pavement is this part of the work.
  const part = job.file === 'picture' ? 1 / job.scale ** 2 : 0.8;
  const rest = (done: number): void => progress(part + (1 - part) * done);
  pavement(studio, (done) => progress(part * done));
  switch (job.file) {
    case 'svg':
      return new Blob([studio.svg()], { type: 'image/svg+xml' });
    case 'picture':
      return pictureFile(studio, job.scale, rest);
    case 'maps':
      return mapsZip(studio, job.normals, rest);
    default:
      return meshFile(studio, job.file);
  }
}
