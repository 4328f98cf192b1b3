//! A cell laid into its tangent plane, as the makers of stones take it, and the way back.

use super::Bend;
use crate::cells::Cell;
use crate::surface_cells::SurfaceCell;
use crate::trimesh::{Frame, SurfacePoint, way};
use glam::{DVec2, DVec3};

/// A cell in the plane, and how it lies on its surface.
#[derive(Clone, Debug)]
pub struct Flat {
    /// Its centre at 0, its axis along x, in picture units; as all of a picture, y down and clockwise on screen.
    pub cell: Cell,
    /// Where the centre is, in the model's units.
    pub at: DVec3,
    /// Where the picture's x, its y and heights point to, in the model. Seen from outside x goes to the right and y
    /// down, so the three are left-handed, as a picture with heights towards the viewer is: nothing is mirrored.
    pub axes: [DVec3; 3],
    /// Picture units for a unit of the model.
    pub unit: f64,
    /// How the surface curves away from the plane.
    pub bend: Bend,
}

impl Flat {
    /// A cell with so many picture units for a unit of the model: its corners by the logarithmic map about its centre.
    pub fn new(cell: &SurfaceCell, unit: f64) -> Self {
        let normal = cell.centre.normal;
        let frame = Frame::of(normal);
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
            // What lies on the other side of a fold is seen from above.
            let to = way(&cell.centre, &corner).map(|way| frame.out(way.to));
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
        let bend = Bend::new(&places, &normals, &truly);
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
                // Counter-clockwise with y up is clockwise the other way round with y down.
                ring: places.into_iter().rev().collect(),
            },
            at: cell.centre.at,
            axes,
            unit,
            bend,
        }
    }

    /// A place of the stone, in picture units, where it is on the surface: from the cell's centre, in the model's axes
    /// and units.
    pub fn placed(&self, p: DVec3) -> DVec3 {
        self.out(self.bend.bent(p))
    }

    /// From the plane's axes and picture units to the model's.
    pub fn out(&self, p: DVec3) -> DVec3 {
        let [x, y, z] = self.axes;
        (x * p.x + y * p.y + z * p.z) / self.unit
    }
}
