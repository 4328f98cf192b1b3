//! The smoothest directions that follow their constraints.
//!
//! Knoppel, Crane, Pinkall, Schroder (2013), Globally Optimal Direction Fields: representation vectors of neighbours,
//! carried to each other, differ as little as possible. The solutions of coarser systems are the initial guess on the
//! mesh itself.
//!
//! A part of the mesh without constraints has only the solution zero. There vectors are smoothed for a short time and
//! made unit vectors again, round after round (Viertel, Osting 2019, An Approach to Quad Meshing Based on Harmonic
//! Cross-Valued Maps and the Ginzburg-Landau Theory). This begins on the coarsest system, where singular points move
//! far in each round.

use super::gradients::Gradients;
use super::system::{Coarsening, Holding, System, SystemLevel};
use glam::DVec2;

/// The most rows of the coarsest system.
const COARSEST: usize = 400;
/// The solver's tolerance on the mesh itself, and its most iterations. The tolerance is also about the error of angles.
const FINE: (f64, usize) = (1e-4, 500);
/// The tolerance and the most iterations on coarser systems.
const ROUGH: (f64, usize) = (1e-4, 100);
/// Rounds of smoothing parts without constraints: on the coarsest system, on those between, on the mesh.
const ROUNDS: [usize; 3] = [40, 6, 2];
/// At the end parts with constraints are smoothed once more, as unit vectors, over this many sizes of a cell. Where
/// constraints are weak or contradict each other, the solution is short, and its turns within a cell are mere noise.
const POLISH: f64 = 1.0;
/// The area over which one round smooths, in mean areas of a row.
const SPREAD: f64 = 20.0;

/// Solves a [`System`] in slices.
#[derive(Clone, Debug)]
pub(super) struct Smoothing {
    levels: Vec<SystemLevel>,
    work: SmoothingPhase,
    /// Vectors at the rows of the current level, of length 1 in parts without constraints.
    now: Vec<DVec2>,
    holding: Holding,
    /// See [`POLISH`].
    polish: f64,
    level: usize,
    round: usize,
    /// Iterations of the solver on the mesh itself.
    pub iterations: usize,
}

#[derive(Clone, Debug)]
enum SmoothingPhase {
    Coarsen(Box<Coarsening>),
    Solve(Box<Gradients>),
    /// Makes unit vectors of the solution.
    Unit(Vec<DVec2>),
    /// Carries the vectors to the next finer level.
    Carry(Vec<DVec2>),
    Done,
}

impl Smoothing {
    /// `sourced` tells for each part whether it has constraints; in other parts the loads are the initial guess. `size`
    /// is about the size of a cell.
    pub fn begin(system: System, sourced: Vec<bool>, size: f64) -> Self {
        Self {
            work: SmoothingPhase::Coarsen(Box::new(Coarsening::begin(&system))),
            levels: vec![SystemLevel {
                system,
                ..SystemLevel::default()
            }],
            now: Vec::new(),
            holding: Holding {
                sourced,
                ..Holding::default()
            },
            polish: 1.0 / (POLISH * POLISH * size * size),
            level: 0,
            round: 0,
            iterations: 0,
        }
    }

    /// Works on at most `amount` rows; true when done.
    pub fn advance(&mut self, amount: usize) -> bool {
        self.work = match std::mem::replace(&mut self.work, SmoothingPhase::Done) {
            SmoothingPhase::Coarsen(work) => self.coarsen(work, amount),
            SmoothingPhase::Solve(mut work) => {
                if work.advance(&self.levels[self.level..], amount) {
                    if self.level == 0 {
                        self.iterations += work.iterations;
                    }
                    self.now = Vec::with_capacity(work.x.len());
                    SmoothingPhase::Unit(work.x)
                } else {
                    SmoothingPhase::Solve(work)
                }
            }
            SmoothingPhase::Unit(x) => self.unit(x, amount),
            SmoothingPhase::Carry(coarse) => self.carry(coarse, amount),
            SmoothingPhase::Done => SmoothingPhase::Done,
        };
        matches!(self.work, SmoothingPhase::Done)
    }

