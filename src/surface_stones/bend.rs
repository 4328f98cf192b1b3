//! From the plane of a cell to its curved surface.
//!
//! A vertex at the distance r from the cell's centre, in the direction d, goes along the circle that touches the plane
//! there and has the surface's curvature in that direction, and then along the normal of the surface where it has
//! come to, which turns across d as well where the surface is twisted. What is left between the bent corners of the
//! ring and the true ones is spread over the stone by inverse squares of distances (Shepard 1968), with nothing left
//! at the centre: neighbours meet in their corners exactly.

use crate::order::greater;
use glam::{DVec2, DVec3};

/// No normal is turned farther, in radians.
const MOST_TURN: f64 = 1.5;
/// Stones reach over a hollow at most this part of its radius, and into a hump.
const MOST_RISE: f64 = 0.5;
/// Below this turn sines and cosines are taken from their series.
const SMALL: f64 = 1e-4;

/// How the surface of a cell curves away from its plane; all in picture units, in the plane's axes.
#[derive(Clone, Debug)]
pub struct Bend {
    /// The shape operator: xx, xy, yy. Above 0 the surface falls away from the plane.
    pub shape: [f64; 3],
    /// The height of stones that lies on the surface.
    pub anchor: f64,
    /// Heights from there are taken so many times.
    pub rise: f64,
    /// Corners of the ring, and how far they are from where they are bent to.
    rest: Vec<(DVec2, DVec3)>,
}

impl Bend {
    /// For a ring with corners at these places, with these normals, which are truly there. The shape is what turns
    /// normals most nearly so (least squares).
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

    /// From now on the height `anchor` lies on the surface. Stones from `low` to `high` are made lower where the
    /// surface curves so much that they would meet over a hollow, or in the middle of a hump.
    pub fn stand(&mut self, anchor: f64, [low, high]: [f64; 2]) {
        let [least, most] = self.curvatures();
        let fits = |curvature: f64, reach: f64| match curvature * reach > MOST_RISE {
            true => MOST_RISE / (curvature * reach),
            false => 1.0,
        };
        self.anchor = anchor;
        self.rise = fits(-least, high - anchor).min(fits(most, anchor - low));
    }

    /// The least and the greatest curvature.
    pub fn curvatures(&self) -> [f64; 2] {
        let [xx, xy, yy] = self.shape;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let spread = (half * half + xy * xy).sqrt();
        [mean - spread, mean + spread]
    }

    /// Where a place of the flat stone comes to.
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

    /// The direction that a normal leans to, for each unit of the way in a direction.
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

/// Sine and cosine of a turn over the length r of an arc, and how far its end is along and down.
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

/// The symmetric matrix S for which S p is most nearly what each normal leans to, as an angle.
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
    // Rows of the normal equations; determinants by Cramer's rule.
    let rows = [
        DVec3::new(xx, xy, 0.0),
        DVec3::new(xy, xx + yy, xy),
        DVec3::new(0.0, xy, yy),
    ];
    let whole = rows[0].dot(rows[1].cross(rows[2]));
    let size = greater(xx + yy, f64::MIN_POSITIVE);
    if whole <= 1e-9 * size * size * size {
        // All corners in a line, or none.
        let mean = (sums.x + sums.z) / size;
        return [mean, 0.0, mean];
    }
    let [a, b, c] = rows;
    let solved = (b.cross(c) * sums.x + c.cross(a) * sums.y + a.cross(b) * sums.z) / whole;
    solved.to_array()
}
