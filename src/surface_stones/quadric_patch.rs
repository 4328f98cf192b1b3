//! Bends a flat stone onto the curved surface of its cell.
//!
//! A vertex at distance r from the cell's centre, in the direction d, first goes along a circle. The circle touches
//! the plane at the centre and has the surface's curvature in the direction d. Then the vertex goes along the
//! surface's normal at the end of that arc, which also leans across d if the surface is twisted. The differences
//! between the bent corners of the ring and the true ones are spread over the stone by inverse squares of distances
//! (Shepard 1968), with none at the centre. So neighbours meet exactly in their corners.

use crate::order::greater;
use glam::{DVec2, DVec3};

/// The greatest angle that a normal turns, in radians.
const MOST_TURN: f64 = 1.5;
/// The greatest height of a stone over a hollow, and depth in a hump, as a part of the radius of curvature.
const MOST_RISE: f64 = 0.5;
/// Below this angle sines and cosines come from their series.
const SMALL: f64 = 1e-4;

/// The curvature of a cell's surface, in picture units and in the plane's axes.
#[derive(Clone, Debug)]
pub struct QuadricPatch {
    /// The shape operator: xx, xy, yy. It is positive where the surface falls away from the plane.
    pub shape: [f64; 3],
    /// The height of the stone that lies on the surface.
    pub anchor: f64,
    /// The factor on heights above and below the anchor.
    pub rise: f64,
    /// Corners of the ring in the plane, each with the difference of its true place from its bent one.
    rest: Vec<(DVec2, DVec3)>,
}

impl QuadricPatch {
    /// Fits the shape operator to the normals at the corners of a ring (least squares). `truly` are the true places
    /// of the corners.
    pub fn new(places: &[DVec2], normals: &[DVec3], truly: &[DVec3]) -> Self {
        let mut bend = Self {
            shape: fitted(places, normals),
            anchor: 0.0,
            rise: 1.0,
            rest: Vec::new(),
        };
        let rest = |(&q, &there): (&DVec2, &DVec3)| (q, there - bend.bent(q.extend(0.0)));
        bend.rest = places.iter().zip(truly).map(rest).collect();
        bend
    }

    /// Puts the height `anchor` on the surface. Stones from `low` to `high` become lower where they would meet over a
    /// hollow or in the middle of a hump.
    pub fn stand(&mut self, anchor: f64, [low, high]: [f64; 2]) {
        let [least, most] = self.curvatures();
        let fits = |curvature: f64, reach: f64| match curvature * reach > MOST_RISE {
            true => MOST_RISE / (curvature * reach),
            false => 1.0,
        };
        self.anchor = anchor;
        self.rise = fits(-least, high - anchor).min(fits(most, anchor - low));
    }

    /// Whether the surface is hollow: its mean curvature is negative.
    pub fn is_hollow(&self) -> bool {
        self.shape[0] + self.shape[2] < 0.0
    }

    /// The least and the greatest principal curvature.
    pub fn curvatures(&self) -> [f64; 2] {
        let [xx, xy, yy] = self.shape;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let spread = (half * half + xy * xy).sqrt();
        [mean - spread, mean + spread]
    }

    /// The bent place of a point of the flat stone.
    pub fn bent(&self, p: DVec3) -> DVec3 {
        let height = (p.z - self.anchor) * self.rise;
        let flat = p.truncate();
        let r = flat.length();
        if r == 0.0 {
            return DVec3::new(0.0, 0.0, height);
        }
        let d = flat / r;
        let turned = self.turned(d);
        let turn = (turned.dot(d) * r).clamp(-MOST_TURN, MOST_TURN);
        let (sin, cos, along, down) = arc(turn, r);
        let twist = turned.dot(d.perp()) * r;
        let normal = (d * sin + d.perp() * twist).extend(cos).normalize();
        (d * along).extend(-down) + normal * height + self.rest_at(flat)
    }

    /// By how much a normal leans for each unit of the way in the direction `d`, as a vector in the plane.
    fn turned(&self, d: DVec2) -> DVec2 {
        let [xx, xy, yy] = self.shape;
        DVec2::new(xx * d.x + xy * d.y, xy * d.x + yy * d.y)
    }

    fn rest_at(&self, p: DVec2) -> DVec3 {
        let mut weights = 1.0 / p.length_squared();
        let mut sum = DVec3::ZERO;
        for &(q, rest) in &self.rest {
            let square = (p - q).length_squared();
            let weight = 1.0 / square;
            if !weight.is_finite() {
                return rest;
            }
            weights += weight;
            sum += rest * weight;
        }
        match weights.is_finite() {
            true => sum / weights,
            false => DVec3::ZERO,
        }
    }
}

/// For an arc of length r that turns by `turn`: sine and cosine of the turn, and how far the arc's end lies along and
/// down.
fn arc(turn: f64, r: f64) -> (f64, f64, f64, f64) {
    if turn.abs() < SMALL {
        let square = turn * turn;
        return (
            turn,
            1.0 - 0.5 * square,
            r * (1.0 - square / 6.0),
            0.5 * r * turn,
        );
    }
    let (sin, cos) = (libm::sin(turn), libm::cos(turn));
    (sin, cos, r * sin / turn, r * (1.0 - cos) / turn)
}

/// The symmetric matrix S for which S p is nearest to the angle that each normal leans by (least squares).
fn fitted(places: &[DVec2], normals: &[DVec3]) -> [f64; 3] {
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    let mut sums = DVec3::ZERO;
    for (p, n) in places.iter().zip(normals) {
        let lean = n.truncate();
        let sine = lean.length();
        if sine > 0.0 {
            let lean = lean * (libm::atan2(sine, n.z) / sine);
            let both = p.y * lean.x + p.x * lean.y;
            sums += DVec3::new(p.x * lean.x, both, p.y * lean.y);
        }
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
    }
    // Rows of the normal equations, solved by Cramer's rule.
    let rows = [
        DVec3::new(xx, xy, 0.0),
        DVec3::new(xy, xx + yy, xy),
        DVec3::new(0.0, xy, yy),
    ];
    let whole = rows[0].dot(rows[1].cross(rows[2]));
    let size = greater(xx + yy, f64::MIN_POSITIVE);
    if whole <= 1e-9 * size * size * size {
        // The corners lie on a line, or there are none.
        let mean = (sums.x + sums.z) / size;
        return [mean, 0.0, mean];
    }
    let [a, b, c] = rows;
    let solved = (b.cross(c) * sums.x + c.cross(a) * sums.y + a.cross(b) * sums.z) / whole;
    solved.to_array()
}
