/** `window.bubblestone`: the words of the page for scripts. */
import type { Engine } from './engine';
import type { Parameter, Preset, Probe, Status } from './types';

export interface Bubblestone {
  /** The digest of the planes, once they are done and drawn. */
  digest(): Promise<string>;
  /** The fragment of the recipe, without '#'. */
  link(): string;
  get(key: string): string;
  status(): Status;
  /** The cell at a place in picture units. */
  probe(x: number, y: number): Probe | undefined;
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
  /** The planes are done and drawn: answers those who wait. */
  done(): void;
  /** They never will be. */
  failed(sentence?: string): void;
}

/** `rests` tells that all that was done is drawn. */
export function scriptFace(engine: Engine, rests: () => boolean): ScriptFace {
  const waiting: { resolve: (digest: string) => void; reject: (error: Error) => void }[] = [];
  const broken = (): Error => new Error('Bubblestone has stopped after an error; load the page again.');
  return {
    face: {
      digest: () =>
        new Promise((resolve, reject) => {
          if (!engine.alive) reject(broken());
          else if (engine.stage() === 'error') reject(new Error(engine.problem()));
          else if (engine.stage() === 'done' && rests()) resolve(engine.digest());
          else waiting.push({ resolve, reject });
        }),
      link: () => engine.link(),
      get: (key) => engine.get(key),
      status: () => engine.status(),
      probe: (x, y) => engine.probe([x, y]),
      schema: engine.schema,
      presets: engine.presets,
    },
    done: () => {
      if (!waiting.length) return;
      const digest = engine.digest();
      for (const { resolve } of waiting.splice(0)) resolve(digest);
    },
    failed: (sentence) => {
      for (const { reject } of waiting.splice(0)) reject(sentence ? new Error(sentence) : broken());
    },
  };
}
