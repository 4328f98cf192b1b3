/** The ranges in which most pictures look good, by the word of a generator's table. They follow the presets. */
import { range, rarely, type Row, type Table, type When, type Weights } from './chance';

const SKIN: When = { stone: ['skin'] };
const FLAG: When = { stone: ['flag'] };
const TILE: When = { tile: ['1'] };
const ROADS = ['road_s', 'road_straight', 'road_spiral', 'y_fork', 'crossing', 'road_notch', 'l_shape', 'annulus'];
/** Forms with a head and a tail. */
const BODIES = ['leg', 'tail', 'fish', 'horn'];
/** Forms to walk on. */
const GROUNDS = ['terrain', 'slope', 'stairs'];
const STONE_PALETTES: Weights = { granite: 2, basalt: 2, sandstone: 2, terracotta: 2, marble: 2, porphyry: 2, slate: 1, mossy: 1, limestone: 2 };
/** All 26 letters, by their numbers. */
const LETTERS: Weights = Object.fromEntries(Array.from({ length: 26 }, (_, k) => [String(k + 1), 1]));
/** All heads of openings, by their numbers. */
const HEADS: Weights = { '0': 1, '1': 1, '2': 1 };

/** Rows for pavements and for surfaces. Their own rows have priority. */
const BOTH: Table = {
  Relief: [
    ['bh', range(0.1, 0.2, 0.01)],
  ],
  Surface: [
    ['palette', STONE_PALETTES],
    ['gloss', { own: 5, glossy: 1 }, SKIN],
    ['gloss', { own: 1 }],
  ],
  Colour: [
    ['pa', { '0': 1, '90': 2, '45': 1 }],
    ['ps', range(0.7, 0.9, 0.05)],
    ['pc', range(0.35, 0.55, 0.01)],
    ['pm', range(0.8, 1, 0.05), SKIN],
    ['pm', range(0.5, 0.8, 0.05)],
    ['belly', { '0': 1 }],
  ],
  Light: [
    ['shin', { '1': 1 }],
    ['shadow', { '1': 1 }],
  ],
};

