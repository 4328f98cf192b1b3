//! Recognises flat and curved faces in polygons.

use super::fault::BuildingFault;
use super::path::Path;
use super::piece::{CircularArc, Piece};
use super::polygon_sides::{PlaneRing, clash, left_of_sides, sides};
use super::surface::{FaceSurface, Sweep};
use crate::modelfiles::PolygonModel;
use crate::order::{self, rank};
use crate::trimesh::polygon;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Polygons whose normals differ by less are in one plane (length of the difference).
const SAME_PLANE: f64 = 1e-4;
/// The tolerance for polygons in one plane, and for joints on one circle (metres).
const SAME_PLACE: f64 = 1e-3;
/// Directions whose cross product is shorter are parallel.
const PARALLEL: f64 = 1e-3;
/// The sharpest turn between two pieces of a curved face: 31 degrees (radians).
const SHARPEST: f64 = 31.0 * PI / 180.0;
/// Polygons with less area are left out as degenerate (square metres).
const LEAST_AREA: f64 = 1e-9;
/// The fewest pieces of a curved face.
const FEWEST: usize = 3;

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
            rings[k].1 == group
                && rings[k].2.distance(normal) < SAME_PLANE
                && rings[k].0.iter().all(|v| off(v) < SAME_PLACE)
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

/// A curved face: pieces around an axis.
#[derive(Clone, Debug)]
pub(super) struct Bow {
    /// A point on the axis.
    pub centre: DVec3,
    /// The unit vector along the axis.
    pub axis: DVec3,
    pub radius: f64,
    /// Whether the face looks away from its axis.
    is_outer: bool,
    /// The numbers of its facets.
    pub facets: Vec<usize>,
    /// The angles of the rulings around the axis (radians), in order.
    angles: Vec<f64>,
}

impl Bow {
    /// Whether a side runs along the axis.
    pub fn is_ruling(&self, a: DVec3, b: DVec3) -> bool {
        is_along(self.axis, b - a)
    }

    /// The widest gap between neighbouring rulings, and the angle at which it ends (radians).
    fn gap(&self) -> (f64, f64) {
        let last = self.angles[self.angles.len() - 1] - TAU;
        let before = [last].into_iter().chain(self.angles.iter().copied());
        let gaps = before.zip(&self.angles).map(|(a, &b)| (b - a, b));
        gaps.fold(
            (0.0, 0.0),
            |best, next| if next.0 > best.0 { next } else { best },
        )
    }

    /// Whether the pieces close around the axis.
    pub fn is_whole(&self) -> bool {
        self.gap().0 <= SHARPEST + PARALLEL
    }

    /// The cylinder through the joints.
    pub fn surface(&self) -> FaceSurface {
        let x = super::facets::perpendicular(self.axis);
        let y = self.axis.cross(x);
        let (gap, start) = self.gap();
        let sweep = if self.is_whole() { TAU } else { TAU - gap };
        // The normal is tangent x axis, which is outwards if angles grow.
        let (from, to) = match self.is_outer {
            true => (start, start + sweep),
            false => (start + sweep, start),
        };
        let arc = CircularArc {
            centre: self.centre,
            radius: self.radius,
            x,
            y,
            from,
            to,
        };
        let profile = Path::new(vec![Piece::Arc(arc)]);
        FaceSurface::Sweep(Sweep::new(profile, self.axis))
    }
}

fn is_along(axis: DVec3, side: DVec3) -> bool {
    side.normalize_or_zero().cross(axis).length() < PARALLEL
}

/// A joint: a side between two pieces, with the circle through it and the far ends of both pieces, seen along the side.
struct Joint {
    pieces: [usize; 2],
    centre: DVec3,
    axis: DVec3,
    radius: f64,
}

/// The curved faces, in the order of their first joints.
pub(super) fn bows(facets: &FacetModel) -> Vec<Bow> {
    let joints: Vec<Joint> = joints(facets);
    let mut of_piece: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (k, joint) in joints.iter().enumerate() {
        joint
            .pieces
            .iter()
            .for_each(|&piece| of_piece.entry(piece).or_default().push(k));
    }
    let mut used = vec![false; joints.len()];
    let mut taken = vec![false; facets.all.len()];
    let mut bows = Vec::new();
    for first in 0..joints.len() {
        let (mut open, mut members) = (vec![first], Vec::new());
        while let Some(k) = open.pop() {
            if used[k] || !is_same_circle(&joints[first], &joints[k]) {
                continue;
            }
            used[k] = true;
            for piece in joints[k].pieces {
                members.push(piece);
                open.extend(of_piece[&piece].iter().copied());
            }
        }
        members.sort_unstable();
        members.dedup();
        members.retain(|&piece| !taken[piece]);
        let bow = (members.len() >= FEWEST).then(|| bow(facets, &joints[first], members));
        if let Some(bow) = bow.filter(|bow| is_possible(facets, bow)) {
            bow.facets.iter().for_each(|&piece| taken[piece] = true);
            bows.push(bow);
        }
    }
    bows
}

fn is_same_circle(a: &Joint, b: &Joint) -> bool {
    let across = |joint: &Joint| joint.centre - a.axis * joint.centre.dot(a.axis);
    is_along(a.axis, b.axis)
        && across(a).distance(across(b)) < SAME_PLACE
        && (a.radius - b.radius).abs() < SAME_PLACE
}

