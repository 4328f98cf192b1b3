//! Sizes and aspect ratios of cells.

use super::SurfaceFieldParams;
use super::bones::BoneSource;
use super::params::{Along, Amount, SurfaceSpot, Taper};
use crate::field::CellKind;
use crate::field::{ASPECT_RANGE, SIZE_RANGE};
use crate::order;
use crate::trimesh::TriMesh;
use crate::trimesh::adjacency::Adjacency;
use crate::trimesh::curvature::Curvature;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The most rounds to find the size that gives the wanted number of cells.
const ROUNDS: usize = 6;

/// Computes sizes and aspect ratios at the vertices, in slices.
#[derive(Clone, Debug)]
pub(super) struct Sizes {
    /// The mean size.
    pub size: f64,
    /// Sizes at the vertices; empty if they are the same everywhere.
    pub values: Vec<f64>,
    /// Aspect ratios at the vertices; empty if they are the same everywhere.
    pub aspects: Vec<f64>,
    /// Factors that do not depend on the mean size.
    factors: Vec<f64>,
    step: SizesPhase,
    at: usize,
    round: usize,
    sum: f64,
    open: BinaryHeap<Reverse<(u64, u32)>>,
    /// The ranges of the tapers of size and aspect ratio.
    spans: [Span; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum SizesPhase {
    Aspects,
    Factors,
    Count,
    Values,
    Open,
    Limit,
    Recount,
    Rescale,
    Done,
}

/// The inputs of sizes.
#[derive(Clone, Copy)]
pub(super) struct SizeInputs<'a> {
    pub params: &'a SurfaceFieldParams,
    pub mesh: &'a TriMesh,
    pub links: &'a Adjacency,
    pub curvature: &'a [Curvature],
    /// The constraint of the bones at each vertex; empty if nothing depends on them.
    pub heard: &'a [BoneSource],
}

/// The area of a cell of size 1 in a dense packing.
pub(super) fn cell_area(kind: CellKind) -> f64 {
    if kind.has_corners() {
        1.0
    } else {
        0.866_025_403_784_438_6
    }
}

/// The mean size, as if sizes were the same everywhere.
pub(super) fn mean_size(params: &SurfaceFieldParams, mesh: &TriMesh) -> f64 {
    let size = match params.size.amount {
        Amount::Size(size) => size,
        Amount::Count(count) => (mesh.area() / (count.max(1.0) * cell_area(params.kind))).sqrt(),
    };
    // A lower bound keeps the count of cells finite, for bad numbers, too.
    let least = 1e-4 * mesh.diagonal();
    if size.is_finite() {
        size.max(least)
    } else {
        least
    }
}

impl Sizes {
    /// Starts with no work done.
    pub fn begin(ground: SizeInputs) -> Self {
        let SizeInputs { params, mesh, .. } = ground;
        Self {
            size: mean_size(params, mesh),
            values: Vec::new(),
            aspects: Vec::new(),
            factors: Vec::new(),
            step: SizesPhase::Aspects,
            at: 0,
            round: 0,
            sum: 0.0,
            open: BinaryHeap::new(),
            spans: [params.size.taper, params.aspect.taper].map(|t| Span::new(t, mesh)),
        }
    }

    /// Works on at most `amount` vertices; true when done.
    pub fn advance(&mut self, ground: SizeInputs, amount: usize) -> bool {
        match self.step {
            SizesPhase::Aspects if !varies_aspect(ground.params) => self.step = SizesPhase::Factors,
            SizesPhase::Factors if !varies_size(ground.params) => self.step = SizesPhase::Done,
            SizesPhase::Limit => self.limit(ground, amount),
            SizesPhase::Done => {}
            _ => {
                let end = ground
                    .links
                    .len()
                    .min(self.at.saturating_add(amount.max(1)));
                for v in self.at..end {
                    self.vertex(ground, v);
                }
                self.at = end;
                if end == ground.links.len() {
                    self.at = 0;
                    self.next(ground.params);
                }
            }
        }
        self.step == SizesPhase::Done
    }