const PLANE: Table = {
  Outline: [
    ['tile', { '0': 2, '1': 1 }, SKIN],
    ['tile', { '0': 5, '1': 1 }],
    ['outline', { square: 5, star: 2, annulus: 2, road_s: 2, plaza: 1, y_fork: 1 }, SKIN],
    ['outline', { annulus: 2, road_s: 3, road_spiral: 3, y_fork: 2, crossing: 2, plaza: 3, road_notch: 1, l_shape: 1, star: 3, square: 3 }],
    ['lines', ''],
    ['ow', range(1.1, 1.55, 0.05), { outline: ROADS }],
    ['ow', range(0.8, 1.3, 0.05), { outline: ['plaza'] }],
    ['ow', range(1.2, 1.5, 0.05), { outline: ['star'] }],
    ['ow', { '1': 1 }],
    ['on', range(5, 9, 1), { outline: ['star'] }],
    ['on', range(1, 4, 1), { outline: ['plaza'] }],
    ['on', range(2, 4, 1), { outline: ['road_s'] }],
    ['on', { '0': 1 }],
    ['oa', range(-30, 30, 5, { plain: [0, 0.75] })],
  ],
  Cells: [
    ['kind', { circle: 1 }, { stone: ['skin'], tile: ['0'], outline: ['star'] }],
    ['kind', { circle: 3, ellipse: 4 }, { stone: ['skin'], tile: ['0'], outline: ['square', 'plaza', 'annulus'] }],
    ['kind', { circle: 3, ellipse: 4, rectangle: 2 }, SKIN],
    ['kind', { square: 4, rectangle: 4, circle: 1 }, FLAG],
    ['kind', { square: 6, rectangle: 2, circle: 2, ellipse: 2 }],
    ['parts', ''],
    ['ca', range(1.2, 1.5, 0.05), SKIN],
    ['ca', range(1.4, 2.1, 0.05)],
    ['cb', { '1': 1 }],
    ['stretch', ''],
  ],
  Size: [
    ['cs', range(0.03, 0.06, 0.001, { per: 'size' }), SKIN],
    ['cs', range(0.028, 0.046, 0.001, { per: 'size' }), { outline: ROADS, tile: ['0'] }],
    ['cs', range(0.031, 0.064, 0.001, { per: 'size' })],
    ['gx', rarely(0.12, -0.4, 0.4)],
    ['gy', rarely(0.12, -0.4, 0.4)],
    ['gr', rarely(0.25, 0.2, 0.6)],
    ['gb', range(0.6, 0.85, 0.05, { plain: [1, 0.8] })],
    ['gd', range(0.15, 0.3, 0.01)],
    ['spots', ''],
  ],
  Direction: [
    ['dir', { constant: 1 }, TILE],
    ['dir', { boundary: 3, constant: 3, circular: 2, spiral: 1 }, { outline: ['square'] }],
    ['dir', { boundary: 6, circular: 1, spiral: 1 }, { outline: ['star', 'plaza'] }],
    ['dir', { boundary: 1 }],
    ['angle', { '90': 3, '0': 1 }, SKIN],
    ['angle', { '0': 3, '45': 2, '-45': 1, '90': 1 }],
    ['fx', range(0.3, 0.7, 0.01, { plain: [0.5, 0.6] })],
    ['fy', range(0.3, 0.7, 0.01, { plain: [0.5, 0.6] })],
    ['fa', range(35, 75, 1)],
    ['strokes', ''],
  ],
  Packing: [
    ['vs', rarely(0.6, 0.05, 0.2, 0.01)],
    ['cells', { fitted: 1 }, SKIN],
    ['cells', { fitted: 14, lloyd: 1 }, { kind: ['circle'] }],
    ['cells', { fitted: 1 }],
  ],
  Relief: [
    ['sv', range(1.25, 1.45, 0.01), { stone: ['skin'], kind: ['circle', 'square'] }],
    ['sv', range(1.35, 1.65, 0.01), SKIN],
    ['sv', range(0.95, 0.98, 0.01), FLAG],
    ['sv', range(0.96, 1.02, 0.01)],
    ['hs', range(0.35, 0.5, 1, { per: 'cs' }), FLAG],
    ['hs', range(0.55, 0.85, 1, { per: 'cs' })],
    ['sr', range(0.4, 0.9, 0.05)],
    ['sc', range(0, 0.4, 0.05), { kind: ['circle', 'square'] }],
    ['sc', range(0.5, 1.6, 0.05)],
    ['tilt', range(0.05, 0.18, 0.01)],
    ['sa', { '0': 3, '180': 1 }],
    ['tc', range(0.2, 0.5, 0.01)],
    ['flat', rarely(0.4, 0.2, 0.5)],
    ['keel', rarely(0.45, 0.3, 0.8)],
    ['rings', rarely(0.12, 4, 7, 1)],
    ['dr', range(0.02, 0.12, 0.01), SKIN],
    ['dr', range(0.08, 0.18, 0.01), FLAG],
    ['dr', range(0.15, 0.4, 0.01)],
  ],
  Surface: [
    ['fd', range(1.1, 1.4, 0.01), SKIN],
    ['fd', range(1.25, 1.5, 0.01)],
    ['af', range(0.02, 0.06, 0.01), SKIN],
    ['af', range(0.04, 0.075, 0.05, { per: 'cs' })],
    [
      'palette',
      { crocodile: 1, lizard: 2, snake: 1, coral: 1, fish: 1, koi: 1, tortoise: 1, armadillo: 1, pangolin: 1, desert: 1, cone: 1, dragon: 2 },
      SKIN,
    ],
    ['vary', range(0.5, 1.2, 0.05), SKIN],
    ['vary', range(0.8, 1.3, 0.05)],
    ['ground', { hide: 1 }, SKIN],
    ['ground', { mortar: 3, soil: 1, dark: 1, sand: 1 }, FLAG],
    ['ground', { sand: 2, soil: 3, dark: 2, moss: 1, gravel: 2, mortar: 1 }],
  ],
  Colour: [
    ['pattern', { none: 3, bands: 1, spots: 1, rosettes: 2, blotches: 2, turing: 2 }, SKIN],
    ['pattern', { none: 9, bands: 1, blotches: 1, boundary: 1 }],
    ['pn', range(0.15, 0.2, 0.01), { pattern: ['turing'] }],
    ['pn', range(0.2, 0.3, 0.01), { pattern: ['rosettes', 'spots'] }],
    ['pn', range(0.15, 0.45, 0.01)],
    ['rim', rarely(0.4, 0.1, 0.4)],
    ['belly', rarely(0.35, 0.4, 0.7), SKIN],
    ['ba', { '90': 3, '0': 1, '45': 1 }],
  ],
  Weather: [
    ['wear', { '0': 1 }, SKIN],
    ['wear', rarely(0.25, 0.3, 0.8)],
    ['moss', { '0': 1 }, SKIN],
    ['moss', rarely(0.2, 0.3, 0.7)],
    ['dirt', rarely(0.15, 0.1, 0.3), SKIN],
    ['dirt', rarely(0.3, 0.2, 0.5)],
    ['wet', { '0': 1 }, SKIN],
    ['wet', rarely(0.15, 0.4, 0.8)],
  ],
  Light: [
    ['light', { parallel: 7, point: 1 }],
    ['az', range(200, 320, 1)],
    ['el', range(32, 50, 1)],
    ['lx', range(0.2, 0.8, 0.01)],
    ['ly', range(0.1, 0.4, 0.01)],
    ['lz', range(0.3, 0.6, 0.01)],
    ['amb', range(1, 1.3, 0.05)],
    ['diff', range(1.1, 1.5, 0.05), { light: ['point'] }],
    ['diff', range(1, 1.3, 0.05)],
    ['spec', range(0.9, 1.4, 0.05)],
    ['occl', range(0.7, 1, 0.05)],
  ],
};

