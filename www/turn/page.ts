/** The turntable on the page: the store tells whether it is on, and where from. */
import { t } from '../words/turn';
import { t as common } from '../words/words';
import { byId, make } from '../base/dom';
import { alertOf, clear } from '../base/messages';
import type { Work } from '../state/work';
import { Turntable } from './turntable';

export class PageTurntable {
  private readonly work: Work;
  private readonly turntable: Turntable;

  constructor(work: Work) {
    this.work = work;
    const { store, engine } = work;
    this.turntable = new Turntable({
      link: () => store.state.recipe,
      held: () => store.state.held,
      get: (key) => engine.get(key),
      camera: () => store.state.camera,
      take: (camera) => store.update({ camera }),
      alone: (subject, camera) => store.update({ body: subject === '' ? undefined : { subject, camera } }),
      leave: () => store.update({ turn: false }),
      ended: (how, why) => this.ended(how, why),
    });
    store.on(['recipe', 'held', 'camera'], () => this.turntable.follow());
    // To edit, to compare and to repeat there is the picture: what was asked for last ends the others.
    store.on(['editing', 'compare', 'repeat'], ({ turn, editing, compare, repeat }) => {
      if (turn && (editing !== undefined || compare || repeat > 1)) store.update({ turn: false });
    });
  }

  show(on: boolean): void {
    const button = byId('turn-button');
    const focused = this.turntable.focused;
    if (on) clear('part');
    else this.work.store.update({ body: undefined });
    this.turntable.toggle(on);
    // A link that opens it leaves the focus where it is.
    if (on && document.activeElement === button) this.turntable.focus();
    if (!on && focused) button.focus();
  }

  /** Closer (1), farther (-1), or the first look again (0). */
  step(by: number): void {
    this.turntable.step(by);
  }

  private ended(how: 'lost' | 'broken', why: string): void {
    const { store } = this.work;
    store.update({ turn: false });
    const again = make('button', { type: 'button' }, t('lost'));
    again.addEventListener('click', () => store.update({ turn: true }));
    alertOf('part', how === 'lost' ? common('lost_module') : t('broken', { reason: why }), again);
  }
}
