/** Starts the page. */
import { App } from './app';
import { isEmbedded } from './link';
import { load } from './engine';
import { choiceOf, choose } from './memory';
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
  const { register } = await import('./offline');
  register((what) => {
    // Said once; the next visits are told of newer builds only.
    if (what === 'stored' && choiceOf('offline') === what) return;
    choose('offline', 'stored');
    passing('offline', t(what === 'stored' ? 'offline_stored' : 'offline_newer'));
  });
}

void start();
