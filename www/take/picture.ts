/** The finished picture at several times its side, written row after row as a PNG file. */
import type { Engine } from '../engine';
import { PngWriter } from './png';
import { t } from './words';
import { breath, BUDGET, type Task } from './working';

export async function pictureFile(engine: Engine, scale: number, task: Task): Promise<Blob> {
  if (typeof CompressionStream !== 'function') throw new Error(t('old'));
  let file: PngWriter | undefined;
  try {
    for (;;) {
      await breath();
      task.signal.throwIfAborted();
      const slice = engine.pictureFile(scale, BUDGET);
      if (typeof slice === 'string') throw new Error(slice);
      if (slice.begun || !file) file = new PngWriter(slice.side, 3, 8);
      if (slice.rows.length) await file.write(slice.rows);
      task.progress(slice.progress);
      if (slice.done) return new Blob([await file.finish()], { type: 'image/png' });
    }
  } finally {
    engine.stopFile();
  }
}
