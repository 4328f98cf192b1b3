/**
 * Finds the moment at which an edge flips while points are moved by hand. The way between two states that were shown is
 * bisected: the module joins the points halfway, until the four corners lie on one circle.
 */
import { acrossOf, distance, edgeKey, edgeKeys, innerEdges, placeOf, sumOf, type Flip, type InnerEdge, type JoinedCells } from '../figures/joined';
import type { Place } from '../figures/place';
import { joinedBy } from './joined';
import { listText } from './lists';
import type { Bubbles, Studio } from './studio';

/** A state that was shown. */
interface ShownPoints {
  readonly places: readonly Place[];
  readonly joined: JoinedCells;
}

/** How often a way is halved at most, and the sum of facing angles that is half a turn, to a hundredth of a degree. */
const HALVINGS = 16;
const HALF_TURN = 179.99;

/** A flip is drawn only if the sum of its facing angles is above this, in degrees: almost half a turn. */
const NEARLY = 179.9;

/** Places that are closer than this, in shares of the picture's side, are the same. */
const SAME = 1e-6;

const BEFORE = ['domain', 'fields'];

export class Flips {
  /** The last flip, until another edge changes or a second one of its four corners is moved. */
  latest: Flip | undefined;
  private readonly studio: Studio;
  private shown: ShownPoints | undefined;
  private work: Generator<undefined, Flip | undefined> | undefined;

  constructor({ Bubblestone }: Bubbles, recipe: string) {
    this.studio = new Bubblestone(recipe);
  }

  /**
   * Searches the way to a state that is shown, until the time `end`; true once it is searched. First finishes a search
   * that has begun.
   */
  advance(now: ShownPoints, end: number): boolean {
    while (this.work || this.isNew(now)) {
      if (performance.now() > end) return false;
      if (this.work) this.go();
      else this.begin(now);
    }
    return true;
  }

  private isNew({ places }: ShownPoints): boolean {
    return String(places) !== String(this.shown?.places);
  }

  private begin(now: ShownPoints): void {
    const { shown } = this;
    this.shown = now;
    if (shown?.places.length === now.places.length) this.work = this.search(shown, now);
    else this.latest = undefined;
  }

  private go(): void {
    const { done, value } = this.work?.next() ?? { done: true };
    if (!done) return;
    this.latest = value ?? undefined;
    this.work = undefined;
  }

  private *search(from: ShownPoints, to: ShownPoints): Generator<undefined, Flip | undefined> {
    const edges = namesOf(from.joined);
    if (edges === namesOf(to.joined)) return this.latest && holds(this.latest, to.joined) ? this.latest : undefined;
    let [low, high, before, after] = [0, 1, from.joined, to.joined];
    for (let k = 0; k < HALVINGS && sumOfFlip(before, after) < HALF_TURN; k++) {
      const middle = (low + high) / 2;
      const joined = this.join(between(from.places, to.places, middle));
      if (namesOf(joined) === edges) [low, before] = [middle, joined];
      else [high, after] = [middle, joined];
      yield;
    }
    const flip = flipOf(before, after);
    const now = edgeKeys(to.joined);
    const stays = flip && !now.has(edgeKey(...flip.before.ends)) && now.has(edgeKey(...acrossOf(flip.before)));
    return stays && flip.sum > NEARLY ? flip : undefined;
  }

  private join(places: readonly Place[]): JoinedCells {
    const { studio } = this;
    studio.set('given', listText(places.map(([x, y]) => [x, y, 0]), 'given'));
    studio.hold(0);
    while (BEFORE.includes(studio.stage())) studio.tick(8, 0);
    while (!studio.reach(8));
    return joinedBy(studio, studio.side());
  }

  free(): void {
    this.studio.free();
  }
}

/** All edges as one text, to compare. */
const namesOf = (joined: JoinedCells): string => [...edgeKeys(joined)].sort().join();

/** Whether all but one of a flip's four corners are where they were. */
function holds({ before, points }: Flip, now: JoinedCells): boolean {
  return [...before.ends, ...acrossOf(before)].filter((id) => distance(placeOf(points, id), placeOf(now.points, id)) > SAME).length < 2;
}

function between(from: readonly Place[], to: readonly Place[], share: number): Place[] {
  return from.map(([x, y], k) => {
    const [u, v] = to[k] ?? [x, y];
    return [x + share * (u - x), y + share * (v - y)];
  });
}

/** The edge that is replaced by the other diagonal of its two triangles, if the meshes differ in nothing else. */
function flippedEdge(before: JoinedCells, after: JoinedCells): InnerEdge | undefined {
  const [old, now] = [edgeKeys(before), edgeKeys(after)];
  const [gone, come] = [[...old].filter((key) => !now.has(key)), [...now].filter((key) => !old.has(key))];
  if (gone.length !== 1 || come.length !== 1) return undefined;
  return innerEdges(before).find((edge) => edgeKey(...edge.ends) === gone[0] && edgeKey(...acrossOf(edge)) === come[0]);
}

function sumOfFlip(before: JoinedCells, after: JoinedCells): number {
  const edge = flippedEdge(before, after);
  return edge ? sumOf(edge) : 0;
}

function flipOf(before: JoinedCells, after: JoinedCells): Flip | undefined {
  const edge = flippedEdge(before, after);
  const triangle = edge && before.triangles.find(({ ids }) => edge.ends.every((id) => ids.includes(id)));
  return edge && triangle && { before: edge, sum: sumOf(edge), points: before.points, centre: triangle.centre, radius: triangle.radius };
}
