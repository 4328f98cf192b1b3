//! The grid of a face: its column lines and its row lines.

use super::lines::{divided, merged, pieces};
use super::parity::Columns;
use crate::building::{Building, Edge, EdgeId, Face, FaceId, FaceSurface, Module, Piece, Stance};

use crate::masonry::region::Region;
use glam::{DVec2, DVec3};

/// How far apart two lines or places may be and still count as one (metres).
pub(super) const NEAR: f64 = 1e-3;

/// How far the line of a gable's top is from other lines at least, in columns.
const TOO_NEAR: f64 = 0.5;

/// The direction of a wall is upwards if the cosine of its angle to the y axis is above this.
const UPRIGHT: f64 = 0.999;

/// The grid of a face. Rows are courses of bricks; columns divide them into pieces of half a brick.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceGrid {
    /// The stance of the face, which decides whether rows run along s or t.
    pub stance: Stance,
    /// The lines of s (metres), rising.
    pub s: Vec<f64>,
    /// The lines of t (metres), rising.
    pub t: Vec<f64>,
    /// The number of row 0 among the courses that the walls of a group share; 0 on other faces.
    pub first_course: usize,
    /// In row k a brick starts at column c if c + k + `first_course` + `phase` is even.
    pub phase: bool,
    /// How deep cells of the face may reach into the wall (metres).
    pub depth: f64,
}

impl FaceGrid {
    /// Whether rows are intervals of s. Else they are intervals of t.
    pub fn are_rows_along_s(&self) -> bool {
        self.stance == Stance::Through
    }

    /// The lines between columns.
    pub fn column_lines(&self) -> &[f64] {
        if self.are_rows_along_s() {
            &self.t
        } else {
            &self.s
        }
    }

    /// The lines between rows.
    pub fn row_lines(&self) -> &[f64] {
        if self.are_rows_along_s() {
            &self.s
        } else {
            &self.t
        }
    }

    /// The rectangle of columns `from..to` in rows `low..high`, as its least and greatest (s, t).
    pub fn block(&self, [from, to]: [usize; 2], [low, high]: [usize; 2]) -> [DVec2; 2] {
        let (columns, rows) = (self.column_lines(), self.row_lines());
        let corners = [[columns[from], rows[low]], [columns[to], rows[high]]];
        corners.map(|[column, row]| {
            if self.are_rows_along_s() {
                DVec2::new(row, column)
            } else {
                DVec2::new(column, row)
            }
        })
    }

    /// Whether a brick starts at a column of a row.
    pub fn starts(&self, column: isize, row: usize) -> bool {
        (column + (row + self.first_course + usize::from(self.phase)) as isize).rem_euclid(2) == 0
    }

    /// The number of the line nearest to a value; the lower one if two are equally near.
    pub fn line_at(lines: &[f64], value: f64) -> usize {
        let above = lines.partition_point(|&line| line < value);
        let below = above.saturating_sub(1);
        let is_nearer = above < lines.len() && lines[above] - value < value - lines[below];
        if is_nearer { above } else { below }
    }

    /// How far `count` columns reach from the place `from`: to higher values if `way` is above 0, else to lower ones
    /// (metres). The reach ends at the outermost line.
    pub fn reach(lines: &[f64], from: f64, way: f64, count: usize) -> f64 {
        let at = Self::line_at(lines, from);
        let to = if way > 0.0 {
            (at + count).min(lines.len() - 1)
        } else {
            at.saturating_sub(count)
        };
        (lines[to] - from).abs()
    }
}

/// Whether a face is a wall: its t is the height above a level.
pub fn is_wall(face: &Face) -> bool {
    match &face.surface {
        FaceSurface::Sweep(sweep) => {
            face.stance() == Stance::Upright && sweep.direction().y > UPRIGHT
        }
        FaceSurface::Disk(_) => false,
    }
}

/// The region of a face.
pub fn region(face: &Face) -> Region {
    Region {
        loops: face.rings.clone(),
    }
}

/// The (s, t) of a point on a face. On a whole cylinder, s lies in the period that the face's rings cover.
pub(super) fn place(face: &Face, p: DVec3) -> DVec2 {
    let place = face.surface.project(p).truncate();
    let [low, high] = face.bounds();
    match face.surface.period() {
        None => place,
        Some(period) => {
            let s = low.x + (place.x - low.x).rem_euclid(period);
            // A point at the seam gets the lower end of the period.
            DVec2::new(if high.x - s < NEAR { low.x } else { s }, place.y)
        }
    }
}

/// The ends and joints of an edge, each with whether it is a springing: a place between a line and an arc.
pub(super) fn joints(building: &Building, edge: EdgeId) -> Vec<(DVec3, bool)> {
    let edge = building.edge(edge);
    if edge.is_closed() {
        return Vec::new();
    }
    let all = edge.path.joints();
    let last = all.len() - 1;
    let places = all.iter().enumerate();
    places
        .map(|(k, &at)| (edge.path.point(at), k > 0 && k < last))
        .collect()
}

/// The edges of a face, each once.
pub(super) fn edges(face: &Face) -> impl Iterator<Item = EdgeId> + '_ {
    face.loops.iter().flatten().map(|walk| walk.edge)
}

