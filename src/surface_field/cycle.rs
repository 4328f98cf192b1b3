//! A multigrid cycle over all coarser systems, as a preconditioner.

use super::system::{Holding, SystemLevel, rotated_sum, seen};
use crate::csr::Csr;
use glam::DVec2;

/// Sweeps in each direction on the coarsest system.
const SWEEPS: usize = 6;

/// A symmetric V-cycle in slices (Brandt 1977, Multi-Level Adaptive Solutions): Gauss-Seidel sweeps run forwards on
/// the way to coarser levels, backwards on the way back.
#[derive(Clone, Debug, Default)]
pub(super) struct Cycle {
    /// For each level: the right-hand side, the answer, the diagonal, and its inverse, which is 0 for empty rows.
    right: Vec<Vec<DVec2>>,
    answer: Vec<Vec<DVec2>>,
    diagonal: Vec<Vec<f64>>,
    inverse: Vec<Vec<f64>>,
    /// The entries of each row in earlier columns: the only ones that a sweep from an answer of 0 needs.
    lower: Vec<Csr<(u32, DVec2)>>,
    level: usize,
    step: CyclePhase,
    at: usize,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum CyclePhase {
    #[default]
    Forward,
    /// Restricts the residual to the next coarser level.
    Restrict,
    /// Adds the correction that the next coarser level has found.
    Correct,
    Backward,
    Coarsest,
}

impl Cycle {
    /// Reserves room for these levels, at most `amount` rows; true when all have room.
    pub fn prepare(
        &mut self,
        levels: &[SystemLevel],
        holding: &Holding,
        amount: &mut usize,
    ) -> bool {
        while *amount > 0 && self.level < levels.len() {
            let (l, system) = (self.level, &levels[self.level].system);
            if self.at == 0 {
                let count = system.len();
                self.right.push(Vec::with_capacity(count));
                self.answer.push(Vec::with_capacity(count));
                self.diagonal.push(Vec::with_capacity(count));
                self.inverse.push(Vec::with_capacity(count));
                self.lower.push(Csr::default());
            }
            let end = system.len().min(self.at.saturating_add(*amount));
            *amount -= end - self.at;
            for v in self.at..end {
                let d = system.diagonal[v] + holding.more(system, v);
                self.diagonal[l].push(d);
                self.inverse[l].push(if d > 0.0 { 1.0 / d } else { 0.0 });
                self.right[l].push(DVec2::ZERO);
                self.answer[l].push(DVec2::ZERO);
                let earlier = system.entries(v).filter(|&(j, _)| (j as usize) < v);
                self.lower[l].push(earlier);
            }
            self.at = end;
            if end == system.len() {
                (self.level, self.at) = (l + 1, 0);
            }
        }
        let done = self.level == levels.len();
        if done {
            self.level = 0;
        }
        done
    }

    /// The diagonal of the finest level, and its inverse.
    pub fn diagonal(&self) -> (&[f64], &[f64]) {
        (&self.diagonal[0], &self.inverse[0])
    }

    /// The answer on the finest level.
    pub fn answer(&self) -> &[DVec2] {
        &self.answer[0]
    }

    /// Works on at most `amount` rows and subtracts those it has used; true when the answer is complete.
    pub fn advance(&mut self, levels: &[SystemLevel], right: &[DVec2], amount: &mut usize) -> bool {
        while *amount > 0 {
            let l = self.level;
            let count = levels[l].system.len();
            if l + 1 == levels.len() {
                self.step = CyclePhase::Coarsest;
            }
            let all = if self.step == CyclePhase::Coarsest {
                2 * SWEEPS * count
            } else {
                count
            };
            let end = all.min(self.at.saturating_add(*amount));
            *amount -= end - self.at;
            let right = if l == 0 { right } else { &[] };
            match self.step {
                CyclePhase::Forward => self.forward(right, end),
                CyclePhase::Restrict => self.restrict(&levels[l], right, end),
                CyclePhase::Correct => self.correct(&levels[l], end),
                CyclePhase::Backward => {
                    for v in self.at..end {
                        self.relax(&levels[l], right, count - 1 - v);
                    }
                }
                CyclePhase::Coarsest => self.coarsest(&levels[l], right, end),
            }
            self.at = end;
            if end == all {
                self.at = 0;
                if self.next() {
                    return true;
                }
            }
        }
        false
    }

    fn next(&mut self) -> bool {
        match self.step {
            CyclePhase::Forward => self.step = CyclePhase::Restrict,
            CyclePhase::Restrict => (self.level, self.step) = (self.level + 1, CyclePhase::Forward),
            CyclePhase::Correct => self.step = CyclePhase::Backward,
            CyclePhase::Backward | CyclePhase::Coarsest => {
                if self.level == 0 {
                    self.step = CyclePhase::Forward;
                    return true;
                }
                (self.level, self.step) = (self.level - 1, CyclePhase::Correct);
            }
        }
        false
    }

    #[inline(always)]
    fn right_of(&self, right: &[DVec2], v: usize) -> DVec2 {
        if right.is_empty() {
            self.right[self.level][v]
        } else {
            right[v]
        }
    }

    #[inline(always)]
    fn relax(&mut self, level: &SystemLevel, right: &[DVec2], v: usize) {
        let around = level.system.around(v, &self.answer[self.level]);
        self.answer_row(right, v, around);
    }

    #[inline(always)]
    fn answer_row(&mut self, right: &[DVec2], v: usize, around: DVec2) {
        let right = self.right_of(right, v);
        self.answer[self.level][v] = self.inverse[self.level][v] * (right - around);
    }

    /// Sweeps from an answer of 0: later rows are still 0 and add nothing.
    fn forward(&mut self, right: &[DVec2], end: usize) {
        for v in self.at..end {
            let earlier = self.lower[self.level].row(v).iter();
            let around = rotated_sum(earlier.copied(), &self.answer[self.level]);
            self.answer_row(right, v, around);
        }
    }

    fn restrict(&mut self, level: &SystemLevel, right: &[DVec2], end: usize) {
        let l = self.level;
        if self.at == 0 {
            self.right[l + 1].fill(DVec2::ZERO);
        }
        for v in self.at..end {
            let own = self.diagonal[l][v] * self.answer[l][v];
            let left = self.right_of(right, v) - own - level.system.around(v, &self.answer[l]);
            self.right[l + 1][level.group[v] as usize] += seen(level.carry[v], left);
        }
    }

    fn correct(&mut self, level: &SystemLevel, end: usize) {
        let (fine, coarse) = self.answer.split_at_mut(self.level + 1);
        let (fine, coarse) = (&mut fine[self.level], &coarse[0]);
        for v in self.at..end {
            fine[v] += level.carry[v].rotate(coarse[level.group[v] as usize]);
        }
    }

    fn coarsest(&mut self, level: &SystemLevel, right: &[DVec2], end: usize) {
        let count = level.system.len();
        if self.at == 0 {
            self.answer[self.level].fill(DVec2::ZERO);
        }
        for k in self.at..end {
            let (sweep, v) = (k / count, k % count);
            let v = if sweep % 2 == 0 { v } else { count - 1 - v };
            self.relax(level, right, v);
        }
    }
}
