/** One line of words on the picture about what is seen while it forms. */
import { t } from '../words/words';
import { byId, make, say } from '../base/dom';
import { PHASES, type Phase } from './watch';

/** Milliseconds that the whole line stays after the end. */
const READ = 2000;

export class Subtitle {
  private readonly line = byId('subtitle');
  private parts: HTMLElement[] = [];
  private timer = 0;

  /** A new forming begins: ears get the whole sentence now, eyes its parts as they come. */
  begin(skin: boolean): void {
    clearTimeout(this.timer);
    this.timer = 0;
    const words = PHASES.map((phase) => t(phase === 'stone' && skin ? 'forming_skin' : `forming_${phase}`));
    this.parts = words.map((word) => make('span', {}, word));
    const seen = make('span', { class: 'seen', 'aria-hidden': 'true' }, ...this.parts);
    const said = make('span', { class: 'said' });
    this.line.replaceChildren(seen, said);
    say(said, words.join(''));
  }

  /** What is seen now. */
  show(phase: Phase): void {
    this.line.toggleAttribute('data-on', true);
    this.parts.forEach((part, at) => part.toggleAttribute('data-shown', at <= PHASES.indexOf(phase)));
  }

  /** The forming is over; where it was ended by the visitor, so are the words. */
  end(early: boolean): void {
    if (this.timer || !this.parts.length) return;
    this.timer = window.setTimeout(() => this.line.toggleAttribute('data-on', false), early ? 0 : READ);
  }
}
