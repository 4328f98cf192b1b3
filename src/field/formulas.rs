//! The formulas of size and aspect ratio that are sampled on the grid.

use super::{FieldParams, Grading, SoftSpot};
use crate::domain::Domain;
use glam::DVec2;

/// The factor of the size at a point that comes from the boundary and the spots.
pub(super) fn size_factor(params: &FieldParams, domain: &Domain, p: DVec2) -> f64 {
    let mut log = graded(&params.size_grading, domain, p);
    shares(&params.size_spots, domain, p, |share, value| {
        log += share * libm::log(value);
    });
    libm::exp(log)
}

/// The aspect ratio of stretched cells at a point.
pub(super) fn aspect(params: &FieldParams, domain: &Domain, p: DVec2) -> f64 {
    let mut log = libm::log(params.aspect) + graded(&params.aspect_grading, domain, p);
    shares(&params.aspect_spots, domain, p, |share, value| {
        log += share * (libm::log(value) - log);
    });
    libm::exp(log)
}

/// Calls `each` with share and value of the spots that reach a point.
fn shares(spots: &[SoftSpot], domain: &Domain, p: DVec2, mut each: impl FnMut(f64, f64)) {
    for spot in spots {
        let share = spot.share(domain.space().shortest(p - spot.centre));
        if share > 0.0 {
            each(share, spot.value);
        }
    }
}

fn graded(grading: &Grading, domain: &Domain, p: DVec2) -> f64 {
    if grading.is_flat() {
        0.0
    } else {
        grading.log_factor(depth(domain, p))
    }
}

/// Distance to the boundary and the constraint lines; 0 outside.
fn depth(domain: &Domain, p: DVec2) -> f64 {
    let boundary = domain.nearest(p).distance.max(0.0);
    domain
        .nearest_line(p)
        .map_or(boundary, |near| boundary.min(near.distance))
}