    fn vertex(&mut self, ground: SizeInputs, v: usize) {
        let params = &ground.params.size;
        match self.step {
            SizesPhase::Aspects => {
                let aspect = aspect(ground, &self.spans[1], v);
                self.aspects.push(aspect);
            }
            SizesPhase::Factors => {
                let mut log = self.spans[0].log(ground, v);
                for spot in &params.spots {
                    log += libm::log(positive(spot.value)) * share(spot, ground.mesh, v);
                }
                self.factors.push(libm::exp(log));
            }
            SizesPhase::Count => {
                let size = self.wanted(ground, v);
                self.sum += ground.links.mass[v] / (size * size);
            }
            SizesPhase::Values => {
                let size = self.wanted(ground, v);
                self.values.push(size);
            }
            SizesPhase::Open => {
                if self.holds_down(v, ground) {
                    let rank = order::rank(self.values[v]);
                    self.open.push(Reverse((rank, v as u32)));
                }
            }
            SizesPhase::Recount => {
                self.sum += ground.links.mass[v] / (self.values[v] * self.values[v])
            }
            SizesPhase::Rescale => self.values[v] *= self.sum,
            SizesPhase::Limit | SizesPhase::Done => {}
        }
    }

    fn next(&mut self, params: &SurfaceFieldParams) {
        let asked = match params.size.amount {
            Amount::Count(count) => Some(count.max(1.0) * cell_area(params.kind)),
            Amount::Size(_) => None,
        };
        self.step = match (self.step, asked) {
            (SizesPhase::Aspects, _) => SizesPhase::Factors,
            (SizesPhase::Factors, Some(_)) => SizesPhase::Count,
            (SizesPhase::Factors, None) => SizesPhase::Values,
            (SizesPhase::Count, Some(asked)) => {
                let ratio = (std::mem::take(&mut self.sum) / asked).sqrt();
                self.size *= ratio;
                self.round += 1;
                let close = (ratio - 1.0).abs() < 1e-3 || self.round == ROUNDS;
                if close {
                    SizesPhase::Values
                } else {
                    SizesPhase::Count
                }
            }
            (SizesPhase::Values, _)
                if params.size.curvature.is_none() && params.size.spots.is_empty() =>
            {
                SizesPhase::Done
            }
            (SizesPhase::Values, _) => SizesPhase::Open,
            (SizesPhase::Open, _) => SizesPhase::Limit,
            (SizesPhase::Recount, Some(asked)) => {
                // The limit of the slope has made cells smaller: scale all up again, to get the wanted number.
                self.sum = (self.sum / asked).sqrt();
                self.size *= self.sum;
                SizesPhase::Rescale
            }
            _ => SizesPhase::Done,
        };
    }

    /// The size at a vertex before the slope is limited.
    fn wanted(&self, ground: SizeInputs, v: usize) -> f64 {
        let bent = ground.params.size.curvature.map_or(1.0, |by| {
            let angle = ground.curvature[v].most() * self.size;
            (by.angle / angle.max(1e-300)).clamp(by.factors.0, by.factors.1.max(by.factors.0))
        });
        self.size * (self.factors[v] * bent).clamp(SIZE_RANGE.0, SIZE_RANGE.1)
    }

    fn holds_down(&self, v: usize, ground: SizeInputs) -> bool {
        let (at, slope) = (ground.mesh.positions(), ground.params.size.slope);
        ground.links.to[ground.links.of(v)].iter().any(|&j| {
            let far = at[v].distance(at[j as usize]);
            self.values[v] + slope * far < self.values[j as usize]
        })
    }