/** Lengths here are multiples of the cell size. */
const SURFACE: Table = {
  Shape: [
    ['form', { leg: 3, tail: 3, fish: 3, turtle: 3, horn: 2, egg: 3, knot: 2, torus: 2, vase: 1 }, SKIN],
    ['form', { terrain: 4, stairs: 2, slope: 1, cylinder: 2, sphere: 3, torus: 3, vase: 3, egg: 2, knot: 2, letter: 1 }],
    ['terrain_hills', range(1.6, 3.2, 0.1)],
    ['terrain_height', range(0.24, 0.46, 0.02)],
    ['terrain_lane', range(0.3, 0.9, 0.05)],
    ['terrain_wind', range(0.2, 0.8, 0.05)],
    ['terrain_hill', range(1, 999, 1)],
    ['slope_rise', range(14, 30, 1)],
    ['slope_width', range(0.4, 0.9, 0.05)],
    ['stairs_steps', range(3, 7, 1)],
    ['stairs_pitch', range(0.4, 0.7, 0.05)],
    ['stairs_width', range(0.5, 1, 0.05)],
    ['cylinder_height', range(0.8, 1.8, 0.05)],
    ['cylinder_top', range(0.7, 1.2, 0.05)],
    ['cylinder_belly', range(-0.2, 0.3, 0.05)],
    ['cylinder_caps', { '1': 1 }],
    ['sphere_height', range(0.6, 1.3, 0.05, { plain: [1, 0.5] })],
    ['sphere_depth', range(0.7, 1.2, 0.05, { plain: [1, 0.7] })],
    ['sphere_square', range(2, 3.4, 0.1, { plain: [2, 0.6] })],
    ['torus_tube', range(0.3, 0.55, 0.01)],
    ['torus_height', range(0.8, 1.3, 0.05, { plain: [1, 0.6] })],
    ['torus_waves', range(3, 7, 1, { plain: [0, 0.6] })],
    ['knot_turns', { '2': 1 }],
    ['knot_lobes', { '3': 4, '5': 1 }],
    ['knot_tube', range(0.6, 0.85, 0.05)],
    ['knot_swing', range(0.36, 0.46, 0.01)],
    ['horn_turns', range(0.8, 2.6, 0.05)],
    ['horn_rise', range(0.4, 1.4, 0.05)],
    ['horn_taper', range(0.1, 0.24, 0.01)],
    ['horn_girth', range(0.55, 0.8, 0.05)],
    ['leg_toes', range(3, 5, 1)],
    ['leg_bend', range(16, 46, 1)],
    ['leg_girth', range(0.9, 1.2, 0.05)],
    ['leg_reach', range(0.85, 1.2, 0.05)],
    ['tail_curl', range(120, 400, 5)],
    ['tail_taper', range(0.14, 0.3, 0.01)],
    ['tail_girth', range(0.13, 0.22, 0.01)],
    ['tail_lift', range(0.1, 0.7, 0.05)],
    ['fish_height', range(0.28, 0.46, 0.01)],
    ['fish_swim', range(-26, 26, 2)],
    ['turtle_width', range(0.7, 0.92, 0.01)],
    ['turtle_height', range(0.26, 0.46, 0.01)],
    ['egg_height', range(1.15, 1.6, 0.05)],
    ['egg_point', range(0.08, 0.3, 0.02)],
    ['vase_height', range(1.2, 1.9, 0.05)],
    ['vase_shoulder', range(0.42, 0.6, 0.01)],
    ['vase_neck', range(0.34, 0.6, 0.01)],
    ['vase_lip', range(1.1, 1.5, 0.05)],
    ['letter_letter', LETTERS],
    ['letter_weight', range(0.16, 0.21, 0.01)],
    ['letter_depth', range(0.2, 0.34, 0.02)],
    ['crease', { fold: 1 }],
    ['open', { shell: 1 }],
    ['yaw', range(-40, 40, 1, { plain: [0, 0.5] })],
  ],
  Cells: [
    ['kind', { circle: 3, ellipse: 2, rectangle: 2 }, { stone: ['skin'], form: ['egg', 'turtle', 'sphere', 'vase'] }],
    ['kind', { rectangle: 3, ellipse: 4, circle: 2 }, SKIN],
    ['kind', { square: 4, rectangle: 4 }, FLAG],
    ['kind', { square: 5, rectangle: 2, circle: 2 }],
    ['ca', range(1.2, 1.5, 0.05), SKIN],
    ['ca', range(1.4, 2, 0.05)],
    ['bent', { even: 1 }],
  ],
  Size: [
    ['cn', range(1400, 3000, 10), { form: ['leg'] }],
    ['cn', range(1800, 3000, 10), { form: ['fish', 'knot'] }],
    ['cn', range(1300, 2600, 10), { form: ['tail', 'horn', 'letter'] }],
    ['cn', range(900, 2000, 10), SKIN],
    ['cn', range(700, 1800, 10)],
    ['taper', range(0.4, 0.7, 0.05), { form: BODIES }],
    ['taper', { '1': 1 }],
    ['along', { bones: 1 }],
    ['cc', { '0': 1 }],
  ],
  Direction: [
    ['dir', { bones: 1 }, { form: BODIES }],
    ['dir', { bones: 3, free: 1 }],
    ['angle', range(-45, 45, 15, { plain: [0, 0.8] })],
    ['flow', { bones: 1 }],
    ['flip', { '0': 1 }],
  ],
  Packing: [
    ['vs', rarely(0.3, 0.05, 0.15, 0.01)],
  ],
  Relief: [
    ['sv', range(1.2, 1.4, 0.01), SKIN],
    ['sv', range(0.93, 0.97, 0.01), FLAG],
    ['sv', range(0.94, 0.99, 0.01)],
    ['hs', range(0.2, 0.34, 0.01), FLAG],
    ['hs', range(0.34, 0.6, 0.01)],
    ['sr', range(0.35, 0.7, 0.05)],
    ['sc', range(0.2, 0.6, 0.05), { kind: ['circle', 'square'] }],
    ['sc', range(0.6, 1.3, 0.05)],
    ['tilt', range(0.14, 0.32, 0.01)],
    ['sa', { '0': 1 }],
    ['tc', range(0.15, 0.4, 0.01)],
    ['flat', rarely(0.3, 0.2, 0.5)],
    ['keel', rarely(0.5, 0.3, 0.7)],
    ['rings', rarely(0.15, 4, 7, 1)],
    ['dr', range(0.02, 0.08, 0.01), SKIN],
    ['dr', range(0.08, 0.18, 0.01), FLAG],
    ['dr', range(0.18, 0.36, 0.01)],
  ],
  Surface: [
    ['fd', range(1.1, 1.3, 0.01), SKIN],
    ['fd', range(1.3, 1.5, 0.01)],
    ['af', range(0.02, 0.05, 0.01), SKIN],
    ['af', range(1.2, 2.2, 0.05)],
    ['palette', { fish: 3, koi: 3 }, { stone: ['skin'], form: ['fish'] }],
    ['palette', { tortoise: 3, armadillo: 1, dragon: 1 }, { stone: ['skin'], form: ['turtle'] }],
    ['palette', { cone: 2, pangolin: 2, dragon: 2 }, { stone: ['skin'], form: ['egg'] }],
    ['palette', { crocodile: 2, lizard: 2, snake: 1, coral: 1, pangolin: 2, desert: 1, dragon: 2 }, SKIN],
    ['vary', range(0.5, 1.1, 0.05), SKIN],
    ['vary', range(0.7, 1.2, 0.05)],
    ['ground', { hide: 1 }, SKIN],
    ['ground', { mortar: 3, sand: 2, dark: 1 }, FLAG],
    ['ground', { sand: 2, soil: 3, dark: 2, mortar: 2 }],
  ],
  Colour: [
    ['pattern', { blotches: 3, rosettes: 1 }, { palette: ['koi'] }],
    ['pattern', { none: 3, bands: 1, spots: 1, blotches: 2, turing: 2 }, SKIN],
    ['pattern', { none: 9, blotches: 1 }],
    ['pn', range(0.16, 0.26, 0.01), { palette: ['koi'] }],
    ['pn', range(0.1, 0.18, 0.01)],
    ['rim', rarely(0.3, 0.1, 0.3)],
    ['belly', rarely(0.4, 0.4, 0.7), { stone: ['skin'], form: BODIES }],
    ['ba', { '90': 1 }],
  ],
  Weather: [
    ['wear', { '0': 1 }, SKIN],
    ['wear', rarely(0.3, 0.3, 0.7), { form: GROUNDS }],
    ['wear', { '0': 1 }],
    ['moss', { '0': 1 }, SKIN],
    ['moss', rarely(0.25, 0.3, 0.7)],
    ['dirt', rarely(0.15, 0.1, 0.3), SKIN],
    ['dirt', rarely(0.2, 0.2, 0.4)],
    ['wet', { '0': 1 }, SKIN],
    ['wet', rarely(0.12, 0.3, 0.6)],
  ],
  Light: [
    ['light', { parallel: 1 }],
    ['az', range(100, 170, 1)],
    ['el', range(34, 52, 1)],
    ['amb', range(0.95, 1.15, 0.05)],
    ['diff', range(1, 1.15, 0.05)],
    ['spec', range(0.9, 1.2, 0.05)],
    ['occl', range(0.8, 1, 0.05)],
  ],
};

