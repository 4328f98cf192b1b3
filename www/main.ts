/** Starts the page. */
import { t } from './words/words';
import { byId } from './base/dom';
import { readSigns } from './base/decimals';
import { reasonOf } from './base/errors';
import { takeLanguage } from './base/language';
import { noteLostStyles } from './base/lost-styles';
import { alertOf, notice } from './base/messages';
import { followTheme } from './base/theme';
import { isHere, load } from './state/arrivals';
import { askedFor, openedFirst } from './state/first';
import { fragment, isEmbedded } from './state/link';
import { lastWork } from './state/memory';
import { isOffered, placeOf } from './module/generators';
import { App } from './shell/app';
import { hearMakes } from './shell/makes';

async function start(): Promise<void> {
  noteLostStyles();
  try {
    const embedded = isEmbedded();
    document.documentElement.toggleAttribute('data-embed', embedded);
    if (!embedded) hearMakes();
    const link = embedded ? fragment : firstLink;
    if (!embedded) early(link());
    const spoken = takeLanguage(placeOf(link()) > 0);
    const [embed] = await Promise.all([embedded ? import('./shell/embed').catch(() => undefined) : undefined, load(link(), 'lost_wasm', spoken), spoken]);
    // The address may have changed while the module was loading.
    while (!isHere(link())) await load(link());
    if (embed) window.bubblestone = new embed.Embed().scripts.face;
    else if (embedded) throw new Error(t('lost_part'));
    else await begin();
  } catch (error) {
    document.documentElement.dataset['stage'] = 'error';
    alertOf('trouble', reasonOf(error));
  }
}

/** Loads the code for the link's view in parallel with the module. A failure shows up later, where the code is used. */
function early(link: string): void {
  const parts: (() => Promise<unknown>)[] = [];
  if (askedFor(lastWork()).words) parts.push(() => import('./look/linked'));
  if (isOffered(link, 'frames')) parts.push(() => import('./turn/page'));
  if (isOffered(link, 'paint')) parts.push(() => import('./space/space'));
  for (const load of parts) load().catch(() => undefined);
}

function firstLink(): string {
  const last = lastWork();
  return openedFirst(askedFor(last).recipe, last);
}

async function begin(): Promise<void> {
  followTheme();
  readSigns();
  const app = new App();
  await app.furnish();
  window.bubblestone = app.scripts();
  void app.finished.then(storeSite);
}

/** Stores the site for the next visit, after the first picture is done. */
async function storeSite(): Promise<void> {
  // If this fails because the connection or the page is gone, the next visit stores the site.
  const offline = await import('./base/offline').catch(() => undefined);
  offline?.register((what) => {
    if (what === 'newer') notice('offline', t('offline_newer'));
    // The text in the page's foot is enough; no message is needed.
    else byId('offline').textContent = t('offline_stored');
  });
}

void start();
