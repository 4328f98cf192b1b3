//! Lays a cell into its tangent plane, where stones are made, and maps stones back.

use super::QuadricPatch;
use crate::cells::Cell;
use crate::surface_cells::SurfaceCell;
use crate::trimesh::{SurfacePoint, TangentFrame, log};
use glam::{DVec2, DVec3};

/// A cell in its tangent plane, and the map back onto the surface.
#[derive(Clone, Debug)]
pub struct UnfoldedCell {
    /// The cell in picture units, with its centre at 0 and its axis along x. As in all pictures, y points down and
    /// rings run clockwise on screen.
    pub cell: Cell,
    /// The place of the centre, in the model's units.
    pub at: DVec3,
    /// The directions of the picture's x, its y and of heights, in the model. Seen from outside x points to the right
    /// and y down. So the three are left-handed, as are a picture's axes with heights towards the viewer, and nothing
    /// is mirrored.
    pub axes: [DVec3; 3],
    /// Picture units in a unit of the model.
    pub unit: f64,
    /// The curvature of the surface against the plane.
    pub bend: QuadricPatch,
}

impl UnfoldedCell {
    /// Lays the corners of a cell into its plane by the logarithmic map about its centre. `unit` is the number of
    /// picture units in a unit of the model.
    pub fn new(cell: &SurfaceCell, unit: f64) -> Self {
        let normal = cell.centre.normal;
        let frame = TangentFrame::of(normal);
        let along = cell.axis.normalize_or_zero();
        let right = match along == DVec2::ZERO {
            true => frame.x,
            false => frame.out(along),
        };
        let axes = [right, right.cross(normal), normal];
        let flat = |v: DVec3| DVec2::new(axes[0].dot(v), axes[1].dot(v)) * unit;
        let lay = |(&at, &normal): (&DVec3, &DVec3)| {
            let corner = SurfacePoint {
                triangle: cell.centre.triangle,
                at,
                normal,
            };
            // A corner on the other side of a fold is projected straight down.
            let to = log(&cell.centre, &corner).map(|way| frame.out(way.to));
            flat(to.unwrap_or(at - cell.centre.at))
        };
        let corners = || cell.ring.iter().zip(&cell.normals);
        let places: Vec<DVec2> = corners().map(lay).collect();
        let local = |v: DVec3| DVec3::from(axes.map(|axis| axis.dot(v)));
        let normals: Vec<DVec3> = cell.normals.iter().map(|&n| local(n)).collect();
        let truly: Vec<DVec3> = cell
            .ring
            .iter()
            .map(|&p| local(p - cell.centre.at) * unit)
            .collect();
        let bend = QuadricPatch::new(&places, &normals, &truly);
        Self {
            cell: Cell {
                id: cell.id,
                centre: DVec2::ZERO,
                kind: cell.kind,
                size: cell.size * unit,
                aspect: cell.aspect,
                axis: match along == DVec2::ZERO {
                    true => DVec2::ZERO,
                    false => DVec2::X,
                },
                // Reverse the ring: counter-clockwise with y up is the opposite order with y down.
                ring: places.into_iter().rev().collect(),
            },
            at: cell.centre.at,
            axes,
            unit,
            bend,
        }
    }

    /// Where a point of the stone (in picture units) lies on the surface, relative to the cell's centre, in the
    /// model's axes and units.
    pub fn placed(&self, p: DVec3) -> DVec3 {
        self.out(self.bend.bent(p))
    }

    /// Maps a vector from the plane's axes and picture units to the model's axes and units.
    pub fn out(&self, p: DVec3) -> DVec3 {
        let [x, y, z] = self.axes;
        (x * p.x + y * p.y + z * p.z) / self.unit
    }
}
