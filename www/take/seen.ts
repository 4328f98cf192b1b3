/** The subject, camera and view that the turntable shows now. */
import { cameraWords, firstCamera, homeOf, wholeBodies } from '../state/asked-view';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';
import type { Seen } from './files/turn';

export function seenNow(engine: Engine, { state: { body, camera, cut, view } }: Store): Seen {
  const first = firstCamera(engine.generator, (key) => engine.get(key));
  return { subject: body?.subject ?? '', camera: cameraWords(body?.camera ?? camera ?? first, homeOf(engine.generator)), view: engine.offers('frames') ? [view, wholeBodies(body ? undefined : cut)].filter(Boolean).join('+') : 'auto' };
}
