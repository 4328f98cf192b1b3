//! From a cell's ring to the few corners of a stone's footprint.

use crate::domain::{cross, signed_area};
use crate::order;
use crate::planar::unit_vector;
use glam::DVec2;

/// Most corners of a stone; a ring along a curved boundary has more points.
pub const MOST_CORNERS: usize = 12;

/// Most points of a ring that are looked at: of a longer ring, some are skipped evenly. The work grows with the square
/// of their number.
const MOST_POINTS: usize = 1000;

/// A convex corner that stands out less than this (in roots of the area) is dropped.
const FLAT: f64 = 0.035;
/// The same limit for a reflex corner: dropping it costs area on both sides, so it is kept longer.
const FLAT_REFLEX: f64 = 0.012;
/// Candidate centres along a side of the ring's box, tried if neither centroid nor particle sees all corners.
const CANDIDATES: usize = 12;
/// Angle between a corner and the rays to either side of it, in radians.
const SIDE_RAY: f64 = 1e-5;

/// The footprint of a stone: star-shaped about its centre and inside the cell's ring.
#[derive(Clone, Debug)]
pub struct Footprint {
    /// A point that sees every corner.
    pub centre: DVec2,
    /// 3 to [`MOST_CORNERS`] corners, clockwise on screen.
    pub corners: Vec<DVec2>,
    /// Unit vector of the longer principal axis.
    pub axis: DVec2,
    /// Half extents along `axis` and across it, of the rectangle with equal second moments.
    pub half: DVec2,
    /// Root of the ring's area: the stone's size.
    pub size: f64,
    /// Whether the ring is convex: then convex combinations of points in it stay in it.
    pub convex: bool,
    ring: Vec<DVec2>,
}

impl Footprint {
    /// `None` if the ring has no appreciable area.
    pub fn new(ring: &[DVec2], hint: DVec2) -> Option<Self> {
        let ring = cleaned(ring)?;
        let area = signed_area(&ring);
        let (centre, ring) = star(ring, hint)?;
        let corners = contained(&ring, centre, simplified(&ring, centre, area.sqrt()));
        let (axis, half) = principal(&ring, centre);
        let convex = (0..ring.len()).all(|i| bend(&ring, i) >= -1e-9 * area);
        Some(Self {
            centre,
            corners,
            axis,
            half,
            size: area.sqrt(),
            convex,
            ring,
        })
    }

    /// The distance from the centre to the ring in the direction of `towards` (of any length but zero).
    pub fn reach(&self, towards: DVec2) -> f64 {
        reach(&self.ring, self.centre, towards) * towards.length()
    }

    /// `p`, moved towards the centre until it lies in the ring enlarged `scale` times.
    pub fn kept_in(&self, p: DVec2, scale: f64) -> DVec2 {
        let arm = p - self.centre;
        if arm == DVec2::ZERO {
            return p;
        }
        let limit = reach(&self.ring, self.centre, arm) * scale;
        if limit >= 1.0 {
            p
        } else {
            self.centre + arm * limit
        }
    }
}

/// The ring without repeated points, clockwise; `None` if too little is left.
fn cleaned(ring: &[DVec2]) -> Option<Vec<DVec2>> {
    if ring.iter().any(|p| !p.is_finite()) {
        return None;
    }
    let extent = ring
        .iter()
        .map(|p| (*p - ring[0]).length())
        .fold(0.0, f64::max);
    let near = |a: DVec2, b: DVec2| (a - b).length() <= 1e-7 * extent;
    let mut kept: Vec<DVec2> = Vec::new();
    for &p in ring.iter().step_by(ring.len().div_ceil(MOST_POINTS).max(1)) {
        if kept.last().is_none_or(|&q| !near(p, q)) {
            kept.push(p);
        }
    }
    while kept.len() > 1 && near(kept[0], kept[kept.len() - 1]) {
        kept.pop();
    }
    let area = signed_area(&kept);
    if area < 0.0 {
        kept.reverse();
    }
    // A thinner stone is invisible, and its principal axis would be noise.
    let thin = area.abs() < 1e-4 * extent * extent || area.abs() < 1e-4;
    (kept.len() >= 3 && !thin).then_some(kept)
}

