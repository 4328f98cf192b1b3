/**
 * A subtitle that describes the forming of the picture. It takes the place of the caption; on a small screen, where the
 * caption is out of sight, it stands at the lower edge of the picture.
 */
import { countedBy } from '../module/stages';
import type { Engine } from '../state/engine';
import { t } from '../words/words';
import { byId, make, say } from '../base/dom';
import { PHASES, type Phase } from './watch';

/** Milliseconds that the whole line stays after the end. */
const READ = 2000;

export class Subtitle {
  private readonly line = byId('subtitle');
  private parts: HTMLElement[] = [];
  private timer = 0;

  /** A new forming begins. Screen readers get the whole sentence now; the screen shows its parts one by one. */
  begin(engine: Engine): void {
    clearTimeout(this.timer);
    this.timer = 0;
    const words = wordsOf(engine);
    this.parts = words.map((word) => make('span', {}, word));
    const seen = make('span', { class: 'seen', 'aria-hidden': 'true' }, ...this.parts);
    const said = make('span', { class: 'said' });
    if (matchMedia('(max-width: 60rem)').matches) byId('sheet').append(this.line);
    else byId('caption').after(this.line);
    this.toggle(this.line.hasAttribute('data-on'));
    this.line.replaceChildren(seen, said);
    say(said, words.join(''));
  }

  /** Shows the words up to this phase. */
  show(phase: Phase): void {
    this.toggle(true);
    this.parts.forEach((part, at) => part.toggleAttribute('data-shown', at <= PHASES.indexOf(phase)));
  }

  /** The forming is over. If the visitor ended it, the words go at once. */
  end(early: boolean): void {
    if (this.timer || !this.parts.length) return;
    this.timer = window.setTimeout(() => this.toggle(false), early ? 0 : READ);
  }

  /** Shows or hides the line. The caption makes room where both have one place. */
  private toggle(on: boolean): void {
    const caption = byId('caption');
    this.line.toggleAttribute('data-on', on);
    caption.toggleAttribute('data-under', on && caption.parentElement === this.line.parentElement);
  }
}

/** The parts of the sentence: one for each phase of a packing, or a single one. */
function wordsOf(engine: Engine): string[] {
  const counted = countedBy(engine.generator);
  if (counted !== 'cells') return [t(`forming_${counted}`)];
  const isSkin = engine.get('stone') === 'skin';
  return PHASES.map((phase) => t(phase === 'stone' && isSkin ? 'forming_skin' : `forming_${phase}`));
}
