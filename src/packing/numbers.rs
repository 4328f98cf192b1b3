//! Numbers of a packing at its present step: each cell with its neighbours, the energy by parts, and a hash of the
//! whole state.

use super::body::MovingParticle;
use super::force::{force_between, potential_between};
use super::packing_domain::{Boundary, MetricSpace};
use super::physics::Physics;
use super::run::Run;
use super::shape::CellShape;
use super::wall::{wall_force, wall_potential};
use super::{EnergyParts, Packing, PopulationChange};
use crate::domain::Domain;
use crate::hash::Hash;
use crate::order;
use glam::DVec2;

/// A packed cell in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct CellNumbers {
    /// Its number in order of creation.
    pub id: u32,
    /// Its centre, in picture units.
    pub centre: DVec2,
    /// Its size, in picture units.
    pub size: f64,
    /// Whether its centre is held.
    pub is_held: bool,
    /// Its velocity, in sizes per unit of time.
    pub velocity: DVec2,
    /// The sum of all forces on it, in sizes.
    pub force: DVec2,
    /// Half the sum of the potentials of its pairs, in its k0.
    pub energy: f64,
    /// The cells that it touches or may touch, by their ids.
    pub neighbours: Vec<NeighbourNumbers>,
}

impl CellNumbers {
    /// The smallest distance w to a neighbour, in stable distances; `None` without neighbours.
    pub fn smallest(&self) -> Option<f64> {
        let each = self.neighbours.iter().map(|near| near.w);
        each.reduce(f64::min)
    }
}

/// A neighbour of a packed cell in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeighbourNumbers {
    /// The neighbour's number.
    pub id: u32,
    /// The distance of the two, in stable distances.
    pub w: f64,
    /// The force of the neighbour on the cell, in the cell's size.
    pub force: DVec2,
}

impl<P: Copy> Run<P> {
    /// The sum of the squared sizes over the number of cells: the mean k0.
    pub(super) fn mean_stiffness(&self) -> f64 {
        let count = self.bodies.len().max(1) as f64;
        let sizes = self.bodies.iter().map(|b| b.particle.size);
        let mean: f64 = sizes.map(|size| size * size / count).sum();
        mean.max(f64::MIN_POSITIVE)
    }

    pub(super) fn energy_parts<S: MetricSpace<Place = P>, W: Boundary<Place = P>>(
        &mut self,
        metric: S,
        walls: W,
    ) -> EnergyParts {
        let pairs = self.sum_energy(metric);
        let Physics {
            mass, stiffness, ..
        } = self.params.physics;
        let mut near = Vec::new();
        let mut parts = EnergyParts::default();
        for body in &self.bodies {
            parts.walls += stiffness * wall_potential(body, walls, &mut near);
            parts.motion += 0.5 * mass * body.velocity.length_squared();
        }
        let unit = self.mean_stiffness();
        EnergyParts {
            pairs,
            walls: parts.walls / unit,
            motion: parts.motion / unit,
        }
    }
}

impl Packing {
    /// All cells in numbers, in the order of their ids.
    pub fn numbers(&mut self, domain: &Domain) -> Vec<CellNumbers> {
        let Physics {
            corners, stiffness, ..
        } = self.run.params.physics;
        let mut pairs = Vec::new();
        self.run.each_pair(domain, |a, b, (r, turn), (i, j)| {
            let (a, b) = (&a.particle, &b.particle);
            let (one, other) = (CellShape::of(a), CellShape::of(b).seen(turn));
            if one.may_touch(&other, r, (corners.square_reach(), 0.0)) {
                let w = one.normalised_distance(&other, r);
                let force = stiffness * force_between(a, b, (r, turn), corners);
                let energy = 0.5 * stiffness * potential_between(a, b, (r, turn), corners);
                pairs.push(([i, j], [a.id, b.id], [-force, force], w, energy));
            }
        });
        let mut near = Vec::new();
        let walls = &self.walls;
        let bodies = self.run.bodies.iter();
        let cell = |body: &MovingParticle<DVec2>| {
            let MovingParticle {
                particle, velocity, ..
            } = body;
            let size = particle.size;
            CellNumbers {
                id: particle.id,
                centre: particle.centre,
                size,
                is_held: particle.fixed,
                velocity: *velocity / size,
                force: stiffness * wall_force(body, walls, &mut near).0 / size,
                energy: 0.0,
                neighbours: Vec::new(),
            }
        };
        let mut cells: Vec<CellNumbers> = bodies.map(cell).collect();
        for ([i, j], [a, b], forces, w, energy) in pairs {
            for (own, id, force) in [(i, b, forces[0]), (j, a, forces[1])] {
                let own = &mut cells[own];
                let force = force / own.size;
                own.force += force;
                own.energy += energy / (own.size * own.size);
                own.neighbours.push(NeighbourNumbers { id, w, force });
            }
        }
        for cell in &mut cells {
            order::sort(&mut cell.neighbours, |near| (near.id.into(), 0));
        }
        order::sort(&mut cells, |cell| (cell.id.into(), 0));
        cells
    }

    /// The energy of all cells by parts.
    pub fn energy_parts(&mut self, domain: &Domain) -> EnergyParts {
        self.run.energy_parts(domain, &self.walls)
    }

    /// When and where cells came and went, in the order of steps.
    pub fn changes(&self) -> &[PopulationChange] {
        &self.run.changes
    }

    /// 16 hex digits that change with any bit of the state: ids, places, velocities and sizes of the cells, the
    /// step, and how many cells came and went.
    pub fn hash(&self) -> String {
        let mut hash = Hash::new();
        let report = self.report();
        for count in [report.step, report.added, report.removed] {
            hash.add(count.into());
        }
        let mut bodies: Vec<_> = self.run.bodies.iter().collect();
        order::sort(&mut bodies, |body| (body.particle.id.into(), 0));
        for MovingParticle {
            particle, velocity, ..
        } in bodies
        {
            hash.add(particle.id.into());
            let numbers = [particle.centre, *velocity].map(|v| v.to_array());
            for number in numbers.as_flattened() {
                hash.add(number.to_bits());
            }
            hash.add(particle.size.to_bits());
        }
        hash.text()
    }
}
