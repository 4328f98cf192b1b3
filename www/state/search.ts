/** The search for the files that a recipe names. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { RecipeFile } from '../../pkg-house/bubblestone.js';

export class FileSearch {
  /** Whether files are being searched for; the work pauses meanwhile. */
  on = false;
  /** The digests of the files that are being searched for, or were not found; '' if the recipe needs none. */
  private sought = '';
  /** Counts the searches; an outdated search delivers nothing. */
  private searches = 0;

  /** Searches once for the files that a studio waits for. */
  begin(studio: Bubblestone, missing: readonly RecipeFile[]): void {
    const digests = missing.flatMap(({ digest }) => digest || []).join(' ');
    if (digests === this.sought) return;
    this.end();
    this.sought = digests;
    if (digests === '') return;
    this.on = true;
    const { searches } = this;
    const wanted = (): boolean => this.searches === searches;
    const found = import('../module/given').then(({ supply }) => supply(studio, wanted));
    // After a failure the work fails as well, or the page asks for the file.
    void found.catch(() => false).then(() => wanted() && (this.on = false));
  }

  /** Ends the search. The same files may be searched for again. */
  end(): void {
    this.sought = '';
    this.on = false;
    this.searches += 1;
  }
}
