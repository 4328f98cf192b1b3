//! Reads a building from an OBJ file, whose polygons and groups are kept.
//!
//! An OBJ file knows neither holes nor arcs, so faces have to be recognised. Polygons of one group that meet in a plane
//! are a flat face. A chain of at least three flat faces of one group whose joints lie on one circle, at right angles to
//! its axis, is a curved face. The names of a group are the labels of its faces. A file tells neither its unit nor its
//! upright axis: [`FileSpace`] does.
//!
//! Jambs that are tangent to an arch do not belong to it: each joint has a circle through itself and its two
//! neighbours, and only joints with the same circle are joined. Places that a file gives to the millimetre, or finer, are
//! put back on their cylinder.

use super::bows::{self, Bow};
use super::checking;
use super::draft::{Draft, DraftArc, DraftFace};
use super::fault::BuildingFault;
use super::georeference;
use super::recognising::{Facet, FacetModel};
use super::rules::flat_surface;
use crate::domain::signed_area;
use crate::modelfiles::{PolygonModel, upright};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// The draft of a file, and what was recognised in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Recognised {
    /// The building.
    pub draft: Draft,
    /// The move of a building that lies far from the origin of its file (metres, y up).
    pub moved: Option<DVec3>,
    /// The number of polygons in the file.
    pub polygons: usize,
    /// The number of polygons without an area, which were left out.
    pub degenerate: usize,
    /// The number of flat faces.
    pub flat: usize,
    /// The curved faces.
    pub curved: Vec<Curved>,
}

/// A curved face that was recognised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curved {
    /// Its index in the draft's list of faces.
    pub face: usize,
    /// The number of flat pieces that it was made of.
    pub pieces: usize,
    /// Its radius (metres).
    pub radius: f64,
    /// Whether it is a whole cylinder.
    pub is_whole: bool,
}

/// The unit and the upright axis of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileSpace {
    /// A unit of the file in metres, as a numerator and a denominator: a length in whole millimetres becomes the nearest
    /// number to its metres.
    pub unit: [f64; 2],
    /// Whether the file's z axis points up. If not, its y axis does.
    pub is_z_up: bool,
}

impl FileSpace {
    /// Metres, with y up, as in buildings.
    pub const METRES: Self = Self {
        unit: [1.0, 1.0],
        is_z_up: false,
    };

    /// A place of the file, in metres with y up.
    fn in_metres(&self, place: DVec3) -> DVec3 {
        let [over, under] = self.unit;
        let place = place * over / under;
        match self.is_z_up {
            true => upright(place),
            false => place,
        }
    }
}

/// Group names that are not labels, in lower case. Endings that programs add, such as `.001`, are cut off first.
const NO_LABELS: [&str; 4] = ["default", "off", "(null)", "none"];

/// Reads a file with this unit and this upright axis. A building of at most 1,000 m that lies farther away than a building
/// may is moved to the origin.
///
/// # Errors
/// [`BuildingFault::NotObj`] with the line that cannot be read; [`BuildingFault::Far`] with the vertex that lies too
/// far away; [`BuildingFault::Polygons`] if two polygons run the same way along a side, as where more
/// than two meet; or [`BuildingFault::Empty`].
pub fn read(bytes: &[u8], space: &FileSpace) -> Result<Recognised, BuildingFault> {
    let mut model = PolygonModel::read(bytes).map_err(BuildingFault::NotObj)?;
    for place in &mut model.positions {
        *place = space.in_metres(*place);
    }
    let moved = georeference::to_origin(&mut model.positions);
    checking::vertices(&model.positions)?;
    let mut facets = FacetModel::new(&model)?;
    let bows = bows::bows(&facets);
    for bow in &bows {
        bow.put_on(&mut facets);
    }
    let mut draft = Draft {
        vertices: facets.positions.clone(),
        ..Draft::default()
    };
    let (mut flat, mut curved) = (0, Vec::new());
    let mut done = BTreeSet::new();
    for bow in &bows {
        let loops = outline(&facets, &bow.facets);
        draft.arcs.extend(arcs(&facets, bow, &loops));
        curved.push(Curved {
            face: draft.faces.len(),
            pieces: bow.facets.len(),
            radius: bow.radius,
            is_whole: bow.is_whole(),
        });
        let labels = labels(&model.groups[facets.all[bow.facets[0]].group as usize]);
        draft.faces.push(face(labels, Some(bow.surface()), loops));
        done.extend(bow.facets.iter().copied());
    }
    for k in (0..facets.all.len()).filter(|k| !done.contains(k)) {
        let mut loops = outline(&facets, &[k]);
        outer_first(&facets, &facets.all[k], &mut loops);
        let ring: Vec<DVec3> = loops[0]
            .iter()
            .map(|&v| facets.positions[v as usize])
            .collect();
        let labels = labels(&model.groups[facets.all[k].group as usize]);
        draft
            .faces
            .push(face(labels, Some(flat_surface(&ring)), loops));
        flat += 1;
    }
    // Faces that meet along a circle have its sides twice.
    let mut seen = BTreeSet::new();
    draft
        .arcs
        .retain(|arc| seen.insert((arc.from.min(arc.to), arc.from.max(arc.to))));
    Ok(Recognised {
        draft,
        moved,
        polygons: model.polygons.len(),
        degenerate: facets.degenerate,
        flat,
        curved,
    })
}

