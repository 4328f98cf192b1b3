//! The cells' centres as nodes of a mesh.

use super::middles::{Meetings, outward};
use crate::mesh::{Metric, Node, Nodes};
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::frame::{arc_over_chord, rotated};
use crate::trimesh::{Frame, SurfacePoint};
use glam::{DVec2, DVec3};

/// A node whose normal points so far away from that of others (cosine) is on the other side of a sheet.
const OTHER_SIDE: f64 = -0.2;

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
        let mut beyond = None;
        let normal = match outward(normal, N) {
            Some(normal) => normal,
            None => {
                beyond = self.beyond(&sorted, normal);
                match &beyond {
                    Some(beyond) => {
                        let own = self.points[beyond.node as usize];
                        middle = (middle * N as f64 - own.at) / (N - 1) as f64;
                        (normal - own.normal).normalize()
                    }
                    None => {
                        let rim = self.meetings.rim(&sorted)?;
                        middle = rim.0;
                        rim.1
                    }
                }
            }
        };
        let frame = Frame::of(normal);
        let nodes = which.map(|node| {
            let k = node as usize;
            let point = &self.points[k];
            let over = beyond.as_ref().filter(|b| b.node == node);
            let aspect = self.aspects[k];
            let metric = if aspect == 1.0 {
                Metric::EUCLIDEAN
            } else {
                let (mut axis, mut from) = (self.axes[k], point.normal);
                if let Some(over) = over {
                    (axis, from) = (rotated(axis, from, over.rim.normal), over.rim.normal);
                }
                let axis = rotated(axis, from, frame.normal);
                Metric::new(frame.within(axis).normalize_or_zero(), aspect)
            };
            Node {
                at: match over {
                    Some(over) => over.laid(&frame, middle, point),
                    None => laid(&frame, middle, point),
                },
                axis: DVec2::ZERO,
                metric,
                corners: self.corners[k],
            }
        });
        Some((frame, nodes))
    }

    /// That one of some nodes which is on the other side of a sheet than all others; `sum` is that of their normals.
    fn beyond(&self, nodes: &[u32], sum: DVec3) -> Option<Beyond> {
        let is_beyond = |node: &&u32| {
            let own = self.points[**node as usize].normal;
            let others = outward(sum - own, nodes.len() - 1);
            others.is_some_and(|others| others.dot(own) < OTHER_SIDE)
        };
        let &node = nodes.iter().find(is_beyond)?;
        let others = || nodes.iter().filter(|&&k| k != node);
        let mut pairs = others().flat_map(|&a| others().map(move |&b| [a, b]));
        let rim = pairs.find_map(|[a, b]| self.meetings.of([a, b, node]))?;
        Some(Beyond { node, rim: *rim })
    }
}

/// A node on the other side of a sheet.
struct Beyond {
    node: u32,
    /// Where it meets others, over the rim: the way to it leads through that.
    rim: SurfacePoint,
}

impl Beyond {
    /// Where it is in a plane of the others: as far beyond the rim as it is along the surface.
    fn laid(&self, frame: &Frame, middle: DVec3, own: &SurfacePoint) -> DVec2 {
        let rim = Frame::of(self.rim.normal);
        let on = rim.out(laid(&rim, self.rim.at, own));
        let on = frame.within(rotated(on, rim.normal, frame.normal));
        laid(frame, middle, &self.rim) + on
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
