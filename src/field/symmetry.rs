//! Directions with rotational symmetry, as representation vectors.
//!
//! A quarter turn leaves a square unchanged, and half a turn a rectangle. So sums, storage and interpolation
//! use (cos N t, sin N t) with N the symmetry, never the angle t.

use glam::DVec2;

/// The representation vector (cos N t, sin N t) of a unit vector at angle t; N is 1, 2 or 4, or on surfaces
/// 6.
pub(crate) fn representation(e: DVec2, symmetry: u32) -> DVec2 {
    match symmetry {
        #[cfg(house)]
        6 => twice(twice(e).rotate(e)),
        4 => twice(twice(e)),
        2 => twice(e),
        _ => e,
    }
}

/// A unit vector with this representation: among the equivalent ones the one with the smallest angle to +x.
/// Zero stays zero.
pub(crate) fn direction_of(r: DVec2, symmetry: u32) -> DVec2 {
    if r == DVec2::ZERO {
        return r;
    }
    match symmetry {
        #[cfg(house)]
        6 => third(half(r)),
        4 => half(half(r)),
        2 => half(r),
        _ => r,
    }
}

fn twice(e: DVec2) -> DVec2 {
    DVec2::new(e.x * e.x - e.y * e.y, 2.0 * e.x * e.y)
}

/// Half the angle, by the half-angle formulas; each is used where it loses no digits.
fn half(r: DVec2) -> DVec2 {
    if r.x >= 0.0 {
        let c = ((1.0 + r.x) / 2.0).sqrt();
        DVec2::new(c, r.y / (2.0 * c))
    } else {
        let s = ((1.0 - r.x) / 2.0).sqrt();
        let s = if r.y < 0.0 { -s } else { s };
        DVec2::new(r.y / (2.0 * s), s)
    }
}

/// A third of an angle of at most a quarter turn. The chord's thirds are the first guess; Newton steps on the
/// circle then converge cubically.
#[cfg(house)]
fn third(r: DVec2) -> DVec2 {
    let mut e = DVec2::new(2.0 + r.x, r.y).normalize();
    for _ in 0..3 {
        let back = DVec2::new(e.x, -e.y);
        let off = twice(back).rotate(back).rotate(r);
        e = e.rotate(DVec2::new(2.0 + off.x, off.y)).normalize();
    }
    e
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::unit_vector;

    #[test]
    fn directions_come_back_from_their_representations() {
        for symmetry in [1, 2, 4, 6] {
            let sector = 180.0 / f64::from(symmetry);
            for k in 0..360 {
                let t = f64::from(k).to_radians();
                let e = unit_vector(t);
                let r = representation(e, symmetry);
                let back = direction_of(r, symmetry);
                assert!((representation(back, symmetry) - r).length() < 1e-12, "{k}");
                let turn = libm::atan2(back.y, back.x).to_degrees().abs();
                assert!(turn <= sector + 1e-6, "{k}: {back}");
            }
        }
    }
}
