/** The two turntables of a host: one shows frames of its engine, the other the bodies of a picture, made by a worker. */
import { LocalFrames } from '../picture/frames/local';
import type { PictureHost } from '../picture/host';
import { Turntable, type Surroundings } from './turntable';

export class Turntables {
  /** The turntable that is shown, or was shown last. */
  shown: Turntable | undefined;
  private readonly host: PictureHost;
  private readonly place: Omit<Surroundings, 'leave' | 'frames'>;
  private readonly leave: Pick<Surroundings, 'leave'>;
  private slant: Turntable | undefined;
  private framed: Turntable | undefined;
  private frames: LocalFrames | undefined;

  /** `leave` ends the turntable of a picture's bodies; an embedded page has no such control. */
  constructor(host: PictureHost, place: Omit<Surroundings, 'leave' | 'frames'>, leave: Pick<Surroundings, 'leave'> = {}) {
    this.host = host;
    this.place = place;
    this.leave = leave;
  }

  /** Shows or hides the turntable for the present generator. */
  show(on: boolean): Turntable {
    const isFramed = this.host.engine.offers('frames');
    const turntable = isFramed ? this.ofFrames : (this.slant ??= new Turntable({ ...this.place, ...this.leave }));
    if (this.shown !== turntable) this.shown?.toggle(false);
    this.shown = turntable;
    this.host.loop.painter = isFramed ? this.frames : undefined;
    turntable.toggle(on);
    return turntable;
  }

  /** The frame of the engine, to be painted on, and the mapping between its places and places on the model. */
  get surface() {
    return {
      host: this.ofFrames.host,
      placeAt: (spot: readonly [number, number]) => this.frames?.placeAt(spot),
      spotOf: (place: readonly [number, number, number]) => this.frames?.spotOf(place),
    };
  }

  private get ofFrames(): Turntable {
    return (this.framed ??= new Turntable({ ...this.place, frames: (heard) => (this.frames = new LocalFrames(this.host, heard)) }));
  }
}
