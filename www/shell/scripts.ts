/** `window.bubblestone`: the functions for scripts. */
import type { Parameter, Preset, Probe, Status } from '../module/types';
import type { Engine } from '../state/engine';
import type { Camera } from '../state/viewing';
import type { Ahead } from '../picture/ahead';

export interface Bubblestone {
  /**
   * The digest of the planes, once they are done and drawn. On a first visit it comes earlier, while the picture
   * still forms on the screen.
   */
  digest(): Promise<string>;
  /** The fragment of the recipe, without '#'. */
  link(): string;
  get(key: string): string;
  status(): Status;
  /** The cell at a place, in units of the picture. */
  probe(x: number, y: number): Probe | undefined;
  /** The hash of a frame of all bodies, as large as the picture, from this camera or from that of the turntable. */
  frame(camera?: string): Promise<string>;
  /** The schema and presets of the present generator. */
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
  /** Resolves waiting digests: the planes are done, and drawn or computed ahead. */
  done(): void;
  /** Rejects waiting digests: there will be no planes. */
  failed(sentence?: string): void;
}

/**
 * `rests` returns whether all finished work is drawn, `camera` the camera of the turntable, and `ahead` the engine
 * that runs ahead, if there is one.
 */
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
