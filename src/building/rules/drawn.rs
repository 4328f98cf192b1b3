//! Walls over a plan that a visitor has drawn: its corners and openings, their limits and faults.

use super::drafting::Drafting;
use super::drawn_fault::{
    DrawnFault, FARTHEST_CORNER, LEAST_OVER, LEAST_PIER, OpeningFault, SHARPEST,
};
use super::openings::{Opening, OpeningHead};
use super::plan_line::PlanLine;
use super::wall_line::WallLine;
use super::{Module, Rule};
use crate::building::draft::Draft;
use crate::domain::{Contact, first_contact};
use glam::DVec2;

/// Walls that do not meet keep so far apart, in modules.
const APART: f64 = 1.0;

/// The least and the greatest value of each number of an opening, except that of its wall, which is the first.
const RANGES: [[i64; 2]; 5] = [[0, 240], [0, 60], [2, 24], [4, 60], [0, 2]];

/// The rule's own plan, used if none is drawn: the walls of a garden with two cut corners, open towards the viewer.
const PLAN: [[i64; 2]; 6] = [[0, 40], [0, 8], [8, 0], [40, 0], [48, 8], [48, 30]];
/// The openings of the walls over [`PLAN`].
const OPENINGS: [[i64; 6]; 4] = [
    [1, 12, 9, 6, 8, 0],
    [3, 12, 0, 8, 13, 2],
    [5, 4, 9, 5, 8, 0],
    [5, 13, 9, 5, 8, 0],
];

/// Walls over a plan, as whole numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnPlan {
    /// The corners of a line, x to the right and y to the front, in modules. The walls stand to the left of it. It is
    /// closed if the last corner is the first one. Without corners, a plan of the rule's own stands.
    pub corners: Vec<[i64; 2]>,
    /// Each opening has the number of its wall (from 1), the distance along the wall at which it begins (modules), the
    /// height of its sill (courses; 0 for a gate), its width (modules), its height up to the head (courses), and its
    /// head: 0 straight, 1 segmental, 2 round.
    pub openings: Vec<[i64; 6]>,
}

/// A checked line, whose walls join drawn walls that go on straight. `parts` has for each drawn wall the wall of the
/// line that it belongs to, and where it begins there (modules).
struct CheckedLine {
    line: PlanLine,
    parts: Vec<(usize, i64)>,
}

/// An opening in a wall of a checked line. Its number is that of its row, from 1.
struct PlacedOpening {
    number: usize,
    wall: usize,
    opening: Opening,
}

impl DrawnPlan {
    /// The plan of rows as links hold them.
    pub fn of_rows(plan: &[Vec<i64>], openings: &[Vec<i64>]) -> Self {
        let corners = plan.iter().flat_map(|row| row.chunks_exact(2));
        let openings = openings.iter();
        Self {
            corners: corners.map(|pair| [pair[0], pair[1]]).collect(),
            openings: openings.filter_map(|row| row[..].try_into().ok()).collect(),
        }
    }

    /// The building, and the faults of the plan. `numbers` are those of [`Rule::Plan`].
    pub fn draft(&self, module: &Module, numbers: &[f64]) -> (Draft, Vec<DrawnFault>) {
        let n = Rule::Plan.fitted(numbers);
        let mut faults = Vec::new();
        let own = Self {
            corners: PLAN.to_vec(),
            openings: OPENINGS.to_vec(),
        };
        let given = match (self.corners.is_empty(), self.openings.is_empty()) {
            (true, true) => &own,
            (true, false) => &Self {
                openings: self.openings.clone(),
                ..own.clone()
            },
            _ => self,
        };
        let (plan, checked) = match given.checked(module, n[1], &mut faults) {
            Ok(checked) => (given, checked),
            Err(fault) => {
                faults.push(fault);
                let checked = own.checked(module, n[1], &mut faults);
                (&own, checked.expect("the rule's own plan fits"))
            }
        };
        let mut walls = WallLine::new(module, checked.line, [n[0], n[1]]);
        let is_roofed = n[2] > 0.0 && walls.set_roof(n[2]);
        if n[2] > 0.0 && !is_roofed {
            faults.push(DrawnFault::Roofless);
        }
        let free = |wall: usize| (walls.free(wall), n[0]);
        let openings = plan.placed_openings(module, &checked.parts, free, &mut faults);
        let mut to = Drafting::default();
        walls.build(&mut to, &openings, is_roofed);
        (to.on_ground(), faults)
    }

