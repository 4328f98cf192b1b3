//! The steps of a packing, forward and back, and its numbers.

use super::Bubblestone;
use crate::cells::Cell;
use crate::generators::{JoinedTriangle, Steps};
use crate::packing::{CellNumbers, NeighbourNumbers, Particle, PopulationChange, force};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Bubblestone {
    /// Holds the packing at a step, or at its end if that comes earlier; without a step, lets go. `reach` does the
    /// work, and views of the packing show that step.
    pub fn hold(&mut self, step: Option<u32>) {
        if let Some(rewind) = self.studio.engine_mut().rewind() {
            rewind.hold(step);
        }
    }

    /// Works for about `budget` milliseconds towards the held step; true when it is reached.
    pub fn reach(&mut self, budget: f64) -> bool {
        let clock = &self.clock;
        let rewind = self.studio.engine_mut().rewind();
        rewind.is_none_or(|rewind| rewind.reach(&mut || clock.now(), budget))
    }

    /// Works for about `budget` milliseconds on the mesh and the polygons of the packing that is shown, at most 400
    /// cells; true when they are made. If the recipe's cells are those of scattered points, these are joined.
    #[wasm_bindgen(js_name = joinCells)]
    pub fn join_cells(&mut self, budget: f64) -> bool {
        let clock = &self.clock;
        let steps = self.studio.engine_mut().steps();
        steps.is_none_or(|steps| steps.join(&mut || clock.now(), budget))
    }

    /// Numbers of the joined cells, by a word:
    /// - 'points', 3 each: id, x, y.
    /// - 'faces', the elements of the mesh of these points, 4 ids each: the last one is -1 in a triangle.
    /// - 'angles', the smallest angles of the mesh's triangles, in degrees: their median, then their counts in 30
    ///   classes from 0 to 60; empty without triangles.
    /// - 'triangles', those of the plain Delaunay triangulation, 10 each: three ids, the angles there in degrees, the
    ///   shortest side, and the circle through the corners as x, y and radius.
    /// - 'cells', the polygons one after the other: id, number of corners, and x, y of each corner.
    pub fn joined(&mut self, part: &str) -> Vec<f64> {
        let mut numbers = Vec::new();
        let Some(joined) = self.steps().and_then(|steps| steps.joined()) else {
            return numbers;
        };
        match part {
            "points" => {
                for Particle { id, centre, .. } in &joined.points {
                    numbers.extend_from_slice(&[f64::from(*id), centre.x, centre.y]);
                }
            }
            "faces" => {
                for face in &joined.mesh.faces {
                    let nodes = face.nodes();
                    let id = |k| nodes.get(k).map_or(-1.0, |&k| joined.id(k).into());
                    numbers.extend_from_slice(&[0, 1, 2, 3].map(id));
                }
            }
            "angles" => {
                numbers.extend(joined.middle_angle);
                for &count in &joined.angles.counts {
                    numbers.push(count.into());
                }
            }
            "triangles" => {
                for triangle in &joined.triangles {
                    let JoinedTriangle {
                        shortest,
                        circle,
                        radius,
                        ..
                    } = triangle;
                    numbers.extend_from_slice(&triangle.ids.map(f64::from));
                    numbers.extend_from_slice(&triangle.angles);
                    numbers.extend_from_slice(&[*shortest, circle.x, circle.y, *radius]);
                }
            }
            "cells" => {
                for Cell { id, ring, .. } in &joined.cells {
                    numbers.extend_from_slice(&[f64::from(*id), ring.len() as f64]);
                    for corner in ring {
                        numbers.extend_from_slice(&[corner.x, corner.y]);
                    }
                }
            }
            _ => {}
        }
        numbers
    }

    /// All packed cells by rising ids, 11 numbers each: id, x, y, size, 1 if held, velocity x and y, force x and y,
    /// energy, and the smallest w (a neighbour's distance over the stable one; 0 without neighbours). Velocities and
    /// forces are in sizes, energies in k0.
    #[wasm_bindgen(js_name = packedCells)]
    pub fn packed_cells(&mut self) -> Vec<f64> {
        let cells = self.steps().map_or(Vec::new(), |steps| steps.numbers());
        let row = |cell: CellNumbers| {
            let (id, is_held) = (f64::from(cell.id), f64::from(u8::from(cell.is_held)));
            let least = cell.smallest().unwrap_or_default();
            let [at, by, force] = [cell.centre, cell.velocity, cell.force];
            [
                id,
                at.x,
                at.y,
                cell.size,
                is_held,
                by.x,
                by.y,
                force.x,
                force.y,
                cell.energy,
                least,
            ]
        };
        cells.into_iter().flat_map(row).collect()
    }

    /// The neighbours of a packed cell by rising ids, 4 numbers each: id, w, and the force on the cell, x and y.
    pub fn neighbours(&mut self, id: u32) -> Vec<f64> {
        let cells = self.steps().map_or(Vec::new(), |steps| steps.numbers());
        let own = cells.into_iter().find(|cell| cell.id == id);
        let near = own.map_or(Vec::new(), |cell| cell.neighbours);
        let row = |near: NeighbourNumbers| [near.id.into(), near.w, near.force.x, near.force.y];
        near.into_iter().flat_map(row).collect()
    }

    /// The energy of the packed cells in units of the mean cell's k0: of pairs, of walls, and of motion.
    #[wasm_bindgen(js_name = energyParts)]
    pub fn energy_parts(&mut self) -> Vec<f64> {
        let parts = self.steps().map(|steps| steps.energy_parts());
        let parts = parts.unwrap_or_default();
        vec![parts.pairs, parts.walls, parts.motion]
    }

    /// The cells that came and went, 5 numbers each: step, id, x, y, and 1 if it came.
    #[wasm_bindgen(js_name = populationChanges)]
    pub fn population_changes(&mut self) -> Vec<f64> {
        let changes = self
            .steps()
            .map_or(&[][..], |steps| steps.population_changes());
        let row = |change: &PopulationChange| {
            let (step, id) = (change.step.into(), change.id.into());
            let came = u8::from(change.came).into();
            [step, id, change.centre.x, change.centre.y, came]
        };
        changes.iter().flat_map(row).collect()
    }

    /// 16 hex digits that change with any bit of the packing's state; '' before there is one.
    #[wasm_bindgen(js_name = stateHash)]
    pub fn state_hash(&mut self) -> String {
        self.steps()
            .map_or(String::new(), |steps| steps.state_hash())
    }

    fn steps(&mut self) -> Option<&mut dyn Steps> {
        self.studio.engine_mut().steps()
    }
}

/// The bubble force (eq. 2) at a distance of w stable distances, in k0 / l0, and the potential (eq. 3), in k0.
#[wasm_bindgen(js_name = bubbleCurve)]
pub fn bubble_curve(w: f64) -> Vec<f64> {
    vec![force::bubble_force(w), force::bubble_potential(w)]
}
