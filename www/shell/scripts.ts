/** `window.bubblestone`: what scripts may ask the page. */
import type { Parameter, Preset, Probe, Status } from '../module/types';
import type { Engine } from '../state/engine';
import type { Camera } from '../state/viewing';
import type { Ahead } from '../picture/ahead';

export interface Bubblestone {
  /** The digest of the planes, once they are done and drawn; on a first visit, while they still form on the screen. */
  digest(): Promise<string>;
  /** The fragment of the recipe, without '#'. */
  link(): string;
  get(key: string): string;
  status(): Status;
  /** The cell at a place, in units of the picture. */
  probe(x: number, y: number): Probe | undefined;
  /** The hash of a frame of all bodies, as large as the picture: seen from here, or from where the turntable is. */
  frame(camera?: string): Promise<string>;
  /** Those of the generator at work. */
  readonly schema: Parameter[];
  readonly presets: Preset[];
}

declare global {
  interface Window {
    bubblestone?: Bubblestone;
  }
}

export interface ScriptFace {
  readonly face: Bubblestone;
  /** The planes are done, and drawn or worked out ahead: answers those who wait. */
  done(): void;
  /** They never will be: rejects those who wait. */
  failed(sentence?: string): void;
}

/** `rests` tells that all that was done is drawn, `camera` where bodies are seen from; `ahead` is where the recipe was worked out before. */
export function scriptFace(engine: Engine, rests: () => boolean, camera: () => Camera | undefined, ahead: () => Ahead | undefined = () => undefined): ScriptFace {
  const waiting: { resolve: (digest: string) => void; reject: (error: Error) => void }[] = [];
  const digest = (): string => ahead()?.planes?.digest ?? engine.digest();
  const broken = (): Error => new Error('Bubblestone has stopped after an error; load the page again.');
  return {
    face: {
      digest: () =>
        new Promise((resolve, reject) => {
          if (!engine.alive) reject(broken());
          else if (engine.stage() === 'error') reject(new Error(engine.problem()));
          else if (ahead()?.planes ?? (engine.stage() === 'done' && rests())) resolve(digest());
          else waiting.push({ resolve, reject });
        }),
      link: () => engine.link(),
      get: (key) => engine.get(key),
      status: () => ahead()?.status ?? engine.status(),
      probe: (x, y) => engine.probe([x, y]),
      frame: async (from) => (await import('../turn/hash')).hashOf(engine.link(), from ?? camera(), engine.generator.home),
      get schema() {
        return engine.schema;
      },
      get presets() {
        return engine.presets;
      },
    },
    done: () => {
      if (!waiting.length) return;
      const answer = digest();
      for (const { resolve } of waiting.splice(0)) resolve(answer);
    },
    failed: (sentence) => {
      for (const { reject } of waiting.splice(0)) reject(sentence ? new Error(sentence) : broken());
    },
  };
}
