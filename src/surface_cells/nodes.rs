//! The centres of cells as nodes of a mesh.

use super::middles::{Meetings, outward};
use crate::mesh::{Metric, Node, Nodes};
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::frame::{arc_over_chord, rotated};
use crate::trimesh::{SurfacePoint, TangentFrame};
use glam::{DVec2, DVec3};

/// A node is on the other side of a sheet if the cosine between its normal and that of other nodes is less than this.
const OTHER_SIDE: f64 = -0.2;

/// Nodes on a surface.
#[derive(Default)]
pub(super) struct SurfaceNodes {
    pub points: Vec<SurfacePoint>,
    /// The meetings of cells; they tell how nodes around the rim of a thin sheet lie.
    pub meetings: Meetings,
    /// Unit vectors along the cells' sides, in space; zero for cells without a direction.
    axes: Vec<DVec3>,
    aspects: Vec<f64>,
    corners: Vec<bool>,
}

impl SurfaceNodes {
    /// The centres of these cells as nodes.
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
            // The nodes share no plane: put them in a row, so that no element comes of them.
            None => which.map(|k| Node::plain(DVec2::new(f64::from(k), 0.0))),
        }
    }
}

impl SurfaceNodes {
    /// Lays nodes that are near each other into one plane. Returns its frame and the nodes, or nothing if the normals
    /// have no common direction.
    pub fn plane<const N: usize>(&self, which: [u32; N]) -> Option<(TangentFrame, [Node; N])> {
        // Sum in rising order, so that the plane does not depend on the order of the nodes.
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
        let frame = TangentFrame::of(normal);
        let nodes = which.map(|node| {
            let k = node as usize;
            let point = &self.points[k];
            let over = beyond.as_ref().filter(|b| b.node == node);
            Node {
                at: match over {
                    Some(over) => over.laid(&frame, middle, point),
                    None => laid(&frame, middle, point),
                },
                axis: DVec2::ZERO,
                metric: self.metric_in(&frame, k, over),
                corners: self.corners[k],
            }
        });
        Some((frame, nodes))
    }

    /// The metric of a node in a plane; the path to a node beyond a rim leads over it.
    fn metric_in(&self, frame: &TangentFrame, k: usize, over: Option<&Beyond>) -> Metric {
        let aspect = self.aspects[k];
        if aspect == 1.0 {
            return Metric::EUCLIDEAN;
        }
        let (mut axis, mut from) = (self.axes[k], self.points[k].normal);
        if let Some(over) = over {
            (axis, from) = (rotated(axis, from, over.rim.normal), over.rim.normal);
        }
        let axis = rotated(axis, from, frame.normal);
        Metric::new(frame.within(axis).normalize_or_zero(), aspect)
    }

    /// The node that is on the other side of a sheet from all others, if one is. `sum` is the sum of all normals.
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
    /// The point of the rim where its cell meets others; the path to the node leads through it.
    rim: SurfacePoint,
}

impl Beyond {
    /// The node's place in the plane of the other nodes: as far beyond the rim as it is along the surface.
    fn laid(&self, frame: &TangentFrame, middle: DVec3, own: &SurfacePoint) -> DVec2 {
        let rim = TangentFrame::of(self.rim.normal);
        let on = rim.out(laid(&rim, self.rim.at, own));
        let on = frame.within(rotated(on, rim.normal, frame.normal));
        laid(frame, middle, &self.rim) + on
    }
}

/// Lays a point into a plane. The vector to it from the middle turns as the surface at the point has to turn into the
/// plane; its length becomes that along the surface.
fn laid(frame: &TangentFrame, middle: DVec3, p: &SurfacePoint) -> DVec2 {
    let r = p.at - middle;
    let flat = frame.within(rotated(r, p.normal, frame.normal));
    let along = flat.length();
    if along == 0.0 {
        return DVec2::ZERO;
    }
    flat * (r.length() * arc_over_chord(frame.normal.dot(p.normal)) / along)
}
