//! Flattens a face's loops in space to its region in s and t, and triangulates it.

use super::facets;
use super::fault::{BuildingFault, OFF_SURFACE, SurfaceFault};
use super::ids::FaceId;
use super::piece::{CircularArc, Piece};
use super::region::{self, Spot, SpotRing};
use super::surface::{Disk, FaceSurface, Sweep};
use super::triangles::{self, TriangleCorner};
use crate::domain::{Contact, first_contact};
use crate::order::{self, rank};
use glam::{DVec2, DVec3};

/// Spots this close to a bend lie on it (metres): the tolerance that [`facets::cuts`] has, too.
const SNAP: f64 = facets::NEAR;
/// Cuts of arcs this close to a bend lie on it (metres): more than [`SNAP`], since loops may be off the surface.
const CUT_SNAP: f64 = 2.0 * OFF_SURFACE;
/// The longest step in s along a straight side of a disk (metres): in s and t, which are polar, the side is a curve.
const POLAR: f64 = 0.06;

/// A side of a face's loop: its shape, and the vertices along it from start to end.
pub(super) struct Walked<'a> {
    pub piece: &'a Piece,
    /// Each vertex with its place; the last one begins the next side.
    pub vertices: Vec<(u32, DVec3)>,
}

/// A face's region.
pub(super) struct Flat {
    /// Its rings in s and t.
    pub rings: Vec<SpotRing>,
    /// Its triangles. New vertices inside are in s and t; those of a disk are in its plane, see [`from_plane`].
    pub triangles: Vec<[TriangleCorner; 3]>,
}

