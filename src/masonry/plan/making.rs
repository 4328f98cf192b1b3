//! Makes the plan of a building.

use super::face_grid::{
    FaceGrid, WallColumns, edges, fixed_lines, joints, place, plain, through_rows,
};
use super::fault::{PlanFault, PlanWarning};
use super::lines::{CourseMark, Courses, divided};
use super::parity::{Change, PhaseEdge, PhasePlan, repair};
use crate::building::{Bend, Building, EdgeId, Face, FaceId, Module, Stance, Surface, labels};

use crate::masonry::module;
use std::collections::BTreeMap;

/// The cosine within which the direction of a wall is upwards.
const UPRIGHT: f64 = 0.999;
/// Ratios of columns and modules beyond this give a warning.
const RATIOS: std::ops::RangeInclusive<f64> = 0.8..=1.25;

/// The plan of a building: what several features must agree on before the first cell is laid.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The module.
    pub module: Module,
    /// The grid of each face.
    pub grids: Vec<FaceGrid>,
    /// For each face the first of those walls that must be shifted by a column together with it.
    pub phase_sets: Vec<FaceId>,
    /// The edges at which bricks do not alternate.
    pub conflicts: Vec<EdgeId>,
    /// The changes of columns that have removed conflicts; walls are numbered as faces.
    pub changes: Vec<Change>,
    /// Warnings about what may look wrong.
    pub warnings: Vec<PlanWarning>,
}

/// Whether a face is a wall: its t is the height above a level.
pub fn is_wall(face: &Face) -> bool {
    match &face.surface {
        Surface::Sweep(sweep) => face.stance() == Stance::Upright && sweep.direction().y > UPRIGHT,
        Surface::Disk(_) => false,
    }
}

/// Whether an edge belongs to a window, a door or an arch.
pub(super) fn is_of_opening(building: &Building, edge: EdgeId) -> bool {
    const OPENINGS: [&str; 4] = [labels::WINDOW, labels::DOOR, labels::ARCH, labels::SILL];
    let labels = &building.edge(edge).labels;
    labels
        .iter()
        .any(|label| OPENINGS.contains(&label.as_str()))
}

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
        building: &Building,
        module: Module,
        depth: impl Fn(FaceId) -> f64,
    ) -> Result<Self, PlanFault> {
        module::check(&module).map_err(PlanFault::Module)?;
        let thin = building
            .fits(&module, |face| 2.0 * depth(face))
            .map_err(PlanFault::Misfit)?;
        let mut making = PlanMaking::new(building, module);
        making
            .warnings
            .extend(thin.into_iter().map(PlanWarning::Thin));
        making.find_courses();
        let (changes, phases) = making.find_phases();
        making.tell_columns();
        Ok(making.finish(changes, &phases, depth))
    }

    /// The grid of a face.
    pub fn grid(&self, face: FaceId) -> &FaceGrid {
        &self.grids[face.index()]
    }
}

struct PlanMaking<'a> {
    building: &'a Building,
    module: Module,
    /// The fixed lines of each face, along s and along t.
    fixed: Vec<[Vec<f64>; 2]>,
    /// For each wall the first wall that it hangs together with.
    groups: Vec<FaceId>,
    /// The columns of each face; those of walls count.
    columns: Vec<WallColumns>,
    courses: BTreeMap<FaceId, Courses>,
    warnings: Vec<PlanWarning>,
}

impl<'a> PlanMaking<'a> {
    fn new(building: &'a Building, module: Module) -> Self {
        let fixed: Vec<[Vec<f64>; 2]> = building
            .face_ids()
            .map(|id| fixed_lines(building, id))
            .collect();
        let columns = building.faces().iter().zip(&fixed);
        Self {
            building,
            module,
            columns: columns
                .map(|(face, fixed)| WallColumns::new(face, fixed[0].clone(), &module))
                .collect(),
            groups: groups(building),
            fixed,
            courses: BTreeMap::new(),
            warnings: Vec::new(),
        }
    }

    /// The walls of each group, by its first wall.
    fn walls(&self) -> BTreeMap<FaceId, Vec<FaceId>> {
        let mut walls: BTreeMap<FaceId, Vec<FaceId>> = BTreeMap::new();
        for id in self
            .building
            .face_ids()
            .filter(|&id| is_wall(self.building.face(id)))
        {
            walls.entry(self.groups[id.index()]).or_default().push(id);
        }
        walls
    }

    fn find_courses(&mut self) {
        for (face, walls) in self.walls() {
            let marks: Vec<CourseMark> = walls.iter().flat_map(|&wall| self.marks(wall)).collect();
            let courses = Courses::new(&marks, self.module.course);
            let told = courses
                .warnings
                .iter()
                .map(|&what| PlanWarning::Courses { face, what });
            self.warnings.extend(told);
            self.courses.insert(face, courses);
        }
    }

    /// The heights of a wall's corners, springings and bounds. Those at an opening are marked so.
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
            let is_opening = is_of_opening(self.building, edge);
            let places = joints(self.building, edge).into_iter();
            marks.extend(places.map(|(p, is_springing)| CourseMark {
                y: p.y,
                is_opening: is_opening || is_springing,
            }));
        }
        marks
    }

    /// Solves the phases of walls; the columns that this changes are changed in `columns`.
    fn find_phases(&mut self) -> (Vec<Change>, PhasePlan) {
        let edges: Vec<PhaseEdge> = self
            .building
            .edge_ids()
            .filter_map(|id| self.phase_edge(id))
            .collect();
        let mut columns: Vec<_> = self
            .columns
            .iter()
            .map(|wall| wall.columns.clone())
            .collect();
        let found = repair(&mut columns, &edges, self.module.half);
        for (wall, columns) in self.columns.iter_mut().zip(columns) {
            wall.columns = columns;
        }
        found
    }

    /// An edge at which the bricks of two walls must alternate.
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

    fn finish(
        mut self,
        changes: Vec<Change>,
        phases: &PhasePlan,
        depth: impl Fn(FaceId) -> f64,
    ) -> Plan {
        let grids = self
            .building
            .face_ids()
            .map(|id| self.grid(id, phases, depth(id)))
            .collect();
        let conflicts: Vec<EdgeId> = phases.conflicts.iter().map(|&edge| EdgeId(edge)).collect();
        self.warnings
            .extend(conflicts.iter().map(|&edge| PlanWarning::Conflict(edge)));
        Plan {
            module: self.module,
            grids,
            phase_sets: phases.roots.iter().map(|&root| FaceId(root)).collect(),
            conflicts,
            changes,
            warnings: self.warnings,
        }
    }

    fn grid(&self, id: FaceId, phases: &PhasePlan, depth: f64) -> FaceGrid {
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
            depth,
        }
    }

    /// The row lines of a wall: the courses of its group within its bounds. Also the number of the first one.
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

    /// The course lines of a wall beside a reveal.
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

/// For each wall the first of the walls that vertical edges join it to.
fn groups(building: &Building) -> Vec<FaceId> {
    let mut firsts: Vec<FaceId> = building.face_ids().collect();
    let root = |firsts: &[FaceId], mut id: FaceId| {
        while firsts[id.index()] != id {
            id = firsts[id.index()];
        }
        id
    };
    for edge in building.edges().iter().filter(|edge| edge.is_vertical()) {
        let [Some(a), Some(b)] = edge.faces else {
            continue;
        };
        if is_wall(building.face(a)) && is_wall(building.face(b)) {
            let [a, b] = [a, b].map(|id| root(&firsts, id));
            firsts[a.max(b).index()] = a.min(b);
        }
    }
    building.face_ids().map(|id| root(&firsts, id)).collect()
}
