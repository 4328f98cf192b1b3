//! Gentle hills: a sum of waves, with a lane that winds between them.

use super::bone::Bone;
use super::flight::grid;
use crate::random::{Purpose, Random};
use crate::trimesh::Soup;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

pub(super) struct Terrain {
    /// Each wave as its vector, its phase and its height.
    waves: Vec<(DVec2, f64, f64)>,
    height: f64,
    lane: f64,
    wind: f64,
    phase: f64,
    /// The height of the lowest place, which is subtracted from all.
    low: f64,
}

/// The number of waves.
const WAVES: u64 = 18;
/// The number of these that have half the length.
const SHORT: u64 = 6;
/// Steps of the grid on which the lowest place is searched.
const LOWEST: u32 = 40;
/// Half the width of the lane.
const LANE: f64 = 0.15;

impl Terrain {
    /// The terrain for the numbers `[hills, height, lane, wind, hill]`.
    pub fn new(n: &[f64]) -> Self {
        let (hills, seed) = (n[0], n[4] as u64);
        let wave = |k: u64| {
            let mut random = Random::new(seed, Purpose::Ground, k);
            let is_short = k >= WAVES - SHORT;
            // Directions are spread evenly, each a little off.
            let angle = TAU * (k as f64 * 0.381_966 + 0.1 * random.signed());
            let often = hills * (0.75 + 0.35 * random.unit()) * if is_short { 1.9 } else { 1.0 };
            let way = DVec2::new(libm::cos(angle), libm::sin(angle)) * (TAU * often * 0.5);
            (way, TAU * random.unit(), if is_short { 0.28 } else { 1.0 })
        };
        let mut waves: Vec<_> = (0..WAVES).map(wave).collect();
        let power: f64 = waves.iter().map(|w| w.2 * w.2).sum();
        for wave in &mut waves {
            wave.2 *= (2.0 / power).sqrt();
        }
        let mut terrain = Self {
            low: 0.0,
            waves,
            height: 0.6 * n[1] / (hills + 1.0),
            lane: n[2],
            wind: n[3],
            phase: Random::new(seed, Purpose::Ground, WAVES).unit() * TAU,
        };
        // The grid is fine enough to come near the lowest place.
        let side = || (0..=LOWEST).map(|k| f64::from(k) / f64::from(LOWEST) - 0.5);
        let heights = side().flat_map(|z| side().map(move |x| (x, z)));
        terrain.low = heights.fold(f64::INFINITY, |low, (x, z)| low.min(terrain.height(x, z)));
        terrain
    }

    /// The x of the lane's middle.
    fn lane(&self, z: f64) -> f64 {
        0.22 * self.wind * libm::sin(5.2 * z + self.phase)
    }

    /// The height at a place of the square with side 1 around the origin.
    pub fn height(&self, x: f64, z: f64) -> f64 {
        let p = DVec2::new(x, z);
        let each = self.waves.iter();
        let sum: f64 = each
            .map(|&(way, phase, height)| height * libm::cos(way.dot(p) + phase))
            .sum();
        // Limit depths, so that valleys have flat ground.
        let lifted = sum + 1.2;
        let hill = 0.5 * (lifted + (lifted * lifted + 0.25).sqrt());
        let off = (x - self.lane(z)) / LANE;
        let fall = 1.0 / (1.0 + off * off * off * off);
        self.height * hill * (1.0 - 0.94 * self.lane * fall) - self.low
    }

    fn at(&self, x: f64, z: f64) -> DVec3 {
        DVec3::new(x, self.height(x, z), z)
    }

    pub fn bones(&self) -> Vec<Bone> {
        if self.lane == 0.0 {
            return Vec::new();
        }
        let points: Vec<DVec3> = (0..=48)
            .map(|k| {
                let z = f64::from(k) / 48.0 - 0.5;
                self.at(self.lane(z), z)
            })
            .collect();
        vec![Bone {
            radii: vec![LANE; points.len()],
            points,
            closed: false,
        }]
    }

    pub fn build(&self, edge: f64) -> Soup {
        let diagonal = (2.0 + 4.0 * self.height * self.height).sqrt();
        // Hilly ground is longer than its plan.
        let steep = 1.0 + 0.3 * (self.height * 8.0).min(0.5);
        let count = (steep / (edge * diagonal)).round().max(2.0) as usize;
        let side = |k: usize| k as f64 / count as f64 - 0.5;
        grid(count, count, |i, j| self.at(side(i), side(j)))
    }
}
