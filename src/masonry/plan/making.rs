//! Makes the plan of a building.

use super::face_grid::{
    FaceGrid, WallColumns, edges, fixed_lines, is_wall, joints, place, plain, through_rows,
};
use super::fault::{PlanFault, PlanWarning};
use super::groups::groups;
use super::lines::{CourseMark, Courses, divided};
use super::parity::{Columns, PhaseEdge, PhasePlan};
use super::repair::{Change, RepairWork};
use super::whole::{Plan, is_of_opening};
use crate::building::{Bend, Building, EdgeId, Face, FaceId, Module, Stance};
use crate::masonry::module;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The width of columns, over that of their modules, gives a warning outside this range.
const RATIOS: std::ops::RangeInclusive<f64> = 0.8..=1.25;
/// Faces or edges in a slice of the work.
const SLICE: usize = 64;

/// The height at which t of a wall is 0 (metres).
fn base(face: &Face) -> f64 {
    face.surface.frame(face.bounds()[0].x, 0.0).origin.y
}

impl Plan {
    /// The plan of a building. `depth` gives how deep cells of each face may reach: half of
    /// the wall's thickness (metres).
    ///
    /// # Errors
    /// If the module does not suit the building.
    pub fn new(
        building: &Arc<Building>,
        module: Module,
        depth: impl Fn(FaceId) -> f64,
    ) -> Result<Self, PlanFault> {
        let depths = building.face_ids().map(depth).collect();
        let mut making = PlanMaking::new(building.clone(), module, depths);
        loop {
            if let Some(plan) = making.advance()? {
                return Ok(plan);
            }
        }
    }
}

/// A plan that is made in slices.
pub struct PlanMaking {
    building: Arc<Building>,
    module: Module,
    /// How deep cells of each face may reach (metres).
    depths: Vec<f64>,
    /// The fixed lines of each face, along s and along t.
    fixed: Vec<[Vec<f64>; 2]>,
    /// For each wall the first wall of its group; for other faces the face itself.
    groups: Vec<FaceId>,
    /// The columns of each face; only those of walls are used.
    columns: Vec<WallColumns>,
    /// The heights that courses should meet, for each group of walls by its first wall.
    marks: BTreeMap<FaceId, Vec<CourseMark>>,
    courses: BTreeMap<FaceId, Courses>,
    warnings: Vec<PlanWarning>,
    step: PlanStep,
}

/// The progress of the work.
#[derive(Default)]
enum PlanStep {
    #[default]
    Begun,
    Checked,
    /// The lines and the heights of faces are collected.
    Lines,
    /// The courses of groups are found, the first group first.
    Courses,
    /// The edges at which bricks alternate are collected, up to this edge.
    Edges(Vec<PhaseEdge>, usize),
    /// Conflicts are mended by changes of these columns.
    Conflicts(RepairWork, Vec<Columns>),
    /// The grids of faces are made.
    Grids(Vec<FaceGrid>, Vec<Change>, PhasePlan),
}

impl PlanMaking {
    /// Begins. `depths` are how deep cells of each face may reach: half of the wall's thickness (metres).
    pub fn new(building: Arc<Building>, module: Module, depths: Vec<f64>) -> Self {
        Self {
            building,
            module,
            depths,
            fixed: Vec::new(),
            groups: Vec::new(),
            columns: Vec::new(),
            marks: BTreeMap::new(),
            courses: BTreeMap::new(),
            warnings: Vec::new(),
            step: PlanStep::Begun,
        }
    }

    /// Does a slice of the work. Returns the plan at the end.
    ///
    /// # Errors
    /// If the module does not suit the building.
    pub fn advance(&mut self) -> Result<Option<Plan>, PlanFault> {
        self.step = match std::mem::take(&mut self.step) {
            PlanStep::Begun => {
                self.check()?;
                PlanStep::Checked
            }
            PlanStep::Checked => {
                self.groups = groups(&self.building);
                PlanStep::Lines
            }
            PlanStep::Lines => self.find_lines(),
            PlanStep::Courses => self.find_courses(),
            PlanStep::Edges(edges, from) => self.find_edges(edges, from),
            PlanStep::Conflicts(mut work, mut columns) => match work.advance(&mut columns) {
                Some((changes, phases)) => self.mended(columns, changes, phases),
                None => PlanStep::Conflicts(work, columns),
            },
            PlanStep::Grids(grids, changes, phases) if grids.len() == self.fixed.len() => {
                return Ok(Some(self.finish(grids, changes, &phases)));
            }
            PlanStep::Grids(mut grids, changes, phases) => {
                let ids = self.building.face_ids().skip(grids.len()).take(SLICE);
                grids.extend(ids.map(|id| self.grid(id, &phases)));
                PlanStep::Grids(grids, changes, phases)
            }
        };
        Ok(None)
    }

