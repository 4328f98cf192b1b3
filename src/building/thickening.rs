//! Makes solids of walls that are single polygons (Legakis, Dorsey, Gortler 2001, section 6, future work: "it may be more
//! natural to specify a stone wall by a single polygon, rather than a closed mesh").

use super::checking;
use super::draft::{Draft, DraftArc, DraftFace};
use super::fault::BuildingFault;
use super::making_parent::path;
use super::piece::Piece;
use super::rules::flat_surface;
use super::sides::{self, Side, SideTable};
use super::surface::{FaceSurface, Sweep};
use glam::DVec3;

/// Sides whose unit tangents differ by more have a kink between them: about a degree.
const KINK: f64 = 0.0175;

impl Draft {
    /// The draft with a back and with narrow sides for each flat face that has a thickness and meets no other face. The
    /// narrow sides have the labels of the face. Where lines and arcs follow each other smoothly, as along a jamb and a
    /// round arch, they have one narrow side. Faces thinner than `least` (metres) stay single, as narrow sides have no room
    /// for the blocks of two corners.
    ///
    /// # Errors
    /// The first fault in the numbers, surfaces or loops of the draft.
    pub fn thickened(&self, least: f64) -> Result<Self, BuildingFault> {
        let is_thick = |thickness: f64| thickness >= least;
        if !self
            .faces
            .iter()
            .any(|face| face.thickness.is_some_and(is_thick))
        {
            return Ok(self.clone());
        }
        checking::check(self)?;
        let sides = sides::join(self)?;
        let mut draft = self.clone();
        for (k, loops) in sides.loops.iter().enumerate() {
            let is_alone = loops
                .iter()
                .flatten()
                .all(|&side| sides.sides[side].twin.is_none());
            let face = &self.faces[k];
            if let (Some(thickness), Some(surface), true) =
                (face.thickness, &face.surface, is_alone)
                && surface.is_flat()
                && is_thick(thickness)
            {
                let back = -surface.frame(0.0, 1.0).normal * thickness;
                draft.faces[k].thickness = None;
                thicken(&mut draft, &sides, face, loops, back);
            }
        }
        Ok(draft)
    }
}

/// Adds the back and the narrow sides of a face. `back` is the vector from its front to its back.
fn thicken(
    draft: &mut Draft,
    sides: &SideTable,
    face: &DraftFace,
    loops: &[Vec<usize>],
    back: DVec3,
) {
    let mut behind: Vec<Vec<DVec3>> = Vec::new();
    for ring in loops {
        let place = |&side: &usize| sides.positions[sides.sides[side].from as usize] + back;
        behind.push(ring.iter().rev().map(place).collect());
        for run in runs(&sides.sides, ring) {
            add_side(draft, sides, face, &run, back);
        }
    }
    let outer = behind.iter().map(|ring| flat_surface(ring));
    let surface = match &face.surface {
        Some(FaceSurface::Disk(_)) | None => outer.into_iter().next(),
        // The frame of the front with s reversed, so that its normal points to the back.
        Some(front) => {
            let frame = front.frame(0.0, 0.0);
            Some(FaceSurface::flat(frame.origin + back, -frame.s, frame.t))
        }
    };
    add_face(draft, face, surface, &behind);
}

/// Divides a loop into runs of sides that follow each other smoothly. A loop without a kink is divided at each vertex.
fn runs(sides: &[Side], ring: &[usize]) -> Vec<Vec<usize>> {
    let n = ring.len();
    let has_kink = |k: usize| {
        let [a, b] = [ring[(k + n - 1) % n], ring[k]].map(|side| &sides[side].piece);
        a.tangent(a.length()).distance(b.tangent(0.0)) > KINK
    };
    let Some(first) = (0..n).find(|&k| has_kink(k)) else {
        return ring.iter().map(|&side| vec![side]).collect();
    };
    let mut runs: Vec<Vec<usize>> = Vec::new();
    for step in 0..n {
        let k = (first + step) % n;
        match runs.last_mut().filter(|_| !has_kink(k)) {
            Some(run) => run.push(ring[k]),
            None => runs.push(vec![ring[k]]),
        }
    }
    runs
}

