//! The surfaces of all cells in one file, cell by cell, and then the ground.
//!
//! Files are right-handed with y up, as in glTF. x runs to the right of the picture, z down it, and y is the height,
//! so from above the surface looks like the picture. One unit is the picture's side, the middle of the picture is at
//! x = z = 0, and the base level is y = 0. So the files of tiles repeat after 1.
//!
//! The picture's axes with the height pointing out of it are left-handed, since its y goes down. So the files
//! exchange height and y, and reverse each triangle.

use super::frame::ExportSpace;
use super::glb::Glb;
use super::maps::roughness;
use super::obj::Obj;
use super::order::{MeshFormat, MeshOrder};
use crate::cells::Cell;
use crate::heightfield::{GROUND, Planes, Surfaces, TextureParams, ground};
use crate::material::{FINISHES, Material};
use crate::solid::{Solid, Solids, Surface};

pub(super) enum Writer {
    Obj(Obj),
    Glb(Box<Glb>),
}

impl Writer {
    /// Adds the surface of the stone with this id, or of the ground for 0.
    pub fn add(&mut self, frame: &ExportSpace, surface: &Surface, id: u32) {
        match self {
            Self::Obj(obj) => obj.add(frame, surface, id),
            Self::Glb(glb) => glb.add(frame, surface, id),
        }
    }

    /// The next parts of the file, as far as they are complete.
    pub fn take(&mut self) -> Vec<Vec<u8>> {
        match self {
            Self::Obj(obj) => obj.take(),
            Self::Glb(_) => Vec::new(),
        }
    }

    /// The rest of the file, in parts.
    pub fn finish(self) -> Vec<Vec<u8>> {
        match self {
            Self::Obj(obj) => obj.finish(),
            Self::Glb(glb) => glb.finish(),
        }
    }
}

/// A mesh file that is being made.
pub struct MeshFile {
    surfaces: Surfaces,
    frame: ExportSpace,
    writer: Writer,
    /// About how many triangles each stone has.
    each: usize,
    /// Squares along a side of the ground.
    squares: usize,
    cells: usize,
}

impl MeshFile {
    /// An empty file for `stones` cells, for planes with these parameters and this table of materials.
    pub fn new(
        order: &MeshOrder,
        params: TextureParams,
        materials: &[Material],
        stones: usize,
    ) -> Self {
        let each = order.of_each(stones);
        let glb = || {
            let glb = Glb::new(mean_roughness(materials), order.images, params.tile);
            #[cfg(house)]
            let glb = glb.joined(order.joined);
            glb
        };
        let unit = 1.0 / params.side as f32;
        let frame = ExportSpace::Picture { unit };
        Self {
            surfaces: Surfaces::new(params, each),
            writer: match order.format {
                MeshFormat::Obj => Writer::Obj(Obj::new(&frame)),
                MeshFormat::Glb => Writer::Glb(Box::new(glb())),
            },
            frame,
            each,
            squares: order.ground_squares(stones, params.side),
            cells: 0,
        }
    }

    /// A maker of solids that are fine enough for this file.
    pub fn solids(&self) -> Solids {
        Solids::to_simplify(self.each)
    }

    /// Cells added so far.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Adds the solid of the next cell, in the order in which the planes were painted.
    pub fn add(&mut self, solid: &Solid, cell: &Cell, planes: &Planes) {
        let surface = self.surfaces.close(solid, cell, self.cells, planes);
        self.cells += 1;
        if !surface.positions.is_empty() {
            self.write(&surface, self.cells as u32);
        }
    }

    /// Adds the ground, after the last cell.
    pub fn add_ground(&mut self, planes: &Planes) {
        self.write(&ground(planes, self.squares), GROUND);
    }

    fn write(&mut self, surface: &Surface, id: u32) {
        self.writer.add(&self.frame, surface, id);
    }

    /// The next parts of the file, as far as they are complete.
    pub fn take(&mut self) -> Vec<Vec<u8>> {
        self.writer.take()
    }

    /// The rest of the file, in parts.
    pub fn finish(self) -> Vec<Vec<u8>> {
        self.writer.finish()
    }
}

/// The mean roughness of the stones' dry finishes, which follow that of the ground in the table.
pub(super) fn mean_roughness(materials: &[Material]) -> f32 {
    let stones = materials.get(1..=FINISHES).unwrap_or_default();
    let sum: f32 = stones
        .iter()
        .map(|o| roughness(f64::from(o.shininess)))
        .sum();
    if stones.is_empty() {
        1.0
    } else {
        sum / stones.len() as f32
    }
}
