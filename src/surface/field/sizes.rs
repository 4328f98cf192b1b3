//! How large cells are to be, and how long.

use super::params::{Along, Amount, SurfaceSpot, Taper};
use super::{ASPECT_RANGE, SIZE_RANGE, SurfaceFieldParams};
use crate::order;
use crate::surface::TriMesh;
use crate::surface::curvature::Curvature;
use crate::surface::links::Links;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Rounds in which a size is found that gives the number of cells asked for.
const ROUNDS: usize = 6;

/// Sizes at the vertices, limited in their slope, in slices.
#[derive(Clone, Debug)]
pub(super) struct Sizes {
    /// The mean size.
    pub size: f64,
    /// At the vertices; none where they are all the same.
    pub values: Vec<f64>,
    open: BinaryHeap<Reverse<(u64, u32)>>,
}

/// The area of a cell of size 1 in a dense packing.
pub(super) fn cell_area(params: &SurfaceFieldParams) -> f64 {
    if params.kind.has_corners() {
        1.0
    } else {
        0.866_025_403_784_438_6
    }
}

/// The size asked for, as if it were the same everywhere.
pub(super) fn mean_size(params: &SurfaceFieldParams, mesh: &TriMesh) -> f64 {
    let size = match params.size.amount {
        Amount::Size(size) => size,
        Amount::Count(count) => (mesh.area() / (count.max(1.0) * cell_area(params))).sqrt(),
    };
    // No field makes more cells than anyone waits for, nor is it one of nothing.
    let least = 1e-4 * mesh.diagonal();
    if size.is_finite() {
        size.max(least)
    } else {
        least
    }
}

impl Sizes {
    /// The sizes as they are asked for. `along` tells of each vertex how far from head to tail it is by the bones.
    pub fn begin(
        params: &SurfaceFieldParams,
        mesh: &TriMesh,
        links: &Links,
        curvature: &[Curvature],
        along: &[f64],
    ) -> Self {
        let asked = &params.size;
        let mut sizes = Self {
            size: mean_size(params, mesh),
            values: Vec::new(),
            open: BinaryHeap::new(),
        };
        if asked.taper.is_none() && asked.curvature.is_none() && asked.spots.is_empty() {
            return sizes;
        }
        let fixed = factors(asked.taper, &asked.spots, mesh, along);
        let (lo, hi) = SIZE_RANGE;
        let value = |v: usize, size: f64| {
            let bent = asked.curvature.map_or(1.0, |by| {
                let factor = by.angle / (curvature[v].most() * size).max(1e-300);
                factor.clamp(by.factors.0, by.factors.1.max(by.factors.0))
            });
            size * (fixed[v] * bent).clamp(lo, hi)
        };
        if let Amount::Count(count) = asked.amount {
            for _ in 0..ROUNDS {
                let all = (0..links.len()).map(|v| value(v, sizes.size));
                let ratio = (cells(links, all) / cell_area(params) / count.max(1.0)).sqrt();
                sizes.size *= ratio;
                if (ratio - 1.0).abs() < 1e-3 {
                    break;
                }
            }
        }
        sizes.values = (0..links.len()).map(|v| value(v, sizes.size)).collect();
        if asked.curvature.is_some() || !asked.spots.is_empty() {
            let all = 0..links.len();
            let opens = all.filter(|&v| sizes.holds_down(v, mesh, links, asked.slope));
            let opens = opens.map(|v| Reverse((order::rank(sizes.values[v]), v as u32)));
            sizes.open = opens.collect();
        }
        sizes
    }

    fn holds_down(&self, v: usize, mesh: &TriMesh, links: &Links, slope: f64) -> bool {
        let at = mesh.positions();
        links.to[links.of(v)].iter().any(|&j| {
            let far = at[v].distance(at[j as usize]);
            self.values[v] + slope * far < self.values[j as usize]
        })
    }

    /// Settles the sizes of so many vertices, the smallest first, each at most a slope above its neighbours (Persson
    /// 2006, Mesh Size Functions for Implicit Geometries and PDE-Based Gradient Limiting); true when done.
    pub fn advance(
        &mut self,
        params: &SurfaceFieldParams,
        mesh: &TriMesh,
        links: &Links,
        amount: usize,
    ) -> bool {
        let at = mesh.positions();
        for _ in 0..amount.max(1) {
            let Some(Reverse((rank, v))) = self.open.pop() else {
                self.settle(params, links);
                return true;
            };
            let (v, own) = (v as usize, self.values[v as usize]);
            if rank > order::rank(own) {
                continue;
            }
            for &j in &links.to[links.of(v)] {
                let most = own + params.size.slope * at[v].distance(at[j as usize]);
                if most < self.values[j as usize] {
                    self.values[j as usize] = most;
                    self.open.push(Reverse((order::rank(most), j)));
                }
            }
        }
        false
    }

