/** The buttons under the canvas: play and pause, step, restart, speed, seed. */
import { byId, byIdAs, say } from './dom';
import { t } from './words';

export interface TransportNeeds {
  toggle(): void;
  step(): void;
  restart(): void;
  speed(stepsPerFrame: number): void;
  seed(text: string): void;
  dice(): void;
  copy(): void;
  save(): void;
}

export class Transport {
  private readonly play = byIdAs('play', HTMLButtonElement);
  private readonly seed = byIdAs('seed', HTMLInputElement);
  private readonly speeds = Array.from(byId('speed').querySelectorAll('input'));

  constructor(needs: TransportNeeds) {
    this.play.addEventListener('click', () => needs.toggle());
    byId('step').addEventListener('click', () => needs.step());
    byId('restart').addEventListener('click', () => needs.restart());
    byId('dice').addEventListener('click', () => needs.dice());
    byId('copy').addEventListener('click', () => needs.copy());
    byId('save').addEventListener('click', () => needs.save());
    this.seed.addEventListener('change', () => {
      const text = this.seed.value;
      // Empty, the box takes what the engine made of the text.
      this.seed.value = '';
      needs.seed(text);
    });
    for (const radio of this.speeds) radio.addEventListener('change', () => needs.speed(Number(radio.value)));
  }

  show(paused: boolean, pace: number, seed: string): void {
    this.play.toggleAttribute('data-paused', paused);
    say(byId('play-word'), t(paused ? 'play' : 'pause'));
    for (const radio of this.speeds) radio.checked = Number(radio.value) === pace;
    if (document.activeElement !== this.seed || this.seed.value === '') this.seed.value = seed;
  }

  /** Full speed, without the slow forming. */
  fastest(): number {
    return Number(this.speeds.at(-1)?.value ?? 1);
  }
}
