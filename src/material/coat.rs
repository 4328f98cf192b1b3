//! Coats: cell patterns that add the mark's and the belly's colours to a palette's base colour.
//!
//! Itoh, Miyata, Shimada (2003) leave colours that follow the cells to future work (section 8). A pattern
//! gives each cell a value, spread evenly over 0..1. The cells with the highest values, up to the requested
//! share, are marked, with a soft border.
//!
//! Because values are spread evenly, share and sharpness mean the same for all patterns. Coats use their own
//! random stream: a stone without its coat looks as before.

use super::marking::{CLOUDS, CLOUDS_AT, Marking, WAVE, WAVELENGTH, belly_at, near, turned};
use super::pattern::{Coat, ColourParams, Pattern};
use super::reaction::Reaction;
use crate::cells::{Cell, Graph};
use crate::domain::{Domain, signed_area};
use crate::order::{self, greater, lesser};
use crate::planar::unit_vector;
use crate::random::{Purpose, Random};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Displacement of spots from their grid points, in grid spacings.
const SCATTER: f64 = 0.32;
/// The number of waves of the noise along the side of its tile.
const WAVES: f64 = 4.0;

/// The coats of all cells, in progress.
pub struct Coats {
    marking: Marking,
    seed: u64,
    side: f64,
    graph: Option<Graph>,
}

impl Coats {
    /// Starts the coats; [`Coats::advance`] continues.
    ///
    /// `side` is the picture's side, in picture units.
    pub fn new(colour: ColourParams, seed: u64, side: f64) -> Self {
        Self {
            marking: Marking::new(colour, seed),
            seed,
            side,
            graph: None,
        }
    }

    /// Does the work of about `count` cells; true when finished. Domain and cells must not change.
    pub fn advance(&mut self, domain: &Domain, cells: &[Cell], count: usize) -> bool {
        if let Some(done) = self.marking.advance(count) {
            return done;
        }
        if self.marking.colour.pattern == Pattern::Turing {
            self.prepare(domain, cells, count);
            return false;
        }
        let due = self.marking.due(cells.len(), count);
        for cell in &cells[due.clone()] {
            let value = self.value(domain, cell);
            self.marking.push(value);
        }
        due.end == cells.len()
    }

    /// One coat for each cell.
    pub fn finish(self, domain: &Domain, cells: &[Cell]) -> Vec<Coat> {
        let place = |cell: &Cell| {
            [
                self.belly(domain, cell.centre),
                self.tone(domain, cell.centre),
            ]
        };
        let places: Vec<[f64; 2]> = cells.iter().map(place).collect();
        self.marking.finish(places.into_iter())
    }

    /// Finds the neighbours of cells, then the first state of their reaction.
    fn prepare(&mut self, domain: &Domain, cells: &[Cell], count: usize) {
        let graph = self.graph.get_or_insert_with(|| Graph::new(domain, cells));
        if graph.advance(domain, count) {
            let links = self.graph.take().map_or(Vec::new(), Graph::finish);
            let ColourParams { scale, share, .. } = self.marking.colour;
            let ids = cells.iter().map(|cell| cell.id).collect();
            let square = |from: u32, to: u32| {
                let [from, to] = [from, to].map(|k| cells[k as usize].centre);
                domain.space().shortest(to - from).length_squared()
            };
            let reaction = Reaction::new(ids, links, square, (scale, 1.0), share, self.seed);
            self.marking.take(reaction);
        }
    }

