/** What pointers and arrow keys do on the picture while nothing is drawn. */
import type { Work } from '../state/work';
import type { View } from '../view';
import { Glass } from './glass';
import { Telling } from './telling';
import '../styles/look.css';

export class Hand {
  readonly glass: Glass;
  readonly telling: Telling;

  constructor(work: Work, view: View) {
    this.telling = new Telling(work, view, {
      busy: () => this.glass.busy,
      reveal: (place) => this.glass.reveal(place),
    });
    this.glass = new Glass(work.store, () => this.telling.moved());
  }
}
