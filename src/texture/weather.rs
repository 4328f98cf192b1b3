//! What years and weather do to the planes: wear, dirt, moss, wet.
//!
//! One pass over the finished stones; then the openness is worked out of them. Tops and hollows are
//! told apart by the mean height around each pixel.

use super::coat::smooth;
use super::ground::Bed;
use super::occlusion::Occlusion;
use super::optics::{DIRT, FINISHES, MOSS, ROWS, WATER};
use super::{GROUND, Planes};
use crate::domain::Domain;
use crate::order::{self, greater, lesser};
use glam::DVec2;
use std::rc::Rc;

/// How much of each, 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WeatherParams {
    /// Trodden tops are lowered, rounded and polished, most of all along the middle of the way.
    pub wear: f64,
    /// Moss, in the joints first.
    pub moss: f64,
    /// Dust and mud in hollows.
    pub dirt: f64,
    /// Damp, then wet, then puddles.
    pub wet: f64,
}

impl WeatherParams {
    fn is_fair(&self) -> bool {
        *self == Self::default()
    }
}

/// Picture units from one distance to the boundary to the next; between them it is interpolated.
const STEP: usize = 8;
/// Half the width of the means around a pixel, in cell sizes: of what feet round, and of what makes
/// a hollow.
const REACH: [f64; 2] = [0.1, 0.5];
/// How trodden a tile is, which has no middle.
const EVERYWHERE: f32 = 0.75;
/// What wear takes off at most, of the joints' depth.
const LOSS: f32 = 0.44;
/// How far below and above that the edge it leaves is rounded, and how deep it rubs off what is rough.
const EDGE: f32 = 0.22;
const RUB: f32 = 0.06;
/// Thickness of moss and of dirt, of the joints' depth.
const PAD: f32 = 0.13;
const SILT: f32 = 0.06;
/// Colours of moss: in the shade and in the light.
const GREENS: [[f32; 3]; 2] = [[54.0, 66.0, 30.0], [102.0, 108.0, 53.0]];
/// What still water shows of the sky, and how much.
const SKY: [f32; 3] = [126.0, 138.0, 148.0];
const MIRROR: f32 = 0.42;

/// Planes with all stones in them, dry and new and with all of the sky's light everywhere.
#[derive(Clone)]
pub struct Painted {
    /// The planes.
    pub planes: Planes,
    pub(super) bed: Rc<Bed>,
    /// The size cells were asked to have on average, in picture units.
    pub(super) size: f64,
    /// The joints' depth, in picture units.
    pub(super) depth: f32,
}

/// The weather over all stones, and then how much of the sky's light comes to each place.
pub struct Weathering {
    planes: Planes,
    bed: Rc<Bed>,
    weather: Weather,
    occlusion: Occlusion,
}

impl Weathering {
    /// Weather to come over planes as they were painted.
    pub fn new(params: WeatherParams, painted: Painted) -> Self {
        let Painted {
            planes,
            bed,
            size,
            depth,
        } = painted;
        let joints = [planes.ground, depth];
        Self {
            weather: Weather::new(params, [planes.side, planes.fine], size, joints),
            occlusion: Occlusion::new(size, planes.fine, planes.tile),
            planes,
            bed,
        }
    }

    /// Goes on by about `rows` rows; true when all is done. The domain must stay the same.
    pub fn advance(&mut self, domain: &Domain, rows: usize) -> bool {
        let planes = &mut self.planes;
        let weathered = self.weather.advance(planes, &self.bed, domain, rows);
        weathered && self.occlusion.advance(planes, rows)
    }

    /// The planes as they are by now.
    pub fn planes(&self) -> &Planes {
        &self.planes
    }

    /// The planes, to keep.
    pub fn finish(self) -> Planes {
        self.planes
    }
}

/// The weather at work.
struct Weather {
    params: WeatherParams,
    /// Pixels along the picture's side, and for each picture unit.
    side: usize,
    fine: usize,
    /// Height of the joints' ground, and their depth.
    level: f32,
    depth: f32,
    size: f32,
    means: [Mean; 2],
    /// Distances to the boundary at every [`STEP`]-th pixel; none on a tile.
    distances: Vec<f32>,
    farthest: f32,
    row: usize,
}

impl Weather {
    /// Weather for joints of a ground at `level` and of `depth` between stones of about `size`, in a
    /// picture of `side` pixels with `fine` of them for each unit.
    fn new(
        params: WeatherParams,
        [side, fine]: [usize; 2],
        size: f64,
        [level, depth]: [f32; 2],
    ) -> Self {
        let radius = |reach: f64| (reach * size) as usize * fine + fine / 2;
        Self {
            params,
            side,
            fine,
            level,
            depth,
            size: size as f32,
            means: REACH.map(|reach| Mean::new(radius(reach), side)),
            distances: Vec::new(),
            farthest: 1.0,
            row: 0,
        }
    }

