/** The menu of files for other programs: maps and meshes. */
import { byId, byIdAs } from './dom';
import { offer } from './download';
import type { Engine } from './engine';
import { clear, notice, passing } from './messages';

/** Milliseconds of work on a mesh between two breaths of the page. */
const BUDGET = 12;

export class Files {
  private readonly menu = byIdAs('files', HTMLDetailsElement);
  private readonly normals = byIdAs('normals', HTMLSelectElement);
  private readonly engine: Engine;
  private busy = false;

  constructor(engine: Engine) {
    this.engine = engine;
    byId('save-maps').addEventListener('click', () => void this.save('-maps.zip', () => this.maps()));
    byId('save-glb').addEventListener('click', () => void this.save('.glb', () => this.mesh('glb', 'model/gltf-binary')));
    byId('save-obj').addEventListener('click', () => void this.save('.obj', () => this.mesh('obj', 'model/obj')));
    this.menu.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.menu.open) return;
      event.stopPropagation();
      this.menu.open = false;
      this.menu.querySelector('summary')?.focus();
    });
    document.addEventListener('pointerdown', ({ target }) => {
      if (target instanceof Node && !this.menu.contains(target)) this.menu.open = false;
    });
  }

  private async save(ending: string, making: () => Promise<Blob>): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    const name = `bubblestone-${this.engine.get('outline')}-${this.engine.get('seed')}${ending}`;
    notice('files', `Making ${name} …`);
    try {
      offer(await making(), name);
      clear('files');
      passing('files', `${name} is saved.`);
    } catch (error) {
      notice('files', error instanceof Error ? error.message : String(error));
    }
    this.busy = false;
  }

  private async maps(): Promise<Blob> {
    if (typeof CompressionStream !== 'function') {
      throw new Error('This browser is too old to pack pictures for other programs. Please update it (Firefox: 113 or later).');
    }
    const { mapsZip } = await import('./maps-zip');
    return mapsZip(this.engine, this.normals.value);
  }

  private async mesh(ending: string, type: string): Promise<Blob> {
    let parts: BlobPart[] = [];
    for (;;) {
      const slice = this.engine.meshFile(ending, BUDGET);
      if (typeof slice === 'string') throw new Error(slice);
      parts = slice.begun ? slice.parts : parts.concat(slice.parts);
      if (slice.done) return new Blob(parts, { type });
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
}
