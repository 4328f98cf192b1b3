/**
 * Runs a recipe once more, with the full module, and makes frames of its bodies for the page.
 *
 * Only the latest request counts. While something moves there are coarse frames only, and each is finished; otherwise
 * no frame ever would be. A view at rest gets a coarse frame, then one with all pixels, which is refined until a newer
 * request comes.
 */
import { reasonOf } from '../base/errors';
import { soon } from '../base/soon';
import { studioFor, supply } from '../module/given';
import { loadWhole } from '../module/load';
import type { SceneStudio } from '../module/scene';
import { generatorOf, making } from '../module/run';
import { progressOf, type Course } from '../module/stages';
import type { Notice } from '../module/types';
import { FrameMaker, type Made } from '../picture/frames/maker';
import { sortOf } from '../picture/frames/sort';
import type { Bodies, Quality, BodyInfo, Wished } from '../picture/frames/source';

/** A request for a frame. */
export interface Wish extends Wished {
  /** The number of the request. */
  readonly n: number;
}

/** A body: the one at a place of the frame, in fractions of its sides, or the one with this number. */
export type About = { x: number; y: number } | { id: number };

/** Requests a body, or the outline of one in the last frame. */
export type Question = (About | { outline: number; fine: number }) & { ask: number };

export type FrameMessage =
  | { frame: ImageBitmap; n: number; quality: Quality; bodies: Bodies }
  /** The last frame shows what is requested. */
  | { kept: Quality; n: number }
  /** Progress, 0..1: first of the recipe, then of a frame. */
  | { working: number }
  | { ask: number; body: BodyInfo | undefined }
  | { ask: number; outline: ImageData | undefined }
  /** There is no picture, or no such subject. */
  | { refused: Notice; n: number }
  | { lost: string }
  | { broken: string };

/** Milliseconds of work in one call. */
const BUDGET = 12;

/** For this many milliseconds a recipe is worked on before a newer one may replace it. */
const PATIENCE = 400;

/** The share of a recipe's own stages in the work before the first frame. */
const WORKED = 0.5;

/** Lets waiting messages arrive. */
const pause = (): Promise<void> => new Promise((resolve) => soon(() => resolve()));

class Turner {
  /** The latest request that is not fulfilled. */
  wish: Wish | undefined;
  private readonly studio: SceneStudio;
  private readonly course: Course;
  private link: string;
  private readonly maker: FrameMaker<Wish>;

  constructor(studio: SceneStudio, course: Course, link: string) {
    this.studio = studio;
    this.maker = new FrameMaker(studio);
    this.course = course;
    this.link = link;
  }

  /** Works until no request is left. */
  async work(): Promise<void> {
    for (let wish = this.wish; wish; wish = this.wish) {
      if (!(await this.ready(wish))) continue;
      const piece = this.maker.advance(wish, BUDGET);
      if (!piece) {
        const kept = this.maker.kept(wish);
        if (kept) say({ kept, n: wish.n });
        if (this.wish === wish) this.wish = undefined;
      } else if ('refused' in piece) this.refuse(wish, piece.refused);
      else if ('working' in piece) say({ working: WORKED + (1 - WORKED) * piece.working });
      else await this.show(piece.made);
      await pause();
    }
  }

  /** A body of the last frame. */
  told(about: About): BodyInfo | undefined {
    const { sides } = this.maker;
    if ('id' in about) return { id: about.id, figures: {}, words: {}, steps: this.studio.making(about.id) };
    const { x, y } = about;
    const body = sides && this.studio.bodyAt(Math.floor(x * sides[0]), Math.floor(y * sides[1]));
    return body && { id: body.id, figures: body.figures, words: body.words, steps: this.studio.making(body.id) };
  }

  outlineOf(id: number, fine: number): ImageData | undefined {
    return this.maker.outlineOf(id, fine);
  }

  /** Runs the request's recipe; false if a newer request came, or there is no picture. */
  private async ready(wish: Wish): Promise<boolean> {
    const { studio } = this;
    if (wish.link !== this.link) {
      studio.open(wish.link);
      this.maker.drop();
      this.link = wish.link;
      await supply(studio);
    }
    const begun = performance.now();
    for (const [stage, status] of making(studio, BUDGET)) {
      say({ working: WORKED * progressOf(this.course, stage, status) });
      await pause();
      if (this.wish?.link !== wish.link && performance.now() - begun > PATIENCE) return false;
    }
    const refused = studio.problem();
    if (refused) this.refuse(wish, refused);
    return !refused;
  }

  private refuse(wish: Wish, refused: Notice): void {
    say({ refused, n: wish.n });
    if (this.wish === wish) this.wish = undefined;
  }

  private async show({ wish, quality, width, height, pixels }: Made<Wish>): Promise<void> {
    const frame = await createImageBitmap(new ImageData(pixels, width, height));
    const bodies: Bodies = { count: this.studio.status().stones, sort: sortOf(this.studio.get('stone')) };
    say({ frame, n: wish.n, quality, bodies }, [frame]);
  }
}

function say(said: FrameMessage, moved: Transferable[] = []): void {
  postMessage(said, { transfer: moved });
}

let turner: Turner | undefined;
let latest: Wish | undefined;
let running = false;

async function begin(link: string): Promise<Turner | undefined> {
  try {
    const module = await loadWhole();
    const studio = await studioFor(module, link);
    return new Turner(studio, generatorOf(module, studio), link);
  } catch (error) {
    say({ lost: reasonOf(error) });
    return undefined;
  }
}

async function run(): Promise<void> {
  if (running || !latest) return;
  running = true;
  try {
    turner ??= await begin(latest.link);
    if (!turner) return;
    turner.wish = latest;
    await turner.work();
  } catch (error) {
    say({ broken: reasonOf(error) });
    return;
  }
  running = false;
}

addEventListener('message', ({ data }: MessageEvent<Wish | Question>) => {
  if ('ask' in data) {
    if ('outline' in data) say({ ask: data.ask, outline: turner?.outlineOf(data.outline, data.fine) });
    else say({ ask: data.ask, body: turner?.told(data) });
    return;
  }
  latest = data;
  if (turner) turner.wish = latest;
  void run();
});