/// Adds the narrow face along a run of sides. Its loop walks these sides backwards, so its profile is reversed, too.
fn add_side(draft: &mut Draft, sides: &SideTable, face: &DraftFace, run: &[usize], back: DVec3) {
    let all = &sides.sides;
    let ends = run.iter().map(|&side| all[side].to);
    let front: Vec<u32> = [all[run[0]].from].into_iter().chain(ends).collect();
    let front: Vec<DVec3> = front.iter().map(|&v| sides.positions[v as usize]).collect();
    let mut ring: Vec<DVec3> = front.iter().rev().copied().collect();
    ring.extend(front.iter().map(|&p| p + back));
    let is_line = |side: &usize| matches!(all[*side].piece, Piece::Line { .. });
    let surface = match run.iter().all(is_line) {
        true => flat_surface(&ring),
        false => {
            let profile = path(all, run).reversed();
            FaceSurface::Sweep(Sweep::new(profile, back.normalize()))
        }
    };
    for &side in run {
        if let Piece::Arc(arc) = &all[side].piece {
            let axis = arc.x.cross(arc.y) * arc.sense();
            let first = draft.vertices.len() as u32;
            let ends = [all[side].from, all[side].to].map(|v| sides.positions[v as usize]);
            draft.vertices.extend(ends.map(|p| p + back));
            draft.arcs.push(DraftArc {
                from: first,
                to: first + 1,
                centre: arc.centre + back,
                axis,
            });
        }
    }
    add_face(draft, face, Some(surface), &[ring]);
}

/// Adds a face with new vertices, which are welded later.
fn add_face(
    draft: &mut Draft,
    like: &DraftFace,
    surface: Option<FaceSurface>,
    loops: &[Vec<DVec3>],
) {
    let mut numbers = Vec::new();
    for ring in loops {
        let first = draft.vertices.len() as u32;
        draft.vertices.extend_from_slice(ring);
        numbers.push((first..draft.vertices.len() as u32).collect());
    }
    draft.faces.push(DraftFace {
        labels: like.labels.clone(),
        surface,
        loops: numbers,
        thickness: None,
    });
}

#[cfg(test)]
mod tests {
    use super::super::rules::{Module, Rule};
    use super::super::tests::built;
    use crate::building::{Bend, json};

    #[test]
    fn a_single_wall_becomes_a_block() {
        let sheet = Rule::Sheet.draft(&Module::NORMAL, &[30.0, 20.0, 2.0]);
        let solid = built("solid", &sheet.thickened(0.239).unwrap());
        assert_eq!((solid.faces().len(), solid.corners().len()), (6, 8));
        assert!(solid.edges().iter().all(|edge| edge.bend == Bend::Convex));
        assert!(solid.warnings().is_empty());
        let depths = solid.edges().iter().map(|edge| edge.length());
        let least = depths.fold(f64::INFINITY, f64::min);
        assert!((least - 0.24).abs() < 1e-9);
        assert_eq!(sheet.thickened(0.25), Ok(sheet));
    }

    #[test]
    fn holes_and_arches_go_through() {
        let page = include_str!("../../docs/building.md");
        let text = page
            .split("```json\n")
            .nth(1)
            .and_then(|rest| rest.split("```").next());
        let mut draft = json::read(text.unwrap()).unwrap();
        draft.faces[0].thickness = Some(0.3);
        let solid = built("solid", &draft.thickened(0.0).unwrap());
        // Front, back and four ends; a sill, and one face for both jambs and their arch.
        assert_eq!(solid.faces().len(), 8);
        assert!(solid.edges().iter().all(|edge| edge.bend != Bend::Open));
        let curved = solid.faces().iter().filter(|face| !face.surface.is_flat());
        assert_eq!(curved.count(), 1);
        // A face that meets another one stays as it is.
        let block = Rule::Block.draft(&Module::NORMAL, &[]);
        assert_eq!(block.thickened(0.0), Ok(block.clone()));
    }
}