    /// Unit vectors at the vertices. Where constraints cancel each other the direction is arbitrary, but never zero, so
    /// the turns around triangles are whole numbers.
    pub fn finish(self) -> Vec<DVec2> {
        self.now
    }

    fn coarsen(&mut self, mut work: Box<Coarsening>, amount: usize) -> SmoothingPhase {
        let last = self.levels.last_mut().expect("a level");
        let fine = &last.system;
        if fine.len() > COARSEST {
            if !work.advance(fine, amount) {
                return SmoothingPhase::Coarsen(work);
            }
            if 3 * work.coarse.len() < 2 * fine.len() {
                (last.group, last.carry) = (work.group, work.carry);
                let next = Coarsening::begin(&work.coarse);
                self.levels.push(SystemLevel {
                    system: work.coarse,
                    ..SystemLevel::default()
                });
                return SmoothingPhase::Coarsen(Box::new(next));
            }
        }
        self.now = fine.load.iter().map(|z| z.normalize_or(DVec2::X)).collect();
        self.level = self.levels.len() - 1;
        self.solve()
    }

    fn has_free(&self) -> bool {
        self.holding.sourced.contains(&false)
    }

    /// Starts the solver from the current vectors.
    fn solve(&mut self) -> SmoothingPhase {
        let system = &self.levels[self.level].system;
        if self.has_free() && self.round == 0 {
            let (mut area, mut rows) = (0.0, 0.0);
            for (v, &mass) in system.mass.iter().enumerate() {
                if !self.holding.is_sourced(system, v) {
                    area += mass;
                    rows += 1.0;
                }
            }
            self.holding.pull = if area > 0.0 {
                rows / (SPREAD * area)
            } else {
                0.0
            };
        }
        self.holding.polish = if self.round == 0 { 0.0 } else { self.polish };
        let how = match (self.level, self.round) {
            (0, 0) if !self.has_free() => FINE,
            _ => ROUGH,
        };
        let now = std::mem::take(&mut self.now);
        SmoothingPhase::Solve(Box::new(Gradients::begin(now, self.holding.clone(), how)))
    }

    fn unit(&mut self, x: Vec<DVec2>, amount: usize) -> SmoothingPhase {
        let system = &self.levels[self.level].system;
        let begin = self.now.len();
        let end = x.len().min(begin.saturating_add(amount.max(1)));
        for (v, &z) in x.iter().enumerate().take(end).skip(begin) {
            // In parts with constraints the length tells how much the constraints agree: keep it as the guess for the
            // next level.
            let is_held = self.level > 0 && self.holding.is_sourced(system, v);
            self.now
                .push(if is_held { z } else { z.normalize_or(DVec2::X) });
        }
        if end < x.len() {
            return SmoothingPhase::Unit(x);
        }
        self.round += 1;
        let coarsest = self.level + 1 == self.levels.len();
        let rounds = match self.level {
            0 => ROUNDS[2],
            _ if !self.has_free() => 1,
            _ if coarsest => ROUNDS[0],
            _ => ROUNDS[1],
        };
        if self.round < rounds {
            return self.solve();
        }
        self.round = 0;
        if self.level == 0 {
            return SmoothingPhase::Done;
        }
        self.level -= 1;
        let count = self.levels[self.level].system.len();
        SmoothingPhase::Carry(std::mem::replace(&mut self.now, Vec::with_capacity(count)))
    }

    fn carry(&mut self, coarse: Vec<DVec2>, amount: usize) -> SmoothingPhase {
        let SystemLevel { group, carry, .. } = &self.levels[self.level];
        let begin = self.now.len();
        let end = group.len().min(begin.saturating_add(amount.max(1)));
        let rows = group[begin..end].iter().zip(&carry[begin..end]);
        self.now
            .extend(rows.map(|(&g, c)| c.rotate(coarse[g as usize])));
        if end < group.len() {
            return SmoothingPhase::Carry(coarse);
        }
        self.solve()
    }
}
