//! The smoothest directions that follow their sources.
//!
//! Knoppel, Crane, Pinkall, Schroder (2013), Globally Optimal Direction Fields: representation vectors of neighbours,
//! carried to each other, differ as little as can be. Coarser systems give the guess from which the mesh's own is
//! solved. A part of the mesh without sources has no such answer but zero: there vectors are smoothed for a short
//! time and made unit vectors again, time after time (Viertel, Osting 2019, An Approach to Quad Meshing Based on
//! Harmonic Cross-Valued Maps and the Ginzburg-Landau Theory), beginning on the coarsest system, where singular points
//! move far in each round.

use super::gradients::Gradients;
use super::system::{Coarsening, System};
use glam::DVec2;

/// The coarsest system has at most so many rows.
const COARSEST: usize = 400;
/// What solving may leave on the mesh itself ...
const FINE: (f64, usize) = (1e-8, 3000);
/// ... and before that.
const ROUGH: (f64, usize) = (1e-4, 400);
/// Rounds of smoothing parts without sources: on the coarsest system, on those between, on the mesh.
const ROUNDS: [usize; 3] = [40, 8, 3];
/// How far smoothing goes in a round, as an area in rows' own.
const SPREAD: f64 = 20.0;

#[derive(Clone, Debug)]
struct Level {
    system: System,
    /// To the next coarser one.
    group: Vec<u32>,
    carry: Vec<DVec2>,
}

/// Solves a [`System`] in slices.
#[derive(Clone, Debug)]
pub(super) struct Smoothing {
    levels: Vec<Level>,
    coarsening: Option<Coarsening>,
    work: Option<Gradients>,
    /// Vectors at the rows of the level at work, of length 1 in parts without sources.
    now: Vec<DVec2>,
    /// Of each part: has it sources?
    sourced: Vec<bool>,
    level: usize,
    round: usize,
    done: bool,
    /// Iterations on the mesh itself.
    pub iterations: usize,
}

impl Smoothing {
    /// `sourced` tells of each part whether sources hold it; in others the loads are the guess to begin with.
    pub fn begin(system: System, sourced: Vec<bool>) -> Self {
        Self {
            levels: vec![Level {
                system,
                group: Vec::new(),
                carry: Vec::new(),
            }],
            coarsening: None,
            work: None,
            now: Vec::new(),
            sourced,
            level: 0,
            round: 0,
            done: false,
            iterations: 0,
        }
    }

    /// Works on so many rows; true when done.
    pub fn advance(&mut self, amount: usize) -> bool {
        if self.done {
            return true;
        }
        if self.now.is_empty() {
            self.coarsen(amount);
            return false;
        }
        let system = &self.levels[self.level].system;
        let Some(work) = &mut self.work else {
            self.begin_round();
            return false;
        };
        if work.advance(system, amount) {
            let work = self.work.take().expect("it is at work");
            if self.level == 0 {
                self.iterations += work.iterations;
            }
            self.end_round(work.x);
        }
        self.done
    }

    /// Unit vectors at the vertices; zero where nothing can be told.
    pub fn finish(self) -> Vec<DVec2> {
        self.now
    }

    fn coarsen(&mut self, amount: usize) {
        let last = self.levels.last_mut().expect("a level");
        let fine = &last.system;
        let work = self
            .coarsening
            .get_or_insert_with(|| Coarsening::begin(fine));
        let small = fine.len() <= COARSEST;
        if !small && !work.advance(fine, amount) {
            return;
        }
        let work = self.coarsening.take().expect("it is at work");
        if !small && 3 * work.coarse.len() < 2 * fine.len() {
            (last.group, last.carry) = (work.group, work.carry);
            self.levels.push(Level {
                system: work.coarse,
                group: Vec::new(),
                carry: Vec::new(),
            });
            return;
        }
        self.now = fine.load.iter().map(|z| z.normalize_or(DVec2::X)).collect();
        self.level = self.levels.len() - 1;
    }

    fn begin_round(&mut self) {
        let system = &self.levels[self.level].system;
        let (mut area, mut rows) = (0.0, 0.0);
        for (&mass, &part) in system.mass.iter().zip(&system.part) {
            if !self.sourced[part as usize] {
                area += mass;
                rows += 1.0;
            }
        }
        let pull = if area > 0.0 {
            rows / (SPREAD * area)
        } else {
            0.0
        };
        let row = |v: usize| {
            if self.sourced[system.part[v] as usize] {
                return (system.held[v], system.load[v]);
            }
            let held = pull * system.mass[v];
            (held, held * self.now[v])
        };
        let how = if self.level == 0 { FINE } else { ROUGH };
        self.work = Some(Gradients::begin(system, self.now.clone(), how, row));
    }

    fn end_round(&mut self, x: Vec<DVec2>) {
        // Where sources hold them, lengths tell how much the sources agree: the guess for the next level.
        let parts = &self.levels[self.level].system.part;
        let is_held = |v: usize| self.level > 0 && self.sourced[parts[v] as usize];
        let all = x.into_iter().enumerate();
        self.now = all
            .map(|(v, z)| if is_held(v) { z } else { z.normalize_or_zero() })
            .collect();
        self.round += 1;
        let coarsest = self.level + 1 == self.levels.len();
        let rounds = match self.sourced.iter().all(|&s| s) {
            true => 1,
            false if coarsest => ROUNDS[0],
            false => ROUNDS[if self.level == 0 { 2 } else { 1 }],
        };
        if self.round < rounds {
            return;
        }
        self.round = 0;
        if self.level == 0 {
            self.done = true;
            self.levels = Vec::new();
            return;
        }
        self.level -= 1;
        let Level { group, carry, .. } = &self.levels[self.level];
        let fine = group.iter().zip(carry);
        self.now = fine.map(|(&g, c)| c.rotate(self.now[g as usize])).collect();
    }
}
