/** Starts the page. */
import { App } from './app';
import { load } from './engine';
import { alertOf } from './messages';
import { takeLanguage } from './words';

async function start(): Promise<void> {
  try {
    await Promise.all([load(), takeLanguage()]);
    const scripts = new App().scripts();
    window.bubblestone = scripts;
    scripts.digest().then(storeSite, () => undefined);
  } catch (error) {
    document.documentElement.dataset['stage'] = 'error';
    alertOf('trouble', error instanceof Error ? error.message : String(error));
  }
}

/** The first picture is done: now there is time for the next visit. */
async function storeSite(): Promise<void> {
  const { register } = await import('./offline');
  register(() => undefined);
}

void start();
