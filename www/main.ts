/** Starts the page. */
import { App } from './app';
import { isEmbedded } from './link';
import { load } from './engine';
import { alertOf } from './messages';
import { takeLanguage } from './words';

async function start(): Promise<void> {
  try {
    const embedded = isEmbedded();
    document.documentElement.toggleAttribute('data-embed', embedded);
    const [embed] = await Promise.all([embedded ? import('./embed') : undefined, load(), takeLanguage()]);
    window.bubblestone = embed ? embed.embed() : new App().scripts();
  } catch (error) {
    document.documentElement.dataset['stage'] = 'error';
    alertOf('trouble', error instanceof Error ? error.message : String(error));
  }
}

void start();
