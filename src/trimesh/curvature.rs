//! Curvature of a triangle mesh.

use super::adjacency::{Adjacency, carried};
use super::{SurfacePoint, TangentFrame, TriMesh};
use crate::field::symmetry::direction_of;
use glam::DVec2;

/// The shape operator S at a place, in the frame of its normal n: along a step dx the normal changes by S dx. S is
/// positive on a ball seen from outside. The unit of curvatures is 1 / length.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Curvature {
    /// The mean of the two principal curvatures.
    pub mean: f64,
    /// Half the difference of the principal curvatures, as a vector at twice the angle of the direction of the
    /// greater one.
    pub bend: DVec2,
}

impl Curvature {
    /// The change of the normal along a step.
    pub fn along(&self, step: DVec2) -> DVec2 {
        let Self { mean, bend } = *self;
        DVec2::new(
            (mean + bend.x) * step.x + bend.y * step.y,
            bend.y * step.x + (mean - bend.x) * step.y,
        )
    }

    /// The principal curvatures with unit vectors of their directions, at right angles. The one with the greater
    /// absolute value comes first; both have their signs. Where both are equal, the directions are arbitrary.
    pub fn principal(&self) -> [(f64, DVec2); 2] {
        let half = self.bend.length();
        let first = direction_of(self.bend.try_normalize().unwrap_or(DVec2::X), 2);
        let [high, low] = [(self.mean + half, first), (self.mean - half, first.perp())];
        if self.mean >= 0.0 {
            [high, low]
        } else {
            [low, high]
        }
    }

    /// The greatest absolute curvature in any direction.
    pub fn most(&self) -> f64 {
        self.mean.abs() + self.bend.length()
    }
}

/// Standard deviation of the averaging along each axis, in sizes of cells.
const REACH: f64 = 0.35;
/// Bounds of the number of rounds of averaging.
const ROUNDS: (f64, f64) = (3.0, 24.0);

/// Curvatures at the vertices of a mesh: a least squares fit to the normals of each vertex' neighbours (Rusinkiewicz
/// 2004, Estimating Curvatures and Their Derivatives on Triangle Meshes, here by vertices), averaged over about a
/// cell.
#[derive(Clone, Debug)]
pub(crate) struct Curvatures {
    pub values: Vec<Curvature>,
    other: Vec<Curvature>,
    pub rounds: usize,
    round: usize,
}

impl Curvatures {
    /// Starts the work; values will be averaged over about a cell of this size.
    pub fn begin(mesh: &TriMesh, links: &Adjacency, size: f64) -> Self {
        // In one round half of each value goes to the neighbours, which spreads it by a quarter of their squared
        // distance along each axis.
        let rounds = REACH * REACH * size * size / (0.25 * links.mean_square(mesh));
        let rounds = rounds.clamp(ROUNDS.0, ROUNDS.1);
        Self {
            values: Vec::with_capacity(links.len()),
            other: Vec::with_capacity(links.len()),
            rounds: rounds.ceil() as usize,
            round: 0,
        }
    }

    /// Works on at most `amount` vertices; true when all are done.
    pub fn advance(&mut self, mesh: &TriMesh, links: &Adjacency, amount: usize) -> bool {
        if self.values.len() < links.len() {
            let end = links
                .len()
                .min(self.values.len().saturating_add(amount.max(1)));
            for v in self.values.len()..end {
                self.values.push(fitted(mesh, links, v));
            }
            return false;
        }
        if self.round == self.rounds {
            return true;
        }
        let end = links
            .len()
            .min(self.other.len().saturating_add(amount.max(1)));
        for v in self.other.len()..end {
            let mean = self.averaged(links, v);
            self.other.push(mean);
        }
        if end == links.len() {
            std::mem::swap(&mut self.values, &mut self.other);
            self.other.clear();
            self.round += 1;
        }
        self.round == self.rounds
    }

    fn averaged(&self, links: &Adjacency, v: usize) -> Curvature {
        let own = self.values[v];
        let (mut mean, mut bend, mut weight) = (0.0, DVec2::ZERO, 0.0);
        for e in links.of(v) {
            let other = links.to[e] as usize;
            let (from, mass, turn) = (self.values[other], links.mass[other], links.turn[e]);
            mean += mass * from.mean;
            bend += mass * from.bend.rotate(turn).rotate(turn);
            weight += mass;
        }
        if weight == 0.0 {
            return own;
        }
        Curvature {
            mean: 0.5 * (own.mean + mean / weight),
            bend: 0.5 * (own.bend + bend / weight),
        }
    }
}

