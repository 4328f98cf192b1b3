/** The figures of chapter 3 with their drawings. */
import { MESHES } from '../figures/mesh';
import { markAt } from '../figures/marks';
import { angleAt, angles, flagAt, HEIGHT } from './angles';
import { delaunay } from './delaunay';
import { dual } from './dual';
import { facing } from './facing';
import { inscribed } from './inscribed';
import { mesh } from './mesh';
import { ofPlaces, WIDTH, type Drawings } from './plate';

export const drawings: Drawings = {
  figures: MESHES,
  drawn: {
    dual: ofPlaces(dual),
    mesh: ofPlaces(mesh),
    angles: { height: HEIGHT, draw: angles, grip: (_view, _plate, key, [angle = 0]) => flagAt(markAt(key) ?? 0, angle), numbers: (x) => [angleAt(x)] },
    delaunay: ofPlaces(delaunay),
    facing: { height: WIDTH, draw: facing },
    inscribed: { height: WIDTH, draw: inscribed },
  },
};
