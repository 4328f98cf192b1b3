//! The surfaces of all cells in one file, cell by cell.
//!
//! Files are right-handed with y up, as glTF wants it: x runs to the right of the picture, z down it,
//! and y is the height; seen from above, the surface looks as the picture. One unit is the picture's
//! side, with the middle of the picture at x = z = 0 and the base level at y = 0, so the files of
//! tiles repeat after 1.
//!
//! The picture's axes with the height pointing out of it are left-handed, since its y goes down. So the
//! files exchange height and y, and turn each triangle over.

use super::frame::Frame;
use super::glb::Glb;
use super::maps::roughness;
use super::obj::Obj;
use crate::cells::Cell;
use crate::heightfield::{Planes, Surfaces, TextureParams};
use crate::material::{FINISHES, Material};
use crate::solid::Solid;

/// A kind of mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Text; an object `cell_K` for the K-th cell, colours in sRGB after the positions.
    Obj,
    /// Binary glTF 2.0; one mesh, colours in linear light.
    Glb,
}

impl MeshFormat {
    /// All kinds with the endings of their files' names.
    pub const ALL: [(MeshFormat, &'static str); 2] =
        [(MeshFormat::Obj, "obj"), (MeshFormat::Glb, "glb")];
}

enum Writer {
    Obj(Obj),
    Glb(Box<Glb>),
}

/// A mesh file in the making.
pub struct MeshFile {
    surfaces: Surfaces,
    frame: Frame,
    writer: Writer,
    cells: usize,
}

impl MeshFile {
    /// A file without cells, for planes of these parameters and this table of materials.
    pub fn new(format: MeshFormat, params: TextureParams, materials: &[Material]) -> Self {
        Self {
            frame: Frame {
                unit: 1.0 / params.side as f32,
            },
            surfaces: Surfaces::new(params),
            writer: match format {
                MeshFormat::Obj => Writer::Obj(Obj::new()),
                MeshFormat::Glb => Writer::Glb(Box::new(Glb::new(mean_roughness(materials)))),
            },
            cells: 0,
        }
    }

    /// Cells added so far.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Adds the solid of the next cell of those that the planes were painted from.
    pub fn add(&mut self, solid: &Solid, cell: &Cell, planes: &Planes) {
        let surface = self.surfaces.close(solid, cell, self.cells, planes);
        if !surface.positions.is_empty() {
            match &mut self.writer {
                Writer::Obj(obj) => obj.add(&self.frame, &surface, self.cells),
                Writer::Glb(glb) => glb.add(&self.frame, &surface),
            }
        }
        self.cells += 1;
    }

    /// The next parts of the file, as far as they are known before the last cell is.
    pub fn take(&mut self) -> Vec<Vec<u8>> {
        match &mut self.writer {
            Writer::Obj(obj) => obj.take(),
            Writer::Glb(_) => Vec::new(),
        }
    }

    /// The rest of the file in parts, one after the other.
    pub fn finish(self) -> Vec<Vec<u8>> {
        match self.writer {
            Writer::Obj(obj) => obj.finish(),
            Writer::Glb(glb) => glb.finish(),
        }
    }
}

/// Of the stones' dry finishes, which come after the ground's.
fn mean_roughness(materials: &[Material]) -> f32 {
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
