//! The bed of the pavement, between and around the stones: a periodic tile of heights and colours with
//! swells, patches, grains and some pebbles. Only the rows of the tile under the current rows of the picture
//! are kept.

use super::pixel_scale::PixelScale;
use crate::material::{Ground, NoiseTile, white};
use crate::order::lesser;
use crate::random::{Purpose, Random};
use std::ops::Range;

/// Picture units along the tile's side, a power of two.
const SIDE: usize = 512;
/// For the broad and the fine noise: random stream, logarithm of the side, levels and dimension.
const NOISES: [(u64, u32, u32, f64); 2] = [(11, 9, 7, 1.35), (12, 8, 1, 1.9)];
/// If the tile has at least this many points for each picture unit, grains of the size 1 / `GRAINY` units lie on the
/// ground. Otherwise the fine noise, whose values are a unit apart, would show as waves, and light from the side as
/// ripples.
const GRAINY: usize = 4;
/// With grains: the share of the fine noise in heights, and the strengths of grains in heights and in colours.
const WAVES: f32 = 0.45;
const GRAINS: [f32; 2] = [0.26, 0.9];
/// The number of places for pebbles along the tile's side. Each place has at most one pebble.
const PLACES: usize = 64;
/// Least and largest radius of pebbles, in picture units; small ones are more frequent.
const PEBBLE: [f32; 2] = [0.7, 2.6];
/// Height of a pebble over the ground, relative to its radius.
const STAND: f32 = 0.55;

/// Height and colour of the ground at the pixels of some rows, always the same for the same pixel.
#[derive(Clone, Debug)]
pub struct Bed {
    ground: Ground,
    level: f32,
    depth: f32,
    seed: u64,
    /// Period of the ground in pixels, if it repeats.
    period: Option<usize>,
    pixel_scale: PixelScale,
    /// Points of the tile for each picture unit, along a side: a power of two, not less than the pixels.
    dense: usize,
    /// The broad and the fine noise.
    tiles: [NoiseTile; 2],
    /// The pebble at each of the [`PLACES`], if any.
    pebbles: Vec<Option<Pebble>>,
    /// The first row of the tile that is kept, and the number of rows kept.
    first: usize,
    held: usize,
    /// Heights of these rows above the base level, in picture units.
    heights: Vec<f32>,
    /// Red, green and blue, 0..255.
    colours: Vec<[f32; 3]>,
}

/// A pebble; lengths are in points of the tile.
#[derive(Clone, Copy, Debug)]
struct Pebble {
    middle: [f32; 2],
    radius: f32,
    /// Height of the ground under it, in picture units.
    base: f32,
    colour: [f32; 3],
}

impl Pebble {
    /// The columns or rows that it may cover.
    fn span(&self, axis: usize) -> Range<i32> {
        let (middle, reach) = (self.middle[axis] as i32, self.radius.ceil() as i32 + 1);
        middle - reach..middle + reach + 1
    }

    /// The distance of a point from the centre, relative to the radius: below 1 inside the pebble.
    fn away(&self, [x, y]: [i32; 2]) -> f32 {
        let [dx, dy] = [
            x as f32 + 0.5 - self.middle[0],
            y as f32 + 0.5 - self.middle[1],
        ];
        (dx * dx + dy * dy).sqrt() / self.radius
    }

    /// Its height in picture units at a relative distance from the centre; `unit` is the number of points in
    /// a picture unit.
    fn height(&self, away: f32, unit: f32) -> f32 {
        self.base + STAND * self.radius * unit * (1.0 - away * away).sqrt()
    }
}

impl Bed {
    /// Ground at `level`, with an unevenness in proportion to the joints' `depth`. Its rows are made by
    /// [`Bed::advance`]. With a `period` it repeats after that many pixels.
    pub fn new(
        ground: Ground,
        [level, depth]: [f32; 2],
        seed: u64,
        period: Option<usize>,
        pixel_scale: PixelScale,
    ) -> Self {
        let dense = (pixel_scale.per_unit() as usize).next_power_of_two();
        let doublings = pixel_scale.noise_doublings();
        let tiles = NOISES.map(|(item, log_side, levels, dimension)| {
            NoiseTile::finer(seed, item, [log_side, levels], dimension, doublings)
        });
        Self {
            ground,
            level,
            depth,
            seed,
            period,
            pixel_scale,
            dense,
            tiles,
            pebbles: Vec::new(),
            first: 0,
            held: 0,
            heights: Vec::new(),
            colours: Vec::new(),
        }
    }

