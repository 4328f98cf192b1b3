/** What can be edited over the canvas: the outline, and the lists of the recipe. */
import type { Engine } from './engine';
import { distance, simplify, toSegment } from './simplify';
import type { Figure, Point, Sort } from './types';

/** Points of a built-in outline that is made free, and of a free one that is edited, at most. */
const FROM_BUILT_IN = 36;
const FROM_FREE = 300;

/** Half the length of a new line and the radius of a new spot, in sides. */
const NEW_LINE = 0.12;
const NEW_SPOT = 0.18;

const times = (value: number): string => `×${Number(value.toFixed(2))}`;
const ratio = (value: number): string => `${Number(value.toFixed(2))}:1`;

function line(word: string, label: string, figure: string): Sort {
  const name: Sort['name'] = (f, index, { points }) => `Point ${index + 1} of ${points.length}, ${figure} ${f + 1}`;
  return { word, label, figure, form: 'line', least: 2, name };
}

function spot(word: string, label: string, value: Sort['value']): Sort {
  const name: Sort['name'] = (f, index, figure) =>
    `${index ? 'Rim' : 'Middle'} of spot ${f + 1}${value ? `, ${value.shown(figure.value)}` : ''}`;
  return { word, label, figure: 'spot', form: 'spot', least: 2, name, value };
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
        label: 'Outline',
        figure: 'ring',
        form: 'ring',
        least: 3,
        name: (f, index, { points }) => `Point ${index + 1} of ${points.length}, ${f === 0 ? 'outer ring' : `ring ${f + 1}`}`,
      },
      line('lines', 'Constraint lines', 'line'),
      {
        word: 'parts',
        label: 'Kinds of parts',
        figure: 'part',
        form: 'seed',
        least: 1,
        name: (f, _, { value }) => `Part ${f + 1}, ${kinds[value] ?? ''}`,
        value: { label: 'Kind of the marked part', words: kinds, min: 0, max: kinds.length - 1, first: 2, shown: (value) => kinds[value] ?? '' },
      },
      line('strokes', 'Strokes', 'stroke'),
      spot('spots', 'Size spots', { label: 'Factor of the size', min: 0.2, max: 3, first: 0.5, shown: times }),
      spot('stretch', 'Aspect spots', { label: 'Aspect ratio', min: 1, max: 5, first: 4, shown: ratio }),
    ];
  }

  /** Those that do something now: parts need lines, a tile has no outline. */
  now(): Sort[] {
    const kinds = this.kinds();
    const use: Record<string, boolean> = {
      outline: this.engine.get('tile') !== '1',
      parts: this.engine.get('lines') !== '',
      stretch: kinds.some((kind) => kind === 'rectangle' || kind === 'ellipse'),
    };
    return this.all.filter(({ word }) => use[word] ?? true);
  }

  /** The kinds in use, of all parts. */
  kinds(): string[] {
    const words = this.engine.schema.find(({ key }) => key === 'kind')?.choices.map(({ word }) => word) ?? [];
    const ofParts = this.engine.list('parts').map((row) => words[row[2] ?? 0] ?? '');
    return [this.engine.get('kind'), ...ofParts];
  }

  /** The figures of a sort, in picture units. */
  read({ word, form }: Sort): Figure[] {
    const side = this.engine.side();
    if (form === 'ring') {
      const most = this.engine.get('outline') === 'polygon' ? FROM_FREE : FROM_BUILT_IN;
      return simplify(this.engine.outline(), side, most).map((points) => ({ points: points.map(([x, y]): Point => [x, y]), value: 0 }));
    }
    return this.engine.list(word).map((row) => {
      const at = (k: number): Point => [(row[k] ?? 0) * side, (row[k + 1] ?? 0) * side];
      if (form === 'line') return { points: Array.from({ length: row.length / 2 }, (_, k) => at(2 * k)), value: 0 };
      if (form === 'seed') return { points: [at(0)], value: row[2] ?? 0 };
      return { points: [at(0), rim(at(0), (row[2] ?? 0) * side, side)], value: row[3] ?? 0 };
    });
  }

  /** Figures of a list as the recipe's text. */
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

  /** A new figure inside the outline and away from the others; a part's seed where it was asked for. */
  fresh({ form, value }: Sort, figures: Figure[], at?: Point): Figure | undefined {
    const side = this.engine.side();
    const middle = at ?? this.free(form, figures);
    const first = value?.first ?? 0;
    if (form === 'seed') return this.seed(figures, middle, first);
    if (form === 'spot') return { points: [middle, rim(middle, NEW_SPOT * side, side)], value: first };
    const [x, y] = middle;
    const half = Math.min(NEW_LINE * side, Math.max(1, x), Math.max(1, side - x));
    return { points: [[x - half, y], [x + half, y]], value: 0 };
  }

  /** The part at this place gets a seed, or, where it has one, that one is marked by taking its place. */
  private seed(figures: Figure[], at: Point, first: number): Figure | undefined {
    const part = this.engine.part(at);
    if (part < 0) return undefined;
    const old = figures.findIndex(({ points: [point] }) => point && this.engine.part(point) === part);
    const [taken] = old < 0 ? [] : figures.splice(old, 1);
    return { points: [at], value: taken ? taken.value : first };
  }

  /** Of places around the picture's middle the one inside the outline with the most room around it. */
  private free(form: Sort['form'], figures: Figure[]): Point {
    const side = this.engine.side();
    const points = figures.flatMap((figure) => figure.points);
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
    return best.place;
  }
}

/** The rim's point of a spot, where it lies in the picture if it can. */
function rim([x, y]: Point, radius: number, side: number): Point {
  const ways: Point[] = [[x + radius, y], [x - radius, y], [x, y + radius], [x, y - radius]];
  return ways.find((way) => way.every((at) => at >= 0 && at <= side)) ?? [x + radius, y];
}
