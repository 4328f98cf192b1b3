//! Joins the polygons of a file to flat facets.

use super::fault::BuildingFault;
use super::polygon_sides::{PlaneRing, clash, left_of_sides, sides};
use super::t_junctions;
use crate::modelfiles::PolygonModel;
use crate::trimesh::polygon;
use glam::DVec3;
use std::collections::BTreeMap;

/// Polygons whose normals differ by less are in one plane (length of the difference).
pub(super) const SAME_PLANE: f64 = 1e-4;
/// Polygons whose vertices are this near to one plane are in one plane, if their normals differ by less than the second
/// number.
const ROUNDED_PLANE: (f64, f64) = (1e-4, 5e-3);
/// The tolerance for polygons in one plane, and for joints on one circle (metres).
pub(super) const SAME_PLACE: f64 = 1e-3;
/// Polygons with less area are left out as degenerate (square metres).
const LEAST_AREA: f64 = 1e-9;

/// Polygons of one group in one plane.
#[derive(Clone, Debug, Default)]
pub(super) struct Facet {
    pub group: u32,
    pub normal: DVec3,
    /// The directed sides of its polygons.
    pub sides: Vec<(u32, u32)>,
}

impl Facet {
    /// Two unit vectors in the plane, right-handed with the normal.
    pub fn axes(&self) -> (DVec3, DVec3) {
        let x = super::facets::perpendicular(self.normal);
        (x, self.normal.cross(x))
    }
}

/// The facets of a model.
pub(super) struct FacetModel {
    /// The welded vertices.
    pub positions: Vec<DVec3>,
    pub all: Vec<Facet>,
    /// The facet to the left of each directed side.
    pub of_side: BTreeMap<(u32, u32), usize>,
    pub degenerate: usize,
}

impl FacetModel {
    /// Joins polygons in one plane to facets.
    ///
    /// # Errors
    /// If there is no polygon, if more than two meet along a side, or if both run the same way there.
    pub fn new(model: &PolygonModel) -> Result<Self, BuildingFault> {
        let (positions, welded) = super::sides::weld(&model.positions);
        let (mut rings, mut degenerate) = (Vec::new(), 0);
        // The number of each ring's polygon in the file.
        let mut polygons = Vec::new();
        for (polygon, (corners, group)) in model.polygons.iter().enumerate() {
            let mut ring: Vec<u32> = corners.iter().map(|&v| welded[v as usize]).collect();
            ring.dedup();
            if ring.len() > 1 && ring.first() == ring.last() {
                ring.pop();
            }
            let points: Vec<DVec3> = ring.iter().map(|&v| positions[v as usize]).collect();
            let across = polygon::across(&points);
            match 0.5 * across.length() > LEAST_AREA {
                true => {
                    rings.push((ring, *group, across.normalize()));
                    polygons.push(polygon);
                }
                false => degenerate += 1,
            }
        }
        if rings.is_empty() {
            return Err(BuildingFault::Empty);
        }
        t_junctions::divide(&mut rings, &positions);
        let left = left_of_sides(&rings).map_err(|[first, second, from, to]| {
            let vertex = |v: usize| welded.iter().position(|&w| w as usize == v).unwrap_or(v);
            BuildingFault::Polygons {
                vertices: [from, to].map(vertex),
                polygons: [first, second].map(|ring| polygons[ring]),
                why: clash(&rings, [first, second], [from, to].map(|v| v as u32)),
            }
        })?;
        let number = planes(&rings, &left, &positions);
        let count = number.iter().max().map_or(0, |most| most + 1);
        let mut all = vec![Facet::default(); count];
        for ((ring, group, normal), &facet) in rings.iter().zip(&number) {
            let own = &mut all[facet];
            (own.group, own.normal) = (*group, *normal);
            own.sides.extend(sides(ring));
        }
        let of_side = left.into_iter().map(|(side, ring)| (side, number[ring]));
        Ok(Self {
            positions,
            all,
            of_side: of_side.collect(),
            degenerate,
        })
    }
}

/// The number of each polygon's plane. Connected polygons of one group in one plane have the same number.
fn planes(
    rings: &[PlaneRing],
    left: &BTreeMap<(u32, u32), usize>,
    positions: &[DVec3],
) -> Vec<usize> {
    let mut number = vec![usize::MAX; rings.len()];
    let mut count = 0;
    for first in 0..rings.len() {
        if number[first] != usize::MAX {
            continue;
        }
        // All have to fit the first polygon's plane: comparing neighbours only would follow a slow bend.
        let (_, group, normal) = rings[first];
        let origin = positions[rings[first].0[0] as usize];
        let fits = |k: usize| {
            let off = |&v: &u32| (positions[v as usize] - origin).dot(normal).abs();
            let is_within = |most: f64| rings[k].0.iter().all(|v| off(v) < most);
            let turn = rings[k].2.distance(normal);
            rings[k].1 == group
                && (turn < SAME_PLANE && is_within(SAME_PLACE)
                    || turn < ROUNDED_PLANE.1 && is_within(ROUNDED_PLANE.0))
        };
        let mut open = vec![first];
        while let Some(k) = open.pop() {
            // A polygon that is not plane is a facet all the same: a later check refuses it.
            if number[k] != usize::MAX || k != first && !fits(k) {
                continue;
            }
            number[k] = count;
            let beyond = sides(&rings[k].0).filter_map(|(a, b)| left.get(&(b, a)));
            open.extend(beyond);
        }
        count += 1;
    }
    number
}
