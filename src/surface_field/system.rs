//! Equations between the representation vectors of neighbours, on finer and coarser meshes.

use crate::trimesh::adjacency::Adjacency;
use glam::DVec2;
use std::ops::Range;
use wide::f64x2;

/// The complex product of two vectors, the first one conjugated: `b` in the frame of `a`.
#[inline(always)]
pub(super) fn seen(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x, -a.y).rotate(b)
}

/// The matrix of the energy sum w |z_i - R_ij z_j|^2 in rows of complex numbers, with the constraints and areas of
/// its vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct System {
    pub start: Vec<u32>,
    pub to: Vec<u32>,
    /// Entries beside the diagonal: -w R^N.
    pub off: Vec<DVec2>,
    pub diagonal: Vec<f64>,
    pub mass: Vec<f64>,
    /// The weight of the constraint at each vertex ...
    pub held: Vec<f64>,
    /// ... and the weight times its representation vector.
    pub load: Vec<DVec2>,
    /// For each vertex the part of the mesh that it belongs to.
    pub part: Vec<u32>,
}

impl System {
    /// The system of a mesh, without rows yet: see [`System::row`].
    pub fn new(links: &Adjacency, part: Vec<u32>) -> Self {
        let mut system = Self {
            mass: links.mass.clone(),
            part,
            ..Self::default()
        };
        system.to.reserve_exact(links.to.len());
        system.off.reserve_exact(links.to.len());
        system.start.push(0);
        system
    }

    /// Adds the next row from the mesh's links, for directions of symmetry N, with its constraint.
    pub fn row(&mut self, links: &Adjacency, symmetry: u32, (held, load): (f64, DVec2)) {
        let v = self.diagonal.len();
        let mut diagonal = 0.0;
        for e in links.of(v) {
            let turn = crate::field::symmetry::representation(links.turn[e], symmetry);
            self.off.push(-links.weight[e] * turn);
            diagonal += links.weight[e];
        }
        self.to.extend(&links.to[links.of(v)]);
        self.diagonal.push(diagonal);
        self.start.push(self.to.len() as u32);
        self.held.push(held);
        self.load.push(load);
    }

    pub fn len(&self) -> usize {
        self.mass.len()
    }

    #[inline(always)]
    pub fn of(&self, row: usize) -> Range<usize> {
        self.start[row] as usize..self.start[row + 1] as usize
    }

    /// The product of a row's entries beside the diagonal with a vector.
    #[inline(always)]
    pub fn around(&self, row: usize, x: &[DVec2]) -> DVec2 {
        rotated_sum(self.entries(row), x)
    }

    /// The entries of a row beside the diagonal: columns and rotations.
    #[inline(always)]
    pub fn entries(&self, row: usize) -> impl Iterator<Item = (u32, DVec2)> {
        let to = self.to[self.of(row)].iter().copied();
        to.zip(self.off[self.of(row)].iter().copied())
    }
}

/// The product of some entries of a row with a vector.
#[inline(always)]
pub(super) fn rotated_sum(entries: impl Iterator<Item = (u32, DVec2)>, x: &[DVec2]) -> DVec2 {
    let mut sum = f64x2::ZERO;
    for (j, off) in entries {
        let DVec2 { x, y } = x[j as usize];
        sum += f64x2::new([off.x, off.y]) * x + f64x2::new([-off.y, off.x]) * y;
    }
    sum.to_array().into()
}

/// Terms added to the diagonal: constraints, or, in parts without any, a pull towards the current vectors.
#[derive(Clone, Debug, Default)]
pub(super) struct Holding {
    /// For each part, whether it has constraints.
    pub sourced: Vec<bool>,
    /// The pull in parts without constraints, by area.
    pub pull: f64,
    /// The pull in parts with constraints, in addition to the constraints.
    pub polish: f64,
}

impl Holding {
    #[inline(always)]
    pub fn is_sourced(&self, system: &System, v: usize) -> bool {
        self.sourced[system.part[v] as usize]
    }

    /// The term added to the diagonal of a row.
    #[inline(always)]
    pub fn more(&self, system: &System, v: usize) -> f64 {
        if self.is_sourced(system, v) {
            system.held[v] + self.polish * system.mass[v]
        } else {
            self.pull * system.mass[v]
        }
    }