    /// Checks whether the module suits the building.
    fn check(&mut self) -> Result<(), PlanFault> {
        module::check(&self.module).map_err(PlanFault::Module)?;
        let thickness = |face: FaceId| 2.0 * self.depths[face.index()];
        let thin = self.building.fits(&self.module, thickness);
        let thin = thin.map_err(PlanFault::Misfit)?.into_iter();
        self.warnings.extend(thin.map(PlanWarning::Thin));
        Ok(())
    }

    /// Finds the fixed lines of some faces, and the heights of those that are walls.
    fn find_lines(&mut self) -> PlanStep {
        let building = self.building.clone();
        for id in building.face_ids().skip(self.fixed.len()).take(SLICE) {
            let (face, fixed) = (
                building.face(id),
                fixed_lines(&building, id, self.module.half),
            );
            let columns = WallColumns::new(face, fixed[0].clone(), &self.module);
            self.columns.push(columns);
            self.fixed.push(fixed);
            if is_wall(face) {
                let marks = self.marks(id);
                let group = self.groups[id.index()];
                self.marks.entry(group).or_default().extend(marks);
            }
        }
        match self.fixed.len() < building.faces().len() {
            true => PlanStep::Lines,
            false => PlanStep::Courses,
        }
    }

    /// Finds the courses of a group of walls.
    fn find_courses(&mut self) -> PlanStep {
        let Some((face, marks)) = self.marks.pop_first() else {
            return PlanStep::Edges(Vec::new(), 0);
        };
        let courses = Courses::new(&marks, self.module.course);
        let told = courses
            .warnings
            .iter()
            .map(|&what| PlanWarning::Courses { face, what });
        self.warnings.extend(told);
        self.courses.insert(face, courses);
        PlanStep::Courses
    }

    /// The heights of a wall's corners, springings and bounds, each with whether it belongs to an opening.
    fn marks(&self, wall: FaceId) -> Vec<CourseMark> {
        let face = self.building.face(wall);
        let [low, high] = face.bounds().map(|place| base(face) + place.y);
        let mut marks = vec![
            CourseMark {
                y: low,
                is_opening: false,
            },
            CourseMark {
                y: high,
                is_opening: false,
            },
        ];
        for edge in edges(face) {
            let is_opening = is_of_opening(&self.building, edge);
            let places = joints(&self.building, edge).into_iter();
            marks.extend(places.map(|(p, is_springing)| CourseMark {
                y: p.y,
                is_opening: is_opening || is_springing,
            }));
        }
        marks
    }

    /// Collects some edges at which the bricks of two walls must alternate.
    fn find_edges(&self, mut edges: Vec<PhaseEdge>, from: usize) -> PlanStep {
        let ids = self.building.edge_ids().skip(from).take(SLICE);
        edges.extend(ids.filter_map(|id| self.phase_edge(id)));
        if from + SLICE < self.building.edges().len() {
            return PlanStep::Edges(edges, from + SLICE);
        }
        let columns = self.columns.iter().map(|wall| wall.columns.clone());
        let columns: Vec<Columns> = columns.collect();
        let work = RepairWork::new(&columns, edges, self.module.half);
        PlanStep::Conflicts(work, columns)
    }

    /// Takes over the columns that have been changed, and the phases.
    fn mended(
        &mut self,
        columns: Vec<Columns>,
        changes: Vec<Change>,
        phases: PhasePlan,
    ) -> PlanStep {
        for (wall, columns) in self.columns.iter_mut().zip(columns) {
            wall.columns = columns;
        }
        self.tell_columns();
        PlanStep::Grids(Vec::new(), changes, phases)
    }

    /// An edge at which the bricks of two walls must alternate; none if they need not.
    fn phase_edge(&self, id: EdgeId) -> Option<PhaseEdge> {
        let edge = self.building.edge(id);
        let walls = [edge.faces[0]?, edge.faces[1]?];
        let is_bent = matches!(edge.bend, Bend::Convex | Bend::Concave);
        let are_walls = walls.iter().all(|&wall| is_wall(self.building.face(wall)));
        if !(edge.is_vertical() && is_bent && are_walls && walls[0] != walls[1]) {
            return None;
        }
        let lines = walls.map(|wall| {
            let s = place(self.building.face(wall), edge.path.point(0.0)).x;
            self.columns[wall.index()].line(s)
        });
        Some(PhaseEdge {
            edge: id.0,
            walls: walls.map(|wall| wall.0),
            lines,
        })
    }