    /// The limit has made cells smaller: all larger again, so that there are as many as asked.
    fn settle(&mut self, params: &SurfaceFieldParams, links: &Links) {
        let Amount::Count(count) = params.size.amount else {
            return;
        };
        if self.values.is_empty() {
            return;
        }
        let all = self.values.iter().copied();
        let ratio = (cells(links, all) / cell_area(params) / count.max(1.0)).sqrt();
        self.size *= ratio;
        for value in &mut self.values {
            *value *= ratio;
        }
    }
}

/// The integral of 1 / size^2.
pub(super) fn cells(links: &Links, sizes: impl Iterator<Item = f64>) -> f64 {
    let each = links.mass.iter().zip(sizes);
    each.map(|(&mass, size)| mass / (size * size)).sum()
}

/// The factors of a taper and of spots that are multiplied.
fn factors(taper: Option<Taper>, spots: &[SurfaceSpot], mesh: &TriMesh, along: &[f64]) -> Vec<f64> {
    let mut logs = tapered(taper, mesh, along);
    for spot in spots {
        let log = libm::log(positive(spot.value));
        for (v, sum) in logs.iter_mut().enumerate() {
            *sum += log * share(spot, mesh, v);
        }
    }
    logs.into_iter().map(libm::exp).collect()
}

fn positive(x: f64) -> f64 {
    if x.is_finite() {
        x.clamp(1e-3, 1e3)
    } else {
        1.0
    }
}

/// Logarithms of the taper's factors.
fn tapered(taper: Option<Taper>, mesh: &TriMesh, along: &[f64]) -> Vec<f64> {
    let count = mesh.positions().len();
    let Some(taper) = taper else {
        return vec![0.0; count];
    };
    let (first, last) = (
        libm::log(positive(taper.first)),
        libm::log(positive(taper.last)),
    );
    let at = |t: f64| first + (last - first) * t;
    match taper.along {
        Along::Bones if along.is_empty() => vec![0.0; count],
        Along::Bones => along.iter().map(|&t| at(t)).collect(),
        Along::Axis(axis) => {
            let height = |v: usize| mesh.positions()[v].dot(axis);
            let each = || (0..count).map(height);
            let lo = each().fold(f64::INFINITY, f64::min);
            let hi = each().fold(f64::NEG_INFINITY, f64::max);
            let span = if hi > lo { hi - lo } else { 1.0 };
            each().map(|h| at((h - lo) / span)).collect()
        }
    }
}

/// A spot's share at a vertex: 1 in its middle, 0 from its radius on.
fn share(spot: &SurfaceSpot, mesh: &TriMesh, v: usize) -> f64 {
    let square = mesh.positions()[v].distance_squared(spot.at.at);
    let rest = 1.0 - square / (spot.radius * spot.radius);
    if rest.is_nan() || rest <= 0.0 {
        return 0.0;
    }
    // The other side of a thin sheet looks the other way.
    let facing = mesh.normals()[v].dot(spot.at.normal);
    rest * rest * (2.0 * (facing + 0.5)).clamp(0.0, 1.0)
}

/// Aspect ratios at the vertices; none where they are all the same.
pub(super) fn aspects(
    params: &SurfaceFieldParams,
    mesh: &TriMesh,
    curvature: &[Curvature],
    along: &[f64],
) -> Vec<f64> {
    let asked = &params.aspect;
    let plain = asked.taper.is_none() && asked.spots.is_empty() && !asked.by_curvature;
    if !params.kind.is_stretched() || plain {
        return Vec::new();
    }
    let base = libm::log(asked.aspect.clamp(ASPECT_RANGE.0, ASPECT_RANGE.1));
    let mut logs = tapered(asked.taper, mesh, along);
    for (v, log) in logs.iter_mut().enumerate() {
        *log += base;
        if asked.by_curvature {
            *log *= one_way(&curvature[v]);
        }
        for spot in &asked.spots {
            let value = libm::log(positive(spot.value));
            *log += (value - *log) * share(spot, mesh, v);
        }
    }
    let held = |log: f64| libm::exp(log).clamp(ASPECT_RANGE.0, ASPECT_RANGE.1);
    logs.into_iter().map(held).collect()
}

/// How much more a surface bends one way than the other, 0..1.
pub(super) fn one_way(curvature: &Curvature) -> f64 {
    let [(most, _), (least, _)] = curvature.principal();
    let (most, least) = (most.abs(), least.abs());
    if most + least > 0.0 {
        (most - least) / (most + least)
    } else {
        0.0
    }
}
