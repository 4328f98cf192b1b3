//! Conjugate gradients, in slices.

use super::cycle::Cycle;
use super::system::{Holding, System, SystemLevel};
use glam::DVec2;

/// Solves (A + D) x = b for the matrix A of a system and a diagonal D (Hestenes, Stiefel 1952), preconditioned with a
/// [`Cycle`] over it and all coarser systems. Sums run over the rows in order, so results do not depend on how the
/// work is cut.
#[derive(Clone, Debug)]
pub(super) struct Gradients {
    pub x: Vec<DVec2>,
    pub iterations: usize,
    holding: Holding,
    cycle: Cycle,
    residual: Vec<DVec2>,
    step: Vec<DVec2>,
    image: Vec<DVec2>,
    /// The residual may be at most this share of b.
    tolerance: f64,
    most: usize,
    goal: f64,
    /// The squared norm of the residual, weighted with the inverse diagonal (`left`) and with the cycle (`product`).
    left: f64,
    product: f64,
    sum: f64,
    share: f64,
    phase: GradientsPhase,
    at: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum GradientsPhase {
    Prepare,
    Begin,
    Cycle,
    Product,
    Turn,
    Image,
    Move,
    Done,
}

impl Gradients {
    /// Starts from an initial guess. Ends when the residual is at most the given share of b, or after the most
    /// iterations.
    pub fn begin(x: Vec<DVec2>, holding: Holding, (tolerance, most): (f64, usize)) -> Self {
        Self {
            iterations: 0,
            step: Vec::with_capacity(x.len()),
            image: Vec::with_capacity(x.len()),
            residual: Vec::with_capacity(x.len()),
            x,
            holding,
            cycle: Cycle::default(),
            tolerance,
            most,
            goal: 0.0,
            left: 0.0,
            product: 0.0,
            sum: 0.0,
            share: 0.0,
            phase: GradientsPhase::Prepare,
            at: 0,
        }
    }

    /// Works on at most `amount` rows of all levels together. The first level is the system to solve. True when done.
    pub fn advance(&mut self, levels: &[SystemLevel], amount: usize) -> bool {
        let mut amount = amount.max(1);
        let system = &levels[0].system;
        while amount > 0 && self.phase != GradientsPhase::Done {
            if self.phase == GradientsPhase::Prepare {
                if self.cycle.prepare(levels, &self.holding, &mut amount) {
                    self.phase = GradientsPhase::Begin;
                }
                continue;
            }
            if self.phase == GradientsPhase::Cycle {
                if self.cycle.advance(levels, &self.residual, &mut amount) {
                    self.phase = GradientsPhase::Product;
                }
                continue;
            }
            let end = system.len().min(self.at.saturating_add(amount));
            amount -= end - self.at;
            self.rows(system, end);
            self.at = end;
            if end == system.len() {
                self.at = 0;
                self.next();
            }
        }
        self.phase == GradientsPhase::Done
    }

    fn rows(&mut self, system: &System, end: usize) {
        let rows = self.at..end;
        let (diagonal, inverse) = self.cycle.diagonal();
        let down = self.cycle.answer();
        match self.phase {
            GradientsPhase::Begin => {
                for v in rows {
                    let b = self.holding.right(system, v, self.x[v]);
                    self.goal += inverse[v] * b.length_squared();
                    let rest = b - diagonal[v] * self.x[v] - system.around(v, &self.x);
                    self.residual.push(rest);
                    self.step.push(DVec2::ZERO);
                    self.image.push(DVec2::ZERO);
                    self.sum += inverse[v] * rest.length_squared();
                }
            }
            GradientsPhase::Product => {
                for v in rows {
                    self.sum += self.residual[v].dot(down[v]);
                }
            }
            GradientsPhase::Turn => {
                for v in rows {
                    self.step[v] = down[v] + self.share * self.step[v];
                }
            }
            GradientsPhase::Image => {
                for v in rows {
                    self.image[v] = diagonal[v] * self.step[v] + system.around(v, &self.step);
                    self.sum += self.step[v].dot(self.image[v]);
                }
            }
            GradientsPhase::Move => {
                for v in rows {
                    self.x[v] += self.share * self.step[v];
                    self.residual[v] -= self.share * self.image[v];
                    self.sum += inverse[v] * self.residual[v].length_squared();
                }
            }
            GradientsPhase::Prepare | GradientsPhase::Cycle | GradientsPhase::Done => {}
        }
    }

    fn next(&mut self) {
        let sum = std::mem::take(&mut self.sum);
        match self.phase {
            GradientsPhase::Begin => {
                self.left = sum;
                self.goal *= self.tolerance * self.tolerance;
                self.phase = GradientsPhase::Cycle;
            }
            GradientsPhase::Product => {
                self.share = if self.product > 0.0 {
                    sum / self.product
                } else {
                    0.0
                };
                self.product = sum;
                self.phase = GradientsPhase::Turn;
            }
            GradientsPhase::Turn => self.phase = GradientsPhase::Image,
            GradientsPhase::Image => {
                self.share = if sum > 0.0 { self.product / sum } else { 0.0 };
                self.phase = GradientsPhase::Move;
            }
            GradientsPhase::Move => {
                self.left = sum;
                self.iterations += 1;
                self.phase = GradientsPhase::Cycle;
            }
            GradientsPhase::Prepare | GradientsPhase::Cycle | GradientsPhase::Done => {}
        }
        let is_between = self.phase == GradientsPhase::Cycle;
        if is_between && (self.left <= self.goal || self.iterations >= self.most) {
            self.phase = GradientsPhase::Done;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::system::Coarsening;
    use super::*;
    use crate::trimesh::adjacency::Adjacency;
    use crate::trimesh::samples;

    #[test]
    fn it_solves_the_same_however_it_is_cut() {
        let mesh = samples::blob(3);
        let links = Adjacency::build(&mesh);
        let mut system = System::new(&links, vec![0; links.len()]);
        for v in 0..links.len() {
            let source = DVec2::new(libm::sin(v as f64), 0.3);
            system.row(&links, 4, (0.001, source));
        }
        let mut levels = Vec::new();
        for _ in 0..2 {
            let mut work = Coarsening::begin(&system);
            while !work.advance(&system, 100) {}
            let (group, carry) = (work.group, work.carry);
            let coarse = std::mem::replace(&mut system, work.coarse);
            levels.push(SystemLevel {
                system: coarse,
                group,
                carry,
            });
        }
        let solved = |amount: usize, levels: &[SystemLevel]| {
            let system = &levels[0].system;
            let zero = vec![DVec2::ZERO; system.len()];
            let holding = Holding {
                sourced: vec![true],
                pull: 0.0,
                polish: 0.0,
            };
            let mut work = Gradients::begin(zero, holding, (1e-10, 500));
            while !work.advance(levels, amount) {}
            work
        };
        let all = solved(usize::MAX, &levels);
        assert_eq!(all.x, solved(17, &levels).x);
        let plain = [SystemLevel {
            group: Vec::new(),
            ..levels[0].clone()
        }];
        let alone = solved(1000, &plain);
        assert!(
            all.iterations > 5 && all.iterations < 40,
            "{}",
            all.iterations
        );
        let system = &levels[0].system;
        for x in [all.x, alone.x] {
            for v in 0..system.len() {
                let own = (system.diagonal[v] + system.held[v]) * x[v];
                let off = own + system.around(v, &x) - system.load[v];
                assert!(off.length() < 1e-8, "{off}");
            }
        }
    }
}
