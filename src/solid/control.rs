//! The control mesh of a stone: rings of points around its axis, one above another, and the centre of the
//! top.
//!
//! Miyata, Itoh, Shimada (2000), A Method of Generating Pavement Textures Using the Square Packing Technique,
//! section 5.1: the cell is scaled by Sv, swept by Hs, and its top corners are displaced by eq. (6). Sections
//! 5.2.2 and eq. (7): a flagstone has further vertices around each corner.
//!
//! Loop's scheme shrinks a bare box to a pebble far smaller than its cell. Therefore every ring has three
//! points for each corner, so that sides stay straight, and a stone has support rings between base and top,
//! which preserve its outline. All stones with n corners have the same connectivity, whatever their kind:
//!
//! ```text
//!    ring of one corner: before - corner - after        rings: 4  top, inset
//!    3 n points a ring, 5 rings, and the middle                3  shoulder
//!                                                              2  just under it
//!                                                              1  at the joint's floor
//!                                                              0  base
//! ```
//!
//! Heights count from the base of stones. The ground lies below their tops by the joints' depth, which grows
//! with Hs over its whole range and never exceeds the cell's size ([`joint_depth`]). Relief, unevenness and
//! swells keep within that depth: otherwise the ground would cover low stones.

use super::footprint::Footprint;
use super::{Distribution, StoneKind, StoneParams};
use crate::random::{Purpose, Random};
use glam::{DVec2, Vec3};

/// Rings of a control mesh.
pub const RINGS: usize = 5;

/// Half of a joint at Sv = 1, as a share of the stone's size.
const HALF_JOINT: f64 = 0.022;
/// The least half of a joint in pixels, because thinner joints come and go with the pixel grid.
const LEAST_HALF_JOINT: f64 = 0.85;
/// The greatest share of a small stone that the least half of a joint may take.
const MOST_HALF_JOINT: f64 = 0.065;
/// Difference in height of top corners at Dr = 0.3, relative to the joint's depth.
const UNEVEN: f64 = 0.10;
/// Share of a low stone's height that is above the ground. For a tall stone the exposed height is at most its
/// size, because the joints' filling holds it.
const EXPOSED: f64 = 0.7;
/// The exposed height of a flagstone half as high as wide, relative to its size: eq. (7) holds for it.
const USUAL_EXPOSED: f64 = 0.25;
/// Depth of the ground below the bevel of flagstones, relative to the exposed height of cobbles.
const FLAG_JOINT: f64 = 0.4;
/// A joint is at most this share of the stones' height deep.
const DEEPEST: f64 = 0.92;
/// Drop of a cobble's dome from its centre to half its width, relative to the joint's depth; here and below
/// for low stones and for tall ones.
const DOME: [f64; 2] = [0.08, 0.26];
/// Distance of a cobble's side points from the corner, relative to its size: it sets the roundness of
/// corners.
const COBBLE_CORNER: [f64; 2] = [0.14, 0.26];
/// The largest such distance, as a share of the side's length: a side's two points leave its middle free.
const LONGEST_CORNER: f64 = 0.42;
/// Sine of the least turn of a corner with its own displacement.
const TRUE_TURN: f64 = 0.55;
/// Least and greatest factor of eq. (6).
const DISPLACEMENT: (f64, f64) = (0.3, 1.9);
/// Normal random numbers are limited to this, so that no stone is torn.
const MOST_NORMAL: f64 = 2.5;
/// Radius of the ellipse between the one that touches the sides (1) and the one through the corners (root 2).
const BETWEEN: f64 = 1.12;
/// Share of the scale's excess over 1 that is lost at the top.
const CROWDED: f64 = 0.8;
/// Rings are inset by at most this share of the shorter half extent.
const MOST_INSET: f64 = 0.72;

/// Depth of the ground below the tops of stones of `size`, in picture units.
pub(super) fn joint_depth(params: &StoneParams, size: f64) -> f64 {
    let exposed = exposed_height(params.height, size);
    let wanted = match params.kind {
        StoneKind::Flagstone => FLAG_JOINT * exposed + bevel_down(params, exposed),
        _ => exposed,
    };
    wanted.min(DEEPEST * params.height)
}

