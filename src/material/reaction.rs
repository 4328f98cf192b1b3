//! A reaction-diffusion system on the graph of the cells.
//!
//! Turk (1991), Generating Textures on Arbitrary Surfaces Using Reaction-Diffusion; Witkin and Kass (1991),
//! Reaction-Diffusion Textures. An activator u produces itself and an inhibitor v that spreads twenty times
//! as fast (Turing 1952, with the cubic term of FitzHugh 1961 and Nagumo 1962):
//!
//! du/dt = Du Lu + r (u - u^3 - v + k),   dv/dt = Dv Lv + r (3 u - 2 v),
//!
//! where L is the mean of the neighbours minus the own value. Around u = v = 0 waves grow fastest at Dv L =
//! -r sqrt(Dv / Du), so the rate r sets the pattern's scale. If that is many cells, the pattern is computed
//! on a thinned graph first and refined from graph to graph.
//!
//! Thinning begins where a wave is longer than eight cells: the cost on a single graph would grow with the
//! square of the scale.

use crate::csr::NONE;
use crate::order::{greater, lesser};
use crate::random::{Purpose, Random};

/// Diffusion of the inhibitor, and of the activator relative to it.
const SPREAD: f64 = 0.8;
const RATIO: f64 = 0.05;
/// The value of k that marks all cells.
const FEED: f64 = 0.17;
/// Growth rate of the fastest wave, relative to r, and the exponent up to which it grows.
const GROWTH: f64 = 0.336;
const GROWTHS: f64 = 16.0;
/// Most steps on the thinnest graph, and steps on each finer one.
const MOST_STEPS: f64 = 2500.0;
const REFINING: usize = 120;
/// The graph is thinned where a wave is longer than this, in edges, and it has more nodes than that.
const COARSE: f64 = 8.0;
const FEWEST: usize = 60;

/// One graph of the hierarchy.
struct GraphLevel {
    /// The start of each node's neighbours in `to`, and the end of the last one's.
    starts: Vec<u32>,
    to: Vec<u32>,
    /// For each node, the node of the next thinner graph that represents it.
    parents: Vec<u32>,
    /// The rate r.
    rate: f64,
}

/// The system in progress.
pub(crate) struct Reaction {
    levels: Vec<GraphLevel>,
    feed: f64,
    u: Vec<f64>,
    v: Vec<f64>,
    next: Vec<f64>,
    spread: Vec<f64>,
    /// Steps left on the current graph, the last of `levels`.
    left: usize,
}

impl Reaction {
    /// The initial system, random by the cells' `ids`. `square` gives the squared distance between two cells
    /// by index, `scale` is the wavelength in the same units, `share` the share of the area where u is high.
    /// Distances below `unit` count as this.
    pub fn new(
        mut ids: Vec<u32>,
        mut links: Vec<Vec<u32>>,
        square: impl Fn(u32, u32) -> f64,
        (scale, unit): (f64, f64),
        share: f64,
        seed: u64,
    ) -> Self {
        let mut places: Vec<u32> = (0..ids.len() as u32).collect();
        let mut levels = Vec::new();
        loop {
            let mean = mean_square(&square, unit, &places, &links);
            let wave = scale / mean.sqrt();
            let thin = wave > COARSE && places.len() > FEWEST;
            let (kept, parents) = if thin {
                thinned(&square, &places, &links)
            } else {
                (Vec::new(), Vec::new())
            };
            levels.push(GraphLevel::new(&links, parents, wave));
            if kept.is_empty() || kept.len() == places.len() {
                break;
            }
            links = joined(&links, &levels[levels.len() - 1].parents, kept.len());
            places = kept.iter().map(|&k| places[k as usize]).collect();
            ids = kept.iter().map(|&k| ids[k as usize]).collect();
        }
        let start = |&id: &u32| 0.1 * Random::new(seed, Purpose::Pattern, id.into()).signed();
        let rate = levels.last().map_or(1.0, |level| level.rate);
        Self {
            levels,
            feed: FEED * (2.0 * share - 1.0),
            u: ids.iter().map(start).collect(),
            v: vec![0.0; ids.len()],
            next: Vec::new(),
            spread: Vec::new(),
            left: lesser(GROWTHS / (GROWTH * rate), MOST_STEPS) as usize,
        }
    }

    /// Does the work of about `count` cells; true when the pattern is finished.
    pub fn advance(&mut self, count: usize) -> bool {
        let mut done = 0;
        while done < count {
            if self.left == 0 {
                if self.levels.len() < 2 {
                    return true;
                }
                self.refine();
            }
            self.step();
            // A step costs much less for each cell than finding its neighbours.
            done += self.u.len() / 16 + 1;
        }
        false
    }

    /// The activator of each cell.
    pub fn finish(self) -> Vec<f64> {
        self.u
    }

