//! The packed squares as cells: they overlap a little on bends and leave gaps.

use super::Cell;
use crate::packing::{Grid, Particle};
use glam::DVec2;

/// A square may overlap its nearest neighbour by this share of a size; where the packing pressed
/// it closer (between walls that are no whole number of cells apart) it is drawn smaller.
const OVERLAP: f64 = 0.11;
/// But never smaller than this share of its size.
const SMALLEST: f64 = 0.8;

/// One square per particle, along the particle's axis.
pub fn packed(particles: &[Particle]) -> Vec<Cell> {
    let Some(first) = particles.first() else {
        return Vec::new();
    };
    let (mut lo, mut hi, mut largest) = (first.centre, first.centre, 0.0_f64);
    for p in particles {
        (lo, hi) = (lo.min(p.centre), hi.max(p.centre));
        largest = largest.max(p.size);
    }
    let mut grid = Grid::new(lo, hi, largest);
    for p in particles {
        grid.push(p.centre);
    }
    particles
        .iter()
        .map(|p| {
            let scale =
                (closeness(p, particles, &grid, largest) / (1.0 - OVERLAP)).clamp(SMALLEST, 1.0);
            let e = p.axis.normalize_or(DVec2::X) * (0.5 * scale * p.size);
            let f = e.perp();
            Cell {
                id: p.id,
                centre: p.centre,
                kind: p.kind,
                size: p.size,
                aspect: p.aspect,
                axis: p.axis,
                ring: [-e - f, e - f, e + f, f - e].map(|c| p.centre + c).to_vec(),
            }
        })
        .collect()
}

/// How close the nearest neighbour is: 1 where the two squares, turned alike, just touch.
fn closeness(p: &Particle, particles: &[Particle], grid: &Grid, largest: f64) -> f64 {
    let axis = p.axis.normalize_or(DVec2::X);
    let mut least = 1.0_f64;
    grid.near(p.centre, largest * std::f64::consts::SQRT_2, |k| {
        let other = &particles[k];
        if other.id != p.id {
            let r = other.centre - p.centre;
            let apart = axis.dot(r).abs().max(axis.perp_dot(r).abs());
            least = least.min(2.0 * apart / (p.size + other.size));
        }
    });
    least
}
