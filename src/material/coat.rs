//! Coats: cell patterns that add the mark's and the belly's colours to a palette's base colour.
//!
//! Itoh, Miyata, Shimada (2003) leave colours that follow the cells to future work (section 8). A pattern
//! gives each cell a value, spread evenly over 0..1. The cells with the highest values, up to the requested
//! share, are marked, with a soft border.
//!
//! Because values are spread evenly, share and sharpness mean the same for all patterns. Coats use their own
//! random stream: a stone without its coat looks as before.

use super::noise::NoiseTile;
use super::reaction::Reaction;
use super::smoothstep::smoothstep;
use crate::cells::{Cell, Graph};
use crate::domain::{Domain, signed_area};
use crate::order::{self, greater, lesser};
use crate::random::{Purpose, Random};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// The rule by which cells are marked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pattern {
    /// No cell is marked.
    #[default]
    Plain,
    /// Wavy bands.
    Bands,
    /// Round spots, scattered evenly.
    Spots,
    /// Round spots with a paler middle.
    Rosettes,
    /// Clouds of noise.
    Blotches,
    /// A reaction and diffusion from cell to cell: spots, a labyrinth or a net.
    Turing,
    /// Large cells.
    Size,
    /// Cells near the boundary.
    Boundary,
    /// Cells near constraint lines.
    Lines,
    /// Cells that point in a direction.
    Direction,
}

impl Pattern {
    /// All patterns with their words.
    pub const ALL: [(Pattern, &'static str); 10] = [
        (Pattern::Plain, "none"),
        (Pattern::Bands, "bands"),
        (Pattern::Spots, "spots"),
        (Pattern::Rosettes, "rosettes"),
        (Pattern::Blotches, "blotches"),
        (Pattern::Turing, "turing"),
        (Pattern::Size, "size"),
        (Pattern::Boundary, "boundary"),
        (Pattern::Lines, "lines"),
        (Pattern::Direction, "direction"),
    ];

    /// The pattern with this word, or [`Pattern::Plain`].
    pub fn of_word(word: &str) -> Pattern {
        let found = Self::ALL.iter().find(|(_, w)| *w == word);
        found.map_or(Pattern::Plain, |&(pattern, _)| pattern)
    }
}

/// Parameters of the cells' colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourParams {
    /// The rule by which cells are marked.
    pub pattern: Pattern,
    /// Distance between marks, or the reach of marks from the boundary or a line, in picture units.
    pub scale: f64,
    /// Direction across bands, or the direction of marked cells: radians from +x, clockwise on screen.
    pub angle: f64,
    /// Sharpness of the border between marked cells and others, 0..1.
    pub sharpness: f64,
    /// Share of marked cells, 0..1.
    pub share: f64,
    /// Share of the mark's colour in marked cells, 0..1.
    pub amount: f64,
    /// Darkens the rim of each cell if positive, its centre if negative, -1..1.
    pub rim: f64,
    /// Share of the belly's colour on the belly's side, 0..1.
    pub belly: f64,
    /// Direction towards the belly, radians from +x, clockwise on screen.
    pub belly_angle: f64,
}

/// The coat of one cell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coat {
    /// Share of the mark's colour, 0..1.
    pub mark: f32,
    /// Share of the belly's colour, 0..1.
    pub belly: f32,
}

/// Amplitude of the bends of bands and spots, in pattern scales.
const WAVE: f64 = 0.2;
/// Displacement of spots from their grid points, in grid spacings.
const SCATTER: f64 = 0.32;
/// The sharpest border of marks is this share of the cells wide; the softest covers all.
const SHARPEST: f64 = 0.03;
/// Values of the noise along one of its waves, and waves along the tile.
const WAVELENGTH: f64 = 16.0;
const WAVES: f64 = 4.0;

/// The coats of all cells, in progress.
pub struct Coats {
    colour: ColourParams,
    seed: u64,
    side: f64,
    phase: f64,
    noise: NoiseTile,
    values: Vec<f64>,
    graph: Option<Graph>,
    reaction: Option<Reaction>,
}

impl Coats {
    /// Starts the coats; [`Coats::advance`] continues.
    ///
    /// `side` is the picture's side, in picture units.
    pub fn new(colour: ColourParams, seed: u64, side: f64) -> Self {
        Self {
            colour,
            seed,
            side,
            phase: Random::new(seed, Purpose::Pattern, u64::MAX).unit(),
            noise: NoiseTile::new(seed, 21, 6, 4, 1.2),
            values: Vec::new(),
            graph: None,
            reaction: None,
        }
    }

    /// Does the work of about `count` cells; true when finished. Domain and cells must not change.
    pub fn advance(&mut self, domain: &Domain, cells: &[Cell], count: usize) -> bool {
        match self.colour.pattern {
            Pattern::Plain => true,
            Pattern::Turing => self.react(domain, cells, count),
            _ => {
                let first = self.values.len();
                let end = cells.len().min(first.saturating_add(count));
                for cell in &cells[first..end] {
                    let value = self.value(domain, cell);
                    self.values.push(value);
                }
                end == cells.len()
            }
        }
    }

