//! Variants of a component: smooth maps of space that stretch, taper, bulge and bend it. They are one to one around
//! the body, so its surface stays closed and does not cross itself.

use super::shell::turned;
use crate::random::{Purpose, Random};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The strength of the maps, as parts of the body's size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vary {
    /// The greatest change of its size along each axis.
    pub stretch: f64,
    /// The greatest change of its section towards its ends.
    pub taper: f64,
    /// The greatest change of its section at some place along it.
    pub bulge: f64,
    /// The greatest angle between its ends, in radians.
    pub bend: f64,
    /// The size of broad bumps and hollows.
    pub lump: f64,
}

impl Vary {
    const fn new([stretch, taper, bulge, bend, lump]: [f64; 5]) -> Self {
        Self {
            stretch,
            taper,
            bulge,
            bend,
            lump,
        }
    }

    /// Pebbles.
    pub const STONE: Self = Self::new([0.20, 0.16, 0.10, 0.35, 0.060]);
    /// Grains and kernels.
    pub const GRAIN: Self = Self::new([0.12, 0.13, 0.08, 0.32, 0.018]);
    /// Round fruit.
    pub const FRUIT: Self = Self::new([0.09, 0.08, 0.06, 0.14, 0.035]);
    /// Metal: sizes differ, and it is hardly bent.
    pub const METAL: Self = Self::new([0.08, 0.015, 0.010, 0.03, 0.0]);
    /// Toys.
    pub const TOY: Self = Self::new([0.05, 0.05, 0.04, 0.06, 0.010]);
    /// Leaves.
    pub const LEAF: Self = Self::new([0.14, 0.16, 0.10, 0.70, 0.020]);
    /// A body from a file.
    pub const FILE: Self = Self::new([0.08, 0.08, 0.05, 0.18, 0.015]);
}

/// The map of one variant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variant {
    middle: DVec3,
    /// Half the length of the body, and the axis along it (0 for x, 1 for y, 2 for z). The two other axes follow in
    /// turn.
    half: f64,
    axis: usize,
    stretch: DVec3,
    taper: f64,
    bulge: [f64; 2],
    /// The curvature, and the direction of bending across the body.
    curvature: f64,
    towards: [f64; 2],
    /// The size of bumps, and the phases of their waves.
    lump: f64,
    phases: [f64; 6],
}

impl Variant {
    /// The map of variant `number` under a seed, for a body with this bounding box. Number 0 is the body itself.
    pub fn new((low, high): (DVec3, DVec3), vary: &Vary, (seed, number): (u64, u64)) -> Self {
        let size = high - low;
        let axis = (0..3).fold(0, |best, k| if size[k] > size[best] { k } else { best });
        let mut random = Random::new(seed, Purpose::Distortion, number);
        let is_plain = number == 0;
        let mut within = |most: f64| most * random.signed() * f64::from(u8::from(!is_plain));
        let half = 0.5 * size[axis];
        let [x, y, z] = [0; 3].map(|_| 1.0 + within(vary.stretch));
        let (cos, sin) = turned(within(PI));
        Self {
            middle: 0.5 * (low + high),
            half,
            axis,
            stretch: DVec3::new(x, y, z),
            taper: within(vary.taper),
            bulge: [within(vary.bulge), within(0.8)],
            curvature: within(vary.bend) / (2.0 * half),
            towards: [cos, sin],
            lump: vary.lump * half * f64::from(u8::from(!is_plain)),
            phases: [0; 6].map(|_| within(PI)),
        }
    }

    /// The place to which the map moves a point of the body.
    pub fn of(&self, p: DVec3) -> DVec3 {
        let p = p - self.middle;
        let p = (p + self.lumps(p)) * self.stretch;
        let (b, c) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let t = p[self.axis] / self.half;
        let [bulge, at] = self.bulge;
        let section = 1.0 + self.taper * t + bulge * libm::cos(0.5 * PI * (t - at));
        let [u, v] = self.towards;
        let (x, y) = (p[b] * section, p[c] * section);
        // Across the body: the part in the plane of the arc, and the part that stands on it.
        let (in_plane, upright) = (u * x + v * y, u * y - v * x);
        let (along, in_plane) = self.bent(p[self.axis], in_plane);
        let mut place = DVec3::ZERO;
        place[self.axis] = along;
        place[b] = u * in_plane - v * upright;
        place[c] = v * in_plane + u * upright;
        self.middle + place
    }

    /// Bends the plane so that the axis becomes an arc.
    fn bent(&self, along: f64, across: f64) -> (f64, f64) {
        if self.curvature == 0.0 {
            return (along, across);
        }
        let radius = 1.0 / self.curvature;
        let (c, s) = turned(along * self.curvature);
        ((radius - across) * s, radius - (radius - across) * c)
    }

    /// Broad bumps: three waves, each across the direction in which it moves points.
    fn lumps(&self, p: DVec3) -> DVec3 {
        let wave = |x: f64, y: f64, k: usize| {
            let [a, b] = [self.phases[k], self.phases[k + 3]];
            libm::sin(x * TAU / (2.6 * self.half) + a) * libm::cos(y * TAU / (3.4 * self.half) + b)
        };
        self.lump * DVec3::new(wave(p.y, p.z, 0), wave(p.z, p.x, 1), wave(p.x, p.y, 2))
    }
}
