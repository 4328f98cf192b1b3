// Walks through a chapter's page, by Tab and through the screens of a class; records of its shifts and its memory.

/** @typedef {import('puppeteer-core').Page} Page */

/**
 * Goes through a page by Tab alone, from its first element to its last. Returns elements that are not reached in the order of
 * the page, and those that are out of sight, under something else or without a ring while they have the focus.
 * @param {Page} page @returns {Promise<string[]>}
 */
export async function walkByTab(page) {
  await page.evaluate(() => {
    /** @type {Element[]} */
    const reached = [];
    /** @type {string[]} */
    const faults = [];
    const own = /** @type {any} */ (window);
    /** These change while figures start to work: grips are added, and stops that were not reached yet are disabled. */
    const LATE = '.grip, [data-stop], :disabled';
    const said = (/** @type {Element} */ element) => `${element.closest('figure')?.id ?? ''} ${element.outerHTML.slice(0, 80)}`;
    const look = (/** @type {Element} */ element) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      const hit = document.elementFromPoint(x, y);
      const isCovered = hit && !element.contains(hit) && !hit.contains(element);
      if (!width || x < 0 || x > innerWidth || y < 0 || y > innerHeight || isCovered) faults.push(`not seen: ${said(element)}`);
      const { outlineStyle, outlineWidth } = getComputedStyle(element);
      if (outlineStyle === 'none' || !parseFloat(outlineWidth)) faults.push(`no ring: ${said(element)}`);
    };
    /** Tab stops once at the buttons of a choice: at the checked one, or else at the first. */
    const isFirst = (/** @type {any} */ element) => element.type !== 'radio' || element.checked || (!document.querySelector(`[name="${element.name}"]:checked`) && document.querySelector(`[name="${element.name}"]`) === element);
    const controls = () => [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')].filter((one) => !one.matches(LATE) && one.checkVisibility({ visibilityProperty: true }) && isFirst(one));
    let isDone = false;
    addEventListener('keydown', () => isDone || !document.activeElement || document.activeElement === document.body || look(document.activeElement), true);
    addEventListener('focusin', (event) => {
      const target = /** @type {Element} */ (event.target);
      isDone ||= target === reached[0];
      if (!isDone && !target.matches(LATE)) reached.push(target);
    });
    /** @type {HTMLElement | null} */ (document.activeElement)?.blur();
    own.hasWalked = () => isDone;
    own.walked = () => [...faults, ...controls().flatMap((one, k) => (one === reached[k] ? [] : [`not in its turn: ${said(one)}`]))];
  });
  for (let k = 0; k < 30 && !(await page.evaluate(() => /** @type {any} */ (window).hasWalked())); k += 1) for (let tabs = 0; tabs < 16; tabs += 1) await page.keyboard.press('Tab');
  return page.evaluate(() => /** @type {any} */ (window).walked());
}

/**
 * Goes through all screens of a class, from the first to the last. On each it looks at the screen as it opens, and that of a
 * figure with one more line of its text; then it gives each answer, and shows the longest sentence on what happened. Returns:
 * - the screens that do not fit the window, and those whose question or one of its answers is not seen;
 * - those whose picture is left out or small: it has nearly half of the window's width, or three quarters of its height; that
 *   of a figure in full also three fifths of the width, or two thirds of the height;
 * - those whose plates move or shrink with an answer or the sentence, and those on which the sentence or the answers are not
 *   seen then.
 * A screen is measured when its figure works and its plates keep their place. The page may be walked again in another window.
 * @param {Page} page @returns {Promise<string[]>}
 */