    /// One coat for each cell.
    pub fn finish(mut self, domain: &Domain, cells: &[Cell]) -> Vec<Coat> {
        if let Some(reaction) = self.reaction.take() {
            self.values = reaction.finish();
        }
        if matches!(
            self.colour.pattern,
            Pattern::Turing | Pattern::Size | Pattern::Blotches
        ) {
            spread_evenly(&mut self.values);
        }
        let coat = |(k, cell): (usize, &Cell)| Coat {
            mark: self.values.get(k).map_or(0.0, |&v| self.colour.weight(v)) as f32,
            belly: self.belly(domain, cell.centre) as f32,
        };
        cells.iter().enumerate().map(coat).collect()
    }

    fn react(&mut self, domain: &Domain, cells: &[Cell], count: usize) -> bool {
        if let Some(reaction) = &mut self.reaction {
            return reaction.advance(count);
        }
        let graph = self.graph.get_or_insert_with(|| Graph::new(domain, cells));
        if graph.advance(domain, count) {
            let links = self.graph.take().map_or(Vec::new(), Graph::finish);
            let ColourParams { scale, share, .. } = self.colour;
            let ids = cells.iter().map(|cell| cell.id).collect();
            let square = |from: u32, to: u32| {
                let [from, to] = [from, to].map(|k| cells[k as usize].centre);
                domain.space().shortest(to - from).length_squared()
            };
            let reaction = Reaction::new(ids, links, square, (scale, 1.0), share, self.seed);
            self.reaction = Some(reaction);
        }
        false
    }

    /// The value of a cell under a pattern that depends on this cell alone.
    fn value(&self, domain: &Domain, cell: &Cell) -> f64 {
        let ColourParams { scale, angle, .. } = self.colour;
        let period = domain.space().period();
        let p = cell.centre;
        let near = |distance: f64| greater(1.0 - distance / (2.0 * scale), 0.0);
        match self.colour.pattern {
            Pattern::Bands => {
                let along = self.turns(p, angle, scale, period) + self.phase;
                let bent = along + WAVE * self.noise(p, period, 1.0);
                triangle(bent)
            }
            Pattern::Spots | Pattern::Rosettes => self.spot(p, period),
            Pattern::Blotches => self.noise(p, period, 1.0) + 0.5 * self.noise(p, period, 2.3),
            Pattern::Size => signed_area(&cell.ring),
            Pattern::Boundary => near(domain.nearest(p).distance.abs()),
            Pattern::Lines => domain.nearest_line(p).map_or(0.0, |n| near(n.distance)),
            Pattern::Direction => {
                // Turns that leave the cell unchanged do not count.
                let full = TAU / f64::from(cell.kind.symmetry());
                let turn = libm::atan2(cell.axis.y, cell.axis.x) - angle;
                triangle(turn / full)
            }
            Pattern::Plain | Pattern::Turing => 0.0,
        }
    }

    /// The phase, in full turns, of a wave along an angle; on a torus, of the nearest wave that repeats.
    fn turns(&self, p: DVec2, angle: f64, length: f64, period: Option<f64>) -> f64 {
        let along = DVec2::new(libm::cos(angle), libm::sin(angle));
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
        let mut tiles = frequency * self.side / (self.colour.scale * WAVES);
        if period.is_some() {
            tiles = greater(tiles.round(), 1.0);
        }
        let at = p * (tiles * WAVELENGTH * WAVES / self.side);
        f64::from(self.noise.between(at.x as f32, at.y as f32))
    }

    /// 1 at the centre of a spot, 0 where the circle around it has a spot's share of the plane.
    fn spot(&self, p: DVec2, period: Option<f64>) -> f64 {
        let scale = self.colour.scale;
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

    fn belly(&self, domain: &Domain, p: DVec2) -> f64 {
        let ColourParams {
            belly, belly_angle, ..
        } = self.colour;
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

impl ColourParams {
    /// The share of the mark in a cell, from its value.
    pub(crate) fn weight(&self, value: f64) -> f64 {
        let c = self;
        let width = 1.0 - (1.0 - SHARPEST) * c.sharpness;
        let weight = smoothstep((value - (1.0 - c.share)) / width + 0.5);
        let pale = match c.pattern {
            Pattern::Rosettes => {
                let out = ((1.0 - value) / greater(c.share, 1e-3)).sqrt();
                0.75 * smoothstep((0.7 - out) / 0.3)
            }
            _ => 0.0,
        };
        c.amount * weight * (1.0 - pale)
    }
}

/// The share of the belly, from one side (0) to the other (1).
pub(crate) fn belly_at(down: f64) -> f64 {
    smoothstep((down - 0.3) / 0.5)
}

/// A triangle wave: 1 at integers, 0 at half-integers.
pub(crate) fn triangle(turns: f64) -> f64 {
    2.0 * (turns - turns.floor() - 0.5).abs()
}

/// Replaces values by their ranks, over 0..1.
pub(crate) fn spread_evenly(values: &mut [f64]) {
    let last = values.len().max(2) - 1;
    let mut ranks: Vec<(f64, u32)> = values.iter().copied().zip(0..).collect();
    order::sort(&mut ranks, |&(value, k)| (order::rank(value), k.into()));
    for (rank, &(_, k)) in ranks.iter().enumerate() {
        values[k as usize] = rank as f64 / last as f64;
    }
}
