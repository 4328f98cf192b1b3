//! The sides of all loops, with welded vertices, each joined to the side of the neighbouring face.

use super::draft::{Draft, DraftArc};
use super::fault::{BuildingFault, BuildingWarning};
use super::ids::FaceId;
use super::piece::{CircularArc, Piece};
use crate::trimesh::spatial_hash::SurfaceHash;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Vertices this close are one (metres).
const WELD: f64 = 2e-4;

/// A directed side of a loop. Its face lies to its left, seen from outside.
#[derive(Clone, Debug)]
pub(super) struct Side {
    pub face: FaceId,
    /// The welded vertices at which it starts and ends.
    pub from: u32,
    pub to: u32,
    pub piece: Piece,
    /// The sides after and before this one in its loop; seams are left out.
    pub next: usize,
    pub previous: usize,
    /// The side of the other face along the same edge; `None` on the border.
    pub twin: Option<usize>,
}

/// All sides that are no seams, and the welded vertices.
pub(super) struct SideTable {
    pub positions: Vec<DVec3>,
    /// The welded vertex of each vertex of the draft.
    pub welded: Vec<u32>,
    pub sides: Vec<Side>,
    /// The loops of each face, each by the numbers of its sides.
    pub loops: Vec<Vec<Vec<usize>>>,
    pub warnings: Vec<BuildingWarning>,
}

/// Two vertices, the smaller first.
pub(super) fn key(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// Welds the vertices of a draft that has passed its tests, and joins its sides.
///
/// # Errors
/// Loops that are too short, arcs given twice, edges of more than two faces, faces turned over.
pub(super) fn join(draft: &Draft) -> Result<SideTable, BuildingFault> {
    let (positions, welded) = weld(&draft.vertices);
    let (arcs, mut unused) = arc_table(draft, &welded)?;
    let mut sides = Vec::new();
    for (k, face) in draft.faces.iter().enumerate() {
        let face_id = FaceId(k as u32);
        for (ring, corners) in face.loops.iter().enumerate() {
            let mut corners: Vec<u32> = corners.iter().map(|&v| welded[v as usize]).collect();
            corners.dedup();
            if corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            if corners.len() < 3 {
                return Err(BuildingFault::ShortLoop {
                    face: face_id,
                    ring,
                });
            }
            add_ring(&mut sides, face_id, &corners, |from, to| {
                unused.remove(&key(from, to));
                piece(&positions, arcs.get(&key(from, to)), from, to)
            });
        }
    }
    let warnings = unused.into_values();
    let warnings = warnings
        .map(|arc| BuildingWarning::UnusedArc { arc })
        .collect();
    find_twins(draft, &welded, &mut sides)?;
    let (sides, loops) = without_seams(sides, draft.faces.len());
    Ok(SideTable {
        positions,
        welded,
        sides,
        loops,
        warnings,
    })
}

/// The distinct vertices, and for each given vertex the number of its distinct one. If two are equal, the first is
/// kept.
pub(super) fn weld(vertices: &[DVec3]) -> (Vec<DVec3>, Vec<u32>) {
    let mut hash = SurfaceHash::around(vertices.iter().copied(), 0.05);
    let mut positions: Vec<DVec3> = Vec::new();
    let mut welded = Vec::with_capacity(vertices.len());
    for &p in vertices {
        let mut own = None;
        hash.any_near(p, WELD, |other| {
            if positions[other].distance(p) < WELD {
                own = own.min(Some(other)).or(Some(other));
            }
            false
        });
        let own = own.unwrap_or_else(|| {
            hash.push_at(p);
            positions.push(p);
            positions.len() - 1
        });
        welded.push(own as u32);
    }
    (positions, welded)
}

type ArcTable<'a> = BTreeMap<(u32, u32), (&'a DraftArc, u32)>;
/// The numbers of arcs by their welded vertices.
type ArcNumbers = BTreeMap<(u32, u32), usize>;

/// The arcs by their pairs of welded vertices, each with the vertex at which it starts; and their numbers in the draft.
fn arc_table<'a>(
    draft: &'a Draft,
    welded: &[u32],
) -> Result<(ArcTable<'a>, ArcNumbers), BuildingFault> {
    let (mut table, mut numbers) = (ArcTable::new(), ArcNumbers::new());
    for (k, arc) in draft.arcs.iter().enumerate() {
        let [from, to] = [arc.from, arc.to].map(|v| welded[v as usize]);
        numbers.insert(key(from, to), k);
        if table.insert(key(from, to), (arc, from)).is_some() {
            let why = super::fault::ArcFault::Twice;
            return Err(BuildingFault::BadArc { arc: k, why });
        }
    }
    Ok((table, numbers))
}

