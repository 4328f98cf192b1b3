//! Cells on the periodic picture: their mesh is made with images of the cells around the picture.
//!
//! Places are rounded to the grain, in which a picture's side is a whole number: an image is then
//! exactly one side away, and rings on the two sides of a seam agree to the last bit.

use super::Cell;
use crate::domain::Domain;
use crate::order;
use crate::packing::Particle;
use crate::planar::on_grain;
use glam::DVec2;

/// Images farther than this many pictures away are not made.
const FARTHEST: f64 = 8.0;

/// The cells with their places on the grain, then their images up to `margin` sizes around the
/// picture. All are moved a little, by less than a thousandth of a picture unit and each by its id:
/// on an even lattice it would be for chance to choose a diagonal, once here and once at the image.
pub(super) fn spread(side: f64, particles: &[Particle], margin: f64) -> Vec<Particle> {
    let largest = particles.iter().fold(0.0_f64, |m, p| m.max(p.size));
    let margin = (margin * largest).min(FARTHEST * side);
    let far = (margin / side).ceil();
    let mut all: Vec<Particle> = particles.to_vec();
    for p in &mut all {
        let noise = p.id.wrapping_mul(0x9e37_79b1);
        let step = |shift: u32| f64::from((noise >> shift) & 127) - 63.0;
        p.centre = on_grain(p.centre) + DVec2::new(step(25), step(18)) / 131_072.0;
    }
    let count = all.len();
    let (lo, hi) = (DVec2::splat(-margin), DVec2::splat(side + margin));
    for shift in shifts(side, far) {
        for k in 0..count {
            let mut image = all[k];
            image.centre += shift;
            if image.centre.cmpge(lo).all() && image.centre.cmple(hi).all() {
                all.push(image);
            }
        }
    }
    all
}

/// To all pictures up to `far` away, but not to the first itself.
fn shifts(side: f64, far: f64) -> Vec<DVec2> {
    let mut shifts = Vec::new();
    let far = far as i32;
    for y in -far..=far {
        for x in -far..=far {
            if (x, y) != (0, 0) {
                shifts.push(DVec2::new(f64::from(x), f64::from(y)) * side);
            }
        }
    }
    shifts
}

/// Do the rings close up over the seams: has every side of one the same side of another, run the
/// other way?
pub(super) fn closes(domain: &Domain, rings: &[Vec<DVec2>]) -> bool {
    let key = |p: DVec2| (order::rank(p.x), order::rank(p.y));
    // Every side by its start in the picture and the way to its end; adding 0 makes of -0 a 0.
    let mut sides: Vec<[DVec2; 2]> = Vec::new();
    for ring in rings {
        let next = ring.iter().cycle().skip(1);
        sides.extend(
            ring.iter()
                .zip(next)
                .map(|(&a, &b)| [domain.wrap(a), b - a + 0.0]),
        );
    }
    order::sort(&mut sides, |s| key(s[1]));
    order::sort(&mut sides, |s| key(s[0]));
    let name = |s: &[DVec2; 2]| (key(s[0]), key(s[1]));
    rings.iter().all(|ring| ring.len() >= 3)
        && sides.windows(2).all(|w| name(&w[0]) != name(&w[1]))
        && sides.iter().all(|&[a, by]| {
            let back = name(&[domain.wrap(a + by), 0.0 - by]);
            sides.binary_search_by_key(&back, name).is_ok()
        })
}

/// Images of the cells that reach over the edges of the picture, with which every corner in the
/// picture has all its cells around it.
pub(super) fn images(domain: &Domain, cells: &[Cell]) -> Vec<Cell> {
    let Some(side) = domain.period() else {
        return Vec::new();
    };
    let mut images = Vec::new();
    for cell in cells {
        let first = cell.ring[0];
        let (lo, hi) = cell
            .ring
            .iter()
            .fold((first, first), |(lo, hi), &p| (lo.min(p), hi.max(p)));
        for shift in shifts(side, 2.0) {
            let reaches = (lo + shift).cmple(DVec2::splat(side)).all()
                && (hi + shift).cmpge(DVec2::ZERO).all();
            if reaches {
                let mut image = cell.clone();
                image.centre += shift;
                for p in &mut image.ring {
                    *p += shift;
                }
                images.push(image);
            }
        }
    }
    images
}

/// The points that are images of others: (the one in the picture, the image, the way there), by the
/// first.
pub(super) fn twins(domain: &Domain, points: &[DVec2]) -> Vec<(u32, u32, DVec2)> {
    if domain.period().is_none() {
        return Vec::new();
    }
    let key = |k: u32| {
        let p = domain.wrap(points[k as usize]);
        (order::rank(p.x), order::rank(p.y))
    };
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order::sort(&mut order, |&k| key(k));
    let mut twins = Vec::new();
    for same in order.chunk_by(|&a, &b| key(a) == key(b)) {
        let at_home = |&&k: &&u32| points[k as usize] == domain.wrap(points[k as usize]);
        let home = same.iter().find(at_home).copied().unwrap_or(same[0]);
        for &k in same.iter().filter(|&&k| k != home) {
            twins.push((home, k, points[k as usize] - points[home as usize]));
        }
    }
    order::sort(&mut twins, |t| (order::pair(t.0, t.1), 0));
    twins
}
