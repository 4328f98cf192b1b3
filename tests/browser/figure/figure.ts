/**
 * A figure on a page without any other part of ours. The address has a recipe and its view, with a "!" between them.
 */
import { PictureHost } from '../../../www/picture/host';
import { load } from '../../../www/state/arrivals';

const [canvas, line] = [document.querySelector('canvas'), document.querySelector('p')];
const [link, view = 'auto'] = location.hash.slice(1).split('!');
if (canvas && line && link !== undefined) {
  await load(link);
  const host = new PictureHost(link, {
    canvas,
    view: () => view,
    camera: () => undefined,
    worked: (stage) => (line.textContent = host.engine.problem() || stage),
    crashed: (error) => (line.textContent = String(error)),
  });
  host.still = false;
  host.drive({ paused: false, pace: 1000 });
  host.changed();
  Object.assign(window, { load, host });
}
