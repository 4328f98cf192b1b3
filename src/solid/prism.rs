//! The prism of a cell of skin.
//!
//! Itoh, Miyata, Shimada (2003), Generation of Organic Textures with Controlled Anisotropy and Directionality
//! via Packing Rectangular and Elliptical Cells, section 6.1: the cell's polygon is scaled by Sv and swept by
//! SkinSize x Sr. The corners of the top are displaced at random within SkinSize x Dr, by Sc along the flow,
//! and by Tc (w - v) towards the centre w from the corner v of the base. The flow's length is the skin size,
//! so Sc counts in skin sizes as Sr does. The tilt of the top is an addition: tops that are only skewed lie
//! in one plane, and tiles of a roof do not.
//!
//! ```text
//!    base: n points      top: n points      the top's middle
//!    2 n triangles around the sides, n over the top; the base is open
//! ```

use super::footprint::Footprint;
use super::{Distribution, StoneKind, StoneParams};
use crate::cells::Cell;
use crate::planar::unit_vector;
use crate::random::{Purpose, Random};
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::{PI, TAU};

/// Normal random numbers are limited to this, so that no cell is torn.
const MOST_NORMAL: f64 = 2.5;

/// Largest distance of a corner from the centre, relative to the mean distance.
const FARTHEST: f64 = 2.0;

/// The shape of a cell of skin. Lengths are relative to the skin size: the mean distance of the cell's
/// corners from its centre (Itoh, Miyata, Shimada 2003, section 6.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkinParams {
    /// Height of the swept prism (Sr).
    pub sweep: f64,
    /// Displacement of the top along the flow (Sc).
    pub skew: f64,
    /// Angle from the flow to the displacement of the top, clockwise, in radians.
    pub skew_angle: f64,
    /// Rise of the top along the flow, for each unit of length.
    pub tilt: f64,
    /// Displacement of the top corners towards the centre, 0..1 (Tc).
    pub taper: f64,
    /// The shape of the faces: from rounded as after subdivision (0) to flat as those of the prism (1).
    pub flatness: f64,
    /// Height of the ridge along the flow, relative to the prism's height, 0..1.
    pub keel: f64,
    /// Number of growth rings.
    pub rings: u32,
    /// Fractal dimension of the noise, 1..2 (Fd). The noise of stones is added to the planes instead.
    pub dimension: f64,
    /// Amplitude of the noise (Af).
    pub amplitude: f64,
}

impl SkinParams {
    /// Upright prisms, a little tapered.
    pub const DEFAULT: Self = Self {
        sweep: 1.0,
        skew: 0.0,
        skew_angle: 0.0,
        tilt: 0.0,
        taper: 0.2,
        flatness: 0.0,
        keel: 0.0,
        rings: 0,
        dimension: 1.1,
        amplitude: 0.1,
    };

    /// The same parameters with a top that neither leans nor rises.
    pub fn upright(self) -> Self {
        Self {
            skew: 0.0,
            tilt: 0.0,
            ..self
        }
    }
}

impl Default for SkinParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// A prism in picture units, y down, z up from the base level.
#[derive(Clone, Debug, PartialEq)]
pub struct Prism {
    /// The scaled corners of the cell's polygon, clockwise on screen.
    pub base: Vec<DVec2>,
    /// The corner above each corner of the base.
    pub top: Vec<DVec3>,
    /// The mean of the top's corners.
    pub middle: DVec3,
    /// Mean distance of the cell's corners from its centre.
    pub skin_size: f64,
}

impl Prism {
    /// The prism over a polygon with the centre `w`. `flow` is the unit vector in which skewed tops lean, or
    /// zero for upright ones. `id` seeds the random numbers.
    pub fn new(polygon: &[DVec2], w: DVec2, flow: DVec2, params: &StoneParams, id: u32) -> Self {
        let skin = &params.skin;
        let n = polygon.len().max(1) as f64;
        let skin_size = polygon.iter().map(|&p| (p - w).length()).sum::<f64>() / n;
        let base: Vec<DVec2> = polygon
            .iter()
            .map(|&p| w + (p - w) * params.scale)
            .collect();
        let way = turned(flow, skin.skew_angle);
        let lean = way * skin.skew * skin_size;
        let mut random = Random::new(params.seed, Purpose::Distortion, u64::from(id));
        let top: Vec<DVec3> = base
            .iter()
            .map(|&v| {
                let height = skin_size * skin.sweep + skin.tilt * (v - w).dot(way);
                let swept = v.extend(height.max(0.0));
                let distorted = swept + displacement(params, &mut random) * skin_size;
                distorted + (lean + (w - v) * skin.taper).extend(0.0)
            })
            .collect();
        let middle = top.iter().sum::<DVec3>() / n;
        Self {
            base,
            top,
            middle,
            skin_size,
        }
    }

