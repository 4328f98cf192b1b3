//! Quoins: large stones at the corners of walls, long and short in turn, with their joints on course lines.

use super::cell::Feature;
use super::run::Run;
use super::site::Site;
use crate::building::{CornerId, EdgeId};
use crate::masonry::tree::GeneratorNode;
use glam::DVec3;

impl Site {
    /// The lowest or the highest stone of an edge, at its corner.
    pub fn quoin_corner(&mut self, id: CornerId, node: &GeneratorNode) {
        let quadrants = self.quadrants(id);
        let Some((run, at_end)) = self.corner_run(id, &quadrants) else {
            return;
        };
        let stones = self.quoins(&run, node.count("courses"));
        let is_top = at_end != goes_down(&run);
        let stone = if is_top { stones.len() - 1 } else { 0 };
        self.quoin(Feature::Corner(id), node, &run, (stone, stones[stone]));
    }

    /// The stones of an edge that its corners have not laid.
    pub fn quoin_edge(&mut self, id: EdgeId, node: &GeneratorNode) {
        for run in self.runs(id).into_iter().filter(|run| run.is_upright) {
            let stones = self.quoins(&run, node.count("courses"));
            for stone in stones.into_iter().enumerate() {
                self.quoin(Feature::Edge(id), node, &run, stone);
            }
        }
    }

    fn quoin(
        &mut self,
        feature: Feature,
        node: &GeneratorNode,
        run: &Run,
        (number, span): (usize, [f64; 2]),
    ) {
        let Some(span) = self.free_part(run, span) else {
            return;
        };
        // Each wall begins with a long stone at its left end, so at every corner one wall has the long one.
        let wall = &run.sides[0];
        let frame = self
            .face(wall.face)
            .surface
            .frame(wall.place.x, wall.place.y);
        let inwards = frame.s * wall.inwards.x + frame.t * wall.inwards.y;
        let is_left_end = DVec3::Y.cross(frame.normal).dot(inwards) > 0.0;
        let long = (number + usize::from(!is_left_end)) % 2;
        let units = ["long", "short"].map(|key| node.count(key));
        let mut draft = self.edge_stone(run, (long, units), span);
        draft.extrude = node.number("extrude");
        self.place(feature, node, draft);
    }

    /// The stones of an upright run from the ground up, of some courses each, as parts of the run.
    fn quoins(&self, run: &Run, courses: usize) -> Vec<[f64; 2]> {
        let rows = self.intervals(run).into_iter().map(|(_, span)| span);
        let mut rows: Vec<[f64; 2]> = rows.collect();
        if goes_down(run) {
            rows.reverse();
        }
        stacks(&rows, courses)
    }
}

fn goes_down(run: &Run) -> bool {
    run.sides[0].along.y < 0.0
}

/// Joins rows into stones of `courses` rows each. The last stone has two rows at least, if there are as many.
pub(super) fn stacks(mut rows: &[[f64; 2]], courses: usize) -> Vec<[f64; 2]> {
    let mut stones = Vec::new();
    while !rows.is_empty() {
        let count = if rows.len() < courses + 2 {
            rows.len().min(courses + 1)
        } else {
            courses
        };
        let (stone, rest) = rows.split_at(count);
        let ends = stone.iter().flatten().copied();
        stones.push([
            ends.clone().fold(f64::MAX, f64::min),
            ends.fold(f64::MIN, f64::max),
        ]);
        rows = rest;
    }
    stones
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_stone_of_one_course_is_left() {
        for courses in 2..6 {
            for count in 1..40_usize {
                let rows: Vec<[f64; 2]> = (0..count).map(|k| [k as f64, k as f64 + 1.0]).collect();
                let stones = stacks(&rows, courses);
                assert_eq!(
                    (stones[0][0], stones[stones.len() - 1][1]),
                    (0.0, count as f64)
                );
                assert!(stones.windows(2).all(|w| w[0][1] == w[1][0]));
                let least = stones.iter().map(|s| s[1] - s[0]).fold(f64::MAX, f64::min);
                assert!(count == 1 || least >= 2.0, "{courses} {count} {stones:?}");
            }
        }
    }
}
