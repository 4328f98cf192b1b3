//! How a packed cell fares among its neighbours: pressed into them, or left alone.

use crate::domain::Domain;
use crate::packing::{Grid, Particle, force::Pair};
use glam::DVec2;

/// A cell's lot, each 0..=1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// How deep it and its neighbours stand in each other; 1 from [`DEEP`] on.
    pub pressed: f32,
    /// The share of its sides along which there is neither a neighbour nor the boundary.
    pub alone: f32,
}

/// An overlap of this share of the stable distance counts in full ...
const DEEP: f64 = 0.40;
/// ... and one of this share is what soft cells at rest have.
const REST: f64 = 0.08;
/// A side is open where no centre is within so many stable distances along it.
const OPEN: f64 = 1.35;

/// The lot of each particle, in their order.
pub fn stress(domain: &Domain, particles: &[Particle]) -> Vec<Stress> {
    let largest = particles.iter().fold(0.0_f64, |m, p| m.max(p.size));
    let (lo, hi) = domain.bounds();
    let mut grid = Grid::new(lo, hi, OPEN * largest.max(1.0));
    particles.iter().for_each(|p| grid.push(p.centre));
    let lot = |(own, particle): (usize, &Particle)| {
        let mut sides = [false; 4];
        let mut depth = 0.0_f64;
        grid.near(particle.centre, OPEN * largest, |other| {
            if other != own {
                meet(particle, &particles[other], &mut sides, &mut depth);
            }
        });
        let axis = along(particle);
        let ways = [axis, -axis, axis.perp(), -axis.perp()];
        let open = ways.iter().zip(sides).filter(|(way, taken)| {
            let beyond = particle.centre + **way * (1.1 * particle.size);
            !taken && domain.contains(beyond)
        });
        Stress {
            alone: open.count() as f32 / 4.0,
            pressed: ((depth - REST) / (DEEP - REST)).clamp(0.0, 1.0) as f32,
        }
    };
    particles.iter().enumerate().map(lot).collect()
}

/// A side's direction; x where the field has none.
pub fn along(particle: &Particle) -> DVec2 {
    match particle.axis == DVec2::ZERO {
        true => DVec2::X,
        false => particle.axis,
    }
}

/// What a neighbour changes: the side it stands at is taken, and it may reach in.
fn meet(particle: &Particle, other: &Particle, sides: &mut [bool; 4], depth: &mut f64) {
    let r = other.centre - particle.centre;
    let pair = Pair::new(particle, other);
    *depth = depth.max(pair.depth(r));
    let axis = along(particle);
    let q = DVec2::new(axis.dot(r), axis.perp_dot(r)) / pair.stable_distance();
    let (x, y) = (q.x.abs(), q.y.abs());
    if x >= y && x < OPEN && y < 0.75 {
        sides[usize::from(q.x < 0.0)] = true;
    }
    if y >= x && y < OPEN && x < 0.75 {
        sides[2 + usize::from(q.y < 0.0)] = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    fn row(places: &[(f64, f64)]) -> Vec<Stress> {
        let ring = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)];
        let domain = Domain::from_checked(&Outline {
            outer: ring.map(DVec2::from).to_vec(),
            holes: Vec::new(),
            ..Outline::default()
        });
        let particles: Vec<Particle> = (0..)
            .zip(places)
            .map(|(id, &(x, y))| Particle {
                id,
                centre: DVec2::new(x, y),
                kind: crate::field::Kind::Square,
                size: 10.0,
                aspect: 1.0,
                axis: DVec2::X,
                fixed: false,
            })
            .collect();
        stress(&domain, &particles)
    }

    #[test]
    fn a_cell_among_its_equals_is_at_ease() {
        let places: Vec<(f64, f64)> = (0..9)
            .map(|k| {
                (
                    40.0 + 10.0 * f64::from(k % 3),
                    40.0 + 10.0 * f64::from(k / 3),
                )
            })
            .collect();
        assert_eq!(row(&places)[4], Stress::default());
    }

    #[test]
    fn overlaps_press_and_gaps_leave_alone() {
        let lots = row(&[(50.0, 50.0), (55.0, 50.0), (20.0, 80.0)]);
        assert_eq!(lots[0].pressed, 1.0);
        assert_eq!(lots[0].alone, 0.75);
        assert_eq!(
            lots[2],
            Stress {
                pressed: 0.0,
                alone: 1.0
            }
        );
    }

    #[test]
    fn the_boundary_is_company() {
        assert_eq!(row(&[(5.0, 5.0)])[0].alone, 0.5);
    }
}
