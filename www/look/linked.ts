/** Shows what a link's words of the view ask for, and tells what of it cannot be shown. */
import { t } from '../words/look';
import { wantsStill } from '../base/dom';
import { notice } from '../base/messages';
import { cameraLimits, LIMITS, read, written, type Fault, type Sights } from '../state/asked-view';
import type { State } from '../state/store';
import type { Work } from '../state/work';
import type { Loop } from '../picture/loop';
import { Until } from '../picture/until';

/**
 * Changes the store as the words say, by `change`; a step is come to from the start of the work. Answers with the words as
 * the page writes them.
 */
export function show(words: string, work: Work, loop: Loop, change: (asked: Partial<State>) => void): string {
  const { engine } = work;
  const { viewing, faults } = read(words, engine.generator);
  const { view, overlays, pace, step, zoom, camera } = viewing;
  change({
    ...(view === undefined ? {} : { view, overlays: overlays ?? [] }),
    // Who asks for less motion keeps the own speed.
    ...(pace === undefined || wantsStill() ? {} : { pace }),
    ...(zoom === undefined || engine.isSpace ? {} : { zoom }),
    ...(step === undefined ? {} : { paused: false }),
    ...(camera === undefined ? {} : { turn: true, camera }),
  });
  if (step !== undefined) {
    loop.until = new Until(step, (made) => {
      // A recipe that gives nothing has told so.
      if (engine.stage() === 'error') return;
      change({ paused: true });
      if (made < step) notice('done', t('linked_ended', { made, step }));
    });
    work.restart();
    loop.changed();
  }
  if (faults.length) notice('link', ...engine.notices(), ...sentences(faults, engine.generator));
  return written(viewing, engine.generator);
}

/** A sentence for each fault: what was given, what may be given, what is taken. */
function sentences(faults: readonly Fault[], sights: Sights): string[] {
  const { bases, overlays, offers } = sights;
  return faults.map(({ what, given, kept }) => {
    const end = kept === undefined ? t('linked_left') : t('linked_kept', { kept });
    if (what === 'view') return t('linked_view', { given, known: bases.join(', '), end });
    if (what === 'layer') return t('linked_layer', { given, known: overlays.join(', '), end });
    if (what === 'step' && !offers.includes('forming')) return t('linked_no_steps', { end });
    if (what === 'camera') return offers.includes('turn') ? t('linked_camera', { given, limits: cameraLimits(sights).map(([from, to]) => `${from}–${to}`).join(', '), end }) : t('linked_no_turn', { end });
    const [from, to] = LIMITS[what];
    return t(`linked_${what}`, { given, from, to, end });
  });
}