    fn tell_columns(&mut self) {
        for id in self
            .building
            .face_ids()
            .filter(|&id| is_wall(self.building.face(id)))
        {
            let WallColumns { fixed, columns } = &self.columns[id.index()];
            for ((ends, &count), width) in
                fixed.windows(2).zip(&columns.counts).zip(&columns.widths)
            {
                let ratio = width / (count as f64 * self.module.half);
                if !RATIOS.contains(&ratio) {
                    let ends = [ends[0], ends[1]];
                    self.warnings.push(PlanWarning::Columns {
                        face: id,
                        ends,
                        ratio,
                    });
                }
            }
        }
    }

    fn finish(&mut self, grids: Vec<FaceGrid>, changes: Vec<Change>, phases: &PhasePlan) -> Plan {
        let conflicts: Vec<EdgeId> = phases.conflicts.iter().map(|&edge| EdgeId(edge)).collect();
        self.warnings
            .extend(conflicts.iter().map(|&edge| PlanWarning::Conflict(edge)));
        Plan {
            module: self.module,
            grids,
            phase_sets: phases.roots.iter().map(|&root| FaceId(root)).collect(),
            conflicts,
            changes,
            warnings: std::mem::take(&mut self.warnings),
        }
    }

    fn grid(&self, id: FaceId, phases: &PhasePlan) -> FaceGrid {
        let face = self.building.face(id);
        let [fixed_s, fixed_t] = &self.fixed[id.index()];
        let width = self.module.half;
        let (mut first_course, mut phase) = (0, false);
        let (s, t) = match face.stance() {
            _ if is_wall(face) => {
                let wall = &self.columns[id.index()];
                phase = phases.phases[id.index()];
                let (rows, first) = self.wall_rows(id);
                first_course = first;
                (divided(&wall.fixed, &wall.columns.counts), rows)
            }
            Stance::Upright => (plain(fixed_s, width), plain(fixed_t, self.module.course)),
            Stance::Level => (plain(fixed_s, width), plain(fixed_t, width)),
            Stance::Through => {
                let beside = self.courses_beside(face);
                (
                    through_rows(face, fixed_s, beside, &self.module),
                    plain(fixed_t, width),
                )
            }
        };
        FaceGrid {
            stance: face.stance(),
            s,
            t,
            first_course,
            phase,
            depth: self.depths[id.index()],
        }
    }

    /// The row lines of a wall along t: the courses of its group within its bounds. Also the number of the first
    /// course.
    fn wall_rows(&self, id: FaceId) -> (Vec<f64>, usize) {
        let face = self.building.face(id);
        let [low, high] = face.bounds().map(|place| place.y);
        let courses = &self.courses[&self.groups[id.index()]];
        let lines = courses.lines.iter().map(|y| y - base(face));
        let inner: Vec<f64> = lines
            .filter(|t| t - low > 1e-4 && high - t > 1e-4)
            .collect();
        let rows = [vec![low], inner, vec![high]].concat();
        (rows, courses.course(low + base(face)))
    }

    /// The course lines (heights, metres) of the first wall beside a reveal; empty if there is none.
    fn courses_beside(&self, face: &Face) -> &[f64] {
        let others = edges(face)
            .flat_map(|edge| self.building.edge(edge).faces)
            .flatten();
        let walls = others.filter(|&other| is_wall(self.building.face(other)));
        let mut groups = walls.map(|wall| self.groups[wall.index()]);
        groups
            .next()
            .map_or(&[], |group| &self.courses[&group].lines)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::building::Rule;

    /// Each slice looks at some faces, at some edges or at one group of walls.
    #[test]
    fn plans_are_made_in_short_slices() {
        let draft = Rule::LHouse.draft(&Module::NORMAL, &[]);
        let building = Arc::new(Building::new(&draft).expect("a building"));
        let depths = vec![f64::INFINITY; building.faces().len()];
        let mut making = PlanMaking::new(building.clone(), Module::NORMAL, depths);
        let mut slices = 1;
        while making.advance().expect("a plan").is_none() {
            slices += 1;
        }
        let groups = making.courses.len();
        let faces = building.faces().len().div_ceil(SLICE);
        let edges = building.edges().len().div_ceil(SLICE);
        assert!(faces > 1 && edges > 2, "{faces} {edges}");
        assert!(slices > 2 * faces + edges + groups, "{slices} slices");
    }
}