export const badInClass = (/** @type {Page} */ page) =>
  page.evaluate(async () => {
    /** @type {string[]} */
    const found = [];
    const root = document.documentElement;
    const all = (/** @type {string} */ selector) => /** @type {HTMLElement[]} */ ([...document.querySelectorAll(selector)]);
    const press = (/** @type {string} */ key) => document.dispatchEvent(new KeyboardEvent('keydown', { key }));
    const frames = async () => {
      for (let k = 0; k < 2; k += 1) await new Promise(requestAnimationFrame);
    };
    const now = () => `${all('.scene').findIndex((scene) => scene.hasAttribute('data-now'))} ${root.dataset.part}`;
    const boxOf = (/** @type {Element | null} */ element) => JSON.stringify(element?.getBoundingClientRect());
    /** Waits until the plates are where they were two frames before. */
    const settled = async (/** @type {Element | null} */ plates) => {
      for (let before = '', after = boxOf(plates); before !== after; after = boxOf(plates)) {
        before = after;
        await frames();
      }
    };
    /** All that is shown, without the inside of drawings and formulas. */
    const shown = (/** @type {Element} */ scene) => [...scene.querySelectorAll('*')].filter((one) => one.checkVisibility({ visibilityProperty: true }) && !one.closest('svg, math, .grip-carrier') && one.getBoundingClientRect().height > 0);
    let seen = 0;
    let moves = 0;
    // An earlier walk in another window has given the answers.
    for (const fold of all('details.answers')) fold.removeAttribute('open');
    for (const input of all('.ask input[type=radio]')) /** @type {HTMLInputElement} */ (input).checked = false;
    for (const sentence of all('.ask-seen')) sentence.hidden = true;
    scrollTo({ top: 0, behavior: 'instant' });
    document.getElementById('class')?.click();
    for (let before = ''; before !== now(); press('ArrowRight')) {
      before = now();
      seen += 1;
      const scene = /** @type {HTMLElement} */ (document.querySelector('[data-now]'));
      const [figure, plates, told] = ['.figure', '.plates', '.figure-told'].map((part) => /** @type {HTMLElement | null} */ (scene.querySelector(part)));
      const isFigure = root.dataset.part === 'figure';
      const name = `${before} ${figure?.id ?? scene.dataset.kind}`;
      while (isFigure && !figure?.dataset.hash) await frames();
      await settled(plates);
      const look = (/** @type {string} */ how) => {
        const lowest = Math.max(root.scrollHeight, ...shown(scene).map((one) => one.getBoundingClientRect().bottom + scrollY));
        if (lowest > innerHeight + 1) found.push(`${name} ${how}: down to ${Math.round(lowest)}`);
      };
      look('as it opens');
      for (const one of scene.querySelectorAll('.ask :is(legend, label)')) {
        const { top, bottom, width } = one.getBoundingClientRect();
        if (!one.checkVisibility({ visibilityProperty: true }) || !width || top < 0 || bottom > innerHeight) found.push(`${name}: not seen: ${one.textContent}`);
      }
      if (!figure || !plates || !told) continue;
      const { width, height } = plates.getBoundingClientRect();
      const isSmall = (/** @type {number} */ broad, /** @type {number} */ high) => width < broad * innerWidth && height < high * innerHeight;
      if (!plates.checkVisibility() || isSmall(0.46, 0.75) || (isFigure && isSmall(0.6, 0.66))) found.push(`${name}: its picture has ${Math.round(width)} x ${Math.round(height)}`);
      const more = document.createElement('span');
      more.append(document.createElement('br'), 'A line more.');
      if (isFigure) {
        told.append(more);
        await settled(plates);
        look('with a line more');
      }
      const first = boxOf(plates);
      const stays = (/** @type {string} */ how) => {
        if (boxOf(plates) !== first) found.push(`${name} ${how}: ${first} ${boxOf(plates)}`);
      };
      for (const input of scene.querySelectorAll('.ask input[type=radio]')) {
        if (!input.checkVisibility()) continue;
        /** @type {HTMLInputElement} */ (input).click();
        moves += 1;
        stays('with an answer');
      }
      for (const place of scene.querySelectorAll('.seen-place')) {
        const sentence = /** @type {HTMLElement | null} */ (place.querySelector('.ask-seen'));
        if (!sentence || !place.checkVisibility()) continue;
        sentence.hidden = false;
        for (const room of place.querySelectorAll('.seen-room')) {
          sentence.textContent = [...room.querySelectorAll('[data-room]')].map((part) => part.getAttribute('data-room')).join('');
          moves += 1;
          stays('with its sentence');
        }
      }
      // Scripts fit the plates again after answers unfold.
      await frames();
      stays('after a while');
      for (const one of scene.querySelectorAll(isFigure ? '.ask label, .ask-seen' : '.ask label')) {
        const { left, top, right, bottom, width } = one.getBoundingClientRect();
        const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        if (!width || bottom > innerHeight || !hit || !one.contains(hit)) found.push(`${name}: not seen in the end: ${one.textContent}`);
      }
      more.remove();
    }
    press('Escape');
    return seen > 7 && moves > 10 ? found : [`only ${seen} were seen, with ${moves} answers and sentences`];
  });

