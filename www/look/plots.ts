/** Plots of the packing's progress and of the quality of its cells. They follow the work. */
import uPlot from 'uplot';
import type { Histogram, Histograms, Series } from '../module/types';
import { t, type LookWord } from '../words/look';
import { byId, make, say, wantsStill } from '../base/dom';
import { RETOLD } from '../base/language';
import { REPAINT } from '../base/theme';
import type { Engine } from '../state/engine';
import type { View } from '../picture/view';
import '../styles/late/plots.css';
import 'uplot/dist/uPlot.min.css';

/** Milliseconds between two updates. */
const PAUSE = 120;

const HEIGHT = 112;

/**
 * The plots name the share of cells within these bounds: of the size, relative to the requested one, and in degrees.
 */
const SIZE_BAND = 0.1;
const ANGLE_BAND = 5;

interface PlotContent {
  readonly data: uPlot.AlignedData;
  readonly said: string;
}

/** The style of a line. Lines of one plot differ by their dashes, too, not by colour alone. */
interface LineStyle {
  readonly colour: string;
  readonly dash: number[];
  readonly width: number;
}

const LINE: LineStyle = { colour: '--accent', dash: [], width: 1.5 };

/** The energy and its parts, with their names. */
const ENERGIES: readonly (LineStyle & { readonly word: LookWord })[] = [
  { word: 'energy_sum', colour: '--text', dash: [], width: 2 },
  { word: 'energy_pairs', colour: '--accent', dash: [7, 3], width: 1.5 },
  { word: 'energy_walls', colour: '--accent', dash: [2, 3], width: 1.5 },
  { word: 'energy_motion', colour: '--soft', dash: [9, 3, 2, 3], width: 1.5 },
];

interface Plot {
  readonly place: HTMLElement;
  readonly said: HTMLElement;
  readonly read: () => PlotContent;
  readonly make: (width: number) => uPlot.Options;
  plot?: uPlot;
}

export class Plots {
  private readonly engine: Engine;
  private readonly section = byId('plots');
  private readonly plots: Plot[];
  private readonly narrow = matchMedia('(max-width: 60rem)');
  private last = 0;
  private timer = 0;

  constructor(engine: Engine, view: View) {
    this.engine = engine;
    this.plots = [
      this.plot('plot_energy', lines('axis_step', ENERGIES), () => {
        const { step, energy, walls, motion } = seriesOf(engine);
        const sum = energy.map((pairs, k) => pairs + (walls[k] ?? 0) + (motion[k] ?? 0));
        return { data: [step, sum, energy, walls, motion], said: said('plot_energy_said', step, sum) };
      }, ENERGIES),
      this.plot('plot_move', lines('axis_step', [LINE], true), () => {
        const { step, move } = seriesOf(engine);
        return { data: [step, move.map((v) => Math.max(v, 1e-6))], said: said('plot_move_said', step, move) };
      }),
      this.plot('plot_size', bars('axis_size'), () => counted(histogramsOf(engine).size, 'plot_size_said', 1 - SIZE_BAND, 1 + SIZE_BAND)),
      this.plot('plot_angle', bars('axis_angle'), () => {
        const { size, angle } = histogramsOf(engine);
        const { data, said } = counted(angle, 'plot_angle_said', 0, ANGLE_BAND);
        return { data, said: size.counts.some(Boolean) && !angle.counts.some(Boolean) ? t('plot_angle_none') : said };
      }),
    ];
    view.drawn(() => this.soon());
    this.narrow.addEventListener('change', () => this.settle());
    for (const sign of [REPAINT, RETOLD]) addEventListener(sign, () => this.renew());
    new ResizeObserver(() => this.fit()).observe(this.section);
    this.settle();
  }

  show(on: boolean): void {
    this.section.hidden = !on;
    if (!on) return;
    this.draw();
    // On a narrow page the plots may be out of sight under the picture.
    if (this.narrow.matches) this.section.scrollIntoView({ block: 'nearest', behavior: wantsStill() ? 'auto' : 'smooth' });
  }

  /** Makes the plots again with the page's colours and words. */
  private renew(): void {
    for (const each of this.plots) {
      each.plot?.destroy();
      delete each.plot;
    }
    this.draw();
  }

  /** Places the plots: under the picture on a narrow page, else above the controls. */
  private settle(): void {
    if (this.narrow.matches) document.querySelector('.stage')?.append(this.section);
    else byId('panel').prepend(this.section);
  }

  private plot(word: LookWord, make_: Plot['make'], read: Plot['read'], named: typeof ENERGIES = []): Plot {
    const place = make('div', { class: 'plot', 'aria-hidden': 'true' });
    const text = make('span', { class: 'plot-said' });
    this.section.append(make('figure', { id: word.replace('_', '-') }, make('figcaption', {}, make('b', {}, t(word)), ' ', text), ...(named.length ? [key(named)] : []), place));
    return { place, said: text, read, make: make_ };
  }

  /** Updates the plots now, or PAUSE after the last time. */
  private soon(): void {
    if (this.section.hidden || this.timer) return;
    this.timer = window.setTimeout(() => this.draw(), Math.max(0, this.last + PAUSE - performance.now()));
  }

  private draw(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.last = performance.now();
    if (this.section.hidden || !this.engine.alive) return;
    for (const plot of this.plots) {
      const { data, said: sentence } = plot.read();
      say(plot.said, sentence);
      // uPlot draws no axes without data.
      plot.place.classList.toggle('empty', !data[1]?.some(Boolean));
      if (plot.plot) plot.plot.setData(data);
      else plot.plot = new uPlot(plot.make(plot.place.clientWidth), data, plot.place);
    }
  }

