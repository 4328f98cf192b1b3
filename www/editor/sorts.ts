/** The sorts of figures that can be edited over the canvas: the outline, its roads, and the lists of the recipe. */
import type { Point } from '../module/types';
import { t, type EditorWord } from '../words/editor';
import type { Engine } from '../state/engine';
import { toolApplies } from '../state/rules';
import { hexagon, type Figure, type FigurePoint, type Sort } from './geometry/figures';
import { handled } from './geometry/handles';
import { distance, toSegment } from './geometry/plane';
import { depth } from './geometry/rings';

/**
 * Half the length of a new line and the radius of a new spot, in sides; the width of the first road, in hundredths of
 * the side.
 */
const NEW_LINE = 0.12;
const NEW_SPOT = 0.18;
const ROAD = 16;

const times = (value: number): string => `×${Number(value.toFixed(2))}`;
const ratio = (value: number): string => `${Number(value.toFixed(2))}:1`;

type Lined = 'line' | 'stroke' | 'road';

function line(word: string, label: EditorWord, figure: Lined, tip: EditorWord, value?: Sort['value']): Sort {
  const name = ({ figure: f, index }: FigurePoint, all: Figure[]): string =>
    t('point_of', { k: index + 1, n: all[f]?.points.length ?? 0, figure: `${t(figure)} ${f + 1}` });
  return { word, label: t(label), figure: t(figure), form: 'line', least: 2, tip: t(tip), name, value, broad: figure === 'road' };
}

function spot(word: string, label: EditorWord, value: NonNullable<Sort['value']>): Sort {
  const name = ({ figure: f, index }: FigurePoint, all: Figure[]): string =>
    `${t(index ? 'spot_rim' : 'spot_middle', { k: f + 1 })}, ${value.shown(all[f]?.value ?? 0)}`;
  return { word, label: t(label), figure: t('spot'), form: 'spot', least: 2, tip: t('tip_spot'), name, value };
}

function ringName(at: number, all: Figure[]): string {
  const rings = all.map(({ points }) => points);
  return at === 0 ? t('outer_ring') : t(depth(rings[at] ?? [], rings) % 2 ? 'hole_n' : 'island_n', { k: at });
}

export class Sorts {
  private readonly engine: Engine;
  private readonly all: Sort[];

  constructor(engine: Engine) {
    this.engine = engine;
    const kinds = engine.schema.find(({ key }) => key === 'kind')?.choices.map(({ label }) => label) ?? [];
    this.all = [
      {
        word: 'outline',
        label: t('outline'),
        figure: t('hole'),
        form: 'ring',
        least: 3,
        tip: t('tip_hole'),
        name: ({ figure, index }, all) => t('point_of', { k: index + 1, n: all[figure]?.points.length ?? 0, figure: ringName(figure, all) }),
      },
      line('road', 'road_label', 'road', 'tip_road', { label: t('road_width'), brief: t('road_brief'), min: 2, max: 60, step: 1, first: ROAD, shown: (value) => `${Math.round(value)} %` }),
      line('lines', 'lines', 'line', 'tip_line'),
      {
        word: 'parts',
        label: t('parts'),
        figure: t('part'),
        form: 'seed',
        least: 1,
        tip: t('tip_part'),
        name: ({ figure }, all) => t('part_of', { k: figure + 1, kind: kinds[all[figure]?.value ?? 0] ?? '' }),
        value: { label: t('part_kind'), words: kinds, min: 0, max: kinds.length - 1, step: 1, first: 2, shown: (value) => kinds[value] ?? '' },
      },
      line('strokes', 'strokes', 'stroke', 'tip_line'),
      spot('spots', 'spots', { label: t('spot_factor'), brief: t('spot_brief'), min: 0.2, max: 3, step: 0.1, first: 0.5, shown: times }),
      spot('stretch', 'stretch', { label: t('spot_ratio'), brief: t('ratio_brief'), min: 1, max: 5, step: 0.1, first: 4, shown: ratio }),
    ];
  }

  /** The sorts that have an effect now. */
  now(): Sort[] {
    return this.all.filter(({ word }) => toolApplies(this.engine, word));
  }

