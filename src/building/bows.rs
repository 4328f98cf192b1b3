//! Recognises curved faces among flat facets.

use super::path::Path;
use super::piece::{CircularArc, Piece};
use super::recognising::{FacetModel, SAME_PLACE, SAME_PLANE};
use super::surface::{FaceSurface, Sweep};
use crate::order::{self, rank};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

/// Programs round the places in a file by up to this (metres): to millimetres, or to tenths of them.
const ROUNDED: [f64; 2] = [5e-4, 5e-5];
/// Vertices this far off their cylinder, or less, are on it (metres).
const EXACT: f64 = 1e-9;
/// Directions whose cross product is shorter are parallel.
const PARALLEL: f64 = 1e-3;
/// The sharpest turn between two pieces of a curved face: 31 degrees (radians).
const SHARPEST: f64 = 31.0 * PI / 180.0;
/// The fewest pieces of a curved face.
const FEWEST: usize = 3;

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

    /// Moves the vertices of the face onto its cylinder, those that are off it by rounding.
    pub fn put_on(&self, facets: &mut FacetModel) {
        let sides = self.facets.iter().flat_map(|&k| &facets.all[k].sides);
        let vertices: BTreeSet<u32> = sides.map(|side| side.0).collect();
        for v in vertices {
            let place = &mut facets.positions[v as usize];
            let away = across(*place - self.centre, self.axis);
            let off = away.length() - self.radius;
            if (EXACT..SAME_PLACE).contains(&off.abs()) {
                *place -= away.normalize_or_zero() * off;
            }
        }
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

/// The part of a vector across an axis.
fn across(way: DVec3, axis: DVec3) -> DVec3 {
    way - axis * way.dot(axis)
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
    /// How much farther the centre may be if the three places are rounded, over the length of the rounding.
    error: f64,
}

/// The curved faces, in the order of their first joints.
///
/// The circle through three near places is not sharp if these are rounded. So joints whose circles may be the same are
/// joined, if all their vertices lie on one cylinder; if not, those are joined whose circles are the same.
pub(super) fn bows(facets: &FacetModel) -> Vec<Bow> {
    let joints: Vec<Joint> = joints(facets);
    let mut of_piece: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (k, joint) in joints.iter().enumerate() {
        joint
            .pieces
            .iter()
            .for_each(|&piece| of_piece.entry(piece).or_default().push(k));
    }
    let mut search = BowSearch {
        facets,
        joints: &joints,
        of_piece,
        used: vec![false; joints.len()],
        tried: vec![false; joints.len()],
        taken: vec![false; facets.all.len()],
    };
    let bow = |first| search.rounded(first).or_else(|| search.exact(first));
    (0..joints.len()).filter_map(bow).collect()
}

/// The search for curved faces among joints.
struct BowSearch<'a> {
    facets: &'a FacetModel,
    joints: &'a [Joint],
    /// The joints of each piece.
    of_piece: BTreeMap<usize, Vec<usize>>,
    /// The joints that are done.
    used: Vec<bool>,
    /// The joints for which rounding was allowed for in vain.
    tried: Vec<bool>,
    /// The pieces of curved faces.
    taken: Vec<bool>,
}