    /// The prism over a footprint. If the footprint is not convex, or has a distant tip, a nearby polygon
    /// without these is used: skin may overlap, but must not be torn.
    pub(super) fn over(plan: &Footprint, flow: DVec2, params: &StoneParams, id: u32) -> Self {
        let (w, n) = (plan.centre, plan.corners.len() as f64);
        let mean = plan.corners.iter().map(|&p| (p - w).length()).sum::<f64>() / n;
        let near = |&p: &DVec2| w + (p - w).clamp_length_max(FARTHEST * mean);
        let mut corners: Vec<DVec2> = plan.corners.iter().map(near).collect();
        fill_in(&mut corners);
        Self::new(&corners, w, flow, params, id)
    }

    /// The points of the control mesh, in the order of [`triangles`].
    pub(super) fn points(&self) -> Vec<Vec3> {
        let base = self.base.iter().map(|b| b.extend(0.0).as_vec3());
        let top = self.top.iter().map(|t| t.as_vec3());
        base.chain(top).chain([self.middle.as_vec3()]).collect()
    }

    /// The area of its sides and its top, in square picture units.
    pub(super) fn area(&self) -> f64 {
        let n = self.base.len();
        let triangle = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a).length() / 2.0;
        (0..n)
            .map(|i| {
                let j = (i + 1) % n;
                let (a, b) = (self.base[i].extend(0.0), self.base[j].extend(0.0));
                let (c, d) = (self.top[i], self.top[j]);
                triangle(a, b, c) + triangle(b, d, c) + triangle(c, d, self.middle)
            })
            .sum()
    }
}

/// Offset of the top of a cell's skin from its base; zero for stones.
pub fn lean(cell: &Cell, params: &StoneParams) -> DVec2 {
    if params.kind != StoneKind::Skin {
        return DVec2::ZERO;
    }
    let reach: f64 = cell.ring.iter().map(|&p| (p - cell.centre).length()).sum();
    let skin_size = reach / cell.ring.len().max(1) as f64;
    turned(cell.axis, params.skin.skew_angle) * params.skin.skew * skin_size
}

/// Moves reflex corners out to the line between their neighbours.
fn fill_in(corners: &mut [DVec2]) {
    let n = corners.len();
    for _ in 0..n {
        for i in 0..n {
            let (a, b) = (corners[(i + n - 1) % n], corners[(i + 1) % n]);
            let (side, arm) = (b - a, corners[i] - a);
            if side.perp_dot(arm) > 0.0 && side != DVec2::ZERO {
                let t = (side.dot(arm) / side.length_squared()).clamp(0.1, 0.9);
                corners[i] = a + side * t;
            }
        }
    }
}

/// A random offset within a ball of the radius Dr.
fn displacement(params: &StoneParams, random: &mut Random) -> DVec3 {
    let amount = match params.distribution {
        Distribution::Uniform => random.unit(),
        Distribution::Normal => random.normal().abs().min(MOST_NORMAL) / 2.0,
    };
    // Uniform on the sphere (Archimedes).
    let (z, angle) = (random.signed(), TAU * random.unit());
    let flat = (1.0 - z * z).max(0.0).sqrt();
    let way = DVec3::new(flat * libm::cos(angle), flat * libm::sin(angle), z);
    way * params.distortion * amount
}

/// A vector turned clockwise on screen by an angle.
pub(super) fn turned(v: DVec2, angle: f64) -> DVec2 {
    // Whole half turns are exact, which keeps symmetric flows exact.
    if angle == 0.0 {
        return v;
    }
    if angle.abs() == PI {
        return -v;
    }
    unit_vector(angle).rotate(v)
}

/// The number of points of a control mesh with `n` corners.
pub(super) fn point_count(n: usize) -> usize {
    2 * n + 1
}

/// The number of triangles that [`triangles`] gives for `n` corners.
pub(super) fn triangle_count(n: usize) -> usize {
    3 * n
}

/// The triangles of the control mesh, clockwise on screen seen from above.
pub(super) fn triangles(n: usize) -> Vec<[u32; 3]> {
    let at = |ring: usize, i: usize| (ring * n + i % n) as u32;
    let mut triangles = Vec::with_capacity(3 * n);
    for i in 0..n {
        let [a, b, c, d] = [at(0, i), at(0, i + 1), at(1, i), at(1, i + 1)];
        triangles.extend([[a, b, c], [b, d, c]]);
    }
    triangles.extend((0..n).map(|i| [at(1, i), at(1, i + 1), 2 * n as u32]));
    triangles
}

/// Radial coordinate of the control mesh's points: 0 at the centre, 1 at the top's corners, 2 at the base's.
/// Refined like the points, it tells where on a cell a vertex is.
pub(super) fn radii(n: usize) -> Vec<Vec3> {
    let radius = |i: usize| Vec3::splat(2.0 - (i / n) as f32);
    (0..point_count(n)).map(radius).collect()
}