  /** The figures of a sort, in picture units. */
  read({ word, form }: Sort): Figure[] {
    const side = this.engine.side();
    if (form === 'ring') return handled(this.engine.outline(), side);
    return this.engine.list(word).map((row) => {
      const at = (k: number): Point => [(row[k] ?? 0) * side, (row[k + 1] ?? 0) * side];
      if (form === 'line') return { points: Array.from({ length: row.length / 2 }, (_, k) => at(2 * k)), value: 0 };
      if (form === 'seed') return { points: [at(0)], value: row[2] ?? 0 };
      return { points: [at(0), rim(at(0), (row[2] ?? 0) * side, side)], value: row[3] ?? 0 };
    });
  }

  /** The figures as the recipe's text. */
  text({ form }: Sort, figures: Figure[]): string {
    const side = this.engine.side();
    const rows = figures.map(({ points, value }) => {
      const [middle, end] = points;
      if (form === 'spot' && middle && end) return [middle[0] / side, middle[1] / side, distance(middle, end) / side, value];
      const places = points.flatMap(([x, y]) => [x / side, y / side]);
      return form === 'seed' ? [...places, value] : places;
    });
    return rows.map((row) => row.map((number) => number.toFixed(6)).join(',')).join(';');
  }

  /** A new figure inside the outline and away from the others. The seed of a part is put at `at`. */
  fresh({ form, value }: Sort, figures: Figure[], at?: Point): Figure | undefined {
    const side = this.engine.side();
    const { place, room } = at ? { place: at, room: 0 } : this.free(form, figures);
    const first = value?.first ?? 0;
    if (form === 'seed') return this.seed(figures, place, first);
    if (form === 'spot') return { points: [place, rim(place, NEW_SPOT * side, side)], value: first };
    const [x, y] = place;
    if (form === 'ring') return { points: hexagon(place, [x + Math.max(0.02 * side, 0.6 * room), y]), value: 0 };
    const half = Math.min(NEW_LINE * side, Math.max(1, x), Math.max(1, side - x));
    return { points: [[x - half, y], [x + half, y]], value: first };
  }

  /** A seed for the part at this place. It replaces the part's old seed and keeps its value. */
  private seed(figures: Figure[], at: Point, first: number): Figure | undefined {
    const part = this.engine.part(at);
    if (part < 0) return undefined;
    const old = figures.findIndex(({ points: [point] }) => point && this.engine.part(point) === part);
    const [taken] = old < 0 ? [] : figures.splice(old, 1);
    return { points: [at], value: taken ? taken.value : first };
  }

  /** Among places around the picture's middle, the one inside the outline with the most room. */
  private free(form: Sort['form'], figures: Figure[]): { place: Point; room: number } {
    const side = this.engine.side();
    const points = form === 'ring' ? [] : figures.flatMap((figure) => figure.points);
    const walls = this.engine.get('tile') === '1' ? [] : this.engine.outline();
    const taken = form === 'seed' ? points.map((point) => this.engine.part(point)) : [];
    let best: { place: Point; room: number } = { place: [side / 2, side / 2], room: -Infinity };
    for (let k = 0; k < 160; k += 1) {
      const r = side * 0.46 * Math.sqrt(k / 160);
      const place: Point = [side / 2 + r * Math.cos(2.399963 * k), side / 2 + r * Math.sin(2.399963 * k)];
      const part = this.engine.part(place);
      if (part < 0 || taken.includes(part)) continue;
      const near = walls.map((ring) => Math.min(...ring.map((from, n) => toSegment(place, from, ring[(n + 1) % ring.length] ?? from))));
      const room = Math.min(0.2 * side, ...near, ...points.map((point) => distance(point, place))) - 0.05 * r;
      if (room > best.room) best = { place, room };
    }
    return best;
  }
}

/** The point on a spot's border, within the picture where possible. */
function rim([x, y]: Point, radius: number, side: number): Point {
  const ways: Point[] = [[x + radius, y], [x - radius, y], [x, y + radius], [x, y - radius]];
  return ways.find((way) => way.every((at) => at >= 0 && at <= side)) ?? [x + radius, y];
}
