//! Coats of cells on a surface: the rules of [`crate::material::Coats`] in space.
//!
//! Noise and bands are functions of the place in space, so they have no seams. Spots are scattered over the surface
//! itself, and reaction and diffusion run from cell to cell. Directions are those of a picture of the model from the
//! front: x to the right and y down.

use crate::material::{
    CLOUDS, CLOUDS_AT, Coat, ColourParams, Marking, Pattern, Reaction, WAVELENGTH, belly_at, near,
    turned,
};
use crate::order::{self, greater, lesser};
use crate::planar::signed_angle;
use crate::random::{Purpose, Random};
use crate::surface_cells::SurfaceCell;
use crate::trimesh::{TangentFrame, polygon};
use glam::DVec3;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

/// The least distance between spots, in units of the scale; it gives about one spot for each square of the scale.
const APART: f64 = 0.83;
/// The relative variation of the sizes of spots.
const UNLIKE: f64 = 0.25;
/// The noise of bands around a body, relative to that of straight bands: less, so that they stay rings.
const STEADY: f64 = 0.4;
/// The weight of a cell's normal in its share of the belly; the rest is the weight of its place.
const FACES: f64 = 0.6;

/// The coats of all cells, while they are made.
pub struct SurfaceCoats {
    marking: Marking,
    seed: u64,
    /// The scale of patterns, in the model's units.
    scale: f64,
    middle: DVec3,
    /// Half of the longest side of the bounding box of all cells.
    half: f64,
    /// Spots: the centre and normal of the middle cell, and the factor on the size.
    spots: Vec<(DVec3, DVec3, f64)>,
    /// For each cell its distance to the border, in the model's units.
    inside: Vec<f64>,
    /// For each cell the length along the body up to it, in the model's units; empty if bands run across an angle.
    along: Vec<f64>,
}

impl SurfaceCoats {
    /// Starts coats that [`SurfaceCoats::advance`] makes. `unit` is the number of picture units in a unit of the
    /// model. `links` are the neighbours by index, see [`super::links`].
    pub fn new(
        colour: ColourParams,
        seed: u64,
        unit: f64,
        cells: &[SurfaceCell],
        links: &[Vec<u32>],
    ) -> Self {
        let (mut low, mut high) = (DVec3::MAX, DVec3::MIN);
        for cell in cells {
            (low, high) = (low.min(cell.centre.at), high.max(cell.centre.at));
        }
        let mut coats = Self {
            marking: Marking::new(colour, seed),
            seed,
            scale: colour.scale / unit,
            middle: (low + high) * 0.5,
            half: greater((high - low).max_element() * 0.5, f64::MIN_POSITIVE),
            spots: Vec::new(),
            inside: Vec::new(),
            along: Vec::new(),
        };
        match colour.pattern {
            Pattern::Spots | Pattern::Rosettes => coats.scatter(cells),
            Pattern::Boundary => coats.inside = inside(cells, links),
            Pattern::Turing => {
                let ids = cells.iter().map(|cell| cell.id).collect();
                let place = |k: u32| cells[k as usize].centre.at;
                let square = |from: u32, to: u32| (place(to) - place(from)).length_squared();
                let scale = (coats.scale, 1.0 / unit);
                let links = links.to_vec();
                let reaction = Reaction::new(ids, links, square, scale, colour.share, seed);
                coats.marking.take(reaction);
            }
            _ => {}
        }
        coats
    }

    /// Makes bands run around a body. `along` has for each cell the length along the body, in the model's units.
    pub fn around(mut self, along: Vec<f64>) -> Self {
        self.along = along;
        self
    }

    /// Does the work for about `count` cells; true when all coats are ready. The cells must be the same each time.
    pub fn advance(&mut self, cells: &[SurfaceCell], count: usize) -> bool {
        if let Some(done) = self.marking.advance(count) {
            return done;
        }
        let due = self.marking.due(cells.len(), count);
        for k in due.clone() {
            let value = self.value(k, &cells[k]);
            self.marking.push(value);
        }
        due.end == cells.len()
    }

    /// The coats, one for each cell.
    pub fn finish(self, cells: &[SurfaceCell]) -> Vec<Coat> {
        let place = |cell: &SurfaceCell| [self.belly(cell), self.tone(cell)];
        let places: Vec<[f64; 2]> = cells.iter().map(place).collect();
        self.marking.finish(places.into_iter())
    }