/// A centre, and a ring that is star-shaped about it.
fn star(ring: Vec<DVec2>, hint: DVec2) -> Option<(DVec2, Vec<DVec2>)> {
    let centroid = centroid(&ring);
    if let Some(&centre) = [centroid, hint].iter().find(|&&c| sees_all(&ring, c)) {
        return Some((centre, ring));
    }
    let best = deepest(&ring)?;
    if sees_all(&ring, best) {
        return Some((best, ring));
    }
    let seen = seen_from(&ring, best);
    let turns = |(a, b)| cross(best, a, b) > 0.0;
    (seen.len() >= 3 && sides(&seen).all(turns)).then_some((best, seen))
}

fn sees_all(ring: &[DVec2], centre: DVec2) -> bool {
    let tolerance = 1e-6 * signed_area(ring).abs();
    sides(ring).all(|(a, b)| cross(centre, a, b) > tolerance)
}

fn sides(ring: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()]))
}

fn centroid(ring: &[DVec2]) -> DVec2 {
    let origin = ring[0];
    let mut sum = DVec2::ZERO;
    let mut twice = 0.0;
    for (a, b) in sides(ring) {
        let area = cross(origin, a, b);
        sum += (a - origin + b - origin) * area;
        twice += area;
    }
    origin + sum / (3.0 * twice)
}

/// The grid point inside the ring that is farthest from its nearest wall; points that see all corners come first.
fn deepest(ring: &[DVec2]) -> Option<DVec2> {
    let low = ring.iter().copied().fold(DVec2::MAX, DVec2::min);
    let high = ring.iter().copied().fold(DVec2::MIN, DVec2::max);
    let mut best: Option<(bool, f64, DVec2)> = None;
    for k in 0..CANDIDATES * CANDIDATES {
        let cell = DVec2::new((k % CANDIDATES) as f64, (k / CANDIDATES) as f64);
        let p = low + (high - low) * (cell + 0.5) / CANDIDATES as f64;
        if !inside(ring, p) {
            continue;
        }
        let wall = sides(ring).map(|(a, b)| distance(p, a, b));
        let rank = (sees_all(ring, p), wall.fold(f64::MAX, f64::min), p);
        if best.is_none_or(|b| (rank.0, rank.1) > (b.0, b.1)) {
            best = Some(rank);
        }
    }
    best.map(|b| b.2)
}

fn distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let t = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (a + along * t - p).length()
}