    /// Goes on by about `rows` rows; true when all is done.
    fn advance(&mut self, planes: &mut Planes, bed: &Bed, domain: &Domain, rows: usize) -> bool {
        if self.params.is_fair() {
            return true;
        }
        let side = self.side;
        if self.measure(domain, rows) || self.means.iter_mut().any(|m| m.fill(planes, rows)) {
            return false;
        }
        let end = side.min(self.row.saturating_add(rows));
        let mut means = [vec![0.0; side], vec![0.0; side]];
        for y in self.row..end {
            for (mean, row) in self.means.iter_mut().zip(&mut means) {
                mean.row(y, planes.tile, row);
            }
            let [near, wide] = &means;
            for (x, (&near, &wide)) in near.iter().zip(wide).enumerate() {
                self.pixel(planes, bed, [x, y], [near, wide]);
            }
        }
        self.row = end;
        end == side
    }

    /// Some more rows of distances; false when all are there.
    fn measure(&mut self, domain: &Domain, rows: usize) -> bool {
        let across = self.side / self.step() + 2;
        let made = self.distances.len() / across;
        if domain.period().is_some() || made == across {
            return false;
        }
        for y in made..across.min(made.saturating_add(rows)) {
            for x in 0..across {
                let at = DVec2::new(x as f64, y as f64) * STEP as f64;
                let distance = domain.nearest(at).distance as f32;
                self.farthest = greater(self.farthest, distance);
                self.distances.push(distance);
            }
        }
        true
    }

    /// Pixels from one distance to the next.
    fn step(&self) -> usize {
        STEP * self.fine
    }

    /// The distance to the boundary, below 0 outside; 0 or more everywhere on a tile.
    fn distance(&self, [x, y]: [usize; 2]) -> f32 {
        let step = self.step();
        let across = self.side / step + 2;
        let at = y / step * across + x / step;
        let part = |v: usize| (v % step) as f32 / step as f32;
        let between = |at: usize| {
            let (a, b) = (self.distances[at], self.distances[at + 1]);
            a + (b - a) * part(x)
        };
        if self.distances.is_empty() {
            return EVERYWHERE * self.farthest;
        }
        let (upper, lower) = (between(at), between(at + across));
        upper + (lower - upper) * part(y)
    }

    fn pixel(&self, planes: &mut Planes, bed: &Bed, [x, y]: [usize; 2], [near, wide]: [f32; 2]) {
        let WeatherParams {
            wear,
            moss,
            dirt,
            wet,
        } = self.params;
        let (wear, moss, dirt, wet) = (wear as f32, moss as f32, dirt as f32, wet as f32);
        let i = y * self.side + x;
        let (px, py, fine) = (x as i32, y as i32, self.fine as i32);
        let (broad, grains) = (
            bed.broad(px + 211 * fine, py + 97 * fine),
            bed.grains(px, py),
        );
        let distance = self.distance([x, y]);
        let trodden = soft(distance / self.farthest * 1.15);
        let mut height = planes.bump[i];
        let mut colour = planes.colour[i].map(f32::from);
        let mut optics = planes.optics[i];
        let stone = planes.id[i] != GROUND;
        // 1/2 on level ground, towards 1 in joints and towards 0 on tops.
        let hollow = (0.5 + (wide - height) / self.depth).clamp(0.0, 1.0);
        if wear > 0.0 && stone {
            let worn = lesser(wear * trodden * (1.0 + 0.35 * broad), 1.0);
            let stand = (height - self.level) / self.depth;
            let rub = RUB * self.depth;
            let flat = order::within(near, height - rub, height + rub);
            height += (flat - height) * worn * soft(3.0 * stand - 1.0);
            // Tops are cut off, with a soft edge.
            let stand = (height - self.level) / self.depth;
            let ceiling = 1.0 + EDGE - (LOSS + EDGE) * worn;
            let over = greater(EDGE - (stand - ceiling).abs(), 0.0);
            let cut = lesser(stand, ceiling) - over * over / (4.0 * EDGE);
            height += (cut - stand) * self.depth * lesser(4.0 * worn, 1.0);
            if worn > 0.3 {
                optics = (optics + 1 + u8::from(worn > 0.6)).min(FINISHES as u8);
            }
            // Dust and weathered crust are off.
            colour = colour.map(|v| v * (1.0 + 0.05 * worn));
        }
        let mut soaks = !stone;
        if dirt > 0.0 {
            let lies = hollow + 0.10 * broad + 0.04 * grains - 0.96 + dirt;
            let cover = (0.35 + 0.6 * dirt) * soft(1.9 * lies);
            let grain = 1.0 + 0.06 * grains + 0.05 * broad;
            mix(&mut colour, bed.dirt().map(|v| v * grain), cover);
            height += SILT * self.depth * cover * soft(2.0 * hollow - 0.6);
            if cover > 0.45 {
                optics = DIRT;
                soaks = true;
            }
        }
        if moss > 0.0 {
            let shade = 0.72 * hollow + 0.15 * broad + 0.06 * grains - 0.14 * trodden;
            let cover = soft((shade - 0.86 + 0.98 * moss) * 7.0);
            let light = (0.5 - 0.55 * (hollow - 0.5) + 0.2 * grains + 0.25 * bed.broad(py, px))
                .clamp(0.0, 1.0);
            let mut green = GREENS[0];
            mix(&mut green, GREENS[1], light);
            let grain = 1.0 + 0.16 * grains;
            mix(&mut colour, green.map(|v| v * grain), cover);
            height += self.depth * PAD * cover * (0.75 + 0.22 * grains);
            if cover > 0.5 {
                optics = MOSS;
                soaks = true;
            }
        }
        if wet > 0.0 {
            let lies = 1.5 * wet - 0.2 + 0.5 * (hollow - 0.5) + 0.2 * broad;
            let soaked = soft(lies) * soft(4.0 * wet);
            let grey = (colour[0] + colour[1] + colour[2]) / 3.0;
            let dark = 1.0 - soaked * if soaks { 0.46 } else { 0.36 };
            colour = colour.map(|v| (grey + (v - grey) * (1.0 + 0.3 * soaked)) * dark);
            optics += ROWS * (u8::from(soaked > 0.33) + u8::from(soaked > 0.7));
            // Around the pavement water runs off.
            let away = soft(0.5 - 2.0 * distance / self.size);
            let surface = self.level + self.depth * (0.85 * wet - 0.5 - 0.6 * away);
            let deep = surface - height;
            if deep > 0.0 {
                let clear = lesser(deep, 1.0);
                let murk = 0.35 * deep / (deep + 2.0);
                colour = colour.map(|v| v * (1.0 - murk));
                mix(&mut colour, SKY, MIRROR * clear);
                height = surface;
                if clear > 0.5 {
                    optics = WATER;
                }
            }
        }
        planes.bump[i] = height;
        planes.colour[i] = colour.map(|v| (v.clamp(0.0, 255.0) + 0.5) as u8);
        planes.optics[i] = optics;
    }
}

