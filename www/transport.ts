/** The buttons under the canvas: play and pause, step, restart, speed. */
import { byId, byIdAs, say } from './dom';
import { t } from './words';

export interface TransportNeeds {
  toggle(): void;
  step(): void;
  restart(): void;
  speed(stepsPerFrame: number): void;
}

export class Transport {
  private readonly play = byIdAs('play', HTMLButtonElement);
  private readonly speeds = Array.from(byId('speed').querySelectorAll('input'));

  constructor(needs: TransportNeeds) {
    this.play.addEventListener('click', () => needs.toggle());
    byId('step').addEventListener('click', () => needs.step());
    byId('restart').addEventListener('click', () => needs.restart());
    for (const radio of this.speeds) radio.addEventListener('change', () => needs.speed(Number(radio.value)));
  }

  show(paused: boolean, pace: number): void {
    this.play.toggleAttribute('data-paused', paused);
    say(byId('play-word'), t(paused ? 'play' : 'pause'));
    for (const radio of this.speeds) radio.checked = Number(radio.value) === pace;
  }

  /** Full speed, without the slow forming. */
  fastest(): number {
    return Number(this.speeds.at(-1)?.value ?? 1);
  }
}
