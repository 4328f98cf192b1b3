/** Starts the page. */
import { byId } from './base/dom';
import { takeLanguage } from './base/language';
import { alertOf, passing } from './base/messages';
import { followTheme } from './base/theme';
import { keepModule } from './module/load';
import { App } from './shell/app';
import { load } from './state/engine';
import { isEmbedded } from './state/link';
import { t } from './words/words';

async function start(): Promise<void> {
  try {
    const embedded = isEmbedded();
    document.documentElement.toggleAttribute('data-embed', embedded);
    const [embed] = await Promise.all([embedded ? import('./shell/embed') : undefined, load(), takeLanguage()]);
    if (embed) window.bubblestone = embed.embed();
    else await begin();
  } catch (error) {
    document.documentElement.dataset['stage'] = 'error';
    alertOf('trouble', error instanceof Error ? error.message : String(error));
  }
}

async function begin(): Promise<void> {
  followTheme();
  const app = new App();
  await app.furnish();
  window.bubblestone = app.scripts();
  void app.finished.then(storeSite);
}

/** The first picture is done: now there is time for the next visit. */
async function storeSite(): Promise<void> {
  // Without a storage the next visit unpacks the module again.
  keepModule().catch(() => undefined);
  const { register } = await import('./shell/offline');
  register((what) => {
    if (what === 'newer') passing('offline', t('offline_newer'));
    // Nothing to do about it: it stands at the foot of the page.
    else byId('offline').textContent = t('offline_stored');
  });
}

void start();