    /// The openings that fit in their walls, each with the number of its wall. `free` gives for a wall the part where
    /// openings may be (metres), and the wall's height (courses).
    fn placed_openings(
        &self,
        module: &Module,
        parts: &[(usize, i64)],
        free: impl Fn(usize) -> ([f64; 2], f64),
        faults: &mut Vec<DrawnFault>,
    ) -> Vec<(usize, Opening)> {
        let mut openings: Vec<PlacedOpening> = Vec::new();
        for (opening, row) in (1..).zip(&self.openings) {
            let mut tell = |why| faults.push(DrawnFault::Opening { opening, why });
            let row = fitted(row, &mut tell);
            let fits = |placed: PlacedOpening| {
                let limits = free(placed.wall);
                check_opening(module, limits, (&row, &placed), &openings).map(|()| placed)
            };
            match placed(&row, opening, parts).and_then(fits) {
                Ok(placed) => openings.push(placed),
                Err(why) => tell(why),
            }
        }
        let all = openings.iter();
        all.map(|placed| (placed.wall, placed.opening)).collect()
    }

    /// Checks the corners for walls of a thickness (modules).
    fn checked(
        &self,
        module: &Module,
        thickness: f64,
        faults: &mut Vec<DrawnFault>,
    ) -> Result<CheckedLine, DrawnFault> {
        let (corners, is_closed) = self.line(faults);
        let least = if is_closed { 3 } else { 2 };
        if corners.len() < least {
            let corners = corners.len();
            return Err(DrawnFault::Few { corners, least });
        }
        let kept: Vec<usize> = (0..corners.len())
            .filter(|&k| !goes_on(&corners, is_closed, k))
            .collect();
        let place = |k: &usize| module.half * point(corners[*k]);
        let line = PlanLine {
            corners: kept.iter().map(place).collect(),
            is_closed,
        };
        check_angles(&line, &kept)?;
        let half = 0.5 * module.joint;
        let distances = [half, thickness * module.half - half];
        for (wall, first) in kept.iter().enumerate().take(line.walls()) {
            for distance in distances {
                let [from, end] = line.span(wall, distance, half);
                let length = (end - from + module.joint) / module.half;
                if length < LEAST_PIER - 1e-9 {
                    let wall = first + 1;
                    return Err(DrawnFault::Short { wall, length });
                }
            }
        }
        let margin = 0.5 * APART * module.half;
        let wide = [distances[0] - margin, distances[1] + margin];
        if let Some(Contact::Within(_, at) | Contact::Between(_, _, at)) =
            first_contact(&line.border(wide, -margin))
        {
            let at = at / module.half;
            return Err(DrawnFault::Crossing { at: [at.x, -at.y] });
        }
        let parts = parts(&corners, &kept, is_closed);
        Ok(CheckedLine { line, parts })
    }

    /// The corners within their limits, no two equal ones in sequence, and whether the line is closed.
    fn line(&self, faults: &mut Vec<DrawnFault>) -> (Vec<[i64; 2]>, bool) {
        let limit = |v: i64| v.clamp(-FARTHEST_CORNER, FARTHEST_CORNER);
        let mut corners: Vec<[i64; 2]> = self.corners.iter().map(|p| p.map(limit)).collect();
        let moved = corners.iter().zip(&self.corners).filter(|(a, b)| a != b);
        let far = moved.count();
        if far > 0 {
            faults.push(DrawnFault::Far { corners: far });
        }
        corners.dedup();
        let is_closed = corners.len() > 1 && corners.first() == corners.last();
        if is_closed {
            corners.pop();
        }
        (corners, is_closed)
    }
}

/// A corner in plan, y away from the viewer.
fn point([x, y]: [i64; 2]) -> DVec2 {
    DVec2::new(x as f64, -y as f64)
}

/// Whether a line goes straight on at a corner.
fn goes_on(corners: &[[i64; 2]], is_closed: bool, k: usize) -> bool {
    let n = corners.len();
    if !is_closed && (k == 0 || k + 1 == n) {
        return false;
    }
    let [[ax, ay], [x, y], [bx, by]] = [(k + n - 1) % n, k, (k + 1) % n].map(|k| corners[k]);
    let ([ux, uy], [vx, vy]) = ([x - ax, y - ay], [bx - x, by - y]);
    ux * vy == uy * vx && ux * vx + uy * vy > 0
}