fn soft(t: f32) -> f32 {
    smooth(f64::from(t)) as f32
}

fn mix(colour: &mut [f32; 3], other: [f32; 3], share: f32) {
    for (own, other) in colour.iter_mut().zip(other) {
        *own += (other - *own) * share;
    }
}

/// The mean height of the square around each pixel: sums of rows first, then running sums of these.
struct Mean {
    radius: usize,
    /// Sums along rows.
    along: Vec<f32>,
    filled: usize,
    /// Sums of `along` over the rows around the one at hand.
    sums: Vec<f64>,
}

impl Mean {
    fn new(radius: usize, side: usize) -> Self {
        Self {
            radius: radius.clamp(1, side / 2),
            along: Vec::new(),
            filled: 0,
            sums: Vec::new(),
        }
    }

    /// Some more sums along rows; false when all are there.
    fn fill(&mut self, planes: &Planes, rows: usize) -> bool {
        let (side, tile) = (planes.side, planes.tile);
        let end = side.min(self.filled.saturating_add(rows));
        for y in self.filled..end {
            let row = &planes.bump[y * side..][..side];
            let of = |x: i64| f64::from(row[place(x, side, tile)]);
            let reach = self.radius as i64;
            let mut sum: f64 = (-reach..=reach).map(of).sum();
            for x in 0..side as i64 {
                self.along.push(sum as f32);
                sum += of(x + reach + 1) - of(x - reach);
            }
        }
        let more = self.filled < end;
        self.filled = end;
        more
    }

    /// The means of a row; rows must be asked for in turn.
    fn row(&mut self, y: usize, tile: bool, out: &mut [f32]) {
        let side = out.len();
        let (y, reach) = (y as i64, self.radius as i64);
        let along = &self.along;
        let of = |y: i64| &along[place(y, side, tile) * side..][..side];
        if y == 0 {
            self.sums = vec![0.0; side];
            for row in (-reach..=reach).map(of) {
                add(&mut self.sums, row, 1.0);
            }
        } else {
            add(&mut self.sums, of(y + reach), 1.0);
            add(&mut self.sums, of(y - reach - 1), -1.0);
        }
        let width = (2 * self.radius + 1) as f64;
        for (out, sum) in out.iter_mut().zip(&self.sums) {
            *out = (sum / (width * width)) as f32;
        }
    }
}

fn add(sums: &mut [f64], row: &[f32], factor: f64) {
    for (sum, &v) in sums.iter_mut().zip(row) {
        *sum += factor * f64::from(v);
    }
}

/// The pixel at a place beyond an edge: the last one there, or on a tile that at the other edge.
fn place(at: i64, side: usize, tile: bool) -> usize {
    let side = side as i64;
    let at = if tile {
        at.rem_euclid(side)
    } else {
        at.clamp(0, side - 1)
    };
    at as usize
}
