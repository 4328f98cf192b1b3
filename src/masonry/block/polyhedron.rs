//! Convex polyhedra whose sides carry the widths of joints.

use super::plane::Plane;
use crate::masonry::footprint::Footprint;
use glam::{DQuat, DVec2, DVec3};
use smallvec::{SmallVec, smallvec};

/// Bodies below this volume count as empty (cubic metres).
pub(super) const LEAST_VOLUME: f64 = 1e-12;

/// The vertex numbers of a side's corners. Most sides have four, and a list of up to eight needs no allocation.
pub type SideCorners = SmallVec<[u32; 8]>;

/// A side of a block.
#[derive(Debug, PartialEq)]
pub struct Side {
    /// Indices of the corners among the polyhedron's vertices, counter-clockwise seen from outside.
    pub corners: SideCorners,
    /// How far the geometry stays behind this side: half a joint, or 0 where it is exposed (metres, at least 0).
    pub inset: f64,
    /// The height of bumps on this side (metres); 0 is smooth. Generators set it for the sides of their cells (Legakis,
    /// Dorsey, Gortler 2001, section 5.5).
    pub roughness: f64,
}

impl Clone for Side {
    fn clone(&self) -> Self {
        // Copies all corners at once; `SmallVec::clone` would copy one by one.
        Self {
            corners: SmallVec::from_slice(&self.corners),
            ..*self
        }
    }
}

/// A closed convex polyhedron whose sides face outwards. On curved walls its sides are only nearly plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyhedron {
    pub(super) vertices: Vec<DVec3>,
    pub(super) sides: Vec<Side>,
}

impl Polyhedron {
    /// The prism on a footprint between the heights `low < high` above the surface (metres; below 0 is inside of the
    /// wall). Its lower and upper ends get the insets `below` and `above`. `map` takes (s, t) and a height to a point
    /// in space, and keeps handedness.
    pub fn prism(
        base: &Footprint,
        [low, high]: [f64; 2],
        [below, above]: [f64; 2],
        map: impl Fn(DVec2, f64) -> DVec3,
    ) -> Self {
        let end = |z: f64| base.corners().iter().map(move |corner| (corner.at, z));
        let places = end(low).chain(end(high));
        let mut body = Self::of_rings(places.map(|(p, z)| map(p, z)).collect());
        let walls = base.corners().iter().map(|corner| corner.inset);
        for (side, inset) in body
            .sides
            .iter_mut()
            .zip([below, above].into_iter().chain(walls))
        {
            side.inset = inset;
        }
        body
    }

    /// The body between two rings of the same number of points, without insets: its sides are the first ring, the
    /// second ring, and the quadrilaterals between them. The second ring is counter-clockwise seen from outside, the
    /// first one clockwise.
    pub fn between([low, high]: &[Vec<DVec3>; 2]) -> Self {
        Self::of_rings([&low[..], &high[..]].concat())
    }

    /// The body between two rings in one list: the first half is the first ring, the second half the second one.
    fn of_rings(vertices: Vec<DVec3>) -> Self {
        let count = vertices.len() as u32 / 2;
        let walls = (0..count).map(|k| {
            let next = (k + 1) % count;
            smallvec![k, next, count + next, count + k]
        });
        let ends = [(0..count).rev().collect(), (count..2 * count).collect()];
        let sides = ends.into_iter().chain(walls);
        Self {
            vertices,
            sides: sides
                .map(|corners| Side {
                    corners,
                    inset: 0.0,
                    roughness: 0.0,
                })
                .collect(),
        }
    }

    /// Whether the body has a volume and each side an area, so that it can be cut.
    pub fn is_sound(&self) -> bool {
        let has_area = |side: &Side| Plane::has_area(self.ring(side));
        self.sides.len() > 3 && self.sides.iter().all(has_area) && self.volume() > LEAST_VOLUME
    }

    /// The body with the sides in `planes` moved out by `by` (metres): the body of a cell that stands out of the wall.
    /// Three or more of the planes may meet in a vertex only at right angles.
    pub fn raised(mut self, planes: &[Plane], by: f64) -> Self {
        for p in &mut self.vertices {
            let on = planes
                .iter()
                .filter(|plane| plane.distance(*p).abs() < 1e-6);
            let normals: Vec<DVec3> = on.map(|plane| plane.normal).collect();
            let sum: DVec3 = normals.iter().sum();
            if let Some(first) = normals.first() {
                *p += sum * (by / sum.dot(*first));
            }
        }
        self
    }

    /// The box between two corners, with no insets; none without volume.
    pub fn cuboid(low: DVec3, high: DVec3) -> Option<Self> {
        let base = Footprint::rectangle(low.truncate(), high.truncate())?;
        let is_right = low.z < high.z;
        is_right.then(|| Self::prism(&base, [low.z, high.z], [0.0; 2], |p, z| p.extend(z)))
    }

    /// The body inside of all planes, each with its inset (metres), and inside of a box; none if nothing is left.
    pub fn from_planes(planes: &[(Plane, f64)], [low, high]: [DVec3; 2]) -> Option<Self> {
        let start = Self::cuboid(low, high)?;
        planes
            .iter()
            .try_fold(start, |body, &(plane, inset)| body.cut(plane, inset))
    }