    /// Points along the tile's side.
    fn side(&self) -> usize {
        SIDE * self.dense
    }

    /// Selects the rows of the picture whose ground will be needed; [`Bed::advance`] makes them.
    pub fn hold(&mut self, rows: Range<usize>) {
        let [first, last] = [rows.start as i32, rows.end as i32 - 1].map(|y| self.stretched(y));
        self.first = first as usize & (self.side() - 1);
        self.held = self.side().min((last - first).max(0) as usize + 1);
        self.heights.clear();
        self.colours.clear();
        self.heights.reserve_exact(self.held * self.side());
        self.colours.reserve_exact(self.held * self.side());
    }

    /// Frees the rows kept; queries of the noise alone still work.
    pub fn drop_rows(&mut self) {
        (self.held, self.heights, self.colours) = (0, Vec::new(), Vec::new());
    }

    /// Makes about `rows` rows of the tile; true when all selected rows are made.
    pub fn advance(&mut self, rows: usize) -> bool {
        let made = self.heights.len() / self.side();
        let end = self.held.min(made.saturating_add(rows));
        for row in made..end {
            self.row((self.first + row) as i32);
        }
        if made < end && end == self.held {
            self.put_pebbles();
        }
        end == self.held
    }

    fn row(&mut self, y: i32) {
        let unit = self.dense as i32;
        for x in 0..self.side() as i32 {
            let (wave, grain) = (self.noise(0, [x, y]), self.noise(1, [x, y]));
            let [raised, tone] = self.grained(grain, [x, y]);
            self.heights.push(self.bare(wave, raised));
            let patch = 0.4 * wave + 0.6 * self.noise(0, [y + 131 * unit, x + 57 * unit]);
            self.colours.push(soil_colour(&self.ground, patch, tone));
        }
    }

    /// The fine noise in heights and in colours at a point, with grains if the points are close enough.
    fn grained(&self, grain: f32, place: [i32; 2]) -> [f32; 2] {
        if self.dense < GRAINY {
            return [grain; 2];
        }
        let finer = self.dense / GRAINY;
        let last = self.side() / finer - 1;
        let [x, y] = place.map(|v| v as usize);
        let corner = |k: usize| {
            let place = [x + (k & 1) * (finer - 1), y + (k >> 1) * (finer - 1)];
            white(place.map(|v| (v / finer) & last), self.seed as u32)
        };
        let grains = (0..4).map(corner).sum::<f32>() / 4.0;
        [
            WAVES * grain + GRAINS[0] * grains,
            grain + GRAINS[1] * grains,
        ]
    }

    /// The height without pebbles for these values of the noises.
    fn bare(&self, wave: f32, grain: f32) -> f32 {
        let swell = self.ground.swell * self.depth;
        self.level + swell * wave + self.ground.grain * grain
    }

    /// Height above the base level, in picture units, within the rows kept.
    pub fn height(&self, x: i32, y: i32) -> f32 {
        self.heights[self.index([x, y].map(|v| self.stretched(v)))]
    }

    /// Red, green and blue, 0..255, within the rows kept.
    pub fn colour(&self, x: i32, y: i32) -> [f32; 3] {
        self.colours[self.index([x, y].map(|v| self.stretched(v)))]
    }

    /// The noise of swells and patches at any pixel, with standard deviation about 1.
    pub fn broad(&self, x: i32, y: i32) -> f32 {
        self.noise_at(0, x, y)
    }

    /// The noise of grains at any pixel, with standard deviation about 1.
    pub fn grains(&self, x: i32, y: i32) -> f32 {
        self.noise_at(1, x, y)
    }

    fn noise_at(&self, which: usize, x: i32, y: i32) -> f32 {
        self.noise(which, [x, y].map(|v| self.stretched(v)))
    }

    /// A noise at a point of the tile.
    fn noise(&self, which: usize, place: [i32; 2]) -> f32 {
        let places = PixelScale::new(self.dense);
        let [x, y] = place.map(|v| places.noise_value(v));
        self.tiles[which].at(x, y)
    }

    /// The colour of the dirt in hollows: red, green and blue, 0..255.
    pub fn dirt(&self) -> [f32; 3] {
        self.ground.dirt.map(f32::from)
    }

    /// The point of the periodic tile for a column or row of pixels. Tiles are stretched so that a period is
    /// a whole number of them.
    fn stretched(&self, v: i32) -> i32 {
        let (pixels, dense) = (self.pixel_scale.per_unit(), self.dense as i32);
        match self.period {
            Some(period) => {
                let period = period as i32;
                let (side, unit) = (self.side() as i32, SIDE as i32 * pixels);
                let tiles = ((period + unit / 2) / unit).max(1);
                v.rem_euclid(period) * tiles * side / period
            }
            None if pixels == dense => v,
            None => (v * dense).div_euclid(pixels),
        }
    }

