/** The tools for painting on a surface, beside the frame. */
import { t } from '../../words/space';
import { make, walkByArrows } from '../../base/dom';
import { shape } from '../../late/svg';

/** The tools, named by the parameter that they write; the last one erases. */
export const TOOLS = ['strokes', 'lines', 'spots', 'stretch', 'erase'] as const;
export type Tool = (typeof TOOLS)[number];

/** The limits of a spot's value, and its first value. */
const VALUES = { spots: { min: 0.2, max: 3, first: 0.5 }, stretch: { min: 1, max: 5, first: 3 } } as const;

const ICONS: Record<Tool | 'flip', string> = {
  strokes: 'M2.5 14.5C6 6.5 9.5 16.5 14 8.2l-2.3-.5.4-1.700 5.300 1.200-1.700 5.200-1.700-.6.7-2.100C9.500 19 6.500 9.500 4.200 15.300z',
  lines: 'M15.800 1.800a2.400 2.400 0 1 1-.8 4.600L6.400 15a2.400 2.400 0 1 1-1.400-1.400L13.600 5a2.400 2.400 0 0 1 2.200-3.200z',
  spots: 'M10 1.800a8.200 8.200 0 1 1 0 16.400 8.200 8.200 0 0 1 0-16.400zm0 1.800a6.400 6.400 0 1 0 0 12.800 6.400 6.400 0 0 0 0-12.800zM10 7.500a2.500 2.500 0 1 1 0 5 2.500 2.500 0 0 1 0-5z',
  stretch: 'M10 4.500c5 0 8.500 2.500 8.500 5.500s-3.500 5.500-8.500 5.500S1.500 13 1.500 10 5 4.500 10 4.500zm0 1.800c-4 0-6.700 1.800-6.700 3.700S6 13.700 10 13.700s6.700-1.800 6.700-3.700S14 6.300 10 6.300z',
  erase: 'M11.600 2.600 17.400 8.400 9.800 16H17v1.800H5.600L2.600 14.800zm0 2.600-4.300 4.300 3.200 3.200 4.300-4.300zM6 10.800l-.9.9L5.200 14.800 6.400 16H7.300l1.900-1.900z',
  flip: 'M6.500 2.500v9h2.300L5.600 16.500 2.400 11.500h2.300v-9zm7 15v-9h-2.300l3.200-5 3.200 5h-2.300v9z',
};

interface Needs {
  choose(tool: Tool): void;
  flip(): void;
}

export class Tools {
  readonly element: HTMLElement;
  private readonly buttons = new Map<Tool, HTMLButtonElement>();
  private readonly flip = button('flip');
  private readonly value = make('input', { type: 'range', id: 'paint-value', step: '0.05' });
  private readonly number = make('output', { for: 'paint-value' });
  private readonly label = make('label', { class: 'paint-value' }, make('span', { class: 'said' }, t('paint_value')), this.value, this.number);
  private readonly values: Record<keyof typeof VALUES, number> = { spots: VALUES.spots.first, stretch: VALUES.stretch.first };
  private tool: Tool | undefined;

  constructor(needs: Needs) {
    for (const tool of TOOLS) {
      const key = button(tool);
      key.setAttribute('aria-pressed', 'false');
      key.addEventListener('click', () => needs.choose(tool));
      this.buttons.set(tool, key);
    }
    this.flip.addEventListener('click', () => needs.flip());
    this.value.addEventListener('input', () => this.taken());
    this.element = make('div', { class: 'edit-tools paint-tools', id: 'paint-tools', role: 'toolbar', 'aria-label': t('paint') }, ...this.buttons.values(), this.flip, this.label);
    walkByArrows(this.element);
    this.show(undefined, [], false);
  }

  /** The value of new spots. */
  valueOf(tool: keyof typeof VALUES): number {
    return this.values[tool];
  }

  /** Shows the chosen tool, the tools that have an effect, and whether the flow is reversed. */
  show(tool: Tool | undefined, useful: readonly Tool[], flipped: boolean): void {
    for (const [word, key] of this.buttons) {
      key.setAttribute('aria-pressed', String(word === tool));
      key.hidden = !useful.includes(word);
    }
    this.flip.setAttribute('aria-pressed', String(flipped));
    // One of the buttons is the Tab stop.
    const all = [...this.buttons.values(), this.flip];
    const stop = (tool && this.buttons.get(tool)) ?? all.find((key) => !key.hidden);
    for (const key of all) key.tabIndex = key === stop ? 0 : -1;
    this.label.hidden = tool !== 'spots' && tool !== 'stretch';
    if (tool === this.tool) return;
    this.tool = tool;
    if (tool !== 'spots' && tool !== 'stretch') return;
    [this.value.min, this.value.max] = [String(VALUES[tool].min), String(VALUES[tool].max)];
    this.value.value = String(this.values[tool]);
    this.taken();
  }

  private taken(): void {
    if (this.tool !== 'spots' && this.tool !== 'stretch') return;
    const { min, max, first } = VALUES[this.tool];
    const value = (this.values[this.tool] = this.value.valueAsNumber);
    for (const [name, at] of [['--place', value], ['--default', first]] as const) this.value.style.setProperty(name, String((at - min) / (max - min)));
    this.number.value = t(this.tool === 'spots' ? 'paint_size' : 'paint_aspect', { n: value.toFixed(2) });
  }
}

function button(word: Tool | 'flip'): HTMLButtonElement {
  const icon = shape('svg', { viewBox: '0 0 20 20', 'aria-hidden': 'true' }, shape('path', { 'fill-rule': 'evenodd', d: ICONS[word] }));
  const key = make('button', { type: 'button', class: 'key', id: `paint-${word}`, title: t(`paint_${word}_title`) }, make('span', { class: 'word' }, t(`paint_${word}`)));
  key.prepend(icon);
  return key;
}
