//! The cells' centres as nodes of a mesh.

use super::middles::{Meetings, outward};
use crate::mesh::{Metric, Node, Nodes};
use crate::surface::frame::{arc_over_chord, rotated};
use crate::surface::packing::SurfaceParticle;
use crate::surface::{Frame, SurfacePoint};
use glam::{DVec2, DVec3};

/// Nodes on a surface.
#[derive(Default)]
pub(super) struct SurfaceNodes {
    pub points: Vec<SurfacePoint>,
    /// Where they meet, which tells how those about the rim of a thin sheet lie.
    pub meetings: Meetings,
    /// Unit vectors along the cells' sides, in space; zero where they have none.
    axes: Vec<DVec3>,
    aspects: Vec<f64>,
    corners: Vec<bool>,
}

impl SurfaceNodes {
    /// The centres of these cells.
    pub fn new(cells: &[SurfaceParticle]) -> Self {
        Self {
            points: cells.iter().map(|c| c.centre).collect(),
            meetings: Meetings::default(),
            axes: cells.iter().map(|c| c.centre.frame().out(c.axis)).collect(),
            aspects: cells.iter().map(|c| c.aspect).collect(),
            corners: cells.iter().map(|c| c.kind.has_corners()).collect(),
        }
    }
}

impl Nodes for SurfaceNodes {
    fn count(&self) -> usize {
        self.points.len()
    }

    fn has_corners(&self, node: u32) -> bool {
        self.corners[node as usize]
    }

    fn laid<const N: usize>(&self, which: [u32; N]) -> [Node; N] {
        match self.plane(which) {
            Some((_, nodes)) => nodes,
            // In a row: nothing can be made of them.
            None => which.map(|k| Node::plain(DVec2::new(f64::from(k), 0.0))),
        }
    }
}

impl SurfaceNodes {
    /// Some nodes that are near each other, laid into one plane, and the plane; nothing where none is like another.
    pub fn plane<const N: usize>(&self, which: [u32; N]) -> Option<(Frame, [Node; N])> {
        // Summed in one order: the same plane to the bit.
        let mut sorted = which;
        sorted.sort_unstable();
        let (mut middle, mut normal) = (DVec3::ZERO, DVec3::ZERO);
        for k in sorted {
            middle += self.points[k as usize].at;
            normal += self.points[k as usize].normal;
        }
        middle /= N as f64;
        let normal = match outward(normal, N) {
            Some(normal) => normal,
            None => {
                let rim = self.meetings.rim(&sorted)?;
                middle = rim.0;
                rim.1
            }
        };
        let frame = Frame::of(normal);
        let nodes = which.map(|k| {
            let k = k as usize;
            let aspect = self.aspects[k];
            let metric = if aspect == 1.0 {
                Metric::EUCLIDEAN
            } else {
                let axis = rotated(self.axes[k], self.points[k].normal, frame.normal);
                Metric::new(frame.within(axis).normalize_or_zero(), aspect)
            };
            Node {
                at: laid(&frame, middle, &self.points[k]),
                axis: DVec2::ZERO,
                metric,
                corners: self.corners[k],
            }
        });
        Some((frame, nodes))
    }
}

/// A point in a plane, in the direction that it has once the surface there is turned into it, and as far from the middle as it
/// is along the surface.
fn laid(frame: &Frame, middle: DVec3, p: &SurfacePoint) -> DVec2 {
    let r = p.at - middle;
    let flat = frame.within(rotated(r, p.normal, frame.normal));
    let along = flat.length();
    if along == 0.0 {
        return DVec2::ZERO;
    }
    flat * (r.length() * arc_over_chord(frame.normal.dot(p.normal)) / along)
}