impl BowSearch<'_> {
    /// The joints that are connected to one, itself among them, and have its circle if places are rounded by a length
    /// (metres); and their pieces that are still free, in order.
    fn connected(&self, first: usize, rounded: f64) -> (BTreeSet<usize>, Vec<usize>) {
        let (mut found, mut open) = (BTreeSet::new(), vec![first]);
        let mut members = BTreeSet::new();
        while let Some(k) = open.pop() {
            let is_same = is_same_circle(&self.joints[first], &self.joints[k], rounded);
            let is_own = !self.used[k] && is_same;
            if !is_own || !found.insert(k) {
                continue;
            }
            for piece in self.joints[k].pieces {
                if members.insert(piece) {
                    open.extend(&self.of_piece[&piece]);
                }
            }
        }
        let free = members.into_iter().filter(|&piece| !self.taken[piece]);
        (found, free.collect())
    }

    /// The curved face of a joint if rounding is allowed for; none if that adds nothing.
    fn rounded(&mut self, first: usize) -> Option<Bow> {
        if self.tried[first] || self.used[first] {
            return None;
        }
        let (exact, _) = self.connected(first, 0.0);
        ROUNDED.into_iter().find_map(|by| {
            let (joints, members) = self.connected(first, by);
            let more = (joints.len() > exact.len()).then_some(members)?;
            let circle = wide_circle(self.facets, &more, &self.joints[first]);
            let bow = circle.and_then(|joint| self.made(&joint, more));
            for k in joints {
                self.tried[k] = true;
                self.used[k] |= bow.is_some();
            }
            bow
        })
    }

    /// The curved face of a joint and those with the same circle.
    fn exact(&mut self, first: usize) -> Option<Bow> {
        let (joints, members) = self.connected(first, 0.0);
        for k in joints {
            self.used[k] = true;
        }
        let joint = &self.joints[first];
        let sides = members.iter().flat_map(|&k| &self.facets.all[k].sides);
        let is_off = |side: &(u32, u32)| {
            let away = self.facets.positions[side.0 as usize] - joint.centre;
            (across(away, joint.axis).length() - joint.radius).abs() > EXACT
        };
        let mut wide = None;
        if sides.copied().any(|side| is_off(&side)) {
            wide = wide_circle(self.facets, &members, joint);
        }
        self.made(wide.as_ref().unwrap_or(joint), members)
    }

    /// The curved face of some pieces, if there are enough and a cylinder can stand for them.
    fn made(&mut self, joint: &Joint, members: Vec<usize>) -> Option<Bow> {
        let bow = (members.len() >= FEWEST).then(|| bow(self.facets, joint, members));
        let bow = bow.filter(|bow| is_possible(self.facets, bow))?;
        for &piece in &bow.facets {
            self.taken[piece] = true;
        }
        Some(bow)
    }
}

/// Whether the circles of two joints may be the same, if the places in the file are rounded by a length (metres).
fn is_same_circle(a: &Joint, b: &Joint, rounded: f64) -> bool {
    let centre = |joint: &Joint| across(joint.centre, a.axis);
    let most = SAME_PLACE + 2.0 * rounded * (a.error + b.error);
    is_along(a.axis, b.axis)
        && centre(a).distance(centre(b)) < most
        && (a.radius - b.radius).abs() < most
}

/// A joint with the circle through three vertices of some pieces that are far apart, seen along the axis of `joint`.
fn wide_circle(facets: &FacetModel, members: &[usize], joint: &Joint) -> Option<Joint> {
    let flat = |p: DVec3| across(p, joint.axis);
    let sides = members.iter().flat_map(|&k| &facets.all[k].sides);
    let places: Vec<DVec3> = sides
        .map(|side| flat(facets.positions[side.0 as usize]))
        .collect();
    let farthest = |away: &dyn Fn(DVec3) -> f64| {
        let far = |best: DVec3, next: DVec3| if away(next) > away(best) { next } else { best };
        places.iter().copied().reduce(far)
    };
    let first = *places.first()?;
    let from = farthest(&|p| p.distance(first))?;
    let to = farthest(&|p| p.distance(from))?;
    let along = (to - from).try_normalize()?;
    let middle = farthest(&|p| (p - from).cross(along).length())?;
    let (centre, radius) = circle(from, middle, to)?;
    Some(Joint {
        centre,
        radius,
        ..*joint
    })
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
        let flat = |p: DVec3| across(p, axis);
        let [p, q, r] = [
            far_end(facets, left, axis, place(a)),
            place(a),
            far_end(facets, right, axis, place(a)),
        ]
        .map(flat);
        if let Some((centre, radius)) = circle(p, q, r) {
            // Rounding changes the height of the middle place over the line between the others.
            let height = (q - p).cross(r - p).length() / p.distance(r);
            joints.push(Joint {
                pieces: [left, right],
                centre,
                axis,
                radius,
                error: 2.0 * radius / height,
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
    let away = |v: u32| across(facets.positions[v as usize] - from, axis).length_squared();
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
    let radius = |v: u32| across(place(v) - bow.centre, bow.axis).length();
    let own = |k: &usize| bow.facets.binary_search(k).is_ok();
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