/// The joints: sides between two facets of one group whose normals differ by at most [`SHARPEST`].
fn joints(facets: &FacetModel) -> Vec<Joint> {
    let mut joints = Vec::new();
    for (&(a, b), &left) in facets.of_side.iter().filter(|((a, b), _)| a < b) {
        let Some(&right) = facets.of_side.get(&(b, a)) else {
            continue;
        };
        let (f, g) = (&facets.all[left], &facets.all[right]);
        let turn = libm::atan2(f.normal.cross(g.normal).length(), f.normal.dot(g.normal));
        if left == right || f.group != g.group || !(SAME_PLANE..=SHARPEST).contains(&turn) {
            continue;
        }
        let place = |v: u32| facets.positions[v as usize];
        let axis = (place(b) - place(a)).normalize();
        let axis = upwards(axis);
        let flat = |p: DVec3| p - axis * p.dot(axis);
        let [p, q, r] = [
            far_end(facets, left, axis, place(a)),
            place(a),
            far_end(facets, right, axis, place(a)),
        ]
        .map(flat);
        if let Some((centre, radius)) = circle(p, q, r) {
            joints.push(Joint {
                pieces: [left, right],
                centre,
                axis,
                radius,
            });
        }
    }
    joints
}

/// The axis, turned so that its largest component is positive. If some are equal, y counts first, then x.
fn upwards(axis: DVec3) -> DVec3 {
    let most = axis.abs().max_element() - 1e-6;
    let part = [axis.y, axis.x, axis.z]
        .into_iter()
        .find(|part| part.abs() >= most);
    axis * part.unwrap_or(1.0).signum()
}

/// The vertex of a facet that is the farthest from a joint, across the axis.
fn far_end(facets: &FacetModel, facet: usize, axis: DVec3, from: DVec3) -> DVec3 {
    let away = |v: u32| {
        let d = facets.positions[v as usize] - from;
        (d - axis * d.dot(axis)).length_squared()
    };
    let vertices = facets.all[facet].sides.iter().map(|side| side.0);
    let first = (0.0, from);
    let best = vertices.fold(first, |best, v| {
        let square = away(v);
        if square > best.0 + 1e-12 {
            (square, facets.positions[v as usize])
        } else {
            best
        }
    });
    best.1
}

/// The centre and the radius of the circle through three points; `None` if they lie on a line.
fn circle(p: DVec3, q: DVec3, r: DVec3) -> Option<(DVec3, f64)> {
    let (a, b) = (p - q, r - q);
    let normal = a.cross(b);
    let square = normal.length_squared();
    if square < 1e-18 {
        return None;
    }
    let to = (b * a.length_squared() - a * b.length_squared()).cross(normal) / (2.0 * square);
    Some((q + to, to.length()))
}

/// Makes a curved face of facets. It takes the circle of one joint, on which all their joints lie.
fn bow(facets: &FacetModel, joint: &Joint, members: Vec<usize>) -> Bow {
    let x = super::facets::perpendicular(joint.axis);
    let y = joint.axis.cross(x);
    let vertices = members.iter().flat_map(|&k| &facets.all[k].sides);
    let angle = |&(v, _): &(u32, u32)| {
        let d = facets.positions[v as usize] - joint.centre;
        let angle = libm::atan2(d.dot(y), d.dot(x));
        if angle < 0.0 { angle + TAU } else { angle }
    };
    let mut angles: Vec<f64> = vertices.map(angle).collect();
    order::sort(&mut angles, |&angle| (rank(angle), 0));
    angles.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    let first = &facets.all[members[0]];
    let at = facets.positions[first.sides[0].0 as usize] - joint.centre;
    Bow {
        centre: joint.centre,
        axis: joint.axis,
        radius: joint.radius,
        is_outer: at.dot(first.normal) > 0.0,
        facets: members,
        angles,
    }
}

/// Whether a cylinder can stand for the pieces: all vertices lie on it, and each side of its outline runs along the
/// axis or around it. A side around the axis has to lie at a border or at a plane across the axis.
fn is_possible(facets: &FacetModel, bow: &Bow) -> bool {
    let place = |v: u32| facets.positions[v as usize];
    let radius = |v: u32| {
        let d = place(v) - bow.centre;
        (d - bow.axis * d.dot(bow.axis)).length()
    };
    let own = |k: &usize| bow.facets.contains(k);
    let fits = |piece: usize, (a, b): (u32, u32)| {
        let (side, across) = (place(b) - place(a), facets.of_side.get(&(b, a)));
        if across == Some(&piece) {
            // A side between two polygons of one piece bounds nothing.
            return true;
        }
        let meets = across.is_none_or(|k| own(k) || is_along(bow.axis, facets.all[*k].normal));
        let is_around = side.dot(bow.axis).abs() < SAME_PLACE * side.length();
        bow.is_ruling(place(a), place(b)) || (is_around && meets)
    };
    bow.facets.iter().all(|&piece| {
        let mut sides = facets.all[piece].sides.iter();
        sides.all(|&side| (radius(side.0) - bow.radius).abs() < SAME_PLACE && fits(piece, side))
    })
}