/// The height of a stone over the ground: half the harmonic mean of a low stone's share and the size. It
/// grows with both and never exceeds the size.
fn exposed_height(height: f64, size: f64) -> f64 {
    let low = EXPOSED * height;
    low * size / (low + size)
}

/// Height difference between the top and the start of a flagstone's bevel: eq. (7), times the stone's exposed
/// height over the usual one.
fn bevel_down(params: &StoneParams, exposed: f64) -> f64 {
    bevel(params.bevel_vertical, exposed / USUAL_EXPOSED)
}

/// How tall a stone is: 0 for a slab, nearly 1 for a stone far higher than wide.
fn tallness(height: f64, size: f64) -> f64 {
    let (height, size) = (height * height, size * size);
    height / (height + size)
}

/// Interpolates from the value for low stones to that for tall ones.
fn lerp([low, tall]: [f64; 2], tallness: f64) -> f64 {
    low + (tall - low) * tallness
}

/// Eq. (7): the distance of a bevel from a corner. `ratio` is Bh or Bv.
fn bevel(ratio: f64, size: f64) -> f64 {
    size / 2.0 * ratio
}

fn half_joint(size: f64) -> f64 {
    (HALF_JOINT * size).max(LEAST_HALF_JOINT.min(MOST_HALF_JOINT * size))
}

/// One ring of the control mesh.
#[derive(Clone, Copy, Default)]
struct RingProfile {
    height: f64,
    /// Inset from the outline, in picture units.
    inset: f64,
    /// Share of the top corners' displacement that reaches this ring.
    displaced: f64,
    /// Roundness, from the outline's shape (0) to an ellipse (1): a dome has no ridges from its corners.
    round: f64,
}

/// The rings from base to top, and the drop of a dome from its centre to half the stone's width.
fn profile(params: &StoneParams, size: f64) -> ([RingProfile; RINGS], f64) {
    match params.kind {
        StoneKind::Flagstone => (flagstone(params, size), 0.0),
        _ => cobble(params, size),
    }
}

fn flagstone(params: &StoneParams, size: f64) -> [RingProfile; RINGS] {
    let (top, depth) = (params.height, joint_depth(params, size));
    let down = bevel_down(params, exposed_height(top, size)).min(DEEPEST * depth);
    let across = bevel(params.bevel_horizontal, size);
    let ring = |height: f64, inset: f64, displaced: f64| RingProfile {
        height,
        inset,
        displaced,
        ..RingProfile::default()
    };
    [
        RingProfile::default(),
        ring(top - down, 0.0, 0.8),
        ring(top - 0.3 * down, 0.15 * across, 1.0),
        ring(top, across, 1.0),
        ring(top, across + 0.12 * size, 1.0),
    ]
}

/// Low setts have flat tops with edges all around, tall cobbles round ones. For each ring: the drop from the
/// top, relative to the joint's depth, the inset, relative to the size, and the roundness, for low and for
/// tall stones.
fn cobble(params: &StoneParams, size: f64) -> ([RingProfile; RINGS], f64) {
    let (top, depth) = (params.height, joint_depth(params, size));
    let tall = tallness(top, size);
    let of = |ends: [f64; 2]| lerp(ends, tall);
    let ring = |drop: [f64; 2], inset: [f64; 2], round: [f64; 2], displaced: f64| RingProfile {
        height: top - of(drop) * depth,
        inset: of(inset) * size,
        displaced,
        round: of(round),
    };
    let rings = [
        RingProfile::default(),
        ring([1.0, 1.0], [0.0, 0.0], [0.0, 0.3], 0.7),
        ring([0.2, 0.44], [0.005, 0.05], [0.0, 0.6], 0.9),
        ring([0.0, 0.12], [0.10, 0.19], [0.0, 1.0], 1.0),
        ring([0.0, 0.0], [0.24, 0.33], [0.6, 1.0], 1.0),
    ];
    (rings, of(DOME) * depth)
}

/// A point of the outline, and the factor of its distance from the axis at the top (eq. (6)).
struct OutlinePoint {
    at: DVec2,
    factor: f64,
    /// The point's share of the top's unevenness, -1..1.
    lift: f64,
}

