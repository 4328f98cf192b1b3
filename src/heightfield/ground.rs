//! The bed of the pavement, between the stones and all around them: one periodic tile of heights and colours
//! with swells and patches, grains, and some pebbles.

use super::pixel_scale::PixelScale;
use crate::material::{Ground, NoiseTile};
use crate::random::{Purpose, Random};

/// Picture units along the tile's side, a power of two.
const SIDE: usize = 512;
/// Item, logarithm of the side, levels and dimension of its two noises, broad and fine.
const NOISES: [(u64, u32, u32, f64); 2] = [(11, 9, 7, 1.35), (12, 8, 1, 1.9)];
/// The side is divided in so many places, each of which may have a pebble.
const PLACES: usize = 64;
/// Radius of pebbles, in picture units: from and to, small ones more often.
const PEBBLE: [f32; 2] = [0.7, 2.6];
/// Height of a pebble over the ground, of its radius.
const STAND: f32 = 0.55;

/// Height and colour of the ground at any pixel, the same whenever asked.
#[derive(Clone, Debug)]
pub struct Bed {
    ground: Ground,
    level: f32,
    depth: f32,
    seed: u64,
    /// The ground repeats after so many pixels.
    period: Option<usize>,
    pixel_scale: PixelScale,
    /// Places of the tile for each picture unit, along a side: a power of two, not less than the
    /// pixels.
    dense: usize,
    /// Noise, broad and fine.
    tiles: Vec<NoiseTile>,
    /// Above the base level, in picture units.
    heights: Vec<f32>,
    /// Red, green and blue, 0..255.
    colours: Vec<[f32; 3]>,
}

impl Bed {
    /// Ground at `level`, its unevenness a part of the joints' `depth`; to be made by
    /// [`Bed::advance`]. With a `period` it repeats after so many pixels.
    pub fn new(
        ground: Ground,
        [level, depth]: [f32; 2],
        seed: u64,
        period: Option<usize>,
        pixel_scale: PixelScale,
    ) -> Self {
        let dense = (pixel_scale.per_unit() as usize).next_power_of_two();
        let places = dense * SIDE * dense * SIDE;
        Self {
            ground,
            level,
            depth,
            seed,
            period,
            pixel_scale,
            dense,
            tiles: Vec::new(),
            heights: Vec::with_capacity(places),
            colours: Vec::with_capacity(places),
        }
    }

    /// Places along the tile's side.
    fn side(&self) -> usize {
        SIDE * self.dense
    }

    /// Makes about `rows` rows of the tile; true when all are made.
    pub fn advance(&mut self, rows: usize) -> bool {
        let mut left = rows;
        while self.tiles.len() < NOISES.len() && left > 0 {
            let (item, log_side, levels, dimension) = NOISES[self.tiles.len()];
            let doublings = self.pixel_scale.noise_doublings();
            let tile = NoiseTile::finer(self.seed, item, [log_side, levels], dimension, doublings);
            self.tiles.push(tile);
            left = left.saturating_sub(SIDE);
        }
        let side = self.side();
        let made = self.heights.len() / side;
        let end = side.min(made.saturating_add(left));
        for y in made..end {
            self.row(y as i32);
        }
        if made < end && end == side {
            self.scatter_pebbles();
        }
        end == side
    }

    fn row(&mut self, y: i32) {
        let swell = self.ground.swell * self.depth;
        let unit = self.dense as i32;
        for x in 0..self.side() as i32 {
            let (wave, grain) = (self.noise(0, [x, y]), self.noise(1, [x, y]));
            self.heights
                .push(self.level + swell * wave + self.ground.grain * grain);
            let patch = 0.4 * wave + 0.6 * self.noise(0, [y + 131 * unit, x + 57 * unit]);
            self.colours.push(soil_colour(&self.ground, patch, grain));
        }
    }

    /// Height above the base level, in picture units.
    pub fn height(&self, x: i32, y: i32) -> f32 {
        self.heights[self.place(x, y)]
    }

    /// Red, green and blue, 0..255.
    pub fn colour(&self, x: i32, y: i32) -> [f32; 3] {
        self.colours[self.place(x, y)]
    }

    /// The noise of swells and patches at any pixel: deviation about 1.
    pub fn broad(&self, x: i32, y: i32) -> f32 {
        self.noise_at(0, x, y)
    }