    /// The right-hand side of a row with the current vector `now`.
    #[inline(always)]
    pub fn right(&self, system: &System, v: usize, now: DVec2) -> DVec2 {
        if self.is_sourced(system, v) {
            system.load[v] + self.polish * system.mass[v] * now
        } else {
            self.pull * system.mass[v] * now
        }
    }
}

/// A system, with the maps that carry vectors of the next coarser system to its rows. The coarsest level has no maps.
#[derive(Clone, Debug, Default)]
pub(super) struct SystemLevel {
    pub system: System,
    /// For each row its group, which is a row of the coarser system ...
    pub group: Vec<u32>,
    /// ... and the rotation that carries the group's vector to it.
    pub carry: Vec<DVec2>,
}

/// No group yet.
const FREE: u32 = u32::MAX;

/// Makes a coarser system in slices. A vertex and its neighbours form a group that moves as one; each member's vector
/// is the group's, carried along the edge between them (aggregation multigrid: Vanek, Mandel, Brezina 1996). A smooth
/// slope becomes steps between groups, which are steep over one edge only. So the coarse matrix is too stiff by the
/// width of a group, and is divided by it (Braess 1995, Towards Algebraic Multigrid for Elliptic Problems).
#[derive(Clone, Debug)]
pub(super) struct Coarsening {
    pub coarse: System,
    /// For each vertex its group ...
    pub group: Vec<u32>,
    /// ... and the rotation that carries the group's vector to it.
    pub carry: Vec<DVec2>,
    /// Members, sorted by group; those of group g begin at `first[g]`.
    first: Vec<u32>,
    members: Vec<u32>,
    /// For each group, where its entry is in the current row.
    place: Vec<u32>,
    count: u32,
    stage: u32,
    at: usize,
}

impl Coarsening {
    pub fn begin(fine: &System) -> Self {
        Self {
            coarse: System::default(),
            group: vec![FREE; fine.len()],
            carry: vec![DVec2::X; fine.len()],
            first: Vec::new(),
            members: Vec::new(),
            place: Vec::new(),
            count: 0,
            stage: 0,
            at: 0,
        }
    }

    /// Works on at most `amount` rows; true when done.
    pub fn advance(&mut self, fine: &System, amount: usize) -> bool {
        // A group's row sums the rows of its members, about 13.
        let (all, amount) = if self.stage < 3 {
            (fine.len(), amount)
        } else {
            (self.count as usize, amount / 13)
        };
        let end = all.min(self.at.saturating_add(amount.max(1)));
        for v in self.at..end {
            match self.stage {
                0 => self.found(fine, v),
                1 => self.join(fine, v),
                2 => self.sort_in(v),
                _ => self.row(fine, v),
            }
        }
        self.at = end;
        if end < all {
            return false;
        }
        self.at = 0;
        self.stage += 1;
        if self.stage == 2 {
            self.sum_up(fine.len());
        }
        self.stage > 3
    }

    /// A vertex that is in no group, and has no neighbour in one, founds a group with all its neighbours.
    fn found(&mut self, fine: &System, v: usize) {
        let neighbours = &fine.to[fine.of(v)];
        if self.group[v] != FREE || neighbours.iter().any(|&j| self.group[j as usize] != FREE) {
            return;
        }
        self.group[v] = self.count;
        for e in fine.of(v) {
            let j = fine.to[e] as usize;
            self.group[j] = self.count;
            // The inverse of the rotation that takes the neighbour's vector to the founder's.
            self.carry[j] = back(fine.off[e]);
        }
        self.count += 1;
    }

    /// Other vertices join the group of the neighbour with the greatest weight. `place` keeps the groups as they were
    /// before.
    fn join(&mut self, fine: &System, v: usize) {
        if v == 0 {
            self.place = self.group.clone();
        }
        if self.group[v] != FREE {
            return;
        }
        let mut best = (0.0, 0);
        for e in fine.of(v) {
            let weight = fine.off[e].length_squared();
            if self.place[fine.to[e] as usize] != FREE && weight > best.0 {
                best = (weight, e);
            }
        }
        if best.0 > 0.0 {
            let j = fine.to[best.1] as usize;
            self.group[v] = self.group[j];
            self.carry[v] = (-fine.off[best.1]).normalize().rotate(self.carry[j]);
        } else {
            self.group[v] = self.count;
            self.count += 1;
        }
    }