/// The control points of a stone, in the order of [`triangles`].
pub fn points(plan: &Footprint, params: &StoneParams, id: u32) -> Vec<Vec3> {
    let (rings, dome) = profile(params, plan.size);
    let outline = outline(plan, params, id);
    let uneven = unevenness(plan, params);
    let mut points = Vec::with_capacity(RINGS * outline.len() + 1);
    for (k, ring) in rings.iter().enumerate() {
        let scale = scale_at(params.scale, ring.displaced);
        for point in &outline {
            let arm = arm(plan, scale, point, ring);
            let p = placed(plan, scale, arm);
            let mut z = ring.height + uneven * point.lift * ring.displaced;
            if k > 1 {
                z -= dome * (arm / plan.half).length_squared().min(2.0);
            }
            points.push(Vec3::new(p.x as f32, p.y as f32, z as f32));
        }
    }
    let (centre, top) = (plan.centre, params.height);
    points.push(Vec3::new(centre.x as f32, centre.y as f32, top as f32));
    points
}

/// The corners alone of the footprint swept to a height (Miyata, Itoh, Shimada 2000, fig. 8 (a)). `displaced`
/// is the share of eq. (6) applied to them: 0 straight above the base, 1 as at the top (fig. 8 (b)). The mesh
/// of [`points`] stands between such corners, and has a smaller top if the scale is above 1.
pub fn corners(
    plan: &Footprint,
    params: &StoneParams,
    id: u32,
    [height, displaced]: [f64; 2],
) -> Vec<Vec3> {
    let ring = RingProfile {
        height,
        displaced,
        ..RingProfile::default()
    };
    let uneven = unevenness(plan, params) * displaced;
    let corner = |point: &OutlinePoint| {
        let p = placed(plan, params.scale, arm(plan, params.scale, point, &ring));
        p.extend(height + uneven * point.lift).as_vec3()
    };
    let outline = outline(plan, params, id);
    outline.iter().skip(1).step_by(3).map(corner).collect()
}

/// Greatest difference in height of the top's corners from level, up or down.
fn unevenness(plan: &Footprint, params: &StoneParams) -> f64 {
    UNEVEN * (params.distortion / 0.3).min(1.5) * joint_depth(params, plan.size)
}

/// The place of an offset, in the cell or in the cell enlarged by a scale above 1.
fn placed(plan: &Footprint, scale: f64, arm: DVec2) -> DVec2 {
    let p = plan.centre + plan.axis * arm.x + plan.axis.perp() * arm.y;
    plan.kept_in(p, scale.max(1.0))
}

/// The scale at a ring. A scale above 1 widens the foot more than the top: stones touch and still show their joints.
fn scale_at(scale: f64, displaced: f64) -> f64 {
    scale.min(1.0) + (scale - 1.0).max(0.0) * (1.0 - CROWDED * displaced)
}

/// The offset of a control point from the stone's axis, along and across the footprint's principal axis.
fn arm(plan: &Footprint, scale: f64, point: &OutlinePoint, ring: &RingProfile) -> DVec2 {
    let factor = 1.0 + (point.factor - 1.0) * ring.displaced;
    let arm = (point.at - plan.centre) * scale * factor;
    // Inset by the same length along and across, so that joints of long cells are even.
    let inset = ring.inset + half_joint(plan.size);
    let narrow = DVec2::ONE - (inset / plan.half).min(DVec2::splat(MOST_INSET));
    let arm = DVec2::new(arm.dot(plan.axis), arm.dot(plan.axis.perp())) * narrow;
    arm.lerp(rounded(arm, plan.half * narrow), ring.round)
}

/// A point of the ellipse between the sides and corners of a rectangle with half extents `half`, in the
/// direction of the offset.
fn rounded(arm: DVec2, half: DVec2) -> DVec2 {
    let away = (arm / half).length();
    if away == 0.0 {
        return arm;
    }
    arm * (BETWEEN / away)
}