/** Things that roll, so that a container or an even shape holds them best; and metal parts. */
const FRUITS = ['orange', 'apple'];
const NUTS = ['chestnut', 'bean', 'cashew', 'almond', 'walnut'];
const METALS = ['nut', 'bolt', 'gear', 'torus'];
const STONES = ['pebble', 'smooth'];
const CONTAINERS = ['bowl', 'openbox'];
/** Shapes of which a part is slim: they need many bodies. */
const SLIM = ['letter', 'torus', 'knot'];

const FINISHES: Weights = { own: 24, river: 1, basalt: 1, quartz: 1, copper: 1, ivory: 1, clay: 1 };
const BRIGHT: Weights = { red: 1, blue: 1, yellow: 1, white: 1, glass: 2, ivory: 1, brass: 1, copper: 1 };

/** The rows of a type, by its number. */
const typeRows = (n: number): Row[] => {
  const type: When = { [`c${n}`]: ['ball', 'torus', 'box'] };
  return [
    [`f${n}`, { brass: 1, steel: 2, copper: 1, own: 4 }, { [`c${n}`]: METALS }],
    [`f${n}`, { own: 3, ...BRIGHT }, type],
    [`f${n}`, { own: 6, greenleaf: 1 }, { [`c${n}`]: ['leaf'] }],
    [`f${n}`, { own: 4, greenapple: 1 }, { [`c${n}`]: ['apple'] }],
    [`f${n}`, { own: 4, blackbean: 1 }, { [`c${n}`]: ['bean'] }],
    [`f${n}`, FINISHES, { [`c${n}`]: STONES }],
    [`f${n}`, { own: 1 }],
    [`k${n}`, n === 1 ? { '1': 1 } : range(0.7, 1.2, 0.05)],
    [`sigma${n}`, { '0': 1 }],
    ...['tu', 'tv', 'tw'].map((turn): Row => [`${turn}${n}`, { '360': 1 }]),
    [`l${n}`, { '2': 1 }],
  ];
};