/// Flattens the loops of a face, and triangulates its region.
///
/// # Errors
/// Loops off their surface, loops that cross, or that do not bound a region.
pub(super) fn flatten(
    face: FaceId,
    surface: &FaceSurface,
    loops: &[Vec<Walked<'_>>],
) -> Result<Flat, BuildingFault> {
    on_surface(face, surface, loops)?;
    match surface {
        FaceSurface::Sweep(sweep) => flatten_sweep(face, sweep, surface, loops),
        FaceSurface::Disk(disk) => flatten_disk(face, disk, surface, loops),
    }
}

/// Tests that all sides lie on the surface: their vertices, and places between them.
fn on_surface(
    face: FaceId,
    surface: &FaceSurface,
    loops: &[Vec<Walked<'_>>],
) -> Result<(), BuildingFault> {
    for side in loops.iter().flatten() {
        let inner = [0.25, 0.5, 0.75].map(|share| side.piece.point(share * side.piece.length()));
        for at in side.vertices.iter().map(|v| v.1).chain(inner) {
            let place = surface.project(at);
            let by = surface.frame(place.x, place.y).origin.distance(at);
            // NaN counts as off the surface.
            if by.is_nan() || by > OFF_SURFACE {
                return Err(BuildingFault::OffSurface { face, at, by });
            }
        }
    }
    Ok(())
}

/// The spots of loops under a map to the plane.
fn spots(loops: &[Vec<Walked<'_>>], flat: impl Fn(DVec3) -> DVec2) -> Vec<SpotRing> {
    let mut rings = Vec::with_capacity(loops.len());
    for walked in loops {
        let mut ring = SpotRing::new();
        for side in walked {
            let starts = &side.vertices[..side.vertices.len() - 1];
            ring.extend(starts.iter().enumerate().map(|(k, &(vertex, p))| Spot {
                at: flat(p),
                vertex: Some(vertex),
                is_cut: k > 0,
            }));
        }
        rings.push(ring);
    }
    rings
}

fn flatten_sweep(
    face: FaceId,
    sweep: &Sweep,
    surface: &FaceSurface,
    loops: &[Vec<Walked<'_>>],
) -> Result<Flat, BuildingFault> {
    let mut rings = spots(loops, |p| surface.project(p).truncate());
    let mut strips = bends(sweep);
    if let Some(period) = sweep.period() {
        region::unwrap(&mut rings, period);
        let seam = region::best_seam(&rings, period, &strips);
        let unbounded = |_| BuildingFault::BadSurface {
            face,
            why: SurfaceFault::Unbounded,
        };
        rings = region::cut_open(&rings, period, seam, None).map_err(unbounded)?;
        for s in &mut strips {
            *s += period * ((seam - *s) / period).ceil();
        }
        order::sort(&mut strips, |&s| (rank(s), 0));
    }
    snap(&mut rings, &strips);
    apart(face, &rings, |at| surface.frame(at.x, at.y).origin)?;
    let inside_out = |_| BuildingFault::InsideOut { face };
    let triangles = triangles::triangulate(&rings, &strips).map_err(inside_out)?;
    Ok(Flat { rings, triangles })
}

/// The values of s at which a swept face bends: the joints of its profile, and the places where its arcs are cut. On a
/// whole cylinder they lie in one period.
fn bends(sweep: &Sweep) -> Vec<f64> {
    let profile = sweep.profile();
    if let (Some(period), [Piece::Arc(arc)]) = (sweep.period(), profile.pieces()) {
        return bends_around(arc, period);
    }
    let mut all = Vec::new();
    for (k, piece) in profile.pieces().iter().enumerate() {
        let start = profile.joints()[k];
        if k > 0 {
            all.push(start);
        }
        if let Piece::Arc(arc) = piece {
            all.extend(facets::cuts(arc).into_iter().map(|s| start + s));
        }
    }
    all
}

/// The arc lengths at which a whole circle is cut. [`facets::cuts`] leaves out the ends of an arc, so a cut at the
/// start is found a whole turn later.
fn bends_around(arc: &CircularArc, period: f64) -> Vec<f64> {
    let more = 0.5 * arc.sense();
    let longer = facets::cuts(&CircularArc {
        to: arc.to + more,
        ..*arc
    });
    let (mut all, behind): (Vec<f64>, Vec<f64>) =
        longer.into_iter().partition(|&s| s < period - SNAP);
    let at_start = behind.first().filter(|&&s| s < period + SNAP);
    all.splice(0..0, at_start.map(|_| 0.0));
    all
}

/// Moves spots that are close to a bend onto it, so that no slivers arise there.
fn snap(rings: &mut [SpotRing], strips: &[f64]) {
    for spot in rings.iter_mut().flatten() {
        let k = strips.partition_point(|&s| s < spot.at.x);
        let near = strips[k.saturating_sub(1)..strips.len().min(k + 1)].iter();
        let reach = if spot.is_cut { CUT_SNAP } else { SNAP };
        let away = |s: f64| (s - spot.at.x).abs();
        let nearest = near
            .copied()
            .reduce(|a, b| if away(b) < away(a) { b } else { a });
        if let Some(s) = nearest.filter(|&s| away(s) < reach) {
            spot.at.x = s;
        }
    }
}

/// Tests that rings neither cross nor touch.
fn apart(
    face: FaceId,
    rings: &[SpotRing],
    place: impl Fn(DVec2) -> DVec3,
) -> Result<(), BuildingFault> {
    let rings: Vec<Vec<DVec2>> = plain(rings);
    match first_contact(&rings) {
        None => Ok(()),
        Some(Contact::Within(_, at) | Contact::Between(_, _, at)) => {
            let at = place(at);
            Err(BuildingFault::Crossing { face, at })
        }
    }
}

/// The rings' places alone, without vertices.
pub(super) fn plain(rings: &[SpotRing]) -> Vec<Vec<DVec2>> {
    let ring = |ring: &SpotRing| ring.iter().map(|spot| spot.at).collect();
    rings.iter().map(ring).collect()
}

/// Disks are triangulated in their plane, where straight lines are straight; their rings are in s and t nevertheless.
fn flatten_disk(
    face: FaceId,
    disk: &Disk,
    surface: &FaceSurface,
    loops: &[Vec<Walked<'_>>],
) -> Result<Flat, BuildingFault> {
    let rings = spots(loops, |p| in_plane(disk, p));
    apart(face, &rings, |at| from_plane(disk, at))?;
    let inside_out = |_| BuildingFault::InsideOut { face };
    let triangles = triangles::triangulate(&rings, &[]).map_err(inside_out)?;
    let unbounded = |_| BuildingFault::BadSurface {
        face,
        why: SurfaceFault::Unbounded,
    };
    Ok(Flat {
        rings: polar(disk, surface, loops).map_err(unbounded)?,
        triangles,
    })
}

/// Coordinates in a disk's plane, right-handed seen from outside.
fn in_plane(disk: &Disk, p: DVec3) -> DVec2 {
    let d = p - disk.centre();
    DVec2::new(d.dot(disk.rim().y), d.dot(disk.rim().x))
}

/// The place at coordinates in a disk's plane: the inverse of [`in_plane`].
pub(super) fn from_plane(disk: &Disk, at: DVec2) -> DVec3 {
    disk.centre() + disk.rim().y * at.x + disk.rim().x * at.y
}

/// The rings of a disk in s and t.
fn polar(
    disk: &Disk,
    surface: &FaceSurface,
    loops: &[Vec<Walked<'_>>],
) -> Result<Vec<SpotRing>, region::UnboundedRegion> {
    let mut rings: Vec<SpotRing> = Vec::new();
    for ring in loops {
        let mut spots = SpotRing::new();
        for side in ring {
            for pair in side.vertices.windows(2) {
                let ends = [pair[0].1, pair[1].1];
                let way = surface.project(ends[1]).x - surface.project(ends[0]).x;
                let is_line = matches!(side.piece, Piece::Line { .. });
                let parts = (way.abs() / POLAR).ceil().clamp(1.0, 200.0);
                let parts = if is_line { parts as u32 } else { 1 };
                for k in 0..parts {
                    let p = ends[0].lerp(ends[1], f64::from(k) / f64::from(parts));
                    spots.push(Spot {
                        at: surface.project(p).truncate(),
                        vertex: (k == 0).then_some(pair[0].0),
                        is_cut: false,
                    });
                }
            }
        }
        rings.push(with_centre(spots));
    }
    let Some(period) = disk.period() else {
        return Ok(rings);
    };
    region::unwrap(&mut rings, period);
    let candidates: Vec<f64> = rings.iter().flatten().map(|spot| spot.at.x).collect();
    let seam = region::best_seam(&rings, period, &candidates);
    region::cut_open(&rings, period, seam, Some(0.0))
}

/// A spot at the disk's centre has no angle: it becomes two spots, with the angles of the spots before and after it.
fn with_centre(spots: SpotRing) -> SpotRing {
    let n = spots.len();
    let mut all = SpotRing::new();
    for (k, &spot) in spots.iter().enumerate() {
        if spot.at.y > SNAP {
            all.push(spot);
            continue;
        }
        for near in [spots[(k + n - 1) % n], spots[(k + 1) % n]] {
            let at = DVec2::new(near.at.x, 0.0);
            all.push(Spot { at, ..spot });
        }
    }
    all
}