    /// The value of a cell under a pattern that depends on this cell alone.
    fn value(&self, domain: &Domain, cell: &Cell) -> f64 {
        let ColourParams { scale, angle, .. } = self.marking.colour;
        let period = domain.space().period();
        let p = cell.centre;
        match self.marking.colour.pattern {
            Pattern::Bands => {
                let along = self.turns(p, angle, scale, period);
                self.marking.band(along, self.noise(p, period, 1.0))
            }
            Pattern::Spots | Pattern::Rosettes => self.spot(p, period),
            Pattern::Blotches => self.noise(p, period, 1.0) + 0.5 * self.noise(p, period, 2.3),
            Pattern::Size => signed_area(&cell.ring),
            Pattern::Boundary => near(domain.nearest(p).distance.abs(), scale),
            Pattern::Lines => domain
                .nearest_line(p)
                .map_or(0.0, |line| near(line.distance, scale)),
            Pattern::Direction => turned(libm::atan2(cell.axis.y, cell.axis.x) - angle, cell.kind),
            Pattern::Plain | Pattern::Turing => 0.0,
        }
    }

    /// The phase, in full turns, of a wave along an angle; on a torus, of the nearest wave that repeats.
    fn turns(&self, p: DVec2, angle: f64, length: f64, period: Option<f64>) -> f64 {
        let along = unit_vector(angle);
        let Some(side) = period else {
            return p.dot(along) / length;
        };
        let mut waves = (along * (side / length)).round();
        if waves == DVec2::ZERO {
            waves = along.signum() * DVec2::from(along.abs().cmpge(DVec2::splat(0.5)));
        }
        (p / side).dot(waves)
    }

    /// Noise with wavelengths of `1 / frequency` pattern scales.
    fn noise(&self, p: DVec2, period: Option<f64>, frequency: f64) -> f64 {
        let mut tiles = frequency * self.side / (self.marking.colour.scale * WAVES);
        if period.is_some() {
            tiles = greater(tiles.round(), 1.0);
        }
        let at = p * (tiles * WAVELENGTH * WAVES / self.side);
        self.marking.noise(at.x, at.y)
    }

    /// 1 at the centre of a spot, falling to 0 where a circle around the centre has the area of a grid square.
    fn spot(&self, p: DVec2, period: Option<f64>) -> f64 {
        let scale = self.marking.colour.scale;
        let count = period.map(|side| greater((side / scale).round(), 1.0));
        let spacing = period.map_or(scale, |side| side / count.unwrap_or(1.0));
        let bent = self.noise(p, period, 1.0) * WAVE * 0.5;
        let at = p / spacing + DVec2::new(bent, -bent);
        let own = at.floor();
        let mut nearest = f64::MAX;
        for k in 0..9 {
            let place = own + DVec2::new(f64::from(k % 3 - 1), f64::from(k / 3 - 1));
            let name = count.map_or(place, |n| place - (place / n).floor() * n);
            let item = order::pair(name.x as i32 as u32, name.y as i32 as u32);
            let mut random = Random::new(self.seed, Purpose::Pattern, item);
            let off = DVec2::new(random.signed(), random.signed()) * SCATTER;
            let size = 1.0 + 0.25 * random.signed();
            let to = (place + 0.5 + off - at) / size;
            nearest = lesser(nearest, to.length_squared());
        }
        greater(1.0 - PI * nearest, 0.0)
    }

    /// The tone of a place, if tones are soft.
    fn tone(&self, domain: &Domain, p: DVec2) -> f64 {
        let ColourParams { soft, scale, .. } = self.marking.colour;
        match soft > 0.0 {
            true => {
                let p = p + DVec2::splat(CLOUDS_AT);
                self.noise(p, domain.space().period(), scale / (CLOUDS * self.side))
            }
            false => 0.0,
        }
    }

    fn belly(&self, domain: &Domain, p: DVec2) -> f64 {
        let ColourParams {
            belly, belly_angle, ..
        } = self.marking.colour;
        if belly <= 0.0 {
            return 0.0;
        }
        let side = self.side;
        let turns = self.turns(
            p - DVec2::splat(0.5 * side),
            belly_angle,
            side,
            domain.space().period(),
        );
        let down = match domain.space().period() {
            Some(_) => 0.5 + 0.5 * libm::sin(TAU * turns),
            None => 0.5 + turns,
        };
        belly * belly_at(down)
    }
}
