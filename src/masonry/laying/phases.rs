//! Chooses the better one of the two phases of connected walls (Legakis, Dorsey, Gortler 2001, section 5.2).

use super::site::Site;
use super::work::SiteWork;
use crate::building::FaceId;
use crate::masonry::plan::is_wall;
use std::collections::BTreeMap;

/// Shifts a set of walls by a column if that makes fewer bricks, or as many bricks and fewer cut ones. So a building
/// that is turned or mirrored has the same number of bricks.
pub(super) struct PhaseWork {
    /// The sets of walls that can be shifted only together, the next set last.
    sets: Vec<Vec<FaceId>>,
    /// The place in its set of the wall that is being counted.
    wall: usize,
    /// The next row of this wall.
    row: usize,
    /// The numbers of bricks and of cut bricks in the set so far: unshifted, then shifted.
    costs: [[usize; 2]; 2],
}

impl PhaseWork {
    pub fn new(site: &Site) -> Self {
        let mut sets: BTreeMap<FaceId, Vec<FaceId>> = BTreeMap::new();
        for (id, &first) in site.building.face_ids().zip(&site.plan.phase_sets) {
            if is_wall(site.face(id)) {
                sets.entry(first).or_default().push(id);
            }
        }
        Self {
            sets: sets.into_values().collect(),
            wall: 0,
            row: 0,
            costs: [[0; 2]; 2],
        }
    }
}

impl SiteWork for PhaseWork {
    /// Counts a row of a wall. After the last row of a set, shifts the set if that is better.
    fn advance(&mut self, site: &mut Site) -> bool {
        let Some(walls) = self.sets.last() else {
            return true;
        };
        let id = walls[self.wall];
        for (shift, cost) in self.costs.iter_mut().enumerate() {
            let [all, cut] = site.row_pieces(id, self.row, shift);
            *cost = [cost[0] + all, cost[1] + cut];
        }
        self.row += 1;
        if self.row < site.plan.grid(id).row_lines().len() - 1 {
            return false;
        }
        (self.wall, self.row) = (self.wall + 1, 0);
        if self.wall < walls.len() {
            return false;
        }
        let [plain, shifted] = std::mem::take(&mut self.costs);
        if shifted < plain {
            for wall in walls {
                site.plan.grids[wall.index()].phase ^= true;
            }
        }
        self.wall = 0;
        self.sets.pop();
        self.sets.is_empty()
    }
}
