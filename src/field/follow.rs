//! The sources of the direction field.

use super::sources::{SourceSegment, Sources};
use super::{Direction, FieldParams, ends};
use crate::domain::Domain;
use crate::planar::Space;
use glam::DVec2;

/// Sources with at most this strength are left out.
const FAINT: f64 = 0.02;

/// The unit vector of the spiral's ray, and the distance to the nearest point where it is undefined. On a torus, rays
/// from one point do not repeat. The rays of (sin x, sin y) do; their singular points are half a side apart.
fn ray(space: Space, params: &FieldParams, p: DVec2) -> (DVec2, f64) {
    let from = p - params.centre;
    let Some(side) = space.period() else {
        return (from.normalize_or_zero(), from.length());
    };
    let half = side / 2.0;
    let turn = from * (std::f64::consts::PI / half);
    let ray = DVec2::new(libm::sin(turn.x), libm::sin(turn.y));
    (
        ray.normalize_or_zero(),
        (from - half * (from / half).round()).length(),
    )
}

/// The direction that the sources are added to, and the distance to the nearest point where it is undefined. `along` is
/// the constant direction or, for a spiral, the direction relative to the rays. `None` for other directions.
pub(super) fn base(
    space: Space,
    params: &FieldParams,
    along: DVec2,
    p: DVec2,
) -> Option<(DVec2, f64)> {
    match params.direction {
        Direction::Constant => Some((along, f64::INFINITY)),
        Direction::Spiral => {
            let (ray, distance) = ray(space, params, p);
            Some((ray.rotate(along), distance))
        }
        _ => None,
    }
}

/// The layers of the direction: the symmetry of each and its sources; empty if the direction is constant. `symmetries`
/// are the symmetries of the cells' kinds.
pub(super) fn layers(
    domain: &Domain,
    params: &FieldParams,
    symmetries: [Option<u32>; 2],
) -> (Vec<u32>, Vec<Sources>) {
    if params.direction == Direction::Printed && !domain.segments().is_empty() {
        return (vec![1], vec![Sources::default()]);
    }
    let mut layers = (Vec::new(), Vec::new());
    for symmetry in symmetries.into_iter().flatten() {
        let list = sources(domain, params, symmetry);
        if params.direction == Direction::Spiral || !list.is_empty() {
            layers.0.push(symmetry);
            layers.1.push(Sources::new(list));
        }
    }
    layers
}

/// All sources of the direction.
pub(super) fn sources(domain: &Domain, params: &FieldParams, symmetry: u32) -> Vec<SourceSegment> {
    let mut list = Vec::new();
    let mut add = |segment, strength| {
        // A faint source must not count as the nearest, because sources far beyond the nearest are cut off.
        if strength > FAINT {
            list.extend(SourceSegment::new(segment, strength, symmetry));
        }
    };
    if params.direction == Direction::Boundary {
        // Squares need no weaker ends: a square fits at right angles to a wall as well as along it.
        let ends = if symmetry == 4 { 1.0 } else { params.ends };
        let strengths = ends::strengths(domain, ends);
        for (&segment, strength) in domain.segments().iter().zip(strengths) {
            add(segment, strength);
        }
    }
    if matches!(params.direction, Direction::Boundary | Direction::Strokes) {
        for &segment in domain.line_segments() {
            add(segment, 1.0);
        }
    }
    if params.direction != Direction::Printed {
        for stroke in &params.strokes {
            for pair in stroke.windows(2) {
                add([pair[0], pair[1]], 1.0);
            }
        }
    }
    list
}
