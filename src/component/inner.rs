//! Inner spheres: few balls that fill a component, chosen from its medial balls.

use super::choice::Choice;
use super::pool::{BallSearch, Inside, Sampling, Sphere};
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
/// A slice looks at this many triangles for each ball of its amount.
const LOOKED_AT: usize = 400;

/// How far the surface lies outside the spheres, in radii of the largest one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gaps {
    /// The greatest distance from a place of the surface to the nearest sphere.
    pub greatest: f64,
    /// The mean of these distances.
    pub mean: f64,
}

/// Limits of the work.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Samples of the surface, at which gaps are measured.
    pub samples: usize,
    /// One in this many samples gets a medial ball.
    pub every: usize,
    /// The most spheres.
    pub most: usize,
}

/// The spheres of a mesh.
pub(super) struct Inner {
    /// The chosen spheres, in the order of choice: each reduces the gaps most at its turn. The first is the largest.
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
    /// The ball under work.
    ball: Option<BallSearch>,
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
            ball: None,
            climb: (0.0, Random::new(SEED, Purpose::Scatter, 0)),
            choice: Choice::default(),
            mesh,
            effort,
            known,
        }
    }

    /// Works on at most `amount` triangles, samples or balls. Returns the spheres when they are chosen; `Some(None)` if
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
            InnerPhase::Pool => self.fill(looked_at(amount)).then_some(InnerPhase::Climb),
            InnerPhase::Climb => {
                if self.largest.is_none() {
                    return Some(None);
                }
                self.climb(looked_at(amount)).then_some(InnerPhase::Choose)
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

    /// Finds medial balls; true after the last one.
    fn fill(&mut self, mut amount: usize) -> bool {
        let inside = Inside {
            mesh: &self.mesh,
            search: &self.search,
            least: LEAST * self.size,
        };
        let count = match &self.known {
            Some(known) => known.len(),
            None => self.sampling.samples.len().div_ceil(self.effort.every),
        };
        while self.at < count {
            let search = self.ball.get_or_insert_with(|| match &self.known {
                Some(known) => BallSearch::around(known[self.at]),
                None => {
                    let sample = self.sampling.samples[self.at * self.effort.every];
                    BallSearch::medial(sample, 0.5 * self.size)
                }
            });
            let Some(ball) = search.advance(&inside, &mut amount) else {
                return false;
            };
            self.ball = None;
            self.at += 1;
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
        true
    }

    /// Moves the largest ball to where it can grow; true after the last step.
    fn climb(&mut self, mut amount: usize) -> bool {
        let (step, random) = &mut self.climb;
        while self.at < CLIMBS {
            let Some(best) = &mut self.largest else { break };
            let larger = Inside {
                mesh: &self.mesh,
                search: &self.search,
                least: best.radius,
            };
            if self.ball.is_none() {
                if amount == 0 {
                    return false;
                }
                let by = DVec3::from([0; 3].map(|_| random.signed()));
                let centre = best.centre + *step * by;
                if larger.has_room(centre, &mut amount) {
                    self.ball = Some(BallSearch::around(centre));
                }
            }
            let found = match &mut self.ball {
                Some(search) => search.advance(&larger, &mut amount),
                None => Some(None),
            };
            let Some(found) = found else { return false };
            match found {
                Some(ball) => *best = ball,
                None => *step *= SHORTER,
            }
            self.ball = None;
            self.at += 1;
        }
        true
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

/// The number of triangles that a slice of this amount looks at.
fn looked_at(amount: usize) -> usize {
    amount.saturating_mul(LOOKED_AT)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::testing;

    /// In the middle of a ball, all triangles of its surface are about equally near: a slice ends within the search for
    /// one sphere.
    #[test]
    fn a_sphere_in_a_fine_ball_takes_many_slices() {
        let mesh = Arc::new(testing::mesh(testing::ball(6)));
        let effort = Effort {
            samples: 20,
            every: 1,
            most: 3,
        };
        let made = |amount: usize| {
            let mut making = InnerMaking::new(mesh.clone(), effort, None);
            let mut slices = [0; 2];
            loop {
                let is_sliced = [InnerPhase::Pool, InnerPhase::Climb].map(|at| at == making.phase);
                let amount = if is_sliced == [false; 2] {
                    usize::MAX
                } else {
                    amount
                };
                for (count, is_its) in slices.iter_mut().zip(is_sliced) {
                    *count += usize::from(is_its);
                }
                if let Some(made) = making.advance(amount) {
                    break (slices, made.expect("room for spheres"));
                }
            }
        };
        let (all_at_once, whole) = made(usize::MAX);
        let (slices, same) = made(1);
        assert_eq!((whole.pool, whole.spheres), (same.pool, same.spheres));
        let most = mesh.triangles().len() / LOOKED_AT;
        assert_eq!(all_at_once, [1, 1]);
        assert!(
            slices[0] > 20 * most && slices[1] > most,
            "{slices:?} {most}"
        );
    }
}
