//! The pairs of cells that may touch, kept for several steps (Verlet 1967).

use super::body::MovingParticle;
use super::packing_domain::{MetricSpace, SpatialHash};
use super::shape::CellShape;
use crate::csr::Csr;
use glam::DVec2;

/// Margin of the neighbour list beyond the reach of forces, in sizes of the largest cell. The list is renewed when a
/// cell has moved by half the margin (Verlet 1967).
const VERLET_MARGIN: f64 = 0.25;

/// For each body, the bodies after it that it may touch.
#[derive(Clone, Debug)]
pub(super) struct NeighbourList<P> {
    /// For each body, its neighbours with higher numbers.
    pub near: Csr<u32>,
    /// The places of the bodies when the list was made.
    made_at: Vec<P>,
    margin: f64,
}

impl<P> Default for NeighbourList<P> {
    fn default() -> Self {
        Self {
            near: Csr::default(),
            made_at: Vec::new(),
            margin: 0.0,
        }
    }
}

impl<P: Copy> NeighbourList<P> {
    /// Invalidates the list after a change of the bodies.
    pub fn forget(&mut self) {
        self.made_at.clear();
    }

    /// Whether the neighbour list is still valid: no body has moved by half the margin.
    fn is_fresh<S: MetricSpace<Place = P>>(&self, bodies: &[MovingParticle<P>], metric: S) -> bool {
        let limit = 0.25 * self.margin * self.margin;
        let mut each = bodies.iter().zip(&self.made_at);
        self.made_at.len() == bodies.len()
            && each.all(|(body, &at)| !metric.has_left(at, body.particle.centre, limit))
    }

    /// Renews the neighbour list if it may be outdated; true if it was renewed. The bodies are first sorted
    /// by the grid's buckets, so that neighbours are close in memory, too.
    pub fn refresh<S: MetricSpace<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        metric: S,
        square_reach: f64,
    ) -> bool {
        if bodies.is_empty() || self.is_fresh(bodies, metric) {
            return false;
        }
        let (mut largest, mut longest, mut root) = (0.0_f64, 0.0_f64, 1.0_f64);
        for body in bodies.iter() {
            let shape = CellShape::of(&body.particle);
            largest = largest.max(shape.size);
            longest = longest.max(shape.length());
            root = root.max(shape.root);
        }
        let margin = VERLET_MARGIN * largest;
        // A move counts for more across a stretched cell than along it.
        self.margin = margin / root;
        let reach = square_reach * longest + margin;
        let grid = metric.grid_around(bodies.iter().map(|b| b.particle.centre), reach / 2.0);
        let firsts = sort_by_bucket(bodies, &grid);
        self.made_at = bodies.iter().map(|b| b.particle.centre).collect();
        let reaches = (reach, square_reach, margin);
        self.collect_pairs(bodies, metric, (&grid, &firsts), reaches);
        true
    }

    /// Collects the pairs that may touch. The bodies are sorted by bucket, so a range of buckets is a range of bodies.
    /// For each body, only bodies after it are tested.
    fn collect_pairs<S: MetricSpace<Place = P>>(
        &mut self,
        bodies: &[MovingParticle<P>],
        metric: S,
        (grid, firsts): (&S::Hash, &[u32]),
        (reach, square, margin): (f64, f64, f64),
    ) {
        self.near.clear();
        let mut near = Vec::new();
        let cells = bodies.iter().map(|b| &b.particle);
        let cells: Vec<_> = cells.map(|p| (p.centre, CellShape::of(p))).collect();
        for (i, &(centre, shape)) in cells.iter().enumerate() {
            for image in metric.images(centre, reach) {
                for run in grid.runs_near(image, reach) {
                    let end = firsts[run.end] as usize;
                    let first = (firsts[run.start] as usize).max(i + 1).min(end);
                    for (&(there, other), j) in cells[first..end].iter().zip(first..) {
                        let Some((r, turn)) = metric.log_from(image, there, reach) else {
                            continue;
                        };
                        if shape.may_touch(&other.seen(turn), r, (square, margin))
                            && !is_walled_off(&bodies[i], &bodies[j], r, metric)
                        {
                            near.push(j as u32);
                        }
                    }
                }
            }
            self.near.push(near.drain(..));
        }
    }

    /// The pairs that may touch, each once.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..self.made_at.len()).flat_map(|i| {
            let near = self.near.row(i).iter();
            near.map(move |&j| (i, j as usize))
        })
    }
}

/// Whether a wall separates two cells at offset `r`. A constraint line does not separate a pair with a fixed cell,
/// because that cell may stand on the line.
fn is_walled_off<S: MetricSpace>(
    body: &MovingParticle<S::Place>,
    other: &MovingParticle<S::Place>,
    r: DVec2,
    metric: S,
) -> bool {
    let (a, b) = (&body.particle, &other.particle);
    let sees_over = a.fixed || b.fixed;
    metric.is_gap_between(a.centre, b.centre) || (!sees_over && metric.crosses_line(a.centre, r))
}

/// Sorts bodies by bucket, and within a bucket by id. Gives the start of each bucket.
fn sort_by_bucket<P: Copy>(
    bodies: &mut [MovingParticle<P>],
    grid: &impl SpatialHash<P>,
) -> Vec<u32> {
    let buckets = bodies.iter().map(|b| grid.bucket(b.particle.centre));
    let buckets: Vec<usize> = buckets.collect();
    // Sorts the bodies' numbers, because bodies are large.
    let mut order = Csr::from_pairs(grid.buckets(), buckets.iter().copied().zip(0..));
    for bucket in 0..grid.buckets() {
        let row = order.row_mut(bucket);
        row.sort_unstable_by_key(|&k: &u32| bodies[k as usize].particle.id);
    }
    let (firsts, order) = order.into_parts();
    let sorted: Vec<_> = order.iter().map(|&k| bodies[k as usize]).collect();
    bodies.copy_from_slice(&sorted);
    firsts
}
