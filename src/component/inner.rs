//! Inner spheres: few balls that fill a component, chosen from its medial balls.

use super::choice::Choice;
use super::pool::{Inside, Sampling, Sphere};
use crate::random::{Purpose, Random, SEED};
use crate::trimesh::{Search, TriMesh};
use glam::DVec3;
use std::sync::Arc;

/// Steps of the search for the largest ball.
const CLIMBS: usize = 240;
/// A step that fails shortens the next ones by this factor.
const SHORTER: f64 = 0.94;
/// No more spheres are needed when no gap is larger than this share of the largest radius.
const TOLERANCE: f64 = 0.05;
/// The least radius of a sphere, as a share of the diagonal.
const LEAST: f64 = 1e-4;
/// Up to this many triangles, a slice finds as many balls as its amount. A search from the middle of a round body
/// visits all triangles, so larger bodies get fewer balls in a slice.
const LIGHT: usize = 400;

/// How far the surface lies outside the spheres, in radii of the largest one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gaps {
    /// The greatest distance from a place of the surface to the nearest sphere.
    pub greatest: f64,
    /// The mean of these distances.
    pub mean: f64,
}

/// The amounts of the work.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Samples of the surface, at which gaps are measured.
    pub samples: usize,
    /// Every how many-th of them gets a medial ball.
    pub every: usize,
    /// The most spheres.
    pub most: usize,
}

/// The spheres of a mesh.
pub(super) struct Inner {
    /// In the order of choice: each one reduces the gaps most. The first is the largest.
    pub spheres: Vec<Sphere>,
    /// For each sphere the greatest gap at places of the surface to which it is the nearest one.
    pub beyond: Vec<f64>,
    /// All medial balls.
    pub pool: Vec<Sphere>,
    pub gaps: Gaps,
}

#[derive(Clone, Copy, PartialEq)]
enum InnerPhase {
    Tree,
    Sample,
    Pool,
    Climb,
    Choose,
}

/// Chooses the spheres of a mesh, in slices.
pub(super) struct InnerMaking {
    mesh: Arc<TriMesh>,
    /// The diagonal of the mesh.
    size: f64,
    search: Search,
    effort: Effort,
    /// Centres of medial balls, if they are known.
    known: Option<Vec<DVec3>>,
    sampling: Sampling,
    phase: InnerPhase,
    at: usize,
    pool: Vec<Sphere>,
    largest: Option<Sphere>,
    climb: (f64, Random),
    choice: Choice,
}

impl InnerMaking {
    /// Starts with a closed mesh that does not cross itself. `known` are the centres of medial balls; without them they
    /// are found.
    pub fn new(mesh: Arc<TriMesh>, effort: Effort, known: Option<Vec<DVec3>>) -> Self {
        Self {
            size: mesh.diagonal(),
            search: Search::begin(&mesh),
            sampling: Sampling::new(effort.samples),
            phase: InnerPhase::Tree,
            at: 0,
            pool: Vec::new(),
            largest: None,
            climb: (0.0, Random::new(SEED, Purpose::Scatter, 0)),
            choice: Choice::default(),
            mesh,
            effort,
            known,
        }
    }

    /// Works on at most `amount` triangles, samples or balls. Returns the spheres when they are chosen, or nothing if
    /// there is no room for any.
    pub fn advance(&mut self, amount: usize) -> Option<Option<Inner>> {
        let amount = amount.max(1);
        let next = match self.phase {
            InnerPhase::Tree => {
                let done = self.search.advance(&self.mesh, amount);
                done.then_some(InnerPhase::Sample)
            }
            InnerPhase::Sample => {
                let done = self.sampling.advance(&self.mesh, amount);
                done.then_some(InnerPhase::Pool)
            }
            InnerPhase::Pool => self.fill(self.balls(amount)).then_some(InnerPhase::Climb),
            InnerPhase::Climb => {
                if self.largest.is_none() {
                    return Some(None);
                }
                self.climb(self.balls(amount)).then_some(InnerPhase::Choose)
            }
            InnerPhase::Choose => {
                if self.choose(amount) {
                    return Some(Some(self.chosen()));
                }
                None
            }
        };
        if let Some(next) = next {
            (self.phase, self.at) = (next, 0);
        }
        None
    }

    /// The number of balls to find in a slice.
    fn balls(&self, amount: usize) -> usize {
        let share = self.mesh.triangles().len().div_ceil(LIGHT).max(1);
        (amount / share).max(1)
    }

    /// Finds medial balls; true after the last one.
    fn fill(&mut self, amount: usize) -> bool {
        let inside = Inside {
            mesh: &self.mesh,
            search: &self.search,
            least: LEAST * self.size,
        };
        let count = match &self.known {
            Some(known) => known.len(),
            None => self.sampling.samples.len().div_ceil(self.effort.every),
        };
        let end = count.min(self.at + amount);
        for k in self.at..end {
            let ball = match &self.known {
                Some(known) => inside.ball(known[k]),
                None => inside.medial(
                    &self.sampling.samples[k * self.effort.every],
                    0.5 * self.size,
                ),
            };
            let Some(ball) = ball else { continue };
            if self
                .largest
                .is_none_or(|largest| ball.radius > largest.radius)
            {
                self.largest = Some(ball);
                self.climb.0 = 0.5 * ball.radius;
            }
            self.pool.push(ball);
        }
        self.at = end;
        end == count
    }

    /// Moves the largest ball to where it can grow; true after the last step.
    fn climb(&mut self, amount: usize) -> bool {
        let end = CLIMBS.min(self.at + amount);
        let (step, random) = &mut self.climb;
        for _ in self.at..end {
            let by = DVec3::from([0; 3].map(|_| random.signed()));
            let Some(best) = &mut self.largest else { break };
            let larger = Inside {
                mesh: &self.mesh,
                search: &self.search,
                least: best.radius,
            };
            match larger.large_ball(best.centre + *step * by) {
                Some(ball) => *best = ball,
                None => *step *= SHORTER,
            }
        }
        self.at = end;
        end == CLIMBS
    }

    /// Chooses spheres; true when there are enough.
    fn choose(&mut self, amount: usize) -> bool {
        let Some(largest) = self.largest else {
            return true;
        };
        if self.choice.spheres().is_empty() {
            let places = self.sampling.samples.iter().map(|sample| sample.at);
            self.choice = Choice::new(places.collect(), self.pool.len());
            self.choice.take(largest);
        }
        let tolerance = TOLERANCE * largest.radius;
        for _ in 0..amount {
            let is_enough = self.choice.spheres().len() >= self.effort.most
                || self.choice.greatest() <= tolerance;
            if is_enough || !self.choice.advance(&self.pool) {
                return true;
            }
        }
        false
    }

    fn chosen(&mut self) -> Inner {
        let choice = std::mem::take(&mut self.choice);
        let largest = choice.spheres()[0].radius;
        Inner {
            beyond: choice.beyond(),
            gaps: Gaps {
                greatest: choice.greatest() / largest,
                mean: choice.mean() / largest,
            },
            spheres: choice.spheres().to_vec(),
            pool: std::mem::take(&mut self.pool),
        }
    }
}
