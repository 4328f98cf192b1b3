/** Registers the service worker that stores the site, so that all its pages work offline. */
import { idle } from './dom';

/** `stored`: the whole site is available offline. `newer`: the next visit gets a newer build than this page. */
type Offline = 'stored' | 'newer';

/** To be called once the first picture is done: before that, every request would delay the picture. */
export function register(tell: (what: Offline) => void): void {
  // An embedded page stores nothing.
  if (!('serviceWorker' in navigator) || window.top !== window.self) return;
  navigator.serviceWorker.addEventListener('message', ({ data }: MessageEvent<Offline>) => {
    document.documentElement.dataset['offline'] = data;
    tell(data);
  });
  // If it fails (forbidden, no space, no connection), the page works without it.
  begin().catch(() => undefined);
}

async function begin(): Promise<void> {
  const registration = await navigator.serviceWorker.register(new URL('../sw.js', ownScript()), { updateViaCache: 'none' });
  await registration.update().catch(() => undefined);
  const worker = registration.installing ?? registration.waiting ?? registration.active;
  if (!worker) return;
  await activated(worker);
  const connection = (navigator as { connection?: { saveData?: boolean } }).connection;
  if (connection?.saveData) return;
  await idle(1000);
  worker.postMessage(ownScript().slice(registration.scope.length));
}

/** The address of the page's script, whose name contains the build's hash. It is in a folder beside the service worker. */
function ownScript(): string {
  return document.querySelector<HTMLScriptElement>('script[type=module]')?.src ?? '';
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
