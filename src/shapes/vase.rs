//! A vase: a solid of revolution with a foot, a belly, a neck, a lip and an inside.

use super::bone::Bone;
use super::canal::hermite;
use super::form::Form;
use super::jet::{Jet, JetPoint, length};
use glam::{DVec2, DVec3};

pub(super) struct Vase {
    /// The outside profile from the foot to the lip and straight up beyond it: distance from the axis, and height.
    profile: Vec<DVec2>,
    height: f64,
    wall: f64,
    floor: f64,
    widest: f64,
}

/// Samples of each piece of the profile.
const SAMPLES: usize = 40;

impl Vase {
    /// The vase for the numbers `[height, shoulder, neck, lip, hollow]`.
    pub fn new(n: &[f64]) -> Self {
        let scale = 1.0 / n[0].max(1.0);
        let (height, widest) = (n[0] * scale, 0.5 * scale);
        let neck = n[2] * widest;
        let (lip, foot) = ((neck * n[3]).min(widest), 0.56 * widest);
        let shoulder = n[1];
        // Share of the height, distance from the axis, and the distance's derivative with respect to that share.
        let up = 1.0 - shoulder;
        let knots = [
            (-0.1, foot * 0.94, 0.2 * widest),
            (0.0, foot, 0.75 * widest),
            (shoulder, widest, 0.0),
            (shoulder + 0.68 * up, neck, 0.0),
            (1.0, lip, 1.4 * (lip - neck) / (0.32 * up)),
            (1.4, lip + 0.4 * (lip - neck), 0.2 * (lip - neck)),
        ];
        let mut profile = Vec::new();
        for pair in knots.windows(2) {
            let ((y, r, dr), (z, s, ds)) = (pair[0], pair[1]);
            for k in 0..SAMPLES {
                let t = k as f64 / SAMPLES as f64;
                let at = hermite(t, r, dr * (z - y), s, ds * (z - y)).0;
                profile.push(DVec2::new(at, (y + (z - y) * t) * height));
            }
        }
        let wall = (0.28 * neck).min(0.05);
        Self {
            profile,
            height,
            wall,
            floor: (1.0 - n[4]) * height,
            widest,
        }
    }

    /// The signed distance to the outside profile, negative towards the axis.
    fn side(&self, round: Jet, y: Jet) -> Jet {
        let p = DVec2::new(round.value, y.value);
        let (k, t) = self.nearest(p);
        let (a, b) = (self.profile[k], self.profile[k + 1]);
        let way = (b - a).normalize();
        let out = DVec2::new(way.y, -way.x);
        let d = p - a - (b - a) * t;
        let (flat, far) = (out.dot(d), d.length());
        let (value, n) = if t > 0.0 && t < 1.0 || far < 1e-9 {
            (flat, out)
        } else {
            (far * flat.signum(), d * (flat.signum() / far))
        };
        Jet::new(value, round.slope * n.x + y.slope * n.y)
    }

    /// The piece of the profile that is nearest to a point, and where on it the nearest place is, from 0 to 1.
    fn nearest(&self, p: DVec2) -> (usize, f64) {
        let mut best = (f64::INFINITY, 0, 0.0);
        let mut look = |k: usize| {
            let (a, b) = (self.profile[k], self.profile[k + 1]);
            let way = b - a;
            let t = ((p - a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let far = (p - a - way * t).length_squared();
            if far < best.0 {
                best = (far, k, t);
            }
            best.0
        };
        // Heights only rise along the profile: search up and down from the piece at the point's own height.
        let last = self.profile.len() - 2;
        let at = self
            .profile
            .partition_point(|q| q.y <= p.y)
            .saturating_sub(1)
            .min(last);
        let mut least = look(at);
        let beyond = |k: usize, least: f64| {
            let off = self.profile[k].y - p.y;
            off * off > least
        };
        for k in at + 1..=last {
            if beyond(k, least) {
                break;
            }
            least = look(k);
        }
        for k in (0..at).rev() {
            if beyond(k + 1, least) {
                break;
            }
            least = look(k);
        }
        let (_, k, t) = best;
        (k, t)
    }
}

impl Form for Vase {
    fn at(&self, p: JetPoint) -> Jet {
        let side = self.side(length(p.x, p.z), p.y);
        let k = 0.9 * self.wall;
        let solid = side.cut(-p.y, 0.05).cut(p.y - self.height, k);
        let inside = (side + self.wall).cut(-p.y + self.floor, 0.08);
        solid.cut(-inside, k)
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let r = self.widest;
        (DVec3::new(-r, 0.0, -r), DVec3::new(r, self.height, r))
    }

    fn coarsest(&self) -> f64 {
        0.45 * self.wall
    }

    fn bones(&self) -> Vec<Bone> {
        let within = self
            .profile
            .iter()
            .filter(|p| p.y >= 0.0 && p.y <= self.height);
        let (points, radii) = within.map(|p| (p.y * DVec3::Y, p.x)).unzip();
        vec![Bone {
            points,
            radii,
            closed: false,
        }]
    }
}
