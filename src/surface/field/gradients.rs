//! Conjugate gradients, in slices.

use super::system::System;
use glam::DVec2;

/// Solves (A + D) x = b for the matrix A of a [`System`] and a diagonal D, preconditioned with its diagonal (Hestenes,
/// Stiefel 1952). Sums run over the rows in their order, however the work is cut.
#[derive(Clone, Debug)]
pub(super) struct Gradients {
    pub x: Vec<DVec2>,
    pub iterations: usize,
    /// 1 / (A + D)'s diagonal; 0 for rows of nothing.
    inverse: Vec<f64>,
    diagonal: Vec<f64>,
    residual: Vec<DVec2>,
    step: Vec<DVec2>,
    image: Vec<DVec2>,
    /// What is left is at most this share of b.
    tolerance: f64,
    most: usize,
    goal: f64,
    left: f64,
    sum: f64,
    share: f64,
    phase: Phase,
    at: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Begin,
    Image,
    Move,
    Turn,
    Done,
}

impl Gradients {
    /// From a guess, until what is left is that share of b, or after the most iterations. `row` answers with D and b.
    pub fn begin(
        system: &System,
        x: Vec<DVec2>,
        (tolerance, most): (f64, usize),
        row: impl Fn(usize) -> (f64, DVec2),
    ) -> Self {
        let count = system.len();
        let mut work = Self {
            x,
            iterations: 0,
            inverse: Vec::with_capacity(count),
            diagonal: Vec::with_capacity(count),
            residual: Vec::with_capacity(count),
            step: Vec::with_capacity(count),
            image: vec![DVec2::ZERO; count],
            tolerance,
            most,
            goal: 0.0,
            left: 0.0,
            sum: 0.0,
            share: 0.0,
            phase: Phase::Begin,
            at: 0,
        };
        for v in 0..count {
            let (more, b) = row(v);
            let diagonal = system.diagonal[v] + more;
            work.diagonal.push(diagonal);
            work.inverse
                .push(if diagonal > 0.0 { 1.0 / diagonal } else { 0.0 });
            work.residual.push(b);
        }
        work
    }

    /// Works on so many rows; true when done.
    pub fn advance(&mut self, system: &System, amount: usize) -> bool {
        let mut amount = amount.max(1);
        while amount > 0 && self.phase != Phase::Done {
            let end = system.len().min(self.at.saturating_add(amount));
            amount -= end - self.at;
            for v in self.at..end {
                match self.phase {
                    Phase::Begin => self.first(system, v),
                    Phase::Image => {
                        let own = self.diagonal[v] * self.step[v];
                        self.image[v] = own + system.around(v, &self.step);
                        self.sum += self.step[v].dot(self.image[v]);
                    }
                    Phase::Move => {
                        self.x[v] += self.share * self.step[v];
                        self.residual[v] -= self.share * self.image[v];
                        self.sum += self.inverse[v] * self.residual[v].length_squared();
                    }
                    Phase::Turn => {
                        let down = self.inverse[v] * self.residual[v];
                        self.step[v] = down + self.share * self.step[v];
                    }
                    Phase::Done => {}
                }
            }
            self.at = end;
            if end == system.len() {
                self.at = 0;
                self.next();
            }
        }
        self.phase == Phase::Done
    }

    fn first(&mut self, system: &System, v: usize) {
        let b = self.residual[v];
        self.goal += self.inverse[v] * b.length_squared();
        let rest = b - self.diagonal[v] * self.x[v] - system.around(v, &self.x);
        self.residual[v] = rest;
        self.step.push(self.inverse[v] * rest);
        self.sum += self.inverse[v] * rest.length_squared();
    }

    fn next(&mut self) {
        let sum = std::mem::take(&mut self.sum);
        match self.phase {
            Phase::Begin => {
                self.left = sum;
                self.goal *= self.tolerance * self.tolerance;
                self.phase = Phase::Image;
            }
            Phase::Image => {
                self.share = if sum > 0.0 { self.left / sum } else { 0.0 };
                self.phase = Phase::Move;
            }
            Phase::Move => {
                self.share = if self.left > 0.0 {
                    sum / self.left
                } else {
                    0.0
                };
                self.left = sum;
                self.iterations += 1;
                self.phase = Phase::Turn;
            }
            Phase::Turn => self.phase = Phase::Image,
            Phase::Done => {}
        }
        let is_between = matches!(self.phase, Phase::Image | Phase::Turn);
        if is_between && (self.left <= self.goal || self.iterations >= self.most) {
            self.phase = Phase::Done;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::links::Links;
    use crate::surface::testing;

    #[test]
    fn it_solves_the_same_however_it_is_cut() {
        let mesh = testing::blob(3);
        let links = Links::build(&mesh);
        let mut system = System::new(&links, vec![0; links.len()]);
        for v in 0..links.len() {
            let source = DVec2::new(libm::sin(v as f64), 0.3);
            system.row(&links, 4, (0.1, source));
        }
        let solved = |amount: usize| {
            let zero = vec![DVec2::ZERO; system.len()];
            let row = |v: usize| (system.held[v], system.load[v]);
            let mut work = Gradients::begin(&system, zero, (1e-10, 500), row);
            while !work.advance(&system, amount) {}
            work
        };
        let all = solved(usize::MAX);
        assert!(all.iterations > 5 && all.iterations < 200);
        assert_eq!(all.x, solved(17).x);
        for v in 0..system.len() {
            let own = (system.diagonal[v] + system.held[v]) * all.x[v];
            let off = own + system.around(v, &all.x) - system.load[v];
            assert!(off.length() < 1e-8, "{off}");
        }
    }
}