/// For each drawn wall the wall between kept corners that it belongs to, and where it begins there (modules, rounded).
fn parts(corners: &[[i64; 2]], kept: &[usize], is_closed: bool) -> Vec<(usize, i64)> {
    let walls = corners.len() - usize::from(!is_closed);
    let part = |k: usize| {
        // The first wall of a closed line may belong to the last kept corner.
        let above = kept.partition_point(|&corner| corner <= k);
        let wall = (above + kept.len() - 1) % kept.len();
        let from = point(corners[kept[wall]]);
        (wall, from.distance(point(corners[k])).round() as i64)
    };
    (0..walls).map(part).collect()
}

/// Refuses walls that meet at a sharp angle. `kept` are the numbers of the line's corners in the plan.
fn check_angles(line: &PlanLine, kept: &[usize]) -> Result<(), DrawnFault> {
    for (k, corner) in kept.iter().enumerate() {
        if let Some([a, b]) = line.turn(k) {
            let angle = libm::acos((-a.dot(b)).clamp(-1.0, 1.0)).to_degrees();
            if angle < SHARPEST - 1e-6 {
                let corner = corner + 1;
                return Err(DrawnFault::Sharp { corner, angle });
            }
        }
    }
    Ok(())
}

/// A row of an opening with its numbers in their ranges. The wall's number is not moved.
fn fitted(row: &[i64; 6], tell: &mut impl FnMut(OpeningFault)) -> [i64; 6] {
    let mut kept = *row;
    for (place, range) in (1..).zip(RANGES) {
        kept[place] = row[place].clamp(range[0], range[1]);
        if kept[place] != row[place] {
            tell(OpeningFault::Number {
                place: place + 1,
                range,
                moved: [row[place], kept[place]],
            });
        }
    }
    kept
}

/// The opening of a row with this number.
fn placed(
    &[wall, along, sill, width, height, head]: &[i64; 6],
    number: usize,
    parts: &[(usize, i64)],
) -> Result<PlacedOpening, OpeningFault> {
    let index = usize::try_from(wall).ok();
    let index = index.and_then(|wall| wall.checked_sub(1));
    let Some(&(index, from)) = index.and_then(|index| parts.get(index)) else {
        let walls = parts.len();
        return Err(OpeningFault::NoWall { wall, walls });
    };
    let opening = Opening {
        left: (from + along) as f64,
        width: width as f64,
        bottom: sill as f64,
        springing: (sill + height) as f64,
        head: OpeningHead::of(head as f64),
        is_door: false,
    };
    Ok(PlacedOpening {
        number,
        wall: index,
        opening,
    })
}

/// Refuses an opening that does not fit in its wall, beside those before it. `free` is the part of the wall for it
/// (metres), `height` that of the wall (courses).
fn check_opening(
    module: &Module,
    (free, height): ([f64; 2], f64),
    (row, placed): (&[i64; 6], &PlacedOpening),
    others: &[PlacedOpening],
) -> Result<(), OpeningFault> {
    let own = &placed.opening;
    // Piers are modules less a joint.
    let pier = LEAST_PIER - 0.5 * module.joint / module.half - 1e-6;
    let from = (free[0] / module.half + pier).ceil();
    let end = (free[1] / module.half - pier).floor();
    if own.width > end - from {
        let wall = row[0] as usize;
        return Err(OpeningFault::Full { wall });
    }
    if own.left < from || own.left + own.width > end {
        let before = own.left as i64 - row[1];
        return Err(OpeningFault::Beyond {
            wall: row[0] as usize,
            ends: [row[1], row[1] + row[3]],
            allowed: [from as i64 - before, end as i64 - before],
        });
    }
    let (top, most) = (own.top(module), height - LEAST_OVER);
    if top > most + 1e-6 {
        return Err(OpeningFault::High { top, most });
    }
    let is_near = |other: &Opening| {
        let beside = other.left - (own.left + own.width);
        let beside = beside.max(own.left - (other.left + other.width));
        let over = other.bottom - top;
        let over = over.max(own.bottom - other.top(module));
        beside < LEAST_PIER && over < LEAST_OVER
    };
    let mut near = others
        .iter()
        .filter(|other| other.wall == placed.wall && is_near(&other.opening));
    near.next().map_or(Ok(()), |other| {
        let other = other.number;
        Err(OpeningFault::Over { other })
    })
}
