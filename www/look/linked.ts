/** Shows the view that a link's words describe, and names the words that cannot be shown. */
import { t } from '../words/look';
import { wantsStill } from '../base/dom';
import { notice } from '../base/messages';
import { cameraLimits, hasBodies, LIMITS, read, written, type Fault, type Sights } from '../state/asked-view';
import type { State } from '../state/store';
import type { Work } from '../state/work';
import type { Loop } from '../picture/loop';
import { Until } from '../picture/until';

/**
 * Applies the words to the store through `change`. A step is reached from the start of the work. Returns the words as
 * the page writes them.
 */
export function show(words: string, work: Work, loop: Loop, change: (asked: Partial<State>) => void): string {
  const { engine } = work;
  const { viewing, faults } = read(words, engine.generator);
  const { view, overlays, pace, step, zoom, camera, cut, body } = viewing;
  change({
    ...(view === undefined ? {} : { view, overlays: overlays ?? [] }),
    // Visitors who prefer reduced motion keep their own speed.
    ...(pace === undefined || wantsStill() ? {} : { pace }),
    ...(zoom === undefined || engine.offers('frames') ? {} : { zoom }),
    ...(step === undefined ? {} : { paused: false }),
    ...(camera === undefined ? {} : { turn: true, camera }),
    ...(cut === undefined ? {} : { cut }),
    ...(body === undefined ? {} : { turn: true, asked: body }),
  });
  if (step !== undefined) {
    loop.until = new Until(step, (made) => {
      // The reason why such a recipe gives no picture is shown already.
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

/** A sentence for each fault: the given value, the allowed ones, and the one used instead. */
function sentences(faults: readonly Fault[], sights: Sights): string[] {
  const { bases, overlays, offers } = sights;
  return faults.map(({ what, given, kept }) => {
    const end = kept === undefined ? t('linked_left') : t('linked_kept', { kept });
    if (what === 'view') return t('linked_view', { given, known: bases.join(', '), end });
    if (what === 'layer') return t('linked_layer', { given, known: overlays.join(', '), end });
    if (what === 'step' && !offers.includes('forming')) return t('linked_no_steps', { end });
    if (what === 'camera') return hasBodies(sights) ? t('linked_camera', { given, limits: cameraLimits(sights).map(([from, to]) => `${from}–${to}`).join(', '), end }) : t('linked_no_turn', { end });
    if (what === 'cut') return t('linked_cut', { given, end });
    if (what === 'body') return t('linked_body', { given, end });
    const [from, to] = LIMITS[what];
    return t(`linked_${what}`, { given, from, to, end });
  });
}
