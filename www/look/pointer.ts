/** Pointer and arrow keys on the picture while nothing is drawn. */
import type { Work } from '../state/work';
import type { View } from '../picture/view';
import { CellProbe } from './probe';
import { Zoom } from './zoom';
import '../styles/late/look.css';

export class Pointer {
  readonly zoom: Zoom;
  readonly probe: CellProbe;

  constructor(work: Work, view: View) {
    this.probe = new CellProbe(work, view, {
      busy: () => this.zoom.busy,
      reveal: (place) => this.zoom.reveal(place),
    });
    this.zoom = new Zoom(work.store, () => this.probe.moved());
  }
}