fn outline(plan: &Footprint, params: &StoneParams, id: u32) -> Vec<OutlinePoint> {
    let corners = &plan.corners;
    let n = corners.len();
    let mut random = Random::new(params.seed, Purpose::Distortion, u64::from(id));
    let mut factors = displacements(params, &mut random, n);
    let mut lifts: Vec<f64> = (0..n).map(|_| random.signed()).collect();
    interpolate_flat_corners(corners, &mut [&mut factors, &mut lifts]);
    let beside = match params.kind {
        StoneKind::Flagstone => bevel(params.bevel_horizontal, plan.size).max(0.01 * plan.size),
        _ => lerp(COBBLE_CORNER, tallness(params.height, plan.size)) * plan.size,
    };
    let mut outline = Vec::with_capacity(3 * n);
    for i in 0..n {
        let towards = |j: usize| {
            let side = corners[j] - corners[i];
            let t = (beside / side.length()).min(LONGEST_CORNER);
            OutlinePoint {
                at: corners[i] + side * t,
                factor: factors[i] + (factors[j] - factors[i]) * t,
                lift: lifts[i] + (lifts[j] - lifts[i]) * t,
            }
        };
        outline.push(towards((i + n - 1) % n));
        outline.push(OutlinePoint {
            at: corners[i],
            factor: factors[i],
            lift: lifts[i],
        });
        outline.push(towards((i + 1) % n));
    }
    outline
}

/// Eq. (6), taken as a factor of each top corner's distance from the stone's axis.
fn displacements(params: &StoneParams, random: &mut Random, n: usize) -> Vec<f64> {
    let mut number = || match params.distribution {
        Distribution::Uniform => random.signed(),
        Distribution::Normal => random.normal().clamp(-MOST_NORMAL, MOST_NORMAL),
    };
    let factor = |r: f64| (1.0 + params.distortion * r).clamp(DISPLACEMENT.0, DISPLACEMENT.1);
    (0..n).map(|_| factor(number())).collect()
}

/// Interpolates the random values of flat corners between true corners: along a curved boundary, values of
/// their own would make the stone ragged.
fn interpolate_flat_corners(corners: &[DVec2], values: &mut [&mut Vec<f64>]) {
    let n = corners.len();
    let true_corners: Vec<usize> = (0..n).filter(|&i| is_true_corner(corners, i)).collect();
    if true_corners.len() < 3 {
        return;
    }
    for (k, &from) in true_corners.iter().enumerate() {
        let to = true_corners[(k + 1) % true_corners.len()];
        let steps = (to + n - from) % n;
        for step in 1..steps {
            let t = step as f64 / steps as f64;
            for list in values.iter_mut() {
                list[(from + step) % n] = list[from] * (1.0 - t) + list[to] * t;
            }
        }
    }
}

fn is_true_corner(corners: &[DVec2], i: usize) -> bool {
    let n = corners.len();
    let (before, here, after) = (corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
    let (into, out) = (here - before, after - here);
    let turn = into.perp_dot(out) / (into.length() * out.length());
    turn > TRUE_TURN || (turn > 0.0 && into.dot(out) < 0.0)
}

/// The number of points that [`points`] gives for `n` corners.
pub fn point_count(n: usize) -> usize {
    RINGS * 3 * n + 1
}

/// The number of triangles that [`triangles`] gives for `n` corners.
pub fn triangle_count(n: usize) -> usize {
    (2 * RINGS - 1) * 3 * n
}

/// The triangles over the points of a stone with `n` corners, clockwise on screen seen from above. The base
/// is open, because it is never seen.
pub fn triangles(n: usize) -> Vec<[u32; 3]> {
    triangles_over(RINGS, n)
}

/// Like [`triangles`], for any number of rings.
pub fn triangles_over(rings: usize, n: usize) -> Vec<[u32; 3]> {
    let m = 3 * n;
    let at = |ring: usize, i: usize| (ring * m + i % m) as u32;
    let mut triangles = Vec::with_capacity((2 * rings - 1) * m);
    for ring in 0..rings - 1 {
        for i in 0..m {
            let [a, b] = [at(ring, i), at(ring, i + 1)];
            let [c, d] = [at(ring + 1, i), at(ring + 1, i + 1)];
            // Diagonals lean towards the corner from both sides, so that stones are not twisted.
            if i % 3 == 0 {
                triangles.extend([[a, b, c], [b, d, c]]);
            } else {
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
    }
    let middle = (rings * m) as u32;
    triangles.extend((0..m).map(|i| [at(rings - 1, i), at(rings - 1, i + 1), middle]));
    triangles
}
