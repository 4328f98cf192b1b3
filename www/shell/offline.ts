/** Lets the service worker store the site, quietly, so that the page works offline from then on. */
import { idle } from '../base/dom';

/** `stored`: all of the site is there offline. `newer`: the next visit gets a newer build than the page is of. */
type Offline = 'stored' | 'newer';

/** To be called once the first picture is done: until then nothing but the picture is worth a request. */
export function register(tell: (what: Offline) => void): void {
  // An embedded page leaves nothing behind.
  if (!('serviceWorker' in navigator) || window.top !== window.self) return;
  navigator.serviceWorker.addEventListener('message', ({ data }: MessageEvent<Offline>) => {
    document.documentElement.dataset['offline'] = data;
    tell(data);
  });
  // Forbidden, no place, no connection: the page works all the same.
  begin().catch(() => undefined);
}

async function begin(): Promise<void> {
  const registration = await navigator.serviceWorker.register(new URL('sw.js', document.baseURI), { updateViaCache: 'none' });
  await registration.update().catch(() => undefined);
  const worker = registration.installing ?? registration.waiting ?? registration.active;
  if (!worker) return;
  await activated(worker);
  const connection = (navigator as { connection?: { saveData?: boolean } }).connection;
  if (connection?.saveData) return;
  await idle(1000);
  worker.postMessage(new URL(ownScript(), document.baseURI).href.slice(registration.scope.length));
}

/** The path of the page's script, which has the build's hash in its name. */
function ownScript(): string {
  return document.querySelector('script[type=module]')?.getAttribute('src') ?? '';
}

function activated(worker: ServiceWorker): Promise<void> {
  return new Promise((resolve, reject) => {
    const look = (): void => {
      if (worker.state === 'activated') resolve();
      if (worker.state === 'redundant') reject(new Error('The site could not be stored.'));
    };
    worker.addEventListener('statechange', look);
    look();
  });
}
