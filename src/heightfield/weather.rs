//! The weather over the planes: wear, dirt, moss, wet.
//!
//! One pass over the finished stones, then one for the ambient occlusion. The mean height around each pixel
//! tells tops from hollows.
//!
//! Height, colour and material change together, so that light and maps follow. The rows of the table of
//! materials are the same for all palettes: every finish, dirt and moss dry, damp and wet, then water.

use super::Planes;
use super::box_filter::BoxFilter;
use super::ground::Bed;
use super::occlusion::Occlusion;
use crate::domain::Domain;
use crate::field::smoothstep_f32;
use crate::material::{Effects, GROUND_ROW, LEVEL, Place, Sample, WeatherParams};
use crate::order::greater;
use glam::DVec2;
use std::rc::Rc;

/// Distances to the boundary are computed every this many picture units, and interpolated between.
const STEP: usize = 8;
/// Radii of the two box filters, in cell sizes: of the smooth surface that wear leaves, and of the
/// surroundings that define a hollow.
const REACH: [f64; 2] = [0.1, 0.5];
/// A tile has no boundary: all its places count as this far from one, as a share of the greatest distance.
const EVERYWHERE: f32 = 0.75;
/// Treading is full from 1 / `TRODDEN` of the greatest distance to the boundary on.
const TRODDEN: f32 = 1.15;
/// Offset of the broad noise from that of the ground, in picture units.
const BROAD_OFF: [i32; 2] = [211, 97];

/// Planes with all stones, before the weather and the ambient occlusion.
#[derive(Clone)]
pub struct Painted {
    /// The planes.
    pub planes: Planes,
    pub(super) bed: Rc<Bed>,
    /// The mean size of cells, in picture units.
    pub(super) size: f64,
    /// The joints' depth, in picture units.
    pub(super) depth: f32,
}

/// Applies the weather to all stones, then computes the ambient occlusion.
pub struct Weathering {
    planes: Planes,
    bed: Rc<Bed>,
    weather: Weather,
    occlusion: Occlusion,
}

impl Weathering {
    /// Starts with the planes as painted.
    pub fn new(params: WeatherParams, painted: Painted) -> Self {
        let Painted {
            mut planes,
            bed,
            size,
            depth,
        } = painted;
        // Planes painted in bands have no occlusion yet. Made only now, it reuses memory that painting has freed.
        planes.occlusion.resize(planes.bump.len(), 255);
        let effects = Effects::new(params, [planes.ground, depth], bed.dirt());
        Self {
            weather: Weather::new(effects, [planes.side, planes.pixel_scale], size, depth),
            occlusion: Occlusion::new(size, planes.pixel_scale, planes.tile),
            planes,
            bed,
        }
    }

    /// Does about `rows` rows; true when finished. The domain must not change.
    pub fn advance(&mut self, domain: &Domain, rows: usize) -> bool {
        let planes = &mut self.planes;
        let weathered = self.weather.advance(planes, &self.bed, domain, rows);
        weathered && self.occlusion.advance(planes, rows)
    }

    /// The present planes.
    pub fn planes(&self) -> &Planes {
        &self.planes
    }

    /// The finished planes.
    pub fn finish(self) -> Planes {
        self.planes
    }
}

/// The weather in progress.
struct Weather {
    effects: Effects,
    /// Pixels along the picture's side, and in each picture unit.
    side: usize,
    pixel_scale: usize,
    /// Depth of the joints, in picture units.
    depth: f32,
    size: f32,
    means: [BoxFilter; 2],
    /// Distances to the boundary at every [`STEP`]-th pixel; empty on a tile.
    distances: Vec<f32>,
    farthest: f32,
    row: usize,
}

impl Weather {
    /// For stones of about `size` with joints of this `depth`, in a picture of `side` pixels with
    /// `pixel_scale` for each unit.
    fn new(effects: Effects, [side, pixel_scale]: [usize; 2], size: f64, depth: f32) -> Self {
        let radius = |reach: f64| (reach * size) as usize * pixel_scale + pixel_scale / 2;
        Self {
            effects,
            side,
            pixel_scale,
            depth,
            size: size as f32,
            means: REACH.map(|reach| BoxFilter::new(radius(reach), side)),
            distances: Vec::new(),
            farthest: 1.0,
            row: 0,
        }
    }

    /// Does about `rows` rows; true when finished.
    fn advance(&mut self, planes: &mut Planes, bed: &Bed, domain: &Domain, rows: usize) -> bool {
        if self.effects.is_none() {
            return true;
        }
        let side = self.side;
        if self.measure(domain, rows) || self.prepare(planes, rows) {
            return false;
        }
        let end = side.min(self.row.saturating_add(rows));
        let mut means = [vec![0.0; side], vec![0.0; side]];
        for y in self.row..end {
            for (mean, row) in self.means.iter_mut().zip(&mut means) {
                mean.row(y, planes, row);
            }
            let [near, wide] = &means;
            for (x, (&near, &wide)) in near.iter().zip(wide).enumerate() {
                self.pixel(planes, bed, [x, y], [near, wide]);
            }
        }
        self.row = end;
        end == side
    }

    /// Sums some of the rows that precede the first means; false when all are done.
    fn prepare(&mut self, planes: &Planes, rows: usize) -> bool {
        self.means.iter_mut().any(|mean| mean.prepare(planes, rows))
    }

    /// Computes some rows of distances; false when all are done.
    fn measure(&mut self, domain: &Domain, rows: usize) -> bool {
        let across = self.side / self.step() + 2;
        let made = self.distances.len() / across;
        if domain.space().period().is_some() || made == across {
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

    /// Pixels between neighbouring entries of `distances`.
    fn step(&self) -> usize {
        STEP * self.pixel_scale
    }

    /// The distance to the boundary, negative outside; 0 or more everywhere on a tile.
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
        let i = y * self.side + x;
        let (px, py, pixel_scale) = (x as i32, y as i32, self.pixel_scale as i32);
        let [right, down] = BROAD_OFF.map(|off| off * pixel_scale);
        let distance = self.distance([x, y]);
        let height = planes.bump[i];
        let place = Place {
            is_stone: planes.material[i] != GROUND_ROW,
            hollow: (LEVEL + (wide - height) / self.depth).clamp(0.0, 1.0),
            near,
            trodden: smoothstep_f32(distance / self.farthest * TRODDEN),
            inside: distance / self.size,
            broad: bed.broad(px + right, py + down),
            grains: bed.grains(px, py),
            patches: bed.broad(py, px),
        };
        let mut sample = Sample {
            height,
            colour: planes.colour[i].map(f32::from),
            material: planes.material[i],
            soaks: !place.is_stone,
        };
        self.effects.apply(&place, &mut sample);
        planes.bump[i] = sample.height;
        planes.colour[i] = sample.colour.map(|v| (v.clamp(0.0, 255.0) + 0.5) as u8);
        planes.material[i] = sample.material;
    }
}
