//! How much of the sky each place of the floor sees past the bodies.
//!
//! Two small maps hold the lowest and the highest surface over the floor. Around a place, in each direction, bodies
//! hide the sky between the least and the greatest angle at which they are seen (Max 1988, Horizon Mapping: Shadows for
//! Bump-Mapped Surfaces). So the floor is dark where a body touches it, and gets lighter with the distance. The maps
//! depend on bodies only and are kept while the camera moves.

use super::shadow::ShadowMaps;
use super::{Cut, Scene};
use crate::order::{greater, lesser};
use glam::Vec3;
use std::f64::consts::TAU;

/// Texels along a side of the maps.
const SIDE: usize = 64;
/// Half the side of the maps, in radii of the ball around all bodies: farther away, bodies hide little of the sky.
const WIDE: f32 = 1.4;
/// The number of directions in which each texel looks at the sky. They differ within squares of [`PATTERN`] by
/// [`PATTERN`] texels; the mean over neighbours has the directions of all texels of a square.
const WAYS: usize = 16;
const PATTERN: usize = 4;
/// The places of a square's texels in the order of their directions. Neighbours have directions far apart (Bayer 1973,
/// An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures), so that no streak is left in the mean.
const TURNS: [u8; PATTERN * PATTERN] = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];
/// The weights of a texel's neighbours in the mean, along each axis: all texels of a square have the same sum.
const WEIGHTS: [f32; 5] = [1.0, 2.0, 2.0, 2.0, 1.0];
/// Distances along a direction at which the heights of bodies are read, in texels.
const STEPS: [f32; 10] = [1.0, 2.0, 3.0, 4.0, 5.5, 7.0, 9.0, 11.0, 14.0, 17.5];
/// A texel takes about as long as this many triangles.
const WORK: usize = 30;
/// The lowest and the highest surface at a texel without a body.
const NOTHING: [f32; 2] = [f32::MAX, 0.0];

/// The sky seen by the floor, while it is computed.
#[derive(Clone)]
pub(super) struct FloorContact {
    maps: Option<ShadowMaps>,
    middle: Vec3,
    /// Texels for each unit.
    scale: f32,
    /// The lowest and the highest surface over the floor, in texels.
    heights: Vec<[f32; 2]>,
    raw: Vec<f32>,
    /// The visible share of the sky at each texel, once all is finished.
    open: Vec<f32>,
}

impl FloorContact {
    pub fn new(scene: &Scene) -> Self {
        let (middle, radius) = scene.ball();
        let half = greater(WIDE * radius, f32::MIN_POSITIVE);
        Self {
            maps: Some(ShadowMaps::upright((middle, half), SIDE)),
            middle,
            scale: 0.5 * SIDE as f32 / half,
            heights: Vec::new(),
            raw: Vec::new(),
            open: Vec::new(),
        }
    }

    /// Draws the maps for a scene that is cut by this plane.
    pub fn cut_by(&mut self, cut: Option<Cut>) {
        if let Some(maps) = &mut self.maps {
            maps.cut = cut;
        }
    }

    /// Does the work of about this many triangles; true when finished.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        if let Some(maps) = &mut self.maps {
            if maps.advance(scene, amount) {
                self.heights = heights(maps, self.scale);
                self.maps = None;
            }
            return false;
        }
        if !self.open.is_empty() {
            return true;
        }
        let from = self.raw.len();
        let end = self.heights.len().min(from + amount.div_ceil(WORK));
        let ways: [Ways; PATTERN * PATTERN] = std::array::from_fn(ways);
        let next = (from..end).map(|at| sky(&self.heights, at, &ways));
        self.raw.extend(next);
        if end == self.heights.len() {
            self.open = (0..end).map(|at| mean(&self.raw, at)).collect();
        }
        false
    }

    /// The visible share of the sky over the floor below a point, 0..1.
    #[inline(always)]
    pub fn open(&self, p: Vec3) -> f32 {
        let half = 0.5 * SIDE as f32 - 0.5;
        let end = SIDE as f32 - 1.001;
        // Beyond the maps, the texels at their edges count.
        let inside = |v: f32| lesser(greater(v, 0.0), end);
        let u = inside(half + (p.x - self.middle.x) * self.scale);
        let v = inside(half + (p.z - self.middle.z) * self.scale);
        let (i, j) = (u as i32, v as i32);
        let (tu, tv) = (u - i as f32, v - j as f32);
        let at = j as usize * SIDE + i as usize;
        let Some(&[a, b]) = self.open[at.min(self.open.len())..].first_chunk() else {
            return 1.0;
        };
        let Some(&[c, d]) = self.open[(at + SIDE).min(self.open.len())..].first_chunk() else {
            return 1.0;
        };
        let (up, down) = (a + (b - a) * tu, c + (d - c) * tu);
        up + (down - up) * tv
    }
}

/// The lowest and the highest surface at each texel, over the lowest point of all bodies, in texels.
fn heights(maps: &ShadowMaps, scale: f32) -> Vec<[f32; 2]> {
    let [below, above] = maps.nears();
    let lowest = below.iter().copied().fold(f32::MIN, greater);
    // From below, rows of the map run the other way.
    let mirrored = |at: usize| (SIDE - 1 - at / SIDE) * SIDE + at % SIDE;
    let height = |at: usize| {
        let (low, high) = (below[mirrored(at)], above[at]);
        match (low > f32::MIN, high > f32::MIN) {
            (false, false) => NOTHING,
            // A surface that is seen from above only, such as a sheet, counts as standing on the floor.
            (false, true) => [0.0, (high + lowest) * scale],
            (true, false) => [(lowest - low) * scale; 2],
            (true, true) => [(lowest - low) * scale, (high + lowest) * scale],
        }
    };
    (0..SIDE * SIDE).map(height).collect()
}

