//! The marking of cells: the part of coats that is the same in the plane and on surfaces.

use super::noise::NoiseTile;
use super::pattern::{Coat, ColourParams, Pattern};
use super::reaction::Reaction;
use crate::field::{CellKind, smoothstep};
use crate::order::{self, greater};
use crate::random::{Purpose, Random};
use std::f64::consts::TAU;
use std::ops::Range;

/// Amplitude of the bends of bands, in pattern scales.
pub(crate) const WAVE: f64 = 0.2;
/// The number of noise values along one wave.
pub(crate) const WAVELENGTH: f64 = 16.0;
/// The distance between clouds of tones, as a share of the side of a picture or of the box around a body.
pub(crate) const CLOUDS: f64 = 0.45;
/// The place in the noise from which clouds are read, so that they do not follow the marks.
pub(crate) const CLOUDS_AT: f64 = 37.0;
/// The width of the sharpest border of marks, as a share of the cells; the softest border covers all cells.
const SHARPEST: f64 = 0.03;

/// The values of all cells under a pattern, in progress.
pub(crate) struct Marking {
    pub colour: ColourParams,
    phase: f64,
    noise: NoiseTile,
    values: Vec<f64>,
    reaction: Option<Reaction>,
}

impl Marking {
    /// A marking without values yet.
    pub fn new(colour: ColourParams, seed: u64) -> Self {
        Self {
            colour,
            phase: Random::new(seed, Purpose::Pattern, u64::MAX).unit(),
            noise: NoiseTile::new(seed, 21, 6, 4, 1.2),
            values: Vec::new(),
            reaction: None,
        }
    }

    /// Uses the values of a reaction.
    pub fn take(&mut self, reaction: Reaction) {
        self.reaction = Some(reaction);
    }

    /// Works on about `count` cells of the reaction; true when finished. `None` if there is no reaction, so that each
    /// cell needs a value by [`Self::push`].
    pub fn advance(&mut self, count: usize) -> Option<bool> {
        match &mut self.reaction {
            Some(reaction) => Some(reaction.advance(count)),
            None => (self.colour.pattern == Pattern::Plain).then_some(true),
        }
    }

    /// The next cells, at most `count`; each gets its value by [`Self::push`].
    pub fn due(&self, cells: usize, count: usize) -> Range<usize> {
        let first = self.values.len();
        first..cells.min(first.saturating_add(count))
    }

    /// Adds the value of the next cell.
    pub fn push(&mut self, value: f64) {
        self.values.push(value);
    }

    /// The coats of all cells; `places` has for each cell the share of the belly and the tone of its place.
    pub fn finish(mut self, places: impl Iterator<Item = [f64; 2]>) -> Vec<Coat> {
        if let Some(reaction) = self.reaction.take() {
            self.values = reaction.finish();
        }
        if matches!(
            self.colour.pattern,
            Pattern::Turing | Pattern::Size | Pattern::Blotches
        ) {
            spread_evenly(&mut self.values);
        }
        let mark = |k: usize| self.values.get(k).map_or(0.0, |&v| self.colour.weight(v));
        let soft = self.colour.soft as f32;
        let coat = |(k, [belly, tone]): (usize, [f64; 2])| Coat {
            mark: mark(k) as f32,
            belly: belly as f32,
            soft,
            tone: tone as f32,
        };
        places.enumerate().map(coat).collect()
    }

    /// The noise at a place of its tile.
    pub fn noise(&self, x: f64, y: f64) -> f64 {
        f64::from(self.noise.between(x as f32, y as f32))
    }

    /// The value at a place `along` bands from the start, where the noise is `noise`.
    pub fn band(&self, along: f64, noise: f64) -> f64 {
        triangle(along + self.phase + WAVE * noise)
    }
}

/// The value of a cell at this distance from a marked line or boundary: 1 on it, falling to 0 at two scales.
pub(crate) fn near(distance: f64, scale: f64) -> f64 {
    greater(1.0 - distance / (2.0 * scale), 0.0)
}

/// The value of a cell turned this far from the marked direction. Turns that leave the cell unchanged do not count.
pub(crate) fn turned(turn: f64, kind: CellKind) -> f64 {
    let full = TAU / f64::from(kind.symmetry());
    triangle(turn / full)
}

/// The share of the belly's colour, at a place from the back (0) to the belly's side (1).
pub(crate) fn belly_at(down: f64) -> f64 {
    smoothstep((down - 0.3) / 0.5)
}

impl ColourParams {
    /// The share of the mark in a cell, from its value.
    fn weight(&self, value: f64) -> f64 {
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

/// A triangle wave: 1 at integers, 0 at half-integers.
fn triangle(turns: f64) -> f64 {
    2.0 * (turns - turns.floor() - 0.5).abs()
}

/// Replaces values by their ranks, over 0..1.
fn spread_evenly(values: &mut [f64]) {
    let last = values.len().max(2) - 1;
    let mut ranks: Vec<(f64, u32)> = values.iter().copied().zip(0..).collect();
    order::sort(&mut ranks, |&(value, k)| (order::rank(value), k.into()));
    for (rank, &(_, k)) in ranks.iter().enumerate() {
        values[k as usize] = rank as f64 / last as f64;
    }
}
