//! Tests of a draft as read: numbers, arcs and surfaces, one by one. Faces that meet are tested when the
//! meshes are made.

use super::draft::{Draft, DraftArc, DraftFace};
use super::fault::{
    ArcFault, BuildingFault, FARTHEST, MOST_FACES, MOST_SIDES, OFF_SURFACE, SurfaceFault,
};
use super::ids::FaceId;
use super::path::Path;
use super::piece::{CircularArc, Piece};
use super::surface::{Disk, FaceSurface, Sweep};
use crate::decimal;
use glam::DVec3;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Tolerance for the length of a unit vector, and for the dot product of unit vectors at right angles.
const UNIT: f64 = 1e-6;
/// Pieces and radii shorter than this are faults (metres).
const SHORT: f64 = 1e-6;
/// The sharpest turn of a smooth profile: about a degree (radians).
const KINK: f64 = 0.0175;

/// Tests a draft. Coordinates are tested first, so that later tests meet finite numbers only.
///
/// # Errors
/// The first fault.
pub(super) fn check(draft: &Draft) -> Result<(), BuildingFault> {
    counts(draft)?;
    numbers(draft)?;
    indices(draft)?;
    arcs(draft)?;
    for (k, face) in draft.faces.iter().enumerate() {
        let face_id = FaceId(k as u32);
        let fault = match &face.surface {
            None => return Err(BuildingFault::NoSurface { face: face_id }),
            Some(surface) => surface_fault(surface),
        };
        if let Some(why) = fault {
            return Err(BuildingFault::BadSurface { face: face_id, why });
        }
    }
    Ok(())
}

fn counts(draft: &Draft) -> Result<(), BuildingFault> {
    let faces = draft.faces.len();
    if faces == 0 {
        return Err(BuildingFault::Empty);
    }
    if faces > MOST_FACES {
        return Err(BuildingFault::TooManyFaces { faces });
    }
    let loops = draft.faces.iter().flat_map(|face| &face.loops);
    let extra: usize = draft.extras.iter().map(|mesh| mesh.triangles.len()).sum();
    let sides = loops.map(Vec::len).sum::<usize>().max(extra);
    let sides = sides.max(draft.vertices.len()).max(draft.arcs.len());
    match sides > MOST_SIDES {
        true => Err(BuildingFault::TooManySides { sides }),
        false => Ok(()),
    }
}

/// Tests that a number is finite and its size at most [`FARTHEST`].
fn number(path: impl Fn() -> String, value: f64) -> Result<(), BuildingFault> {
    match beyond(value) {
        None => Ok(()),
        Some(found) => Err(BuildingFault::Number {
            path: path(),
            found,
        }),
    }
}

/// A number that is not finite, or greater than [`FARTHEST`], as text.
fn beyond(value: f64) -> Option<String> {
    (value.abs() > FARTHEST || value.is_nan()).then(|| match value.is_finite() {
        true => decimal::text(value),
        false => format!("{value}"),
    })
}

/// Tests the vertices of an OBJ file.
///
/// # Errors
/// The first vertex that lies too far away.
pub(super) fn vertices(all: &[DVec3]) -> Result<(), BuildingFault> {
    let far =
        |(k, place): (usize, &DVec3)| Some((k, place.to_array().into_iter().find_map(beyond)?));
    let Some((k, found)) = all.iter().enumerate().find_map(far) else {
        return Ok(());
    };
    let low = all.iter().copied().reduce(DVec3::min);
    let high = all.iter().copied().reduce(DVec3::max);
    let size = high.unwrap_or_default() - low.unwrap_or_default();
    Err(BuildingFault::Far {
        vertex: k + 1,
        found,
        size: size.to_array(),
    })
}

/// Tests that the parts of a vector are finite and at most [`FARTHEST`].
fn vector(path: impl Fn() -> String, v: DVec3) -> Result<(), BuildingFault> {
    let mut all = v.to_array().into_iter();
    all.try_for_each(|value| number(&path, value))
}

fn numbers(draft: &Draft) -> Result<(), BuildingFault> {
    for (k, &v) in draft.vertices.iter().enumerate() {
        vector(|| format!("v[{k}]"), v)?;
    }
    for (k, arc) in draft.arcs.iter().enumerate() {
        vector(|| format!("arcs[{k}].centre"), arc.centre)?;
        vector(|| format!("arcs[{k}].axis"), arc.axis)?;
    }
    for (k, face) in draft.faces.iter().enumerate() {
        face_numbers(k, face)?;
    }
    for (k, mesh) in draft.extras.iter().enumerate() {
        for (i, &v) in mesh.positions.iter().enumerate() {
            vector(|| format!("extras[{k}].v[{i}]"), v)?;
        }
    }
    number(|| "ground".into(), draft.ground.unwrap_or(0.0))
}

fn face_numbers(k: usize, face: &DraftFace) -> Result<(), BuildingFault> {
    let path = || format!("faces[{k}].param");
    match &face.surface {
        Some(FaceSurface::Sweep(sweep)) => {
            vector(path, sweep.direction())?;
            for piece in sweep.profile().pieces() {
                piece_numbers(path, piece)?;
            }
        }
        Some(FaceSurface::Disk(disk)) => {
            vector(path, disk.normal())?;
            piece_numbers(path, &Piece::Arc(*disk.rim()))?;
        }
        None => {}
    }
    let thickness = || format!("faces[{k}].thickness");
    match face.thickness {
        Some(value) if value <= 0.0 => Err(BuildingFault::Number {
            path: thickness(),
            found: decimal::text(value),
        }),
        value => number(thickness, value.unwrap_or(0.0)),
    }
}