    /// Limits the slope at up to `amount` vertices, from the smallest size up: each is at most a slope above its
    /// neighbours (Persson 2006, Mesh Size Functions for Implicit Geometries and PDE-Based Gradient Limiting).
    fn limit(&mut self, ground: SizeInputs, amount: usize) {
        let (at, slope) = (ground.mesh.positions(), ground.params.size.slope);
        for _ in 0..amount.max(1) {
            let Some(Reverse((rank, v))) = self.open.pop() else {
                let counted = matches!(ground.params.size.amount, Amount::Count(_));
                self.step = if counted {
                    SizesPhase::Recount
                } else {
                    SizesPhase::Done
                };
                return;
            };
            let (v, own) = (v as usize, self.values[v as usize]);
            if rank > order::rank(own) {
                continue;
            }
            for &j in &ground.links.to[ground.links.of(v)] {
                let most = own + slope * at[v].distance(at[j as usize]);
                if most < self.values[j as usize] {
                    self.values[j as usize] = most;
                    self.open.push(Reverse((order::rank(most), j)));
                }
            }
        }
    }
}

fn varies_size(params: &SurfaceFieldParams) -> bool {
    let size = &params.size;
    size.taper.is_some() || size.curvature.is_some() || !size.spots.is_empty()
}

fn varies_aspect(params: &SurfaceFieldParams) -> bool {
    let aspect = &params.aspect;
    let varies = aspect.taper.is_some() || aspect.by_curvature || !aspect.spots.is_empty();
    varies && params.kind.is_stretched()
}

fn positive(x: f64) -> f64 {
    if x.is_finite() {
        x.clamp(1e-3, 1e3)
    } else {
        1.0
    }
}

/// A taper and the heights between which it runs.
#[derive(Clone, Copy, Debug)]
struct Span {
    taper: Option<Taper>,
    lowest: f64,
    height: f64,
}

impl Span {
    fn new(taper: Option<Taper>, mesh: &TriMesh) -> Self {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        if let Some(Taper {
            along: Along::Axis(axis),
            ..
        }) = taper
        {
            for p in mesh.positions() {
                (lo, hi) = (lo.min(p.dot(axis)), hi.max(p.dot(axis)));
            }
        }
        Self {
            taper,
            lowest: lo,
            height: if hi > lo { hi - lo } else { 1.0 },
        }
    }

    /// The logarithm of the factor at a vertex.
    fn log(&self, ground: SizeInputs, v: usize) -> f64 {
        let Some(taper) = self.taper else {
            return 0.0;
        };
        let t = match taper.along {
            Along::Bones => ground.heard.get(v).map(|h| h.along),
            Along::Axis(axis) => {
                Some((ground.mesh.positions()[v].dot(axis) - self.lowest) / self.height)
            }
        };
        let (first, last) = (
            libm::log(positive(taper.first)),
            libm::log(positive(taper.last)),
        );
        t.map_or(0.0, |t| first + (last - first) * t)
    }
}

/// The share of a spot at a vertex: 1 in its middle, 0 from its radius on.
fn share(spot: &SurfaceSpot, mesh: &TriMesh, v: usize) -> f64 {
    let square = mesh.positions()[v].distance_squared(spot.at.at);
    let rest = 1.0 - square / (spot.radius * spot.radius);
    if rest.is_nan() || rest <= 0.0 {
        return 0.0;
    }
    // No share on the other side of a thin sheet, which faces away.
    let facing = mesh.normals()[v].dot(spot.at.normal);
    rest * rest * (2.0 * (facing + 0.5)).clamp(0.0, 1.0)
}

/// The aspect ratio at a vertex.
fn aspect(ground: SizeInputs, span: &Span, v: usize) -> f64 {
    let asked = &ground.params.aspect;
    let base = asked.aspect.clamp(ASPECT_RANGE.0, ASPECT_RANGE.1);
    let mut log = libm::log(base) + span.log(ground, v);
    if asked.by_curvature {
        log *= one_way(&ground.curvature[v]);
    }
    for spot in &asked.spots {
        let value = libm::log(positive(spot.value));
        log += (value - log) * share(spot, ground.mesh, v);
    }
    libm::exp(log).clamp(ASPECT_RANGE.0, ASPECT_RANGE.1)
}

/// How much more a surface is curved one way than the other, 0..1.
pub(super) fn one_way(curvature: &Curvature) -> f64 {
    let [(most, _), (least, _)] = curvature.principal();
    let (most, least) = (most.abs(), least.abs());
    if most + least > 0.0 {
        (most - least) / (most + least)
    } else {
        0.0
    }
}
