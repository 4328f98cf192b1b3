/** The types that a viewer of frames and their maker share: requests, and the frames that come back. */
import type { Notice } from '../../module/types';
import type { Sort } from './sort';

/**
 * The content of a frame. Depth, normals and numbers are the module's maps; `alpha` is the coverage of a picture without
 * a background.
 */
export type Plane = 'light' | 'depth' | 'normal' | 'id' | 'alpha';

/** The quality of a frame: coarse, with all pixels, or refined to the end. */
export type Quality = 'moving' | 'still' | 'fine';

/** A request for a frame. */
export interface Wished {
  readonly link: string;
  /** '' for all bodies, or a step in the making of one (`ID:STEP`). */
  readonly subject: string;
  readonly camera: string;
  readonly width: number;
  readonly height: number;
  readonly plane: Plane;
  /** The module's word for a plane that cuts bodies away; '' without one. */
  readonly cut: string;
  /** Whether the next request will come soon. */
  readonly moving: boolean;
  /** Whether a frame at rest is refined, if its plane can be. */
  readonly refined: boolean;
}

/**
 * A body: its number, its measures (`figures`) and texts (`words`) by the words of its generator, and the words of the
 * steps in its making.
 */
export interface BodyInfo {
  readonly id: number;
  readonly figures: Record<string, number>;
  readonly words: Record<string, string>;
  readonly steps: string[];
}

/** The number and sort of the bodies; `what` is the word of the view if it shows something else. */
export interface Bodies {
  readonly count: number;
  readonly sort: Sort;
  readonly what?: string | undefined;
}

/** Receives the messages of the maker of frames. */
export interface Heard {
  /** `latest` is true if the frame is the one requested last. */
  frame(frame: ImageBitmap, quality: Quality, bodies: Bodies, latest: boolean): void;
  /** The last frame shows what is requested, with this quality: no other comes for now. */
  kept(quality: Quality): void;
  working(done: number): void;
  refused(why: Notice): void;
  /** The maker could not be loaded, or it failed; there are no more frames. */
  ended(how: 'lost' | 'broken', why: string): void;
}

/** A place in the frame, in fractions of its sides. */
export type FramePlace = readonly [u: number, v: number];

/** A label of the shown view, at a place of a frame. */
export interface PlacedLabel {
  readonly text: string;
  readonly at: FramePlace;
}

/** A source of frames. */
export interface FrameSource {
  /** Requests frames; true if they differ from those requested before. */
  want(wish: Wished): boolean;
  /** The body at a place of the last frame, in fractions of its sides. */
  bodyAt(x: number, y: number): Promise<BodyInfo | undefined>;
  /** The body with this number, once there has been a frame. */
  bodyOf(id: number): Promise<BodyInfo | undefined>;
  /** The outline of a body in the last frame; `fine` is the number of the frame's pixels for one of the page. */
  outlineOf(id: number, fine: number): Promise<ImageData | undefined>;
  /** The labels of the view in the last frame, the most important one first. */
  labels(): Promise<readonly PlacedLabel[]>;
  /** Ends the source: no more frames are requested. */
  end(): void;
}

/** Draws something else instead of the view, also in pieces. */
export interface Painter {
  /** The share of the time that it may take while the work goes on. */
  readonly share: number;
  /** Called when its content may have changed. */
  changed(): void;
  /** Works for about `budget` milliseconds; true when the work may go on. */
  advance(budget: number): boolean;
}

/** The loop that calls a painter. */
export interface Beat {
  /** Requests a frame, because there is more to paint. */
  look(): void;
  /** Whether no work is left, except the work that a pause holds. */
  readonly stands: boolean;
}