/** Sunlight near its defaults, for bodies whose colours people know. */
const STILL_LIGHT: Row[] = [
  ['light', { parallel: 1 }],
  ['amb', range(0.95, 1.15, 0.05)],
  ['diff', range(1, 1.15, 0.05)],
  ['spec', range(0.9, 1.2, 0.05)],
  ['shin', { '1': 1 }],
  ['shadow', { '1': 1 }],
  ['occl', range(0.8, 1, 0.05)],
];

/** Recipes here have between some tens and some thousand darts. */
const PILE: Table = {
  Component: [
    ['c1', { rice: 3, pebble: 3, smooth: 2, chestnut: 2, nut: 2, bolt: 2, gear: 1, ball: 2, torus: 1, box: 1, bean: 2, cashew: 1, almond: 1, walnut: 1, leaf: 2, orange: 1, apple: 2 }],
    ...typeRows(1),
    ['variants', range(6, 12, 1)],
    ['jitter', range(0, 0.04, 0.01), { c1: METALS }],
    ['jitter', range(0.05, 0.2, 0.01)],
  ],
  'Second type': [
    ['c2', { none: 2, bolt: 1 }, { c1: ['nut', 'gear'] }],
    ['c2', { none: 2, nut: 1 }, { c1: ['bolt'] }],
    ['c2', { none: 3, smooth: 1 }, { c1: ['pebble'] }],
    ['c2', { none: 3, pebble: 1 }, { c1: ['smooth'] }],
    ['c2', { none: 3, almond: 1, walnut: 1 }, { c1: ['chestnut', 'cashew'] }],
    ['c2', { none: 3, chestnut: 1, cashew: 1 }, { c1: ['almond', 'walnut'] }],
    ['c2', { none: 2, apple: 1 }, { c1: ['orange'] }],
    ['c2', { none: 2, orange: 1 }, { c1: ['apple'] }],
    ['c2', { none: 2, ball: 1 }, { c1: ['ball'] }],
    ['c2', { none: 1 }],
    ...typeRows(2),
  ],
  'Third type': [
    ['c3', { none: 3, bean: 1 }, { c2: NUTS }],
    ['c3', { none: 4, ball: 1 }, { c2: ['ball'] }],
    ['c3', { none: 1 }],
    ...typeRows(3),
  ],
  'Fourth type': [['c4', { none: 1 }], ...typeRows(4)],
  Shape: [
    ['form', { riceball: 5, bowl: 2, heap: 2 }, { c1: ['rice'] }],
    ['form', { bowl: 4, openbox: 2, heap: 2 }, { c1: [...FRUITS, ...NUTS] }],
    ['form', { heap: 3, openbox: 2, letter: 1, bowl: 1 }, { c1: METALS }],
    ['form', { heap: 4, dome: 2, block: 1 }, { c1: ['leaf', 'box'] }],
    ['form', { sphere: 2, egg: 1, torus: 2, knot: 1, letter: 1, dome: 2, heap: 2, bowl: 1 }, { c1: ['ball'] }],
    ['form', { heap: 4, dome: 2, block: 1, openbox: 1, egg: 1, torus: 1, terrain: 1 }],
    ['heap_height', range(0.24, 0.36, 0.01)],
    ['heap_round', range(0.7, 0.94, 0.02)],
    ['heap_depth', range(0.7, 1, 0.05)],
    ['dome_height', range(0.35, 0.6, 0.01)],
    ['dome_depth', range(0.8, 1, 0.05)],
    ['riceball_thick', range(0.4, 0.52, 0.01)],
    ['riceball_round', range(0.35, 0.65, 0.05)],
    ['block_height', range(0.4, 0.8, 0.05)],
    ['block_depth', range(0.6, 1, 0.05)],
    ['block_round', range(0.15, 0.4, 0.05)],
    ['bowl_depth', range(0.28, 0.42, 0.01)],
    ['bowl_full', range(0.6, 0.95, 0.05)],
    ['openbox_depth', range(0.6, 1, 0.05)],
    ['openbox_height', range(0.22, 0.38, 0.01)],
    ['openbox_full', range(0.6, 0.95, 0.05)],
    ...shapeRows(),
    ['ps', range(5, 8, 0.5), { c1: FRUITS }],
    ['ps', range(15, 18, 0.5), { form: SLIM }],
    ['ps', range(7, 11, 0.5), { c1: ['leaf', 'box', 'torus', 'gear'] }],
    ['ps', range(8, 12, 0.5), { form: CONTAINERS }],
    ['ps', range(8, 14, 0.5)],
    ['core', { own: 1 }],
    ['layers', { '1': 1 }, { form: SLIM }],
    ['layers', { '1': 5, '2': 2, '3': 1 }],
    ['yaw', range(-40, 40, 1, { plain: [0, 0.5] })],
  ],
  Placing: [
    ['darts', { random: 1 }],
    ['merge', { merged: 1 }],
    ['frame', { local: 1 }],
  ],
  Refinement: [
    ['refine', { exact: 1 }],
    ['reading', { nearest: 1 }],
    ['iterations', { '15': 1 }],
    ['reach', { given: 1 }],
    ['offset', range(0.05, 0.25, 0.01)],
    ['removal', { '0.05': 1 }],
    ['alpha', { '0.75': 3, '1': 1, '0.5': 1 }],
    ['order', { random: 1 }],
    ['first', { large: 1 }],
    ['retries', { '1': 1 }],
  ],
  Look: [
    ['vary', range(0.7, 1.3, 0.05)],
    ['gloss', { own: 6, glossy: 1 }],
    ['wet', rarely(0.12, 0.2, 0.6)],
  ],
  Light: [['az', range(60, 150, 1)], ['el', range(36, 55, 1)], ...STILL_LIGHT],
};

