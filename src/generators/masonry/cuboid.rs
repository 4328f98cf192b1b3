//! Blocks that are cuboids: those of one size share a body, however they are turned.

use crate::masonry::block::Polyhedron;
use glam::DVec3;

/// Unit vectors count as perpendicular if their dot product is below this.
const RIGHT: f64 = 1e-6;
/// Sizes are rounded to steps of this length (metres); cuboids with equal steps share a body.
const STEP: f64 = 5e-5;

/// A cuboid in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cuboid {
    pub middle: DVec3,
    /// Its axes: unit vectors, right-handed.
    pub axes: [DVec3; 3],
    /// Its sizes along these axes, in steps of 0.05 mm.
    pub steps: [u32; 3],
}

impl Cuboid {
    /// Reads a body as a cuboid whose third axis points outwards. `None` if the body is no cuboid.
    pub fn of(body: &Polyhedron, outwards: DVec3) -> Option<Self> {
        if body.sides().len() != 6 || body.vertices().len() != 8 {
            return None;
        }
        let normals: Vec<DVec3> = body.planes().map(|plane| plane.normal).collect();
        let nearest = |way: DVec3, of: &[DVec3]| {
            of.iter().copied().fold(DVec3::ZERO, |best, normal| {
                if best == DVec3::ZERO || normal.dot(way) > best.dot(way) {
                    normal
                } else {
                    best
                }
            })
        };
        let z = nearest(outwards, &normals);
        let beside: Vec<DVec3> = normals
            .iter()
            .copied()
            .filter(|n| n.dot(z).abs() < RIGHT)
            .collect();
        if beside.len() != 4 {
            return None;
        }
        let y = nearest(DVec3::Y, &beside);
        let x = y.cross(z);
        let are_right = normals.iter().all(|n| {
            let along = [x, y, z].map(|axis| n.dot(axis).abs());
            along.iter().filter(|v| **v > RIGHT).count() == 1
        });
        if !are_right {
            return None;
        }
        let axes = [x, y, z];
        let middle = body.vertices().iter().sum::<DVec3>() / 8.0;
        let size = axes.map(|axis| {
            let far = body
                .vertices()
                .iter()
                .map(|&p| (p - middle).dot(axis).abs());
            2.0 * far.fold(0.0, f64::max)
        });
        Some(Self {
            middle,
            axes,
            steps: size.map(|length| (length / STEP).round() as u32),
        })
    }

    /// The cuboid of these sizes about the origin, along the axes of space.
    pub fn plain(steps: [u32; 3]) -> Option<Polyhedron> {
        let half = DVec3::from(steps.map(|steps| 0.5 * STEP * f64::from(steps)));
        Polyhedron::cuboid(-half, half)
    }
}
