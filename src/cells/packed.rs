//! The packed cells as they are: they overlap a little on bends and leave gaps.

use super::Cell;
use crate::packing::{Grid, Particle, force::Pair};

/// Allowed overlap with the nearest neighbour, as a share of the size. Cells that overlap more (between walls whose
/// distance is not a whole number of cells) are drawn smaller.
const OVERLAP: f64 = 0.11;
/// Corners of a round cell.
const CORNERS: u32 = 16;
/// The smallest scale at which a cell is drawn.
const SMALLEST: f64 = 0.8;

/// One cell for each particle, of its kind and along its axis.
pub fn packed(particles: &[Particle]) -> Vec<Cell> {
    let Some(first) = particles.first() else {
        return Vec::new();
    };
    let (mut lo, mut hi, mut largest) = (first.centre, first.centre, 0.0_f64);
    for p in particles {
        (lo, hi) = (lo.min(p.centre), hi.max(p.centre));
        largest = largest.max(p.size * p.aspect.sqrt());
    }
    let mut grid = Grid::new(lo, hi, largest);
    for p in particles {
        grid.push(p.centre);
    }
    particles
        .iter()
        .map(|p| {
            let scale = (nearest_distance(p, particles, &grid, largest) / (1.0 - OVERLAP))
                .clamp(SMALLEST, 1.0);
            Cell::new(p, p.ring(scale, CORNERS))
        })
        .collect()
}

/// The normalised distance of the nearest neighbour: 1 if the two just touch.
fn nearest_distance(p: &Particle, particles: &[Particle], grid: &Grid, largest: f64) -> f64 {
    let mut least = 1.0_f64;
    grid.near(p.centre, largest * std::f64::consts::SQRT_2, |k| {
        let other = &particles[k];
        if other.id != p.id {
            let depth = Pair::new(p, other).penetration(other.centre - p.centre);
            least = least.min(1.0 - depth);
        }
    });
    least
}
