/** Starts the page. */
import { App } from './app';
import { load } from './engine';
import { alertOf } from './messages';
import { takeLanguage } from './words';

async function start(): Promise<void> {
  try {
    await Promise.all([load(), takeLanguage()]);
    window.bubblestone = new App().scripts();
  } catch (error) {
    document.documentElement.dataset['stage'] = 'error';
    alertOf('trouble', error instanceof Error ? error.message : String(error));
  }
}

void start();
