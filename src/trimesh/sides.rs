//! The two sides of open parts. A closed part has an outside; an open one, such as a slope or a bowl, has two sides
//! that are equal in kind, and a file may name either of them as the outside.
//!
//! The guess: a part that mostly faces one way is a sheet, and its upper side is the outside; any other part is a
//! shell, and its outside faces away from its centre.

use super::borders::PartSearch;
use super::{MeshBuilding, NONE, TriMesh};
use crate::notice::{Code, Notice};
use glam::DVec3;
use std::sync::Arc;

/// Triangles in a slice.
const SLICE: usize = 1 << 15;
/// A part is a sheet if the sum of its triangles' area vectors is at least this share of its area. That share is 1
/// for a plane, 1/2 for half a sphere, and 0 for a tube.
const SHEET: f64 = 0.6;
/// A side must be better than the other one by this share of the greatest possible value.
const CLEAR: f64 = 0.05;

/// The side of open parts that is the outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The side that the file names.
    Given,
    /// The upper or outer side.
    Guessed,
    /// The lower or inner side.
    Other,
}

/// A mesh with the wanted outsides.
#[derive(Clone, Debug)]
pub struct Sided {
    /// The mesh; the given one if no triangle was turned over.
    pub mesh: Arc<TriMesh>,
    /// Whether any part is open.
    pub is_open: bool,
    /// The area of the largest part.
    pub largest: f64,
    /// The sum of the squared edges of all triangles, divided by their area: about 7 for equilateral triangles. The
    /// boxes of needles overlap, so a search looks at about as many boxes as this number.
    pub slenderness: f64,
    /// A remark on parts that were turned, or that look as if they should be.
    pub notice: Option<Notice>,
}

/// The sums over a part that its guess needs.
#[derive(Clone, Copy, Default)]
struct PartSums {
    is_open: bool,
    triangles: usize,
    /// Twice the area. `facing` is twice the sum of area vectors, `moment` the centroid times twice the area.
    area: f64,
    /// The sum of the squared edges.
    squares: f64,
    facing: DVec3,
    moment: DVec3,
    /// Twice the flux through the part of the vector from [`Siding::about`] to a point of the surface.
    flux: f64,
    /// The sum of the triangles' distances from [`Siding::about`], each times twice the triangle's area.
    reach: f64,
}

impl PartSums {
    fn add(&mut self, [a, b, c]: [DVec3; 3]) {
        let facing = (b - a).cross(c - a);
        let (area, middle) = (facing.length(), (a + b + c) / 3.0);
        self.triangles += 1;
        self.area += area;
        let edges = [
            a.distance_squared(b),
            b.distance_squared(c),
            c.distance_squared(a),
        ];
        self.squares += edges.iter().sum::<f64>();
        self.facing += facing;
        self.moment += area * middle;
        self.flux += middle.dot(facing);
        self.reach += area * middle.length();
    }

    /// Whether the given outside looks like the inside.
    fn is_wrong(&self) -> bool {
        let (towards, most) = match self.facing.length() >= SHEET * self.area {
            true => (self.facing.y, self.area),
            // Relative to the centroid.
            false => {
                let centre = self.moment / self.area;
                (self.flux - centre.dot(self.facing), self.reach)
            }
        };
        self.is_open && towards < -CLEAR * most
    }
}

enum SidingPhase {
    Search,
    Measure,
    Build(Box<MeshBuilding>),
}

/// Turns open parts over where that is wanted, in slices.
pub struct Siding {
    mesh: Arc<TriMesh>,
    sides: Sides,
    phase: SidingPhase,
    /// Finds the part of each triangle.
    search: PartSearch,
    /// How many triangles have been measured.
    at: usize,
    parts: Vec<PartSums>,
    /// The middle of the bounding box. Places are relative to it, so that sums lose few digits.
    about: DVec3,
}

impl Siding {
    /// Starts with a mended surface.
    pub fn new(mesh: Arc<TriMesh>, sides: Sides) -> Self {
        let (low, high) = mesh.bounds();
        Self {
            sides,
            phase: SidingPhase::Search,
            search: PartSearch::default(),
            at: 0,
            parts: Vec::new(),
            about: 0.5 * (low + high),
            mesh,
        }
    }

    /// Does one more slice. Returns the surface when it is done.
    pub fn advance(&mut self) -> Option<Sided> {
        match &mut self.phase {
            SidingPhase::Search => {
                if self.search.advance(&self.mesh) {
                    self.parts = vec![PartSums::default(); self.search.count];
                    self.phase = SidingPhase::Measure;
                }
                None
            }
            SidingPhase::Measure => self.measure().then(|| self.turn()).flatten(),
            // Turning parts over adds no edge, so the mesh has no new fault.
            SidingPhase::Build(building) => {
                let mesh = building.advance()?.map_or(self.mesh.clone(), Arc::new);
                Some(self.sided(mesh))
            }
        }
    }

    /// Measures one more slice of triangles; true after the last one.
    fn measure(&mut self) -> bool {
        let part = &self.search.part;
        let end = part.len().min(self.at + SLICE);
        for (t, &part) in part.iter().enumerate().take(end).skip(self.at) {
            let corners = self.mesh.corners(t as u32).map(|p| p - self.about);
            let own = &mut self.parts[part as usize];
            own.add(corners);
            own.is_open |= self.mesh.across[t].contains(&NONE);
        }
        self.at = end;
        end == part.len()
    }

    /// Whether a part is to be turned over.
    fn is_turned(&self, part: &PartSums) -> bool {
        match self.sides {
            Sides::Given => false,
            Sides::Guessed => part.is_wrong(),
            Sides::Other => part.is_open && !part.is_wrong(),
        }
    }