    fn sum_up(&mut self, rows: usize) {
        let groups = self.count as usize;
        self.first = vec![0; groups + 1];
        for &g in &self.group {
            self.first[g as usize + 1] += 1;
        }
        for g in 0..groups {
            self.first[g + 1] += self.first[g];
        }
        self.members = vec![0; rows];
        self.place = self.first.clone();
        self.coarse.start.push(0);
    }

    fn sort_in(&mut self, v: usize) {
        let next = &mut self.place[self.group[v] as usize];
        self.members[*next as usize] = v as u32;
        *next += 1;
    }

    fn row(&mut self, fine: &System, g: usize) {
        if g == 0 {
            self.place = vec![FREE; self.count as usize];
        }
        let coarse = &mut self.coarse;
        let begin = coarse.to.len();
        let (mut diagonal, mut mass, mut held, mut load) = (0.0, 0.0, 0.0, DVec2::ZERO);
        let members = &self.members[self.first[g] as usize..self.first[g + 1] as usize];
        for &v in members {
            let v = v as usize;
            let own = self.carry[v];
            diagonal += fine.diagonal[v];
            mass += fine.mass[v];
            held += fine.held[v];
            load += seen(own, fine.load[v]);
            for e in fine.of(v) {
                let j = fine.to[e] as usize;
                let entry = seen(own, fine.off[e].rotate(self.carry[j]));
                let other = self.group[j];
                if other as usize == g {
                    diagonal += entry.x;
                    continue;
                }
                let place = &mut self.place[other as usize];
                if *place == FREE || (*place as usize) < begin {
                    *place = coarse.to.len() as u32;
                    coarse.to.push(other);
                    coarse.off.push(DVec2::ZERO);
                }
                coarse.off[*place as usize] += entry;
            }
        }
        let soft = (f64::from(self.count) / fine.len() as f64).sqrt();
        for off in &mut coarse.off[begin..] {
            *off *= soft;
        }
        coarse.diagonal.push(diagonal * soft);
        coarse.mass.push(mass);
        coarse.held.push(held);
        coarse.load.push(load);
        coarse.part.push(fine.part[members[0] as usize]);
        coarse.start.push(coarse.to.len() as u32);
    }
}

fn back(off: DVec2) -> DVec2 {
    let turn = (-off).normalize_or(DVec2::X);
    DVec2::new(turn.x, -turn.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::samples;

    fn energy(system: &System, x: &[DVec2]) -> f64 {
        let row = |v: usize| x[v].dot(system.diagonal[v] * x[v] + system.around(v, x));
        (0..system.len()).map(row).sum()
    }

    #[test]
    fn a_coarse_vector_has_the_energy_of_the_fine_one_it_stands_for() {
        for mesh in [samples::blob(3), samples::hill(20)] {
            let links = Adjacency::build(&mesh);
            let mut fine = System::new(&links, vec![0; links.len()]);
            for _ in 0..links.len() {
                fine.row(&links, 4, (0.1, DVec2::new(0.0, 0.1)));
            }
            let mut work = Coarsening::begin(&fine);
            while !work.advance(&fine, 50) {}
            let coarse = &work.coarse;
            assert!(
                coarse.len() * 5 < fine.len(),
                "{} {}",
                coarse.len(),
                fine.len()
            );
            let x: Vec<DVec2> = (0..coarse.len())
                .map(|k| DVec2::new(libm::sin(k as f64), libm::cos(1.3 * k as f64)))
                .collect();
            let carried = |v: usize| work.carry[v].rotate(x[work.group[v] as usize]);
            let y: Vec<DVec2> = (0..fine.len()).map(carried).collect();
            let width = (fine.len() as f64 / coarse.len() as f64).sqrt();
            let (a, b) = (energy(coarse, &x) * width, energy(&fine, &y));
            assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
            let loads = |s: &System, x: &[DVec2]| -> f64 {
                s.load.iter().zip(x).map(|(a, b)| a.dot(*b)).sum()
            };
            assert!((loads(coarse, &x) - loads(&fine, &y)).abs() < 1e-9);
            assert!((coarse.mass.iter().sum::<f64>() / mesh.area() - 1.0).abs() < 1e-9);
        }
    }
}