/** Records the shifts of a page’s layout from its beginning on. */
export const watchShifts = (/** @type {Page} */ page) =>
  page.evaluateOnNewDocument(() => {
    const own = /** @type {any} */ (window);
    own.shifts = [];
    const said = (/** @type {any} */ { node }) => node?.outerHTML?.slice(0, 120) ?? node?.textContent;
    new PerformanceObserver((list) => own.shifts.push(...list.getEntries().map((/** @type {any} */ { value, sources }) => [value, ...sources.map(said)].join(' ')))).observe({ type: 'layout-shift', buffered: true });
  });

/** Keeps references to the memories of a page’s modules from its beginning on. */
export const watchMemory = (/** @type {Page} */ page) =>
  page.evaluateOnNewDocument(() => {
    const own = /** @type {any} */ (window);
    const assembly = /** @type {any} */ (WebAssembly);
    own.memories = [];
    for (const name of ['instantiate', 'instantiateStreaming']) {
      const plain = assembly[name].bind(WebAssembly);
      assembly[name] = async (/** @type {any[]} */ ...given) => {
        const made = await plain(...given);
        own.memories.push((made.instance ?? made).exports.memory);
        return made;
      };
    }
  });

/**
 * Words in plates that are smaller than 11 px, that stick out of their plate, or that lie on other words. Runs in the page.
 * @param {Element[]} plates @returns {string[]}
 */
export function badWords(plates) {
  return plates.flatMap((plate) => {
    const svg = /** @type {SVGSVGElement} */ (plate);
    const own = svg.getBoundingClientRect();
    const scale = own.width / svg.viewBox.baseVal.width;
    const texts = [...svg.querySelectorAll('text')].filter((text) => text.checkVisibility());
    /** The parts of a text that have letters of their own. */
    const parts = texts.flatMap((text) => [text, ...text.querySelectorAll('tspan')]).filter((part) => [...part.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim()));
    const small = parts.filter((part) => parseFloat(getComputedStyle(part).fontSize) * scale < 10.95);
    const boxes = texts.map((text) => text.getBoundingClientRect());
    // Boxes are higher than their letters.
    const out = texts.filter((_, k) => {
      const { left, right, top, bottom } = /** @type {DOMRect} */ (boxes[k]);
      return left < own.left - 1 || right > own.right + 1 || top < own.top - 4 || bottom > own.bottom + 4;
    });
    const covered = texts.filter((_, k) =>
      boxes.slice(0, k).some((one) => {
        const { left, right, top, bottom, height } = /** @type {DOMRect} */ (boxes[k]);
        return Math.min(right, one.right) - Math.max(left, one.left) > 1 && Math.min(bottom, one.bottom) - Math.max(top, one.top) > 0.3 * Math.min(height, one.height);
      }),
    );
    const said = (/** @type {string} */ fault) => (/** @type {Element} */ { textContent }) => `${plate.closest('figure')?.id} ${fault}: ${textContent}`;
    return [...small.map(said('small')), ...out.map(said('cut')), ...covered.map(said('on other words'))];
  });
}