/// Fits S at a vertex to the differences between its normal and those of its neighbours.
fn fitted(mesh: &TriMesh, links: &Adjacency, v: usize) -> Curvature {
    let frame = &links.frames[v];
    let (at, normals) = (mesh.positions(), mesh.normals());
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    let (mut x_x, mut x_y, mut y_y) = (0.0, 0.0, 0.0);
    for &other in &links.to[links.of(v)] {
        let step = frame.within(at[other as usize] - at[v]);
        let change = frame.within(normals[other as usize] - frame.normal);
        let square = step.length_squared();
        if square == 0.0 {
            continue;
        }
        let weight = 1.0 / square;
        xx += weight * step.x * step.x;
        xy += weight * step.x * step.y;
        yy += weight * step.y * step.y;
        x_x += weight * step.x * change.x;
        y_y += weight * step.y * change.y;
        x_y += weight * (step.y * change.x + step.x * change.y);
    }
    let trace = xx + yy;
    if trace == 0.0 {
        return Curvature::default();
    }
    let (a, b) = (xx + 1e-9 * trace, yy + 1e-9 * trace);
    let pivot = trace - xy * xy / a - xy * xy / b;
    if pivot < 1e-4 * trace {
        // All neighbours lie on one line, as at a corner of the border: only the mean can be fitted.
        return Curvature {
            mean: (x_x + y_y) / trace,
            bend: DVec2::ZERO,
        };
    }
    let mixed = (x_y - xy * x_x / a - xy * y_y / b) / pivot;
    let (first, second) = ((x_x - mixed * xy) / a, (y_y - mixed * xy) / b);
    Curvature {
        mean: 0.5 * (first + second),
        bend: DVec2::new(0.5 * (first - second), mixed),
    }
}

/// The curvature at a point, interpolated between the corners of its triangle.
pub(crate) fn interpolated(values: &[Curvature], mesh: &TriMesh, p: &SurfacePoint) -> Curvature {
    let frame = p.frame();
    let weights = p.weights(mesh).to_array();
    let corners = mesh.triangles()[p.triangle as usize];
    let mut sum = Curvature::default();
    for (v, weight) in corners.into_iter().zip(weights) {
        let (value, from) = (
            values[v as usize],
            TangentFrame::of(mesh.normals()[v as usize]),
        );
        let turn = frame.within(carried(from.x, from.normal, frame.normal));
        let turn = turn.normalize_or(DVec2::X);
        sum.mean += weight * value.mean;
        sum.bend += weight * value.bend.rotate(turn).rotate(turn);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::super::samples;
    use super::*;
    use glam::DVec3;

    fn curvatures(mesh: &TriMesh, size: f64) -> Vec<Curvature> {
        let links = Adjacency::build(mesh);
        let mut work = Curvatures::begin(mesh, &links, size);
        while !work.advance(mesh, &links, 100) {}
        work.values
    }

    fn quantile(mut errors: Vec<f64>, share: f64) -> f64 {
        crate::order::sort(&mut errors, |&e| (crate::order::rank(e), 0));
        errors[(share * (errors.len() - 1) as f64) as usize]
    }

    #[test]
    fn a_ball_bends_alike_everywhere() {
        let mesh = samples::ball(4);
        for c in curvatures(&mesh, 0.2) {
            assert!((c.mean - 1.0).abs() < 0.01, "{c:?}");
            assert!(c.bend.length() < 0.01, "{c:?}");
        }
    }

    #[test]
    fn a_torus_bends_as_its_formula_says() {
        let mesh = samples::torus(120, 48);
        let values = curvatures(&mesh, 0.1);
        for (v, c) in values.iter().enumerate() {
            let p = mesh.positions()[v];
            let r = (p.x * p.x + p.z * p.z).sqrt();
            // Expected: 1 / 0.4 around the tube, cos b / r along it.
            let around = (r - 1.0) / 0.4 / r;
            let [(most, _), (least, direction)] = c.principal();
            assert!((most - 2.5).abs() < 0.05, "{most}");
            assert!((least - around).abs() < 0.05, "{least} {around}");
            let frame = TangentFrame::of(mesh.normals()[v]);
            let along = DVec3::new(-p.z, 0.0, p.x) / r;
            assert!(frame.out(direction).dot(along).abs() > 0.999);
            let step = c.along(direction) - least * direction;
            assert!(step.length() < 1e-9);
            assert!((c.most() - most).abs() < 1e-9);
        }
        // Interpolation in the middle of a triangle agrees with its corners.
        let p = SurfacePoint::new(&mesh, 7, DVec3::splat(1.0 / 3.0));
        let c = interpolated(&values, &mesh, &p);
        assert!((c.most() - 2.5).abs() < 0.05);
    }

    #[test]
    fn noise_is_averaged_away() {
        // Edges are 0.08 long; the noise is up to a third of that.
        let noisy = samples::noisy(&samples::torus(80, 32), 0.025);
        let errors = |size: f64| {
            let values = curvatures(&noisy, size);
            quantile(values.iter().map(|c| (c.most() - 2.5).abs()).collect(), 0.5)
        };
        let (near, far) = (errors(0.01), errors(0.4));
        assert!(far < 0.3 && far < 0.8 * near, "{near} {far}");
    }

    #[test]
    fn a_saddle_bends_both_ways() {
        let saddle = samples::moved(&samples::flat(40), |_, p| {
            let (x, z) = (p.x - 0.5, p.z + 0.5);
            DVec3::new(x, 0.5 * (x * x - z * z), z)
        });
        let values = curvatures(&saddle, 0.05);
        let c = values[20 * 41 + 20];
        assert!(
            c.mean.abs() < 0.02 && (c.bend.length() - 1.0).abs() < 0.03,
            "{c:?}"
        );
    }
}