fn face(
    labels: Vec<String>,
    surface: Option<super::surface::FaceSurface>,
    loops: Vec<Vec<u32>>,
) -> DraftFace {
    DraftFace {
        labels,
        surface,
        loops,
        thickness: None,
    }
}

/// The labels of a group.
fn labels(names: &[String]) -> Vec<String> {
    let plain = |name: &String| {
        let (head, tail) = name.rsplit_once('.').unwrap_or((name, ""));
        let is_number = !tail.is_empty() && tail.bytes().all(|b| b.is_ascii_digit());
        if is_number {
            head.to_owned()
        } else {
            name.clone()
        }
    };
    let is_label = |name: &String| !NO_LABELS.contains(&name.to_ascii_lowercase().as_str());
    names.iter().map(plain).filter(is_label).collect()
}

/// The loops around facets: the sides that no two of them share. Where loops touch, each goes on to the vertex of the
/// lowest number.
fn outline(facets: &FacetModel, members: &[usize]) -> Vec<Vec<u32>> {
    let sides = members.iter().flat_map(|&k| &facets.all[k].sides);
    let all: BTreeSet<(u32, u32)> = sides.copied().collect();
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &(a, b) in all.iter().filter(|&&(a, b)| !all.contains(&(b, a))) {
        next.entry(a).or_default().insert(0, b);
    }
    let mut loops = Vec::new();
    while let Some((&first, _)) = next.iter().find(|(_, ends)| !ends.is_empty()) {
        let (mut ring, mut at) = (Vec::new(), first);
        while let Some(end) = next.get_mut(&at).and_then(Vec::pop) {
            ring.push(at);
            at = end;
        }
        loops.push(ring);
    }
    loops
}

/// Puts the loop with the greatest area first.
fn outer_first(facets: &FacetModel, facet: &Facet, loops: &mut [Vec<u32>]) {
    let (x, y) = facet.axes();
    let area = |ring: &Vec<u32>| {
        let flat = |&v: &u32| {
            let p = facets.positions[v as usize];
            glam::DVec2::new(p.dot(x), p.dot(y))
        };
        signed_area(&ring.iter().map(flat).collect::<Vec<_>>())
    };
    let areas: Vec<f64> = loops.iter().map(area).collect();
    let best = (0..areas.len()).fold(0, |best, k| if areas[k] > areas[best] { k } else { best });
    loops.swap(0, best);
}

/// The sides of a curved face's loops that run around its axis.
fn arcs(facets: &FacetModel, bow: &Bow, loops: &[Vec<u32>]) -> Vec<DraftArc> {
    let mut arcs = Vec::new();
    for ring in loops {
        let next = ring.iter().cycle().skip(1);
        for (&from, &to) in ring.iter().zip(next) {
            let [a, b] = [from, to].map(|v| facets.positions[v as usize]);
            if bow.is_ruling(a, b) {
                continue;
            }
            let centre = bow.centre + bow.axis * (a - bow.centre).dot(bow.axis);
            let turn = (a - centre).cross(b - centre).dot(bow.axis).signum();
            arcs.push(DraftArc {
                from,
                to,
                centre,
                axis: bow.axis * turn,
            });
        }
    }
    arcs
}
