/** The row of the dialog that saves meshes. It shows the sizes of the files before one is made. */
import { t } from '../words/take';
import { make } from '../base/dom';
import { countedBy } from '../module/stages';
import type { Engine } from '../state/engine';
import { row, select, shown } from './dialog';
import type { Kind } from './file-name';
import type { Job } from './files/job.worker';

/** Triangles of a stone, by level of detail. */
const DETAILS = { low: 100, middle: 400, high: 1600 };

/** Approximate bytes for a pixel of a mesh's images: colour, normals, occlusion with roughness. */
const IMAGES = [1.85, 2.2, 1.15];

/**
 * By how many bytes a GLB file of one mesh is larger than the module's size, which is that of a mesh for each stone.
 * Each body saves its text (`textured`: with images), each triangle has wider indices, and with images each vertex has
 * more normals and tangents.
 */
const JOINED = { text: -850, textured: -560, triangle: 6, vertex: 28 };

/** The last choices. */
const chosen = { detail: 'middle', bodies: 'each' };

/** Approximate bytes of a line in a table of places. */
const PLACE = 160;

type Offer = (id: string, word: string, kind: () => Kind, job: () => Job) => HTMLElement;

export function meshes(engine: Engine, offer: Offer): HTMLElement {
  const words = { low: t('low', { n: shown(DETAILS.low) }), middle: t('middle', { n: shown(DETAILS.middle) }), high: t('high', { n: shown(DETAILS.high) }) };
  const detail = select('detail', t('detail'), words, chosen.detail);
  const bodies = select('bodies', t('bodies'), { each: t(`bodies_each_${countedBy(engine.generator)}`), one: t('bodies_one') }, chosen.bodies);
  const size = make('output', { class: 'take-note', id: 'mesh-size', for: 'detail bodies' });
  const tell = (): void => {
    Object.assign(chosen, { detail: detail.value, bodies: bodies.value });
    size.value = sizes(engine);
  };
  for (const choice of [detail, bodies]) choice.addEventListener('change', tell);
  tell();
  const file = (id: string, word: string, file: 'glb' | 'obj', images = false): HTMLElement => {
    const joined = (): boolean => file === 'glb' && bodies.value === 'one';
    const kind = (): Kind => ({ variant: [detail.value, images && 'images', joined() && 'one-mesh'], ending: file });
    return offer(id, word, kind, () => ({ file, detail: detail.value, images, joined: joined() }));
  };
  // Images are maps of a plane.
  const images = engine.offers('maps') ? [file('save-glb-images', t('images'), 'glb', true)] : [];
  const places = engine.offers('places') ? [offer('save-places', 'CSV', () => ({ variant: ['places'], ending: 'csv' }), () => ({ file: 'places' }))] : [];
  const building = engine.offers('building') ? [offer('save-building', t('building'), () => ({ variant: ['building'], ending: 'json' }), () => ({ file: 'building' }))] : [];
  const note = t(engine.offers('maps') ? 'mesh_note' : 'mesh_note_space');
  return row(t('mesh'), note, detail, bodies, file('save-glb', 'GLB', 'glb'), ...images, file('save-obj', 'OBJ', 'obj'), ...places, ...building, size);
}

/** The sentence on the sizes of the files with the last choices. */
function sizes(engine: Engine): string {
  const images = IMAGES.map((bytes) => bytes * engine.side() ** 2);
  const [plain, textured, obj] = [meshSize(engine, 'glb'), meshSize(engine, 'glb', images), meshSize(engine, 'obj')];
  const told = { n: shown(rounded(plain.triangles)), glb: megabytes(plain.bytes), obj: megabytes(obj.bytes) };
  if (engine.offers('maps')) return t('mesh_size', { ...told, images: megabytes(textured.bytes) });
  const { cells } = engine.status();
  return engine.offers('places') ? t('mesh_size_places', { ...told, bodies: shown(cells), csv: megabytes(PLACE * cells) }) : t('mesh_size_space', told);
}

/** The approximate triangles and bytes of a mesh file with the last choices; `images` are the bytes of its images. */
function meshSize(engine: Engine, ending: 'glb' | 'obj', images: readonly number[] = []): { triangles: number; bytes: number } {
  const [triangles = 0, bytes = 0] = engine.ask((studio) => studio.meshSize(ending, chosen.detail, Uint32Array.from(images)), new Float64Array());
  return { triangles, bytes: ending === 'glb' && chosen.bodies === 'one' ? bytes + joinedBytes(engine, triangles, images.length > 0) : bytes };
}

/** By how many bytes a file grows if it has one mesh. */
function joinedBytes(engine: Engine, triangles: number, textured: boolean): number {
  const { cells } = engine.status();
  const { text, triangle, vertex } = JOINED;
  if (!textured) return triangle * triangles + text * cells;
  // The ground has a fifth as many triangles as the stones. Its normals and tangents are in the file anyway.
  const ofStones = triangles / 1.2 / 2 + 2 * cells;
  return triangle * triangles + JOINED.textured * cells + vertex * ofStones;
}

/** Rounds to three digits. */
function rounded(count: number): number {
  return Number(count.toPrecision(3));
}

/** Bytes in megabytes, or in kilobytes if they are few. */
export function megabytes(bytes: number): string {
  const [unit, name] = bytes < 1e5 ? [1e3, 'kB'] : [1e6, 'MB'];
  return `${shown(Number((bytes / unit).toPrecision(2)))} ${name}`;
}
