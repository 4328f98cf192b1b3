//! Simple bodies: balls, pebbles, rings and blocks.

use super::shell::{Shell, bell, turned};
use super::{Mark, Part};
use glam::DVec3;
use std::f64::consts::TAU;

/// A ball with a painted band, as toys have.
pub(super) fn ball(level: usize) -> Shell {
    // Heights of the rings as angles from the pole, in degrees; the band has sharp borders.
    const RINGS: [f64; 25] = [
        0.0, 7.0, 14.0, 22.0, 30.0, 38.0, 46.0, 54.0, 62.0, 70.0, 71.0, 76.0, 83.0, 90.0, 97.0,
        104.0, 109.0, 110.0, 118.0, 126.0, 134.0, 143.0, 152.0, 166.0, 180.0,
    ];
    const COARSE: [f64; 11] = [
        0.0, 26.0, 49.0, 69.0, 71.0, 90.0, 109.0, 111.0, 131.0, 154.0, 180.0,
    ];
    const COARSEST: [f64; 8] = [0.0, 38.0, 68.0, 71.0, 109.0, 112.0, 142.0, 180.0];
    let (rings, around) = match level {
        0 => (&RINGS[..], 36),
        1 => (&COARSE[..], 20),
        _ => (&COARSEST[..], 12),
    };
    Shell::tube(rings.len(), around, |ring, angle| {
        let (y, r) = turned(rings[ring].to_radians());
        let (c, s) = turned(angle);
        let is_band = (71.0..=109.0).contains(&rings[ring]);
        let mark = if is_band {
            Mark::of(Part::Cap)
        } else {
            Mark::BODY
        };
        (DVec3::new(r * c, y, r * s), mark)
    })
}

/// A body that water has rounded: an ellipsoid with softened flats.
struct Pebble {
    axes: DVec3,
    /// The directions of the flats, with their distances from the centre.
    flats: &'static [[f64; 4]],
    /// How sharply flats meet: the exponent of the norm that joins them.
    sharp: f64,
    /// The direction across the bands, and the phase by which they advance in a unit (radians).
    bands: [f64; 4],
    /// The direction across a vein of quartz, and its distance from the centre.
    vein: Option<[f64; 4]>,
}

fn split([x, y, z, w]: [f64; 4]) -> (DVec3, f64) {
    (DVec3::new(x, y, z).normalize(), w)
}

impl Pebble {
    fn shell(&self) -> Shell {
        Shell::ball(11, |n| {
            let mut sum = libm::pow((n / self.axes).length(), self.sharp);
            for &flat in self.flats {
                let (to, far) = split(flat);
                sum += libm::pow((n.dot(to) / far).max(0.0), self.sharp);
            }
            let p = n * libm::pow(sum, -1.0 / self.sharp);
            let wobble = libm::sin(2.3 * p.x + 3.1 * p.y + 0.5) * libm::sin(2.9 * p.z - 1.2 * p.x);
            let p = p * (1.0 + 0.028 * wobble);
            (p, self.mark(p))
        })
    }

    fn mark(&self, p: DVec3) -> Mark {
        let (across, count) = split(self.bands);
        let bent = p.dot(across) + 0.06 * libm::sin(3.0 * p.x + 2.0 * p.z);
        let band = 0.6 * libm::sin(count * bent) + 0.4 * libm::sin(2.3 * count * bent + 1.0);
        let Some(vein) = self.vein else {
            return Mark::BODY.shaded(band);
        };
        let (across, far) = split(vein);
        let share = bell((p.dot(across) + 0.05 * libm::sin(4.0 * p.y) - far) / 0.095);
        Mark::of(Part::Vein).shared(1.1 * share).shaded(band)
    }
}

/// A pebble of a river: still a little angular, with bands and a vein.
pub(super) fn pebble() -> Shell {
    Pebble {
        axes: DVec3::new(1.0, 0.58, 0.78),
        flats: &[
            [0.9, 0.5, 0.5, 0.80],
            [-0.8, 0.3, 0.7, 0.76],
            [0.2, 1.0, -0.3, 0.56],
            [-0.5, -0.9, 0.1, 0.58],
            [0.5, -0.2, -0.9, 0.74],
            [-0.7, 0.5, -0.8, 0.72],
        ],
        sharp: 9.0,
        bands: [0.35, 1.0, 0.2, 7.0],
        vein: Some([1.0, 0.5, 0.35, 0.18]),
    }
    .shell()
}

/// A pebble of a beach: smooth all around, with fine bands.
pub(super) fn smooth_pebble() -> Shell {
    Pebble {
        axes: DVec3::new(1.0, 0.56, 0.80),
        flats: &[[0.8, 0.2, 0.6, 0.95], [-0.3, 1.0, -0.2, 0.60]],
        sharp: 3.2,
        bands: [0.2, 0.25, 1.0, 9.0],
        vein: None,
    }
    .shell()
}

/// A ring with a round section, as toys have.
pub(super) fn torus() -> Shell {
    const SECTION: usize = 20;
    Shell::ring(SECTION, 44, |k, angle| {
        let (c, s) = turned(TAU * k as f64 / SECTION as f64);
        let (x, z) = turned(angle);
        let r = 0.68 + 0.32 * c;
        (DVec3::new(r * x, 0.32 * s, r * z), Mark::BODY)
    })
}

/// Half the sides of the block.
const BLOCK: DVec3 = DVec3::new(0.8, 0.5, 0.6);
/// The radius of its edges.
const ROUND: f64 = 0.085;

/// A block with rounded edges.
pub(super) fn block() -> Shell {
    // Three pieces of a quarter of a circle on each side of an edge, then the flat face.
    const CUTS: [f64; 14] = [
        -1.0, -0.97, -0.93, -0.89, -0.66, -0.44, -0.22, 0.22, 0.44, 0.66, 0.89, 0.93, 0.97, 1.0,
    ];
    Shell::cube(&CUTS, |p| {
        // A face is flat up to 0.89. Beyond that, the number is the share of a quarter circle along the rounded edge.
        let core = BLOCK - DVec3::splat(ROUND);
        let flat = p.clamp(DVec3::splat(-0.89), DVec3::splat(0.89)) / 0.89;
        let over = (p.abs() - DVec3::splat(0.89)) / 0.11;
        let part = DVec3::from(over.to_array().map(|x| match x {
            ..=0.0 => 0.0,
            x => libm::tan(0.25 * std::f64::consts::PI * x.min(1.0)),
        }));
        let out = part * p.signum();
        let is_edge = part.to_array().iter().filter(|&&x| x > 0.0).count() > 1;
        let mark = Mark::of(if is_edge { Part::Edge } else { Part::Body }).shared(0.5);
        let at = core * flat + ROUND * out.normalize_or_zero();
        // Year rings about the middle of the trunk, which lies beside the block.
        let trunk = libm::hypot(at.y + 1.1, at.z - 0.4 + 0.04 * libm::sin(2.0 * at.x));
        (at, mark.shaded(libm::sin(14.0 * trunk)))
    })
}
