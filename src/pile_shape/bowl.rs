//! A bowl and its content.

use super::piled::{PiledShape, Vessel};
use super::rings;
use crate::pile::Wall;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// The thickness at the lowest point and at the lip.
const THICK: [f64; 2] = [0.04, 0.028];
/// The radius of the inside at the lip.
const WIDE: f64 = 0.5 - THICK[1];
/// The height, the outer radius and the width of the foot ring.
const FOOT_HEIGHT: f64 = 0.028;
const FOOT_RADIUS: f64 = 0.19;
const FOOT_WIDTH: f64 = 0.03;
/// The radius of the content, as a share of the bowl's inner radius at the height of the content's edge.
const CONTENT: f64 = 0.93;
/// The share by which the content is less steep at its edge than a paraboloid.
const EVEN: f64 = 0.5;
/// How far the drawn inside lies behind the wall that stops bodies, so that bodies do not cut it.
const GAP: f64 = 0.001;
/// Rows of the profile along each side and along the lip, and corners around.
const ROWS: usize = 24;
const LIP_ROWS: usize = 10;
const AROUND: usize = 96;

/// The bowl for the numbers `[depth, full]`. The content is a cap: the fuller the bowl, the higher the cap and the
/// nearer its edge to the lip. The cap bulges, as bodies slide inwards from it. It is flatter at the edge, so that the
/// normal, along which bodies slide, does not lead into the wall.
pub(super) fn bowl(n: &[f64], edge: f64) -> PiledShape {
    let inside = BowlInside {
        low: FOOT_HEIGHT + THICK[0],
        curve: n[0] / (WIDE * WIDE),
    };
    let level = 0.8 + 0.2 * n[1];
    let radius = CONTENT * WIDE * level.sqrt();
    let rise = WIDE * (0.06 + 0.27 * n[1]);
    let profile = |t: f64| {
        let height = inside.low + n[0] * level + rise * (1.0 - t * t) * (1.0 - EVEN * t * t);
        DVec2::new(radius * t, height)
    };
    let wall = Wall::Bowl {
        lowest: DVec3::Y * inside.low,
        curve: inside.curve,
    };
    let mut vessel = Vessel::new("ceramic");
    let (soup, normals) = rings::turned(&inside.outline(), AROUND);
    vessel.add(&soup, &normals);
    PiledShape {
        surface: rings::disc(profile, edge),
        walls: vec![wall],
        vessel: Some(vessel),
    }
}

/// The paraboloid inside of a bowl.
struct BowlInside {
    low: f64,
    curve: f64,
}

impl BowlInside {
    /// The point at this radius, and the unit normal into the wall.
    fn at(&self, r: f64) -> (DVec2, DVec2) {
        let slope = 2.0 * self.curve * r;
        let normal = DVec2::new(slope, -1.0) / (1.0 + slope * slope).sqrt();
        (DVec2::new(r, self.low + self.curve * r * r), normal)
    }

    /// The point of the outside, and the unit normal into the wall there.
    fn outside(&self, r: f64) -> (DVec2, DVec2) {
        let (p, normal) = self.at(r);
        let thick = THICK[0] + (THICK[1] - THICK[0]) * r / WIDE;
        (p + thick * normal, normal)
    }

    /// The half section of the bowl: up the inside, over the lip, down the outside, round the foot ring, and to the
    /// axis.
    fn outline(&self) -> Vec<DVec2> {
        let radius = |k: usize| WIDE * k as f64 / ROWS as f64;
        let inner = (0..=ROWS).map(|k| {
            let (p, normal) = self.at(radius(k));
            p + GAP * normal
        });
        let mut line: Vec<DVec2> = inner.collect();
        line.extend(self.lip());
        // The outside ends where the foot ring begins.
        let outer = (0..=ROWS).rev().map(|k| self.outside(radius(k)).0);
        line.extend(outer.take_while(|p| p.x > FOOT_RADIUS + 0.01));
        line.extend(self.foot());
        line
    }

    /// The points between the inside and the outside, on a half circle.
    fn lip(&self) -> Vec<DVec2> {
        let ((outer, normal), (inner, _)) = (self.outside(WIDE), self.at(WIDE));
        let inner = inner + GAP * normal;
        let (middle, half) = (0.5 * (inner + outer), 0.5 * inner.distance(outer));
        let along = normal.perp();
        let point = |k: usize| {
            let angle = PI * k as f64 / LIP_ROWS as f64;
            middle + half * (libm::sin(angle) * along - libm::cos(angle) * normal)
        };
        (1..LIP_ROWS).map(point).collect()
    }

    /// The foot ring and the underside.
    fn foot(&self) -> Vec<DVec2> {
        let (out, within) = (FOOT_RADIUS, FOOT_RADIUS - FOOT_WIDTH);
        // The root of the ring lies on the outside.
        let root = (0..=ROWS * 8).map(|k| self.outside(WIDE * k as f64 / (ROWS * 8) as f64).0);
        let root = root.take_while(|p| p.x <= out).last().unwrap_or_default();
        let under = self.low - THICK[0];
        let round = 0.3 * FOOT_WIDTH;
        vec![
            DVec2::new(root.x, root.y),
            DVec2::new(out - 0.2 * round, round),
            DVec2::new(out - 0.4 * round, 0.35 * round),
            DVec2::new(out - round, 0.0),
            DVec2::new(within + round, 0.0),
            DVec2::new(within + 0.4 * round, 0.35 * round),
            DVec2::new(within + 0.2 * round, round),
            DVec2::new(within - 0.1 * round, under),
            DVec2::new(0.0, under),
        ]
    }
}
