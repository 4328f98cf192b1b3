/** The buttons under the canvas: pause, play and watch again, step, speed. */
import { t } from '../words/words';
import { byId, byIdAs, say } from '../base/dom';

interface TransportNeeds {
  toggle(): void;
  step(): void;
  speed(stepsPerFrame: number): void;
}

/** The actions of the first button. */
type Main = 'pause' | 'play' | 'again';

export class Transport {
  private readonly play = byIdAs('play', HTMLButtonElement);
  private readonly speeds = Array.from(byId('speed').querySelectorAll('input'));

  constructor(needs: TransportNeeds) {
    this.play.addEventListener('click', () => needs.toggle());
    byId('step').addEventListener('click', () => needs.step());
    for (const radio of this.speeds) radio.addEventListener('change', () => needs.speed(Number(radio.value)));
  }

  show(main: Main, pace: number): void {
    this.play.dataset['does'] = main;
    this.play.title = t(`${main}_title`);
    say(byId('play-word'), t(main));
    for (const radio of this.speeds) radio.checked = Number(radio.value) === pace;
  }

  /** The steps per frame at full speed, without the slow forming. */
  fastest(): number {
    return Number(this.speeds.at(-1)?.value ?? 1);
  }
}