    /// The noise of grains at any pixel: deviation about 1.
    pub fn grains(&self, x: i32, y: i32) -> f32 {
        self.noise_at(1, x, y)
    }

    fn noise_at(&self, which: usize, x: i32, y: i32) -> f32 {
        let (at, side) = (self.place(x, y), self.side());
        self.noise(which, [(at % side) as i32, (at / side) as i32])
    }

    /// At a place of the tile.
    fn noise(&self, which: usize, place: [i32; 2]) -> f32 {
        let places = PixelScale::new(self.dense);
        let [x, y] = place.map(|v| places.noise_value(v));
        self.tiles[which].at(x, y)
    }

    /// The colour of the dirt in hollows: red, green and blue, 0..255.
    pub fn dirt(&self) -> [f32; 3] {
        self.ground.dirt.map(f32::from)
    }

    /// Where in the tile a pixel is: tiles are stretched to a whole number in a period.
    fn place(&self, x: i32, y: i32) -> usize {
        match self.period {
            Some(period) => {
                let period = period as i32;
                let (side, unit) = (
                    self.side() as i32,
                    SIDE as i32 * self.pixel_scale.per_unit(),
                );
                let tiles = ((period + unit / 2) / unit).max(1);
                let stretched = |v: i32| v.rem_euclid(period) * tiles * side / period;
                self.index(stretched(x), stretched(y))
            }
            None => self.index(self.of_pixel(x), self.of_pixel(y)),
        }
    }

    fn of_pixel(&self, v: i32) -> i32 {
        let (pixels, dense) = (self.pixel_scale.per_unit(), self.dense as i32);
        if pixels == dense {
            v
        } else {
            (v * dense).div_euclid(pixels)
        }
    }

    fn index(&self, x: i32, y: i32) -> usize {
        let side = self.side();
        (y as usize & (side - 1)) * side + (x as usize & (side - 1))
    }

    fn scatter_pebbles(&mut self) {
        let ground = self.ground;
        let mut random = Random::new(self.seed, Purpose::Ground, 0);
        let apart = (self.side() / PLACES) as f64;
        let unit = self.dense as f32;
        for place in 0..PLACES * PLACES {
            let x = ((place % PLACES) as f64 + random.unit()) * apart;
            let y = ((place / PLACES) as f64 + random.unit()) * apart;
            let (there, size, tone) = (random.unit(), random.unit(), random.signed());
            let warm = random.signed() as f32;
            if there < f64::from(ground.pebbles) {
                let radius = PEBBLE[0] + (PEBBLE[1] - PEBBLE[0]) * (size * size * size) as f32;
                let light = 1.0 + 0.28 * tone as f32;
                let colour = [1.0 + 0.06 * warm, 1.0, 1.0 - 0.06 * warm]
                    .map(|w| w * light)
                    .into_iter()
                    .zip(ground.pebble)
                    .map(|(w, c)| w * f32::from(c));
                let mut rgb = [0.0; 3];
                rgb.iter_mut().zip(colour).for_each(|(to, c)| *to = c);
                self.pebble([x as f32, y as f32], radius * unit, rgb);
            }
        }
    }

    /// In places of the tile.
    fn pebble(&mut self, [x, y]: [f32; 2], radius: f32, colour: [f32; 3]) {
        let unit = 1.0 / self.dense as f32;
        let base = self.heights[self.index(x as i32, y as i32)];
        let reach = radius.ceil() as i32 + 1;
        for py in y as i32 - reach..=y as i32 + reach {
            for px in x as i32 - reach..=x as i32 + reach {
                let (dx, dy) = (px as f32 + 0.5 - x, py as f32 + 0.5 - y);
                let away = (dx * dx + dy * dy).sqrt() / radius;
                if away < 1.0 {
                    let at = self.index(px, py);
                    let height = base + STAND * radius * unit * (1.0 - away * away).sqrt();
                    self.heights[at] = self.heights[at].max(height);
                    let cover = ((1.0 - away) * radius * unit * 1.5).min(1.0);
                    let old = self.colours[at];
                    self.colours[at] =
                        std::array::from_fn(|k| old[k] + (colour[k] - old[k]) * cover);
                }
            }
        }
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
