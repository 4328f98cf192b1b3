/**
 * A film as a file. Frames are added in their order, each shown for the same time.
 *
 * Some encoders deliver frames in the order of decoding, which is not the order of showing. The library that writes
 * the files accepts that.
 */
import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output, WebMOutputFormat } from 'mediabunny';
import { RATE, SHAPES, encoding, type Codec, type Shape } from './codecs';
import { planesOf } from './planes';

/** The most frames that may wait for the encoder: each takes megabytes. */
const WAITING = 8;

/** Frames from one key frame to the next; players jump to these. */
const KEY = 90;

/**
 * The trial of codecs: the number of frames, the bytes by which each differs from the one before, and the
 * milliseconds per frame that are fast enough.
 */
const TRIAL = { frames: 5, shift: 40_000, quick: 50 };

export class FilmEncoder {
  private readonly encoder: VideoEncoder;
  private readonly track: EncodedVideoPacketSource;
  private readonly target = new BufferTarget();
  private readonly output: Output;
  private frames = 0;
  private failure: Error | undefined;
  /** Ends a wait for the encoder. */
  private wake: () => void = () => undefined;

  private constructor(
    private readonly codec: Codec,
    private readonly shape: Shape,
  ) {
    this.track = new EncodedVideoPacketSource(codec.track);
    // The index of the frames stands at the beginning, so that a player can start before it has the whole file.
    const format = codec.file === 'mp4' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
    this.output = new Output({ format, target: this.target });
    this.output.addVideoTrack(this.track, { frameRate: RATE });
    const fail = (error: Error): void => {
      this.failure ??= error;
      this.wake();
    };
    // The track keeps the order of the calls, also when nothing waits for them.
    this.encoder = new VideoEncoder({
      output: (chunk, meta) => void this.track.add(EncodedPacket.fromEncodedChunk(chunk), inColours(meta, codec)).catch(fail),
      error: fail,
    });
    this.encoder.addEventListener('dequeue', () => this.wake());
    this.encoder.configure(encoding(codec, shape));
  }

  static async of(codec: Codec, shape: Shape): Promise<FilmEncoder> {
    const film = new FilmEncoder(codec, shape);
    await film.output.start();
    return film;
  }

  /** Shows an RGBA image for `times` frames. Throws the browser's error if it cannot encode the frames. */
  async add(rgba: Uint8ClampedArray, times = 1): Promise<void> {
    const { width, height } = SHAPES[this.shape];
    const planes = planesOf(rgba, width, height, this.codec.matrix);
    for (let time = 0; time < times; time += 1) {
      while (!this.failure && this.encoder.encodeQueueSize >= WAITING) await new Promise<void>((resolve) => (this.wake = resolve));
      if (this.failure) throw this.failure;
      const [timestamp, next] = [at(this.frames), at(this.frames + 1)];
      const frame = new VideoFrame(planes, { format: 'I420', codedWidth: width, codedHeight: height, timestamp, duration: next - timestamp, colorSpace: coloursOf(this.codec) });
      this.encoder.encode(frame, { keyFrame: this.frames % KEY === 0 });
      frame.close();
      this.frames += 1;
    }
  }

  async finish(): Promise<Blob> {
    await this.encoder.flush();
    this.encoder.close();
    await this.output.finalize();
    const { buffer } = this.target;
    if (this.failure || !buffer) throw this.failure ?? new Error('VideoEncoder');
    return new Blob([buffer], { type: `video/${this.codec.file}` });
  }
}

/**
 * The fastest of some codecs. One browser takes ten times as long for VP9 as for VP8, another one for VP8 as for VP9.
 * The other codecs are tried only if the first one is slow. `rgba` is a frame to try them with, and is overwritten.
 */
export async function quickest(codecs: readonly Codec[], shape: Shape, rgba: Uint8ClampedArray): Promise<Codec> {
  let [best, least] = [codecs[0], Infinity];
  for (const codec of codecs.length > 1 ? codecs : []) {
    const encoder = await FilmEncoder.of(codec, shape);
    const begin = performance.now();
    for (let frame = 0; frame < TRIAL.frames; frame += 1) {
      await encoder.add(rgba);
      rgba.copyWithin(TRIAL.shift, 0);
    }
    await encoder.finish();
    const time = (performance.now() - begin) / TRIAL.frames;
    if (time < least) [best, least] = [codec, time];
    if (time < TRIAL.quick) break;
  }
  if (!best) throw new Error('VideoEncoder');
  return best;
}

/** The time, in microseconds, at which a frame begins. */
function at(frame: number): number {
  return Math.round((frame * 1e6) / RATE);
}

function coloursOf({ matrix }: Codec): VideoColorSpaceInit {
  return { primaries: 'bt709', transfer: 'bt709', matrix, fullRange: false };
}

/** Adds the colours to the encoder's description of its frames: without them, players have to guess. */
function inColours(meta: EncodedVideoChunkMetadata | undefined, codec: Codec): EncodedVideoChunkMetadata | undefined {
  return meta?.decoderConfig ? { ...meta, decoderConfig: { ...meta.decoderConfig, colorSpace: coloursOf(codec) } } : meta;
}
