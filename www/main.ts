/** Starts the page. */
import { App } from './app';
import { byId } from './dom';
import { isEmbedded } from './link';
import { load } from './engine';
import { alertOf, passing } from './messages';
import { keepModule } from './module';
import { followTheme } from './theme';
import { t, takeLanguage } from './words';

async function start(): Promise<void> {
  try {
    const embedded = isEmbedded();
    document.documentElement.toggleAttribute('data-embed', embedded);
    const [embed] = await Promise.all([embedded ? import('./embed') : undefined, load(), takeLanguage()]);
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
  // What does not come, a lost connection or a page that is left already: the next visit stores it.
  const offline = await import('./offline').catch(() => undefined);
  offline?.register((what) => {
    if (what === 'newer') passing('offline', t('offline_newer'));
    // Nothing to do about it: it stands at the foot of the page.
    else byId('offline').textContent = t('offline_stored');
  });
}

void start();