  private fit(): void {
    for (const { plot, place } of this.plots) {
      const width = place.clientWidth;
      if (plot && width && plot.width !== width) plot.setSize({ width, height: HEIGHT });
    }
  }
}

/** The page's colour at the time of drawing. */
const colour = (name: string) => (): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function axes(word: LookWord, log: boolean): uPlot.Axis[] {
  const plain = { stroke: colour('--soft'), font: '11px system-ui, sans-serif', ticks: { stroke: colour('--line'), size: 4, width: 1 }, grid: { stroke: colour('--line'), width: 1 } };
  return [
    { ...plain, size: 22, gap: 2, grid: { show: false }, label: t(word), labelSize: 14, labelFont: '11px system-ui, sans-serif', labelGap: 0 },
    { ...plain, size: 44, gap: 4, space: 18, values: (_, marks, __, ___, apart) => marks.map((mark: number | null) => (mark === null ? '' : log ? short(mark) : spaced(mark, apart))), ...(log ? { filter: decades, grid: { ...plain.grid, filter: decades }, ticks: { ...plain.ticks, filter: decades } } : {}) },
  ];
}

/** Only the powers of ten get a mark on a logarithmic scale. */
function decades(_: uPlot, marks: number[]): (number | null)[] {
  return marks.map((mark) => (Math.abs(Math.log10(mark) - Math.round(Math.log10(mark))) < 1e-9 ? mark : null));
}

const still = { cursor: { show: false }, legend: { show: false }, height: HEIGHT, padding: [6, 8, 0, 0] as uPlot.Padding };

/** The names of lines, each with a piece of its line. */
function key(lines: typeof ENERGIES): HTMLElement {
  const pieces = lines.map(({ word, colour: name, dash, width }) => {
    const piece = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    piece.setAttribute('viewBox', '0 0 26 8');
    piece.innerHTML = `<path d="M0 4h26" stroke="var(${name})" stroke-width="${width}" stroke-dasharray="${dash.join(' ')}"/>`;
    return make('span', {}, piece, t(word));
  });
  return make('p', { class: 'plot-key' }, ...pieces);
}

function lines(word: LookWord, styles: readonly LineStyle[], log = false): Plot['make'] {
  return (width) => ({
    ...still,
    width,
    // uPlot's enum does not exist at run time: 3 is its logarithmic scale.
    // eslint-disable-next-line @typescript-eslint/no-unsafe-enum-assignment
    scales: { x: { time: false }, y: log ? { distr: 3 } : {} },
    axes: axes(word, log),
    series: [{}, ...styles.map(({ colour: name, dash, width: wide }) => ({ stroke: colour(name), width: wide, dash, points: { show: false } }))],
  });
}

function bars(word: LookWord): Plot['make'] {
  return (width) => ({
    ...still,
    width,
    scales: { x: { time: false }, y: { range: (_: uPlot, __: number, most: number) => [0, Math.max(most, 1)] as uPlot.Range.MinMax } },
    axes: axes(word, false),
    series: [{}, { stroke: colour('--accent'), fill: colour('--accent'), width: 0, points: { show: false }, ...(uPlot.paths.bars ? { paths: uPlot.paths.bars({ size: [0.86, 40] }) } : {}) }],
  });
}

/** The progress of the packing so far. */
function seriesOf(engine: Engine): Series {
  const empty = new Float64Array();
  const none = { step: empty, energy: empty, walls: empty, motion: empty, move: empty };
  return engine.ask((studio) => studio.series(), none);
}

function histogramsOf(engine: Engine): Histograms {
  const none = { from: 0, to: 0, counts: new Uint32Array() };
  return engine.ask((studio) => studio.histograms(), { size: none, angle: none });
}

/** A sentence with the last and the first value of a series. */
function said(word: 'plot_energy_said' | 'plot_move_said', step: Float64Array, values: Float64Array): string {
  const [now, first] = [values.at(-1), values[0]];
  if (now === undefined || first === undefined) return t('plot_none');
  return t(word, { step: step.at(-1) ?? 0, now: short(now), first: short(first) });
}

/** The middles of the classes with their counts, and the share of cells between two bounds. */
function counted({ from, to, counts }: Histogram, word: 'plot_size_said' | 'plot_angle_said', low: number, high: number): PlotContent {
  const wide = (to - from) / (counts.length || 1);
  const middles = Array.from(counts, (_, k) => from + (k + 0.5) * wide);
  const n = counts.reduce((sum, count) => sum + count, 0);
  const inside = middles.reduce((sum, at, k) => sum + (at > low && at < high ? (counts[k] ?? 0) : 0), 0);
  const share = n ? Math.round((100 * inside) / n) : 0;
  return { data: [middles, Array.from(counts)], said: n ? t(word, { share, n }) : t('plot_none') };
}

/** Four significant digits. */
function short(value: number): string {
  return signed(Math.abs(value) >= 1e4 ? `${Number((value / 1000).toPrecision(4))}k` : String(Number(value.toPrecision(4))));
}

/** A number with enough decimals to tell neighbouring marks apart. */
function spaced(value: number, apart: number): string {
  const digits = Math.max(0, Math.min(6, -Math.floor(Math.log10(apart || 1))));
  return Math.abs(value) >= 1e4 || !apart ? short(value) : signed(String(Number(value.toFixed(digits))));
}

function signed(text: string): string {
  return text.replace('-', '−');
}