fn piece_numbers(path: impl Fn() -> String, piece: &Piece) -> Result<(), BuildingFault> {
    match piece {
        Piece::Line { from, to } => {
            vector(&path, *from)?;
            vector(path, *to)
        }
        Piece::Arc(arc) => {
            for v in [arc.centre, arc.x, arc.y] {
                vector(&path, v)?;
            }
            let mut all = [arc.radius, arc.from, arc.to].into_iter();
            all.try_for_each(|value| number(&path, value))
        }
    }
}

fn indices(draft: &Draft) -> Result<(), BuildingFault> {
    let count = draft.vertices.len();
    let exists =
        |path: &dyn Fn() -> String, vertex: u32, count: usize| match (vertex as usize) < count {
            true => Ok(()),
            false => Err(BuildingFault::NoVertex {
                path: path(),
                vertex,
            }),
        };
    for (k, face) in draft.faces.iter().enumerate() {
        for (i, ring) in face.loops.iter().enumerate() {
            let path = || format!("faces[{k}].loops[{i}]");
            ring.iter().try_for_each(|&v| exists(&path, v, count))?;
        }
    }
    for (k, arc) in draft.arcs.iter().enumerate() {
        let path = || format!("arcs[{k}]");
        [arc.from, arc.to]
            .iter()
            .try_for_each(|&v| exists(&path, v, count))?;
    }
    for (k, mesh) in draft.extras.iter().enumerate() {
        let path = || format!("extras[{k}].triangles");
        let mut all = mesh.triangles.iter().flatten();
        all.try_for_each(|&v| exists(&path, v, mesh.positions.len()))?;
    }
    Ok(())
}

fn arcs(draft: &Draft) -> Result<(), BuildingFault> {
    let mut seen = BTreeSet::new();
    for (k, arc) in draft.arcs.iter().enumerate() {
        let pair = (arc.from.min(arc.to), arc.from.max(arc.to));
        let fault = match seen.insert(pair) {
            true => arc_fault(draft, arc),
            false => Some(ArcFault::Twice),
        };
        if let Some(why) = fault {
            return Err(BuildingFault::BadArc { arc: k, why });
        }
    }
    Ok(())
}

fn arc_fault(draft: &Draft, arc: &DraftArc) -> Option<ArcFault> {
    let axis = arc.axis.normalize_or_zero();
    if axis == DVec3::ZERO {
        return Some(ArcFault::NoAxis);
    }
    let [from, to] = [arc.from, arc.to].map(|v| draft.vertices[v as usize] - arc.centre);
    if from.dot(axis).abs().max(to.dot(axis).abs()) > OFF_SURFACE {
        return Some(ArcFault::Plane);
    }
    let radii = [from.length(), to.length()];
    let is_bad = (radii[0] - radii[1]).abs() > OFF_SURFACE || radii[0] < OFF_SURFACE;
    is_bad.then_some(ArcFault::Radius)
}

/// The first fault of a surface; `None` if it has none.
fn surface_fault(surface: &FaceSurface) -> Option<SurfaceFault> {
    match surface {
        FaceSurface::Sweep(sweep) => sweep_fault(sweep),
        FaceSurface::Disk(disk) => disk_fault(disk),
    }
}

fn sweep_fault(sweep: &Sweep) -> Option<SurfaceFault> {
    let (profile, direction) = (sweep.profile(), sweep.direction());
    if let Some(fault) = path_fault(profile) {
        return Some(fault);
    }
    let is_level = |s: f64| profile.tangent(s).dot(direction).abs() < UNIT;
    let pieces = profile.pieces().iter().zip(profile.joints());
    let mut quarters =
        pieces.flat_map(|(piece, start)| [0.0, 0.3].map(|share| start + share * piece.length()));
    let is_right = (direction.length() - 1.0).abs() < UNIT && quarters.all(is_level);
    (!is_right).then_some(SurfaceFault::Direction)
}

fn path_fault(path: &Path) -> Option<SurfaceFault> {
    let is_short = |piece: &Piece| match piece {
        Piece::Line { .. } => piece.length() < SHORT,
        Piece::Arc(arc) => arc.radius < SHORT || piece.length() < SHORT,
    };
    let turns = |piece: &Piece| matches!(piece, Piece::Arc(arc) if is_over(arc));
    let is_square = |piece: &Piece| match piece {
        Piece::Line { .. } => true,
        Piece::Arc(arc) => is_square(arc.x, arc.y),
    };
    let pieces = path.pieces();
    if pieces.is_empty() || pieces.iter().any(is_short) {
        Some(SurfaceFault::NoLength)
    } else if pieces.iter().any(turns) {
        Some(SurfaceFault::Turns)
    } else if !pieces.iter().all(is_square) {
        Some(SurfaceFault::Direction)
    } else if path.widest_gap() > OFF_SURFACE {
        Some(SurfaceFault::Gap)
    } else {
        (path.sharpest_turn() > KINK).then_some(SurfaceFault::Kink)
    }
}

/// Whether an arc runs around its circle more than once.
fn is_over(arc: &CircularArc) -> bool {
    (arc.to - arc.from).abs() > TAU + UNIT
}

/// Whether two vectors are unit vectors at right angles.
fn is_square(x: DVec3, y: DVec3) -> bool {
    let is_unit = |v: DVec3| (v.length() - 1.0).abs() < UNIT;
    is_unit(x) && is_unit(y) && x.dot(y).abs() < UNIT
}

fn disk_fault(disk: &Disk) -> Option<SurfaceFault> {
    let rim = disk.rim();
    if rim.radius < SHORT || rim.to - rim.from < SHORT {
        return Some(SurfaceFault::NoLength);
    }
    if is_over(rim) {
        return Some(SurfaceFault::Turns);
    }
    let is_right = is_square(rim.x, rim.y) && is_square(rim.x, disk.normal());
    (!is_right).then_some(SurfaceFault::Direction)
}