/// The line or arc from one vertex to another.
fn piece(positions: &[DVec3], arc: Option<&(&DraftArc, u32)>, from: u32, to: u32) -> Piece {
    let [a, b] = [from, to].map(|v| positions[v as usize]);
    let Some(&(arc, start)) = arc else {
        return Piece::Line { from: a, to: b };
    };
    let axis = arc.axis.normalize();
    let [first, last] = if start == from { [a, b] } else { [b, a] };
    let quarter = CircularArc::about(arc.centre, axis, first, 0.0);
    let d = last - arc.centre;
    let angle = libm::atan2(d.dot(quarter.y), d.dot(quarter.x));
    let angle = if angle <= 0.0 { angle + TAU } else { angle };
    let whole = Piece::Arc(CircularArc::about(arc.centre, axis, first, angle));
    match start == from {
        true => whole,
        false => whole.reversed(),
    }
}

fn add_ring(
    sides: &mut Vec<Side>,
    face: FaceId,
    corners: &[u32],
    piece: impl FnMut(u32, u32) -> Piece,
) {
    let (first, n) = (sides.len(), corners.len());
    let mut piece = piece;
    for k in 0..n {
        let (from, to) = (corners[k], corners[(k + 1) % n]);
        sides.push(Side {
            face,
            from,
            to,
            piece: piece(from, to),
            next: first + (k + 1) % n,
            previous: first + (k + n - 1) % n,
            twin: None,
        });
    }
}

fn find_twins(draft: &Draft, welded: &[u32], sides: &mut [Side]) -> Result<(), BuildingFault> {
    let mut table: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
    for (k, side) in sides.iter().enumerate() {
        table.entry(key(side.from, side.to)).or_default().push(k);
    }
    // The first vertex of the draft that was welded to `v`.
    let original = |v: u32| {
        welded
            .iter()
            .position(|&w| w == v)
            .map_or(0, |at| at as u32)
    };
    let vertices = |(a, b): (u32, u32)| {
        debug_assert!(welded.len() == draft.vertices.len());
        [original(a), original(b)]
    };
    for (pair, members) in table {
        match members[..] {
            [a, b] if sides[a].from == sides[b].from => {
                return Err(BuildingFault::TurnedOver {
                    vertices: vertices(pair),
                    faces: [sides[a].face, sides[b].face],
                });
            }
            [a, b] => (sides[a].twin, sides[b].twin) = (Some(b), Some(a)),
            [_] => {}
            _ => {
                return Err(BuildingFault::NonManifold {
                    vertices: vertices(pair),
                    faces: members.iter().map(|&k| sides[k].face).collect(),
                });
            }
        }
    }
    Ok(())
}

/// Drops the sides at which a face meets itself (seams), and joins the remaining sides to loops: where a seam was, the
/// loop goes on with the side after the seam's twin.
fn without_seams(mut sides: Vec<Side>, faces: usize) -> (Vec<Side>, Vec<Vec<Vec<usize>>>) {
    let is_seam =
        |side: &Side, sides: &[Side]| side.twin.is_some_and(|twin| sides[twin].face == side.face);
    let seams: Vec<bool> = sides.iter().map(|side| is_seam(side, &sides)).collect();
    for k in (0..sides.len()).filter(|&k| !seams[k]) {
        let mut next = sides[k].next;
        while seams[next] {
            let twin = sides[next].twin.unwrap_or(next);
            next = sides[twin].next;
        }
        sides[k].next = next;
        sides[next].previous = k;
    }
    let mut number = vec![usize::MAX; sides.len()];
    let kept = (0..sides.len()).filter(|&k| !seams[k]);
    for (new, old) in kept.enumerate() {
        number[old] = new;
    }
    let mut kept: Vec<Side> = Vec::new();
    for (side, _) in sides.into_iter().zip(&seams).filter(|(_, seam)| !**seam) {
        kept.push(Side {
            next: number[side.next],
            previous: number[side.previous],
            twin: side.twin.map(|twin| number[twin]),
            ..side
        });
    }
    let loops = loops(&kept, faces);
    (kept, loops)
}

/// The loops of each face.
fn loops(sides: &[Side], faces: usize) -> Vec<Vec<Vec<usize>>> {
    let mut loops = vec![Vec::new(); faces];
    let mut seen = vec![false; sides.len()];
    for first in 0..sides.len() {
        let mut ring = Vec::new();
        let mut k = first;
        while !seen[k] {
            seen[k] = true;
            ring.push(k);
            k = sides[k].next;
        }
        if !ring.is_empty() {
            loops[sides[first].face.index()].push(ring);
        }
    }
    loops
}