    /// The vertices (metres).
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// The sides.
    pub fn sides(&self) -> &[Side] {
        &self.sides
    }

    /// The corners of a side, counter-clockwise seen from outside.
    pub fn ring(&self, side: &Side) -> impl ExactSizeIterator<Item = DVec3> + Clone {
        side.corners.iter().map(|&v| self.vertices[v as usize])
    }

    /// The planes of the sides, in their order.
    pub fn planes(&self) -> impl Iterator<Item = Plane> + '_ {
        self.sides
            .iter()
            .map(|side| Plane::of_ring(self.ring(side)).expect("a side has an area"))
    }

    /// Sets the inset of each side (metres, at least 0): `inset` gets its plane and its old inset.
    pub fn with_insets(mut self, mut inset: impl FnMut(Plane, f64) -> f64) -> Self {
        let insets: Vec<f64> = self
            .planes()
            .zip(&self.sides)
            .map(|(plane, side)| inset(plane, side.inset))
            .collect();
        for (side, inset) in self.sides.iter_mut().zip(insets) {
            side.inset = inset;
        }
        self
    }

    /// Sets the inset of each side (metres, at least 0): `inset` gets the side with its corners.
    pub fn with_insets_of(mut self, inset: impl Fn(&Side) -> f64) -> Self {
        self.sides
            .iter_mut()
            .for_each(|side| side.inset = inset(side));
        self
    }

    /// Sets the roughness of each side: `roughness` gets its plane and returns the height of bumps (metres, 0 is
    /// smooth).
    pub fn with_roughness(mut self, roughness: impl Fn(Plane) -> f64) -> Self {
        let marks: Vec<f64> = self.planes().map(roughness).collect();
        for (side, mark) in self.sides.iter_mut().zip(marks) {
            side.roughness = mark;
        }
        self
    }

    /// Whether any side is rough.
    pub fn has_rough_sides(&self) -> bool {
        self.sides.iter().any(|side| side.roughness > 0.0)
    }

    /// The volume, in cubic metres.
    pub fn volume(&self) -> f64 {
        let origin = self.vertices[0];
        let six = self.sides.iter().flat_map(|side| {
            let first = self.vertices[side.corners[0] as usize] - origin;
            let pairs = side.corners[1..].windows(2);
            pairs.map(move |w| {
                let [a, b] = [w[0], w[1]].map(|v| self.vertices[v as usize] - origin);
                first.dot(a.cross(b))
            })
        });
        six.sum::<f64>() / 6.0
    }

    /// The mean of the vertices.
    pub fn centre(&self) -> DVec3 {
        self.vertices.iter().sum::<DVec3>() / self.vertices.len() as f64
    }

    /// The corners of the bounding box with the smallest and with the largest coordinates.
    pub fn bounds(&self) -> [DVec3; 2] {
        let grow = |[low, high]: [DVec3; 2], &p: &DVec3| [low.min(p), high.max(p)];
        self.vertices.iter().fold([self.vertices[0]; 2], grow)
    }

    /// Whether no vertex lies farther than `slack` outside of any side (metres).
    pub fn is_convex(&self, slack: f64) -> bool {
        self.planes()
            .all(|plane| self.vertices.iter().all(|&p| plane.distance(p) <= slack))
    }

    /// The part that two bodies share, with the insets of the first; the sides of the second get none. None if nothing
    /// is shared.
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let ([low, high], [from, to]) = (self.bounds(), other.bounds());
        if low.cmpge(to).any() || from.cmpge(high).any() {
            return None;
        }
        let mut planes = other.planes();
        planes.try_fold(self.clone(), |body, plane| body.cut(plane, 0.0))
    }

    /// The volume that two bodies share, in cubic metres.
    pub fn shared_volume(&self, other: &Self) -> f64 {
        self.intersection(other).map_or(0.0, |body| body.volume())
    }

    /// The body with each side moved in by its inset; none if nothing is left.
    ///
    /// Most patterns claim all space, and shrink their cells to leave gaps for mortar (Legakis, Dorsey, Gortler 2001,
    /// section 3.3).
    pub fn shrunk(&self) -> Option<Self> {
        let sides = self.planes().zip(&self.sides);
        let mut joints = sides.filter(|(_, side)| side.inset != 0.0);
        joints.try_fold(self.clone(), |body, (plane, side)| {
            body.cut(plane.inset(side.inset), 0.0)
        })
    }

    /// The body turned about its centre, then moved.
    pub fn turned(self, turn: DQuat, by: DVec3) -> Self {
        let centre = self.centre();
        self.mapped(|p| centre + turn * (p - centre) + by)
    }

    /// The body with its vertices at other places. The map keeps planes, and handedness.
    pub fn mapped(mut self, map: impl Fn(DVec3) -> DVec3) -> Self {
        self.vertices.iter_mut().for_each(|p| *p = map(*p));
        self
    }
}