    fn step(&mut self) {
        let Some(level) = self.levels.last() else {
            return;
        };
        let rate = level.rate;
        let (u, v) = (&mut self.u, &mut self.v);
        level.laplacian(u, &mut self.next);
        for (k, next) in self.next.iter_mut().enumerate() {
            let (a, b) = (u[k], v[k]);
            *next = a + SPREAD * RATIO * *next + rate * (a - a * a * a - b + self.feed);
        }
        std::mem::swap(u, &mut self.next);
        // `next` holds the activator before the step.
        level.laplacian(v, &mut self.spread);
        for (k, b) in v.iter_mut().enumerate() {
            *b += SPREAD * self.spread[k] + rate * (3.0 * self.next[k] - 2.0 * *b);
        }
        self.left -= 1;
    }

    /// Goes to the next finer graph: each node takes the mean of the representatives of itself and of its
    /// neighbours.
    fn refine(&mut self) {
        self.levels.pop();
        let Some(level) = self.levels.last() else {
            return;
        };
        for values in [&mut self.u, &mut self.v] {
            let of = |k: usize| values[level.parents[k] as usize];
            let finer = (0..level.parents.len()).map(|k| {
                let around: f64 = level.links(k).map(of).sum();
                (of(k) + around) / (level.links(k).len() + 1) as f64
            });
            let finer: Vec<f64> = finer.collect();
            *values = finer;
        }
        self.left = REFINING;
    }
}

impl GraphLevel {
    fn new(links: &[Vec<u32>], parents: Vec<u32>, wave: f64) -> Self {
        let mut starts = vec![0];
        let mut to: Vec<u32> = Vec::new();
        for list in links {
            to.extend(list);
            starts.push(to.len() as u32);
        }
        // L of a wave, on edges with mean square 1, is a quarter of its squared wave number.
        let turn = std::f64::consts::TAU / greater(wave, 1.0);
        let fastest = lesser(0.25 * turn * turn, 1.0);
        Self {
            starts,
            to,
            parents,
            rate: fastest * SPREAD * RATIO.sqrt(),
        }
    }

    fn links(&self, k: usize) -> impl ExactSizeIterator<Item = usize> {
        let (from, to) = (self.starts[k] as usize, self.starts[k + 1] as usize);
        self.to[from..to].iter().map(|&j| j as usize)
    }

    /// L: the mean of the neighbours minus the own value.
    fn laplacian(&self, values: &[f64], out: &mut Vec<f64>) {
        out.clear();
        for (k, &own) in values.iter().enumerate() {
            let links = self.links(k);
            let count = links.len().max(1) as f64;
            let sum: f64 = links.map(|j| values[j] - own).sum();
            out.push(sum / count);
        }
    }
}

/// The mean squared length of the edges.
fn mean_square(
    square: &impl Fn(u32, u32) -> f64,
    unit: f64,
    places: &[u32],
    links: &[Vec<u32>],
) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for (list, &place) in links.iter().zip(places) {
        for &j in list {
            sum += square(place, places[j as usize]);
            count += 1.0;
        }
    }
    greater(sum / greater(count, 1.0), unit * unit)
}

/// The nodes of a thinner graph, no two of them neighbours, and for each node its representative: the nearest
/// one among its neighbours.
fn thinned(
    square: &impl Fn(u32, u32) -> f64,
    places: &[u32],
    links: &[Vec<u32>],
) -> (Vec<u32>, Vec<u32>) {
    let mut kept = Vec::new();
    let mut parents = vec![NONE; places.len()];
    for (k, list) in links.iter().enumerate() {
        if list.iter().all(|&j| parents[j as usize] == NONE) {
            parents[k] = kept.len() as u32;
            kept.push(k as u32);
        }
    }
    let own = parents.clone();
    for (k, list) in links.iter().enumerate() {
        let mut nearest = f64::MAX;
        for &j in list.iter().filter(|_| own[k] == NONE) {
            let far = square(places[k], places[j as usize]);
            // Up to rounding, the first of two equally near ones.
            if own[j as usize] != NONE && far < 0.99 * nearest {
                nearest = far;
                parents[k] = own[j as usize];
            }
        }
    }
    (kept, parents)
}

/// The edges of a thinner graph: between the representatives of neighbours.
fn joined(links: &[Vec<u32>], parents: &[u32], count: usize) -> Vec<Vec<u32>> {
    let mut joined = vec![Vec::new(); count];
    for (k, list) in links.iter().enumerate() {
        for &j in list {
            let (from, to) = (parents[k], parents[j as usize]);
            let known: &mut Vec<u32> = &mut joined[from as usize];
            if from != to && !known.contains(&to) {
                known.push(to);
            }
        }
    }
    joined
}
