//! The sources of the direction: what it follows.

use super::sources::{Source, Sources};
use super::{Direction, FieldParams, ends};
use crate::domain::Domain;
use crate::planar::Space;
use glam::DVec2;

/// Sources of less strength are left out.
const FAINT: f64 = 0.02;

/// The unit vector of the spiral's ray, and the distance to the nearest point where it has none. Rays
/// from one point do not repeat: on a torus they are those of the sines, which have such points half a
/// side apart.
pub(super) fn ray(space: Space, params: &FieldParams, p: DVec2) -> (DVec2, f64) {
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

/// The symmetries of the direction's layers and the sources of each; nothing where the direction is
/// the same everywhere. `symmetries` are those that the cells' kinds have.
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

/// All that the direction follows.
pub(super) fn sources(domain: &Domain, params: &FieldParams, symmetry: u32) -> Vec<Source> {
    let mut list = Vec::new();
    let mut add = |segment, strength| {
        // What is left out does not hide what is farther away.
        if strength > FAINT {
            list.extend(Source::new(segment, strength, symmetry));
        }
    };
    if params.direction == Direction::Boundary {
        // At right angles to a wall a square stands as well as along it.
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
