//! Quality measures that compare packings, meshes and cells, whatever made them.
//!
//! All are pure functions of the cells or the mesh, the outline and the fields. Areas are shares of the
//! outline's area, angles degrees. Nothing is computed unless it is requested.

mod cells;
mod cover;
mod figure;
mod mesh;

pub use cells::CellMetrics;
pub use cover::Cover;
pub use figure::Figure;
pub(crate) use figure::symmetry_angle;
pub(crate) use mesh::angles_of;
pub use mesh::{Jacobian, MeshMetrics, TriangleQuality, smallest_angles};

use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::Fields;
use crate::mesh::Mesh;
use crate::order;
use crate::packing::Particle;
use crate::planar::signed_angle;
use glam::DVec2;

/// Sides of a cell and edges at a node are counted up to this; larger numbers count as this.
pub const MOST_SIDES: usize = 12;

/// Numbers of items by their number of sides (or edges): entry k counts those with k.
pub type Histogram = [usize; MOST_SIDES + 1];

/// Quality measures of a pavement.
#[derive(Clone, Debug, PartialEq)]
pub struct Metrics {
    /// Measures of the cells' polygons.
    pub cells: CellMetrics,
    /// Measures of the mesh of their centres.
    pub mesh: MeshMetrics,
}

impl Metrics {
    /// Measures cells and mesh. The mesh's vertices are the particles' centres, in the same order.
    pub fn new(
        domain: &Domain,
        fields: &Fields,
        particles: &[Particle],
        mesh: &Mesh,
        cells: &[Cell],
    ) -> Self {
        Self {
            cells: CellMetrics::new(domain, fields, cells),
            mesh: MeshMetrics::new(domain, particles, mesh),
        }
    }
}

/// Sums numbers to their mean and standard deviation.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    weight: f64,
    sum: f64,
    squares: f64,
}

impl Tally {
    fn add(&mut self, x: f64) {
        self.add_weighted(x, 1.0);
    }

    fn add_weighted(&mut self, x: f64, weight: f64) {
        self.weight += weight;
        self.sum += weight * x;
        self.squares += weight * x * x;
    }

    /// `None` if empty.
    fn mean(&self) -> Option<f64> {
        (self.weight > 0.0).then(|| self.sum / self.weight)
    }

    /// The standard deviation over the mean, 0 if empty.
    fn variation(&self) -> f64 {
        let mean = self.mean().unwrap_or(0.0);
        if mean > 0.0 {
            (self.squares / self.weight - mean * mean).max(0.0).sqrt() / mean
        } else {
            0.0
        }
    }
}

/// The median; for an even count the mean of the two in the middle.
pub(crate) fn median(mut numbers: Vec<f64>) -> Option<f64> {
    order::sort(&mut numbers, |&x| (order::rank(x), 0));
    let n = numbers.len();
    let upper = *numbers.get(n / 2)?;
    Some(0.5 * (upper + numbers[(n - 1) / 2]))
}

/// The angle between a line and a direction, both unoriented, modulo `period` degrees: 0..period / 2.
fn angle(line: DVec2, direction: DVec2, period: f64) -> f64 {
    let turn = signed_angle(direction, line).to_degrees();
    let rest = turn - period * (turn / period).floor();
    rest.min(period - rest)
}

/// The directed edges of a ring, with the inside on the same hand as in the outline's outer ring.
fn ring_edges(ring: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    let back = crate::domain::signed_area(ring) < 0.0;
    let n = ring.len();
    (0..n).map(move |k| {
        let (a, b) = (ring[k], ring[(k + 1) % n]);
        if back { [b, a] } else { [a, b] }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::unit_vector;

    #[test]
    fn angles_are_folded() {
        let at = |degrees: f64| {
            let t = degrees.to_radians();
            unit_vector(t)
        };
        for (line, direction, period, wanted) in [
            (10.0, 0.0, 90.0, 10.0),
            (80.0, 0.0, 90.0, 10.0),
            (190.0, 0.0, 90.0, 10.0),
            (-10.0, 20.0, 60.0, 30.0),
            (100.0, 20.0, 60.0, 20.0),
            (260.0, 0.0, 180.0, 80.0),
        ] {
            assert!((angle(at(line), at(direction), period) - wanted).abs() < 1e-9);
        }
    }

    #[test]
    fn medians_and_variations() {
        assert_eq!(median(vec![]), None);
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.5));
        let mut tally = Tally::default();
        assert_eq!((tally.mean(), tally.variation()), (None, 0.0));
        for x in [1.0, 3.0] {
            tally.add(x);
        }
        assert_eq!((tally.mean(), tally.variation()), (Some(2.0), 0.5));
    }
}