    /// The column of a point of the tile, and its row counted from the first one kept.
    fn in_held(&self, [x, y]: [i32; 2]) -> [usize; 2] {
        let last = self.side() - 1;
        [
            x as usize & last,
            (y as usize).wrapping_sub(self.first) & last,
        ]
    }

    fn index(&self, place: [i32; 2]) -> usize {
        let [x, y] = self.in_held(place);
        y * self.side() + x
    }

    fn scatter_pebbles(&mut self) {
        let ground = self.ground;
        let mut random = Random::new(self.seed, Purpose::Ground, 0);
        let apart = (self.side() / PLACES) as f64;
        self.pebbles = vec![None; PLACES * PLACES];
        for place in 0..PLACES * PLACES {
            let x = ((place % PLACES) as f64 + random.unit()) * apart;
            let y = ((place / PLACES) as f64 + random.unit()) * apart;
            let (there, size, tone) = (random.unit(), random.unit(), random.signed());
            let warm = random.signed() as f32;
            if there < f64::from(ground.pebbles) {
                let radius = PEBBLE[0] + (PEBBLE[1] - PEBBLE[0]) * (size * size * size) as f32;
                let light = 1.0 + 0.28 * tone as f32;
                let warmth = [1.0 + 0.06 * warm, 1.0, 1.0 - 0.06 * warm];
                let middle = [x as f32, y as f32];
                self.pebbles[place] = Some(Pebble {
                    middle,
                    radius: radius * self.dense as f32,
                    base: self.base(place, middle.map(|v| v as i32)),
                    colour: std::array::from_fn(|k| {
                        warmth[k] * light * f32::from(ground.pebble[k])
                    }),
                });
            }
        }
    }

    /// The height at the centre of a new pebble, which may lie on earlier ones.
    fn base(&self, place: usize, middle: [i32; 2]) -> f32 {
        let [wave, grain] = [0, 1].map(|which| self.noise(which, middle));
        let mut base = self.bare(wave, self.grained(grain, middle)[0]);
        // Pebbles are smaller than their places, so the nine places around suffice.
        for k in 0..9 {
            let (column, row) = (
                place % PLACES + PLACES + k % 3 - 1,
                place / PLACES + PLACES + k / 3 - 1,
            );
            let there = row % PLACES * PLACES + column % PLACES;
            let Some(pebble) = &self.pebbles[there] else {
                continue;
            };
            let side = self.side() as i32;
            let beyond = [column, row].map(|v| (v / PLACES) as i32 - 1);
            let away = pebble.away([0, 1].map(|k| middle[k] - beyond[k] * side));
            if away < 1.0 {
                base = base.max(pebble.height(away, 1.0 / self.dense as f32));
            }
        }
        base
    }

    /// Adds the pebbles to the rows kept.
    fn put_pebbles(&mut self) {
        if self.pebbles.is_empty() {
            self.scatter_pebbles();
        }
        let pebbles = std::mem::take(&mut self.pebbles);
        for pebble in pebbles.iter().flatten() {
            for y in pebble.span(1) {
                if self.in_held([0, y])[1] < self.held {
                    pebble.span(0).for_each(|x| self.put(pebble, [x, y]));
                }
            }
        }
        self.pebbles = pebbles;
    }

    fn put(&mut self, pebble: &Pebble, place: [i32; 2]) {
        let unit = 1.0 / self.dense as f32;
        let (away, at) = (pebble.away(place), self.index(place));
        if away >= 1.0 {
            return;
        }
        self.heights[at] = self.heights[at].max(pebble.height(away, unit));
        let cover = lesser((1.0 - away) * pebble.radius * unit * 1.5, 1.0);
        let (old, colour) = (self.colours[at], pebble.colour);
        self.colours[at] = std::array::from_fn(|k| old[k] + (colour[k] - old[k]) * cover);
    }
}

fn soil_colour(ground: &Ground, patch: f32, grain: f32) -> [f32; 3] {
    let mix = (0.5 - 0.5 * patch).clamp(0.0, 1.0);
    let light = 1.0 + ground.speckle * grain;
    let [a, b] = ground.colours;
    std::array::from_fn(|k| {
        let base = f32::from(a[k]) * (1.0 - mix) + f32::from(b[k]) * mix;
        (base * light).clamp(0.0, 255.0)
    })
}