    /// Begins to build the mesh with turned parts, or returns the given mesh if no part is turned.
    fn turn(&mut self) -> Option<Sided> {
        let turned: Vec<bool> = self.parts.iter().map(|part| self.is_turned(part)).collect();
        if !turned.contains(&true) {
            return Some(self.sided(self.mesh.clone()));
        }
        let all = self.mesh.triangles().iter().zip(&self.search.part);
        let triangles = all.map(|(&[a, b, c], &part)| match turned[part as usize] {
            true => [a, c, b],
            false => [a, b, c],
        });
        let building = MeshBuilding::new(self.mesh.positions().to_vec(), triangles.collect());
        self.phase = SidingPhase::Build(Box::new(building));
        None
    }

    fn sided(&self, mesh: Arc<TriMesh>) -> Sided {
        let wrong = self.parts.iter().filter(|part| part.is_wrong());
        let wrong: usize = wrong.map(|part| part.triangles).sum();
        let all = |sum: fn(&PartSums) -> f64| self.parts.iter().map(sum).sum::<f64>();
        let code = match self.sides {
            Sides::Given => Some(Code::ModelFacesIn),
            Sides::Guessed => Some(Code::MendedSides),
            Sides::Other => None,
        };
        Sided {
            mesh,
            is_open: self.parts.iter().any(|part| part.is_open),
            slenderness: 2.0 * all(|part| part.squares) / all(|part| part.area),
            largest: 0.5 * self.parts.iter().map(|part| part.area).fold(0.0, f64::max),
            notice: code
                .filter(|_| wrong > 0)
                .map(|code| Notice::new(code).with("n", wrong)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{samples, testing};
    use super::*;

    fn sided(mesh: &Arc<TriMesh>, sides: Sides) -> Sided {
        let mut siding = Siding::new(mesh.clone(), sides);
        loop {
            if let Some(sided) = siding.advance() {
                return sided;
            }
        }
    }

    fn turned(mesh: &TriMesh) -> Arc<TriMesh> {
        let triangles = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]);
        Arc::new(TriMesh::new(mesh.positions().to_vec(), triangles.collect()).unwrap())
    }

    #[test]
    fn a_sheet_that_faces_down_is_turned_up_once() {
        let up = Arc::new(samples::hill(8));
        let down = turned(&up);
        let guessed = sided(&down, Sides::Guessed);
        assert_eq!(guessed.mesh.triangles(), up.triangles());
        assert_eq!(guessed.notice.map(|n| n.code), Some(Code::MendedSides));
        let again = sided(&guessed.mesh, Sides::Guessed);
        assert!(Arc::ptr_eq(&again.mesh, &guessed.mesh));
        assert!(again.notice.is_none() && again.is_open);
    }

    #[test]
    fn the_largest_part_is_measured() {
        let two = Arc::new(testing::mesh(testing::cubes(
            &[[0; 3], [4, 0, 0], [4, 0, 1]],
            2,
        )));
        let largest = sided(&two, Sides::Guessed).largest;
        assert!((largest - 10.0).abs() < 1e-12, "{largest}");
    }

    #[test]
    fn needles_are_slender_and_other_triangles_are_not() {
        let slenderness = |soup| sided(&Arc::new(testing::mesh(soup)), Sides::Guessed).slenderness;
        for soup in [
            testing::ball(4),
            testing::flat(30),
            testing::torus(90, 40, 0.4),
        ] {
            let few = slenderness(soup);
            assert!((6.9..12.0).contains(&few), "{few}");
        }
        let [some, many] = [1000, 4000].map(|rim| slenderness(testing::disc(rim)));
        assert!(
            some > 600.0 && (3.9..4.1).contains(&(many / some)),
            "{some} {many}"
        );
    }

    #[test]
    fn a_tube_faces_outwards() {
        let tube = Arc::new(samples::cylinder(16, 8));
        let inside = turned(&tube);
        assert!(Arc::ptr_eq(&sided(&tube, Sides::Guessed).mesh, &tube));
        let outside = sided(&inside, Sides::Guessed).mesh;
        assert_eq!(outside.triangles(), tube.triangles());
        // Far from the origin, too.
        let far = tube.positions().iter().map(|&p| p + DVec3::splat(1e4));
        let far = TriMesh::new(far.collect(), inside.triangles().to_vec()).unwrap();
        let outside = sided(&Arc::new(far), Sides::Guessed).mesh;
        assert_eq!(outside.triangles(), tube.triangles());
    }

    #[test]
    fn the_other_side_is_the_other_one_whatever_the_file_says() {
        let up = Arc::new(samples::hill(8));
        let down = turned(&up);
        for given in [&up, &down] {
            let other = sided(given, Sides::Other);
            assert_eq!(other.mesh.triangles(), down.triangles());
            assert!(other.notice.is_none());
        }
    }

    #[test]
    fn as_the_file_says_turns_nothing_but_remarks_on_it() {
        let down = turned(&samples::hill(8));
        let given = sided(&down, Sides::Given);
        assert!(Arc::ptr_eq(&given.mesh, &down));
        assert_eq!(given.notice.map(|n| n.code), Some(Code::ModelFacesIn));
    }

    #[test]
    fn closed_parts_keep_their_outside() {
        let torus = Arc::new(samples::torus(24, 10));
        for sides in [Sides::Given, Sides::Guessed, Sides::Other] {
            let sided = sided(&torus, sides);
            assert!(Arc::ptr_eq(&sided.mesh, &torus));
            assert!(!sided.is_open && sided.notice.is_none());
        }
    }
}