    fn value(&self, k: usize, cell: &SurfaceCell) -> f64 {
        let p = (cell.centre.at - self.middle) / self.scale;
        let ColourParams { pattern, angle, .. } = self.marking.colour;
        match pattern {
            Pattern::Bands => match self.along.get(k) {
                Some(along) => self
                    .marking
                    .band(along / self.scale, STEADY * self.noise(p)),
                None => self.marking.band(p.dot(front(angle)), self.noise(p)),
            },
            Pattern::Spots | Pattern::Rosettes => self.spot(cell),
            Pattern::Blotches => self.noise(p) + 0.5 * self.noise(p * 2.3),
            Pattern::Size => area(&cell.ring),
            Pattern::Boundary => near(self.inside[k], self.scale),
            Pattern::Direction => {
                let frame = TangentFrame::of(cell.centre.normal);
                let wanted = frame.within(front(angle));
                let turn = signed_angle(wanted, cell.axis);
                turned(turn, cell.kind)
            }
            Pattern::Plain | Pattern::Turing | Pattern::Lines => 0.0,
        }
    }

    /// Noise with a standard deviation of about 1: the sum of noise in three planes at right angles.
    fn noise(&self, p: DVec3) -> f64 {
        let at = p * WAVELENGTH;
        let plane = |x: f64, y: f64| self.marking.noise(x, y);
        let sum = plane(at.x, at.y) + plane(at.y + 19.0, at.z + 7.0) + plane(at.z + 41.0, at.x);
        sum / 3f64.sqrt()
    }

    /// Chooses the cells in the middle of spots: in random order, each cell that is far enough from all cells chosen
    /// before.
    fn scatter(&mut self, cells: &[SurfaceCell]) {
        let mut due: Vec<(u64, u32)> = (0..cells.len() as u32)
            .map(|k| {
                let id = u64::from(cells[k as usize].id);
                let mut random = Random::new(self.seed, Purpose::Pattern, id);
                (random.bits(), k)
            })
            .collect();
        due.sort_unstable();
        let apart = APART * self.scale;
        for (_, k) in due {
            let cell = &cells[k as usize];
            let (p, n) = (cell.centre.at, cell.centre.normal);
            let is_near = |spot: &(DVec3, DVec3, f64)| {
                (spot.0 - p).length_squared() < apart * apart && spot.1.dot(n) > 0.0
            };
            if !self.spots.iter().any(is_near) {
                let id = u64::from(cell.id);
                let mut random = Random::new(self.seed, Purpose::Pattern, !id);
                self.spots.push((p, n, 1.0 + UNLIKE * random.signed()));
            }
        }
    }

    /// 1 in the middle of a spot, falling to 0 at the edge of the spot's share of the surface.
    fn spot(&self, cell: &SurfaceCell) -> f64 {
        let mut nearest = f64::MAX;
        for &(p, n, size) in &self.spots {
            // A spot does not reach through a thin sheet.
            if n.dot(cell.centre.normal) > -0.2 {
                let to = (p - cell.centre.at) / (self.scale * size);
                nearest = lesser(nearest, to.length_squared());
            }
        }
        greater(1.0 - PI * nearest, 0.0)
    }

    /// The tone of a cell's place; 0 unless tones are soft.
    fn tone(&self, cell: &SurfaceCell) -> f64 {
        let p = (cell.centre.at - self.middle) / (2.0 * CLOUDS * self.half);
        match self.marking.colour.soft > 0.0 {
            true => self.noise(p + DVec3::splat(CLOUDS_AT)),
            false => 0.0,
        }
    }

    fn belly(&self, cell: &SurfaceCell) -> f64 {
        let ColourParams {
            belly, belly_angle, ..
        } = self.marking.colour;
        if belly <= 0.0 {
            return 0.0;
        }
        let towards = front(belly_angle);
        let faces = cell.centre.normal.dot(towards);
        let lies = (cell.centre.at - self.middle).dot(towards) / self.half;
        belly * belly_at(0.5 + 0.5 * (FACES * faces + (1.0 - FACES) * lies))
    }
}

/// A direction in a picture of the model from the front, as a vector of the model.
fn front(angle: f64) -> DVec3 {
    DVec3::new(libm::cos(angle), -libm::sin(angle), 0.0)
}

/// The area of a ring in space.
fn area(ring: &[DVec3]) -> f64 {
    0.5 * polygon::across(ring).length()
}

