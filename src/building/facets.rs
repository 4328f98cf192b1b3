//! Where arcs are cut into chords, so that all faces of one cylinder are cut at the same angles.

use super::piece::CircularArc;
use glam::DVec3;
use std::f64::consts::TAU;

/// The longest chord of an arc (metres).
const CHORD: f64 = 0.06;
/// The widest angle of a chord (radians).
const ANGLE: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// The most chords of a whole turn. Circles of over 190 m radius then have chords longer than [`CHORD`], which sag by
/// less than 0.2 mm.
const MOST: f64 = 20_000.0;
/// Cuts this close to the arc's ends are left out (metres): the ends lie on them.
pub(super) const NEAR: f64 = 1e-4;

/// The arc lengths (metres, rising) at which an arc is cut between its ends.
///
/// Cuts are at whole steps from a direction that depends on the axis alone. So arcs of one circle are cut at the same
/// places, whichever way they run and wherever they begin, and so are circles of one cylinder.
pub(super) fn cuts(arc: &CircularArc) -> Vec<f64> {
    let widest = ANGLE.min(CHORD / arc.radius).max(4.0 * NEAR / arc.radius);
    // Radii that differ by rounding must not differ in their number of steps.
    let step = TAU / (TAU / widest - 1e-6).ceil().min(MOST);
    let (start, sign) = absolute_start(arc);
    let start = start * sign * arc.sense();
    let near = NEAR / arc.radius;
    let sweep = (arc.to - arc.from).abs();
    let first = ((start + near) / step).floor() + 1.0;
    let angles = (0..).map(|k| (first + f64::from(k)) * step - start);
    let inner = angles.take_while(|&angle| angle < sweep - near);
    inner.map(|angle| angle * arc.radius).collect()
}

/// The angle of an arc's start in the frame of its axis, and +1 if the arc's angles grow with those of the frame, else
/// -1.
fn absolute_start(arc: &CircularArc) -> (f64, f64) {
    let normal = arc.x.cross(arc.y);
    let first = normal.to_array().into_iter().find(|c| c.abs() > 1e-6);
    let sign = first.unwrap_or(1.0).signum();
    let axis = normal * sign;
    let zero = perpendicular(axis);
    let start = super::piece::Piece::Arc(*arc).point(0.0) - arc.centre;
    let angle = libm::atan2(start.dot(axis.cross(zero)), start.dot(zero));
    (angle, sign)
}

/// A unit vector at right angles to the unit vector `axis`: the coordinate axis that is the farthest from it, made
/// perpendicular. If two are equally far, the first is used.
pub(super) fn perpendicular(axis: DVec3) -> DVec3 {
    let parts = axis.abs().to_array();
    let least = axis.abs().min_element() + 1e-6;
    let k = parts.iter().position(|&part| part <= least).unwrap_or(0);
    let e = DVec3::AXES[k];
    (e - axis * axis.dot(e)).normalize()
}

#[cfg(test)]
mod tests {
    use super::super::piece::Piece;
    use super::*;

    #[test]
    fn parts_of_a_circle_share_the_cuts_of_the_whole() {
        let axis = DVec3::new(0.3, -1.0, 0.2).normalize();
        let centre = DVec3::new(1.0, 2.0, 3.0);
        let zero = perpendicular(axis);
        for radius in [0.05, 0.3, 1.6, 12.0] {
            let start = centre + zero * radius;
            let whole = Piece::Arc(CircularArc::about(centre, axis, start, TAU));
            let all: Vec<DVec3> = match whole {
                Piece::Arc(arc) => cuts(&arc).into_iter().map(|s| whole.point(s)).collect(),
                Piece::Line { .. } => unreachable!(),
            };
            for (from, sweep, axis) in [(0.3, 1.0, axis), (5.0, 3.0, -axis), (-2.0, 6.0, axis)] {
                let begin =
                    Piece::Arc(CircularArc::about(centre, axis, start, TAU)).point(from * radius);
                let arc = CircularArc::about(centre, axis, begin, sweep);
                for arc in [
                    arc,
                    CircularArc {
                        from: arc.to,
                        to: arc.from,
                        ..arc
                    },
                ] {
                    let piece = Piece::Arc(arc);
                    let lengths = cuts(&arc);
                    assert!(lengths.len() as f64 + 2.0 > sweep / ANGLE);
                    let mut ends = vec![0.0];
                    ends.extend(&lengths);
                    ends.push(piece.length());
                    for pair in ends.windows(2) {
                        let chord = piece.point(pair[0]).distance(piece.point(pair[1]));
                        assert!(chord <= CHORD + 1e-9, "{chord}");
                    }
                    for s in lengths {
                        let p = piece.point(s);
                        let near = all.iter().chain([&start]).any(|q| q.distance(p) < 1e-9);
                        assert!(near, "{radius} {from} {s}");
                    }
                }
            }
        }
    }
}