/// For each direction the steps along it, in whole texels, and the squares of their lengths.
type Ways = [[([i32; 2], f32); STEPS.len()]; WAYS];

/// The directions at a texel of the pattern.
fn ways(texel: usize) -> Ways {
    std::array::from_fn(|way| {
        let part = (f64::from(TURNS[texel]) + 0.5) / (PATTERN * PATTERN) as f64;
        let angle = TAU * (way as f64 + part) / WAYS as f64;
        let along = [libm::cos(angle), libm::sin(angle)];
        STEPS.map(|step| {
            let texels = along.map(|v| libm::round(v * f64::from(step)) as i32);
            let [x, y] = texels.map(|v| v as f32);
            (texels, x * x + y * y)
        })
    })
}

/// The visible share of the sky at a texel, weighted by the cosine of its angle to the vertical.
fn sky(heights: &[[f32; 2]], at: usize, ways: &[Ways; PATTERN * PATTERN]) -> f32 {
    // The squared sine of the angle at which a height is seen; `away` is the squared distance.
    let sine = |height: f32, away: f32| height * height / (height * height + away);
    let (x, y) = ((at % SIDE) as i32, (at / SIDE) as i32);
    let own = heights[at];
    let first = match own == NOTHING {
        true => [1.0, 0.0],
        false => [sine(own[0], 0.25), 1.0],
    };
    let mut hidden = 0.0;
    for way in &ways[at / SIDE % PATTERN * PATTERN + at % PATTERN] {
        let [mut least, mut most] = first;
        for &([dx, dy], away) in way {
            let (x, y) = (x + dx, y + dy);
            if x < 0 || y < 0 || x >= SIDE as i32 || y >= SIDE as i32 {
                break;
            }
            let there = heights[y as usize * SIDE + x as usize];
            if there != NOTHING {
                least = lesser(least, sine(there[0], away));
                most = greater(most, sine(there[1], away));
            }
        }
        hidden += greater(most - least, 0.0);
    }
    1.0 - hidden / WAYS as f32
}

/// The mean around a texel, in which all directions have the same weight.
fn mean(raw: &[f32], at: usize) -> f32 {
    let around = |v: usize| {
        (v..)
            .zip(WEIGHTS)
            .map(|(v, weight)| (v.saturating_sub(2).min(SIDE - 1), weight))
    };
    let mut sum = 0.0;
    for (y, down) in around(at / SIDE) {
        for (x, across) in around(at % SIDE) {
            sum += across * down * raw[y * SIDE + x];
        }
    }
    let all: f32 = WEIGHTS.iter().sum();
    sum / (all * all)
}

#[cfg(test)]
mod tests {
    use super::{FloorContact, NOTHING, PATTERN, SIDE};
    use glam::Vec3;

    /// The sky over the floor around an upright cylinder in the middle, between two heights, all in texels.
    fn around_cylinder(radius: f32, heights: [f32; 2]) -> FloorContact {
        let middle = 0.5 * (SIDE as f32 - 1.0);
        let height = |at: usize| {
            let away = [at % SIDE, at / SIDE].map(|v| v as f32 - middle);
            let is_inside = libm::hypotf(away[0], away[1]) < radius;
            if is_inside { heights } else { NOTHING }
        };
        let heights: Vec<_> = (0..SIDE * SIDE).map(height).collect();
        let ways: [super::Ways; PATTERN * PATTERN] = std::array::from_fn(super::ways);
        let raw: Vec<f32> = (0..heights.len())
            .map(|at| super::sky(&heights, at, &ways))
            .collect();
        let open = (0..raw.len()).map(|at| super::mean(&raw, at)).collect();
        FloorContact {
            maps: None,
            middle: Vec3::ZERO,
            scale: 1.0,
            heights,
            raw,
            open,
        }
    }

    /// Around something round, the floor has no streaks: it is about as dark on all sides, and gets lighter outwards.
    #[test]
    fn a_round_body_leaves_no_streaks_on_the_floor() {
        for (radius, heights) in [(4.0, [5.0, 16.0]), (2.2, [6.0, 20.0]), (7.0, [0.0, 12.0])] {
            let contact = around_cylinder(radius, heights);
            let mut inner = 0.0;
            for away in [10.0_f32, 12.0, 15.0, 18.0, 22.0] {
                let at = |degrees: u32| {
                    let (sin, cos) = libm::sincosf((degrees as f32).to_radians());
                    contact.open(Vec3::new(away * cos, 0.0, away * sin))
                };
                let [mut low, mut high, mut sum] = [1.0_f32, 0.0, 0.0];
                for open in (0..360).map(at) {
                    (low, high, sum) = (low.min(open), high.max(open), sum + open);
                }
                assert!(high - low < 0.018, "{radius}, {away}: {low} to {high}");
                assert!(sum / 360.0 > inner, "{radius}, {away}: {sum}");
                inner = sum / 360.0;
            }
        }
    }
}
