/** Starts the page. */
import { App } from './app';
import { load } from './engine';
import { fragment } from './link';
import { alertOf } from './messages';

async function start(): Promise<void> {
  try {
    await load();
    window.bubblestone = new App(fragment()).scripts();
  } catch (error) {
    document.documentElement.dataset['stage'] = 'error';
    alertOf('trouble', error instanceof Error ? error.message : String(error));
  }
}

void start();
