//! Displacement of the vertices of a refined cell of skin: flat faces, keel, growth rings, fractal noise.
//!
//! Itoh, Miyata, Shimada (2003), section 6.3; Fournier, Fussell, Carpenter (1982), Computer Rendering of
//! Stochastic Models: each subdivision puts a vertex in the middle of each edge. It takes the mean
//! displacement of the edge's ends plus one of its own, in vertical direction. The displacements of all
//! levels are added to the smooth surface of the last level. The amplitude falls by 2^-H a level, with H = 2
//! - Fd.
//!
//! Stencils of skin end on Loop's limit surface, and the noise ends at the level that a picture needs, so
//! finer triangles change almost nothing. The variance of the noise allows for two facts: edges between two
//! new vertices differ by two new numbers, and a pixel averages over some of the last ones.

use super::prism::{Prism, turned};
use super::subdivide::Stencil;
use super::{SkinParams, StoneParams};
use crate::order::{greater, lesser};
use crate::random::{Purpose, Random};
use glam::{DVec2, Vec3};

/// Standard deviation of the noise at the distance of a skin size, relative to its amplitude.
const DEVIATION: f64 = 0.5;
/// Gain of the last level for the roughest noise. A pixel averages over several vertices; without the gain a
/// surface would be smoother than requested, by up to 0.15 of the dimension.
const LAST: f64 = 2.0;
/// Depth of growth rings, in skin sizes.
const RING_DEPTH: f32 = 0.05;
/// Share of the half width that a keel takes.
const KEEL_WIDTH: f32 = 0.85;

/// Moves refined vertices towards the faces of the control mesh by the share `flatness`: 1 gives the prism
/// itself, with its flat top, edges and corners.
pub(super) fn flatten(vertices: &mut [Vec3], stencil: &Stencil, control: &[Vec3], flatness: f64) {
    if flatness <= 0.0 {
        return;
    }
    let share = flatness as f32;
    let mut flat = control.to_vec();
    flat.reserve(stencil.len());
    for edges in stencil.levels() {
        for &[a, b] in edges {
            flat.push((flat[a as usize] + flat[b as usize]) * 0.5);
        }
    }
    for (v, flat) in vertices.iter_mut().zip(flat) {
        *v += (flat - *v) * share;
    }
}

/// Raises a keel along the flow and lowers the grooves of growth rings. `radii` are the vertices' radial coordinates
/// (see `prism::radii`).
pub(super) fn add_keel_and_rings(
    vertices: &mut [Vec3],
    radii: &[f32],
    (prism, centre, flow): (&Prism, DVec2, DVec2),
    params: &SkinParams,
) {
    if params.keel == 0.0 && params.rings == 0 {
        return;
    }
    let across = turned(flow, params.skew_angle).perp().as_vec2();
    let centre = centre.as_vec2();
    let extent = prism
        .base
        .iter()
        .map(|b| (b.as_vec2() - centre).dot(across).abs());
    let half = greater(extent.fold(0.0, f32::max) * KEEL_WIDTH, 1e-3);
    let keel = (params.keel * params.sweep * prism.skin_size) as f32;
    let rings = params.rings as f32;
    let depth = RING_DEPTH * prism.skin_size as f32;
    for (v, &radius) in vertices.iter_mut().zip(radii) {
        let mut z = v.z;
        // 1 on the top, falling to 0 at the base.
        let upper = greater(lesser(2.0 - radius, 1.0), 0.0);
        if keel > 0.0 {
            let off = ((v.x - centre.x) * across.x + (v.y - centre.y) * across.y).abs() / half;
            let side = greater(1.0 - off, 0.0);
            z += keel * side * side * upper * upper;
        }
        if rings > 0.0 {
            let turn = radius * rings;
            let part = turn - turn.floor();
            let groove = 4.0 * part * (1.0 - part);
            z -= depth * (1.0 - groove) * (1.0 - groove) * upper * lesser(turn, 1.0);
        }
        v.z = z;
    }
}

/// Adds noise of the first `levels` levels, with the amplitude Af, to the heights of refined vertices.
pub(super) fn add_noise(
    vertices: &mut [Vec3],
    radii: &[f32],
    (stencil, levels): (&Stencil, u32),
    (skin_size, id): (f64, u32),
    params: &StoneParams,
) {
    if params.skin.amplitude <= 0.0 {
        return;
    }
    let hurst = (2.0 - params.skin.dimension).clamp(0.0, 1.0);
    let fall = libm::exp2(-hurst);
    // Uniform numbers with standard deviation 1. The corners start with noise, too: without it a surface of
    // low dimension would lack its widest waves, and be too rough for its amplitude.
    let mut amplitude = params.skin.amplitude * skin_size * DEVIATION * 3.0f64.sqrt();
    let mut random = Random::new(params.seed, Purpose::Noise, u64::from(id));
    let corner = |_| (amplitude * random.signed()) as f32;
    let mut noise: Vec<f32> = (0..stencil.sources()).map(corner).collect();
    noise.reserve(stencil.len());
    // The variance that averaging removes. An edge has one new number on the halves of old edges and two
    // between them, one and a half on average.
    amplitude *= ((1.0 - libm::exp2(2.0 * hurst - 2.0)).max(0.0) * 2.0 / 1.5).sqrt();
    for (level, edges) in (1..=levels).zip(stencil.levels()) {
        amplitude *= fall;
        let last = if level == levels {
            LAST * (1.0 - hurst)
        } else {
            0.0
        };
        let scale = (amplitude * (1.0 + last) / f64::from(1u32 << 31)) as f32;
        for pair in edges.chunks(2) {
            let bits = random.bits();
            for (k, &[a, b]) in pair.iter().enumerate() {
                let draw = (bits >> (32 * k)) as u32 as i32 as f32;
                let mean = (noise[a as usize] + noise[b as usize]) * 0.5;
                noise.push(mean + scale * draw);
            }
        }
    }
    for &[a, b] in stencil.levels().skip(levels as usize).flatten() {
        noise.push((noise[a as usize] + noise[b as usize]) * 0.5);
    }
    for ((v, noise), &radius) in vertices.iter_mut().zip(noise).zip(radii) {
        // The base stays in its plane.
        v.z += noise * greater(lesser(2.0 - radius, 1.0), 0.0);
    }
}