/// Even-odd rule.
fn inside(ring: &[DVec2], p: DVec2) -> bool {
    let crossings = sides(ring).filter(|(a, b)| {
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossings.count() % 2 == 1
}

/// The part of the ring visible from `centre`: first hits of rays just beside each corner.
fn seen_from(ring: &[DVec2], centre: DVec2) -> Vec<DVec2> {
    let mut angles: Vec<f64> = ring
        .iter()
        .map(|p| libm::atan2(p.y - centre.y, p.x - centre.x))
        .flat_map(|a| [a - SIDE_RAY, a + SIDE_RAY])
        .collect();
    order::sort(&mut angles, |&a| (order::rank(a), 0));
    angles.dedup_by(|b, a| *b - *a < SIDE_RAY / 16.0);
    let hit = |&angle: &f64| {
        let ray = unit_vector(angle);
        // Hits of one ray on a wall's two ends differ by rounding; slightly less is always inside.
        centre + ray * first_hit(ring, centre, ray) * (1.0 - 1e-6)
    };
    angles.iter().map(hit).collect()
}

fn first_hit(ring: &[DVec2], centre: DVec2, ray: DVec2) -> f64 {
    let mut nearest = f64::MAX;
    for (a, b) in sides(ring) {
        let (u, v) = (a - centre, b - centre);
        let (left, right) = (ray.perp_dot(u), ray.perp_dot(v));
        if (left > 0.0) != (right > 0.0) {
            let t = left / (left - right);
            let along = (u + (v - u) * t).dot(ray);
            if along > 0.0 {
                nearest = nearest.min(along);
            }
        }
    }
    if nearest == f64::MAX { 0.0 } else { nearest }
}

/// Distance to the ring along `arm`, in lengths of `arm`; the ring is star-shaped about `centre`.
fn reach(ring: &[DVec2], centre: DVec2, arm: DVec2) -> f64 {
    let length = arm.length();
    if length == 0.0 {
        return f64::MAX;
    }
    first_hit(ring, centre, arm / length) / length
}

/// Height of corner `i` over its neighbours' chord, times the chord: negative if reflex.
fn bend(ring: &[DVec2], i: usize) -> f64 {
    let n = ring.len();
    let (before, after) = (ring[(i + n - 1) % n], ring[(i + 1) % n]);
    cross(before, ring[i], after)
}

/// Drops flat corners, flattest first, until the rest stand out and are few.
fn simplified(ring: &[DVec2], centre: DVec2, size: f64) -> Vec<DVec2> {
    let mut corners = ring.to_vec();
    while corners.len() > 3 {
        let n = corners.len();
        let flatness = |i: usize| {
            let (before, after) = (corners[(i + n - 1) % n], corners[(i + 1) % n]);
            if cross(centre, before, after) <= 1e-3 * size * size {
                return f64::MAX;
            }
            let out = bend(&corners, i) / (after - before).length();
            let scale = if out < 0.0 { FLAT_REFLEX } else { FLAT };
            out.abs() / (scale * size)
        };
        let (i, least) = (0..n)
            .map(|i| (i, flatness(i)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .expect("corners is not empty");
        if n <= MOST_CORNERS && least > 1.0 {
            break;
        }
        corners.remove(if least < f64::MAX {
            i
        } else {
            least_missed(&corners, centre)
        });
    }
    corners
}

/// The corner whose removal leaves its neighbours best visible from the centre. Among more than four corners
/// there is always one whose neighbours are less than half a turn apart.
fn least_missed(corners: &[DVec2], centre: DVec2) -> usize {
    let n = corners.len();
    let seen = |i: usize| cross(centre, corners[(i + n - 1) % n], corners[(i + 1) % n]);
    (0..n)
        .max_by(|&a, &b| seen(a).total_cmp(&seen(b)))
        .unwrap_or(0)
}

/// Moves the ends of every side towards the centre until the side passes inside the ring's points.
fn contained(ring: &[DVec2], centre: DVec2, corners: Vec<DVec2>) -> Vec<DVec2> {
    let n = corners.len();
    let mut factor = vec![1.0f64; n];
    for i in 0..n {
        let (a, b) = (corners[i] - centre, corners[(i + 1) % n] - centre);
        let side = a.perp_dot(b);
        for &p in ring {
            let arm = p - centre;
            if a.perp_dot(arm) < 0.0 || arm.perp_dot(b) < 0.0 || a.dot(arm) + b.dot(arm) < 0.0 {
                continue;
            }
            // The side's point in direction arm is arm times this.
            let at = side / (arm.perp_dot(b) + a.perp_dot(arm));
            let pull = (1.0 / at).clamp(0.0, 1.0);
            factor[i] = factor[i].min(pull);
            factor[(i + 1) % n] = factor[(i + 1) % n].min(pull);
        }
    }
    let drawn = corners.iter().zip(&factor);
    drawn.map(|(&c, &f)| centre + (c - centre) * f).collect()
}

/// Principal axis and half extents from the second moments about the centre.
fn principal(ring: &[DVec2], centre: DVec2) -> (DVec2, DVec2) {
    let (mut xx, mut xy, mut yy, mut twice) = (0.0, 0.0, 0.0, 0.0);
    for (a, b) in sides(ring) {
        let (a, b) = (a - centre, b - centre);
        let area = a.perp_dot(b);
        xx += area * (a.x * a.x + a.x * b.x + b.x * b.x) / 6.0;
        yy += area * (a.y * a.y + a.y * b.y + b.y * b.y) / 6.0;
        xy += area * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y) / 12.0;
        twice += area;
    }
    let (xx, xy, yy) = (xx / twice, xy / twice, yy / twice);
    let middle = (xx + yy) / 2.0;
    let spread = ((xx - yy) * (xx - yy) / 4.0 + xy * xy).sqrt();
    let long = if xx >= yy {
        DVec2::new(spread + (xx - yy) / 2.0, xy)
    } else {
        DVec2::new(xy, spread + (yy - xx) / 2.0)
    };
    let axis = long.try_normalize().unwrap_or(DVec2::X);
    // A rectangle with half extent a has the moment a^2 / 3.
    let half = |moment: f64| (3.0 * moment.max(0.0)).sqrt();
    (
        axis,
        DVec2::new(half(middle + spread), half(middle - spread)),
    )
}