/// The distance of each cell from the border along the graph of cells; huge if there is no border.
fn inside(cells: &[SurfaceCell], links: &[Vec<u32>]) -> Vec<f64> {
    let mut far = vec![f64::MAX; cells.len()];
    let mut due = BinaryHeap::new();
    for (k, cell) in cells.iter().enumerate().filter(|(_, c)| c.on_border) {
        far[k] = 0.5 * cell.size;
        due.push(std::cmp::Reverse((order::rank(far[k]), k as u32)));
    }
    while let Some(std::cmp::Reverse((rank, k))) = due.pop() {
        let k = k as usize;
        if rank != order::rank(far[k]) {
            continue;
        }
        for &to in &links[k] {
            let step = (cells[to as usize].centre.at - cells[k].centre.at).length();
            if far[k] + step < far[to as usize] {
                far[to as usize] = far[k] + step;
                due.push(std::cmp::Reverse((order::rank(far[k] + step), to)));
            }
        }
    }
    far
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{rows, torus};
    use super::super::{links, mean_size};
    use super::*;

    #[test]
    fn coats_follow_the_surface() {
        let rows = rows([60, 20], [true, true]);
        let shape = torus(0.4);
        let cells = rows.cells(&shape);
        let links = links(&cells);
        let unit = 24.0 / mean_size(&cells);
        for (pattern, word) in Pattern::ALL {
            let colour = ColourParams {
                pattern,
                scale: 240.0,
                sharpness: 0.6,
                share: 0.4,
                amount: 1.0,
                belly: 1.0,
                belly_angle: std::f64::consts::FRAC_PI_2,
                ..ColourParams::default()
            };
            let made = |slice: usize| {
                let mut coats = SurfaceCoats::new(colour, 1, unit, &cells, &links);
                while !coats.advance(&cells, slice) {}
                coats.finish(&cells)
            };
            let coats: Vec<Coat> = made(usize::MAX);
            assert_eq!(coats, made(37), "{word}");
            let mean = coats.iter().map(|c| f64::from(c.mark)).sum::<f64>() / coats.len() as f64;
            match pattern {
                Pattern::Plain | Pattern::Lines | Pattern::Boundary => {
                    assert_eq!(mean, 0.0, "{word}")
                }
                // All cells of a row have one size and direction.
                Pattern::Direction => {}
                _ => assert!((0.2..0.6).contains(&mean), "{word}: {mean}"),
            }
            for (coat, cell) in coats.iter().zip(&cells) {
                let is_below = cell.centre.normal.y < -0.7;
                assert!(!is_below || coat.belly > 0.6, "{word}: {}", coat.belly);
                assert!(cell.centre.normal.y < 0.7 || coat.belly < 0.1);
            }
            if pattern == Pattern::Turing {
                // Neighbours are alike, because the pattern is far wider than a cell.
                let unlike = links.iter().enumerate().map(|(k, list)| {
                    let off = |j: &u32| f64::from((coats[k].mark - coats[*j as usize].mark).abs());
                    list.iter().map(off).sum::<f64>() / list.len() as f64
                });
                let unlike = unlike.sum::<f64>() / cells.len() as f64;
                assert!(unlike < 0.3, "{unlike}");
            }
        }
    }

    /// Bands around a body are rings: cells at the same length along it have nearly the same value, wherever they are
    /// around it.
    #[test]
    fn bands_around_a_body_are_rings() {
        let rows = rows([60, 20], [true, true]);
        let shape = torus(0.4);
        let cells = rows.cells(&shape);
        let links = links(&cells);
        let colour = ColourParams {
            pattern: Pattern::Bands,
            scale: 480.0,
            sharpness: 0.0,
            ..ColourParams::default()
        };
        let unit = 24.0 / mean_size(&cells);
        let angle = |cell: &SurfaceCell| libm::atan2(cell.centre.at.z, cell.centre.at.x);
        let lengths: Vec<f64> = cells.iter().map(angle).collect();
        let spread = |around: bool| {
            let mut coats = SurfaceCoats::new(colour, 1, unit, &cells, &links);
            if around {
                coats = coats.around(lengths.clone());
            }
            while !coats.advance(&cells, 100) {}
            let coats = coats.finish(&cells);
            let mut most = 0.0f32;
            for (a, here) in lengths.iter().zip(&coats) {
                for (b, there) in lengths.iter().zip(&coats) {
                    if (a - b).abs() < 1e-6 {
                        most = most.max((here.mark - there.mark).abs());
                    }
                }
            }
            most
        };
        assert!(
            spread(true) < 0.5 * spread(false),
            "{} {}",
            spread(true),
            spread(false)
        );
    }

    /// Soft tones change little from a cell to its neighbours, and much over the body.
    #[test]
    fn soft_tones_follow_the_place() {
        let rows = rows([60, 20], [true, true]);
        let cells = rows.cells(&torus(0.4));
        let links = links(&cells);
        let colour = ColourParams {
            soft: 1.0,
            ..ColourParams::default()
        };
        let coats = SurfaceCoats::new(colour, 1, 24.0 / mean_size(&cells), &cells, &links);
        let tones: Vec<f32> = coats.finish(&cells).iter().map(|coat| coat.tone).collect();
        let (low, high) = tones
            .iter()
            .fold((9.0f32, -9.0f32), |(a, b), &v| (a.min(v), b.max(v)));
        assert!(high - low > 1.0, "{low} {high}");
        for (k, near) in links.iter().enumerate() {
            for &j in near {
                assert!((tones[k] - tones[j as usize]).abs() < 0.3 * (high - low));
            }
        }
    }
}