/** The rows for the numbers of the shapes that piles share with surfaces. */
function shapeRows(): Row[] {
  return (SURFACE['Shape'] ?? []).filter(([key]) => /^[a-z]+_/.test(key));
}

/** Adds the shared rows to a table's own rows. */
function withBoth(own: Table): Table {
  return Object.fromEntries(Object.entries(own).map(([group, rows]) => [group, [...rows, ...(BOTH[group] ?? [])]]));
}

/** Buildings with the patterns, modules and colours that suit them. */
const MASONRY: Table = {
  Building: [
    ['building', { gabled: 4, lhouse: 3, gate: 3, wall: 2, tower: 2, steps: 2, plan: 2, ring: 1, block: 1 }],
    ['lhouse_length', range(40, 52, 1)],
    ['lhouse_width', range(32, 42, 1)],
    ['lhouse_wing', range(14, 22, 1)],
    ['lhouse_depth', range(14, 18, 1)],
    ['lhouse_height', range(30, 40, 1)],
    ['lhouse_windows', range(1, 3, 1)],
    ['lhouse_head', HEADS],
    ['lhouse_pitch', range(38, 50, 1)],
    ['gabled_length', range(38, 56, 1)],
    ['gabled_width', range(26, 36, 1)],
    ['gabled_height', range(28, 40, 1)],
    ['gabled_pitch', range(36, 52, 1)],
    ['gabled_windows', range(1, 3, 1)],
    ['gabled_head', HEADS],
    ['wall_length', range(42, 60, 1)],
    ['wall_height', range(24, 32, 1)],
    ['wall_thickness', range(3, 4, 1)],
    ['wall_width', range(4, 7, 1)],
    ['gate_span', range(8, 14, 1)],
    ['gate_pier', range(4, 8, 1)],
    ['gate_springing', range(12, 22, 1)],
    ['gate_over', range(5, 10, 1)],
    ['gate_thickness', range(4, 6, 1)],
    ['steps_steps', range(3, 6, 1)],
    ['steps_width', range(14, 22, 1)],
    ['steps_tread', range(2, 3, 1)],
    ['steps_riser', { '2': 1 }],
    ['steps_column', range(6, 8, 1)],
    ['steps_height', range(16, 24, 1)],
    ['tower_around', range(64, 110, 2)],
    ['tower_height', range(40, 66, 1)],
    ['tower_windows', range(3, 7, 1)],
    ['tower_width', range(3, 4, 1)],
    ['ring_walls', range(4, 9, 1)],
    ['ring_side', range(12, 20, 1)],
    ['ring_height', range(10, 20, 1)],
    ['block_length', range(14, 30, 1)],
    ['block_width', range(10, 20, 1)],
    ['block_height', range(12, 24, 1)],
    ['plan_height', range(22, 30, 1)],
    ['plan_thickness', range(2, 3, 1)],
    ['yaw', range(115, 165, 1), { building: ['lhouse'] }],
    ['yaw', range(-30, 30, 1, { plain: [0, 0.5] })],
  ],
  Pattern: [
    ['pattern', { diagonal: 2, cement: 2, bricks: 1 }, { building: ['steps'] }],
    ['pattern', { coped: 1 }, { building: ['ring', 'tower', 'wall', 'gate', 'plan'] }],
    ['pattern', { quoins: 3, bricks: 1, ashlar: 2 }],
    ['hand', { solved: 1 }],
  ],
  Module: [
    ['module', { ashlar: 1 }, { pattern: ['ashlar'] }],
    ['module', { nf: 3, us: 1, uk: 1 }],
  ],
  Blocks: [
    ['rough', range(0.35, 0.7, 0.05), { pattern: ['ashlar'] }],
    ['rough', { '0': 1 }],
    ['recess', range(4, 9, 1)],
    ['chamfer', range(3, 7, 1)],
    ['crooked', range(0.5, 1.6, 0.1)],
  ],
  Look: [
    ['walls', { honey: 3, grey: 3, pale: 1 }, { pattern: ['ashlar'] }],
    ['walls', { red: 4, yellow: 2, dark: 2, white: 1 }],
    // Quoins of the wall's own colour would look like bricks of a wrong size.
    ['dressing', { pale: 3, honey: 1, grey: 1 }, { pattern: ['quoins'] }],
    ['dressing', { same: 1, pale: 2 }],
    ['mortar', { light: 3, grey: 1, sand: 1 }],
    ['roof', { slate: 3, tiles: 2, brown: 2, stone: 1 }],
    ['vary', range(0.8, 1.3, 0.05)],
    ['gloss', { own: 1 }],
  ],
  Weather: [
    ['ground', { grass: 4, gravel: 1 }, { building: ['gabled', 'lhouse'] }],
    ['ground', { grass: 2, gravel: 2, paving: 2 }],
    ['moss', range(0.1, 0.4, 0.05), { building: ['gabled', 'lhouse'] }],
    // Level tops turn green all over where roofs have only patches.
    ['moss', range(0, 0.25, 0.05)],
    ['damp', range(0.1, 0.6, 0.05)],
  ],
  Light: [['az', range(40, 80, 1)], ['el', range(24, 42, 1)], ...STILL_LIGHT],
};

export const CHANCES: Record<string, Table> = { plane: withBoth(PLANE), surface: withBoth(SURFACE), pile: PILE, masonry: MASONRY };
