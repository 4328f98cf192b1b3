/** The page's side of the worker that makes frames: it sends the latest request there and receives frames. */
import { reasonOf } from '../base/errors';
import type { FrameSource, Heard, BodyInfo, PlacedLabel, Wished } from '../picture/frames/source';
import type { About, Question, FrameMessage, Wish } from './turn.worker';

/** The answer to a question. */
type Answer = Extract<FrameMessage, { ask: number }> | undefined;

export class Frames implements FrameSource {
  private readonly heard: Heard;
  private worker: Worker | undefined;
  private last: Wish | undefined;
  private readonly asked = new Map<number, (answer: Answer) => void>();
  private questions = 0;

  constructor(heard: Heard) {
    this.heard = heard;
  }

  want(wish: Wished): boolean {
    const { last } = this;
    const isSame = last && (Object.keys(wish) as (keyof typeof wish)[]).every((key) => wish[key] === last[key]);
    if (isSame && this.worker) return false;
    this.last = { ...wish, n: (last?.n ?? 0) + 1 };
    try {
      this.worker ??= this.begin();
      this.worker.postMessage(this.last satisfies Wish);
    } catch (error) {
      // Browsers refuse workers to a page in a closed frame. The answer comes later, as that of a worker would.
      setTimeout(() => this.stop('lost', reasonOf(error)));
    }
    return true;
  }

  bodyAt(x: number, y: number): Promise<BodyInfo | undefined> {
    return this.body({ x, y });
  }

  bodyOf(id: number): Promise<BodyInfo | undefined> {
    return this.body({ id });
  }

  async outlineOf(id: number, fine: number): Promise<ImageData | undefined> {
    const answer = await this.answer({ outline: id, fine });
    return answer && 'outline' in answer ? answer.outline : undefined;
  }

  /** The worker's frames are of pavements, whose views have no labels. */
  labels(): Promise<readonly PlacedLabel[]> {
    return Promise.resolve([]);
  }

  private async body(about: About): Promise<BodyInfo | undefined> {
    const answer = await this.answer(about);
    return answer && 'body' in answer ? answer.body : undefined;
  }

  private answer(about: About | { outline: number; fine: number }): Promise<Answer> {
    const { worker } = this;
    if (!worker) return Promise.resolve(undefined);
    const ask = (this.questions += 1);
    return new Promise((resolve) => {
      this.asked.set(ask, resolve);
      worker.postMessage({ ask, ...about } satisfies Question);
    });
  }

  /** Ends the worker, with all its memory. */
  end(): void {
    this.worker?.terminate();
    this.worker = this.last = undefined;
    for (const resolve of this.asked.values()) resolve(undefined);
    this.asked.clear();
  }

  private begin(): Worker {
    const worker = new Worker(new URL('./turn.worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.stop('lost', event.message);
    });
    worker.addEventListener('message', ({ data }: MessageEvent<FrameMessage>) => this.hear(data));
    return worker;
  }

  private hear(said: FrameMessage): void {
    const { heard } = this;
    if ('frame' in said) heard.frame(said.frame, said.quality, said.bodies, said.n === this.last?.n);
    else if ('kept' in said) {
      if (said.n === this.last?.n) heard.kept(said.kept);
    } else if ('working' in said) heard.working(said.working);
    else if ('ask' in said) {
      this.asked.get(said.ask)?.(said);
      this.asked.delete(said.ask);
    } else if ('refused' in said) {
      if (said.n === this.last?.n) heard.refused(said.refused);
    } else if ('lost' in said) this.stop('lost', said.lost);
    else this.stop('broken', said.broken);
  }

  private stop(how: 'lost' | 'broken', why: string): void {
    this.end();
    this.heard.ended(how, why);
  }
}
