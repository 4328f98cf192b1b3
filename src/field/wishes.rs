//! What the parameters wish at a point, before it is sampled.

use super::{FieldParams, Rim, Spot};
use crate::domain::Domain;
use glam::DVec2;

/// The factor of the size at a point, by the boundary's and the spots' share in it.
pub(super) fn growth(params: &FieldParams, domain: &Domain, p: DVec2) -> f64 {
    let mut log = rim(&params.size_rim, domain, p);
    shares(&params.size_spots, domain, p, |share, value| {
        log += share * libm::log(value);
    });
    libm::exp(log)
}

/// The aspect ratio of stretched cells at a point.
pub(super) fn stretch(params: &FieldParams, domain: &Domain, p: DVec2) -> f64 {
    let mut log = libm::log(params.aspect) + rim(&params.aspect_rim, domain, p);
    shares(&params.aspect_spots, domain, p, |share, value| {
        log += share * (libm::log(value) - log);
    });
    libm::exp(log)
}

/// The spots that count at a point: their share and value.
fn shares(spots: &[Spot], domain: &Domain, p: DVec2, mut each: impl FnMut(f64, f64)) {
    for spot in spots {
        let share = spot.share(domain.space().shortest(p - spot.centre));
        if share > 0.0 {
            each(share, spot.value);
        }
    }
}

fn rim(rim: &Rim, domain: &Domain, p: DVec2) -> f64 {
    if rim.is_flat() {
        0.0
    } else {
        rim.log_factor(depth(domain, p))
    }
}

/// Distance to the boundary and the constraint lines; 0 outside.
fn depth(domain: &Domain, p: DVec2) -> f64 {
    let boundary = domain.nearest(p).distance.max(0.0);
    domain
        .nearest_line(p)
        .map_or(boundary, |near| boundary.min(near.distance))
}