/// The fixed lines of a face along s and along t: the places of its corners and joints, and its bounds. `half` is the
/// width of a column (metres). On walls, the line of a gable's top gives way to a line that it would be too near to.
pub(super) fn fixed_lines(building: &Building, id: FaceId, half: f64) -> [Vec<f64>; 2] {
    let face = building.face(id);
    let [low, high] = face.bounds();
    let (mut s, mut t, mut tops) = (Vec::new(), Vec::new(), Vec::new());
    for id in edges(face) {
        let is_top = is_wall(face) && is_plain_slope(building.edge(id));
        for (p, _) in joints(building, id) {
            let place = place(face, p);
            if is_top { &mut tops } else { &mut s }.push(place.x);
            t.push(place.y);
        }
    }
    let firm = s.clone();
    let is_far = |top: &f64| {
        firm.iter()
            .all(|line| (line - top).abs() >= TOO_NEAR * half)
    };
    s.extend(tops.into_iter().filter(is_far));
    let ends = match face.surface.period() {
        // A seam is no line of the grid: lines begin at a corner, if there is one.
        Some(period) => {
            let first = s.iter().copied().reduce(f64::min).unwrap_or(low.x);
            [first, first + period]
        }
        None => [low.x, high.x],
    };
    [within(s, ends), within(t, [low.y, high.y])]
}

/// Whether an edge is one straight piece that neither stands upright nor lies level.
fn is_plain_slope(edge: &Edge) -> bool {
    let [Piece::Line { from, to }] = edge.path.pieces() else {
        return false;
    };
    let way = (*to - *from).abs();
    way.y > NEAR && way.x.max(way.z) > NEAR
}

/// Sorted lines within bounds. The bounds win over lines near to them.
fn within(lines: Vec<f64>, [low, high]: [f64; 2]) -> Vec<f64> {
    let inner = lines
        .into_iter()
        .filter(|&line| line - low > NEAR && high - line > NEAR);
    merged([low, high].into_iter().chain(inner).collect())
}

/// The fixed lines with equal pieces of about `size` between them (metres): the lines of faces that are no walls.
pub(super) fn plain(fixed: &[f64], size: f64) -> Vec<f64> {
    let counts: Vec<usize> = fixed
        .windows(2)
        .map(|w| pieces(w[1] - w[0], size))
        .collect();
    divided(fixed, &counts)
}

/// The rows of a reveal along its profile. On straight parts that stand upright, joints follow the courses of the wall
/// beside it; arcs get voussoirs of about a course.
pub(super) fn through_rows(
    face: &Face,
    fixed: &[f64],
    courses: &[f64],
    module: &Module,
) -> Vec<f64> {
    let mut lines = fixed.to_vec();
    if let FaceSurface::Sweep(sweep) = &face.surface {
        let profile = sweep.profile();
        let starts = profile.joints();
        for (piece, ends) in profile.pieces().iter().zip(starts.windows(2)) {
            lines.extend_from_slice(ends);
            match piece {
                Piece::Arc(_) => lines.extend(plain(ends, module.course)),
                Piece::Line { from, to } if (to.y - from.y).abs() > 0.9 * from.distance(*to) => {
                    let at =
                        |y: f64| ends[0] + (y - from.y) / (to.y - from.y) * (ends[1] - ends[0]);
                    lines.extend(
                        courses
                            .iter()
                            .map(|&y| at(y))
                            .filter(|s| (ends[0]..ends[1]).contains(s)),
                    );
                }
                Piece::Line { .. } => lines.extend(plain(ends, module.half)),
            }
        }
    }
    let bounds = [fixed[0], fixed[fixed.len() - 1]];
    let mut lines = within(lines, bounds);
    lines.dedup_by(|next, kept| *next - *kept < NEAR);
    lines
}

/// The columns of a wall, and the fixed lines of s between which they lie (metres).
#[derive(Clone, Debug)]
pub(super) struct WallColumns {
    pub fixed: Vec<f64>,
    pub columns: Columns,
}

impl WallColumns {
    pub fn new(face: &Face, fixed: Vec<f64>, module: &Module) -> Self {
        let widths: Vec<f64> = fixed.windows(2).map(|w| w[1] - w[0]).collect();
        Self {
            columns: Columns::new(&widths, module.half, face.surface.period().is_some()),
            fixed,
        }
    }

    /// The number of the fixed line at a value of s.
    pub fn line(&self, s: f64) -> u32 {
        FaceGrid::line_at(&self.fixed, s) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> FaceGrid {
        FaceGrid {
            stance: Stance::Upright,
            s: vec![0.0, 0.125, 0.25, 0.375, 0.5],
            t: vec![0.0, 0.1, 0.2],
            first_course: 3,
            phase: false,
            depth: 0.125,
        }
    }

    #[test]
    fn reaches_end_at_lines_and_at_the_face() {
        let grid = grid();
        assert_eq!(FaceGrid::reach(&grid.s, 0.0, 1.0, 2), 0.25);
        assert_eq!(FaceGrid::reach(&grid.s, 0.5, -1.0, 1), 0.125);
        assert_eq!(FaceGrid::reach(&grid.s, 0.375, 1.0, 4), 0.125);
        assert_eq!(
            [0.0, 0.06, 0.07, 0.49, 9.0].map(|v| FaceGrid::line_at(&grid.s, v)),
            [0, 0, 1, 4, 4]
        );
    }

    #[test]
    fn rows_of_reveals_run_along_s() {
        let upright = grid();
        let through = FaceGrid {
            stance: Stance::Through,
            ..grid()
        };
        assert_eq!(
            upright.block([1, 3], [0, 1]),
            [DVec2::new(0.125, 0.0), DVec2::new(0.375, 0.1)]
        );
        assert_eq!(
            through.block([0, 1], [1, 3]),
            [DVec2::new(0.125, 0.0), DVec2::new(0.375, 0.1)]
        );
        // Bricks start at every other column, shifted by one in the next row.
        assert!(upright.starts(1, 0) && !upright.starts(2, 0) && upright.starts(2, 1));
    }
}
