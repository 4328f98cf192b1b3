//! Plain blocks: shrunk to their joints, chamfered, and laid a little out of true.

use super::bevel::{Bevelled, BlockMesh};
use super::polyhedron::Polyhedron;
use crate::random::{Purpose, Random};
use glam::{DQuat, DVec3};

/// How blocks are laid and dressed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dressing {
    /// Width of the chamfer (metres, at least 0).
    pub chamfer: f64,
    /// The greatest turn about the outward direction (radians, at least 0).
    pub turn: f64,
    /// The greatest displacement outwards or inwards (metres, at least 0).
    pub shift: f64,
    /// The seed.
    pub seed: u64,
}

impl Dressing {
    /// Bricks: a chamfer of 4 mm, turns up to 0.35 degrees, shifts up to 2 mm.
    pub const BRICK: Self = Self {
        chamfer: 0.004,
        turn: 0.006,
        shift: 0.002,
        seed: crate::random::SEED,
    };

    /// How cell number `cell`, which looks towards `outwards` (unit vector), lies out of true: a rotation about its
    /// centre, and a displacement (metres).
    pub fn out_of_true(&self, outwards: DVec3, cell: u32) -> (DQuat, DVec3) {
        let mut random = Random::new(self.seed, Purpose::Turn, u64::from(cell));
        let angle = 0.5 * self.turn * random.signed();
        let turn = DQuat::from_xyzw(
            libm::sin(angle) * outwards.x,
            libm::sin(angle) * outwards.y,
            libm::sin(angle) * outwards.z,
            libm::cos(angle),
        );
        (turn, outwards * (self.shift * random.signed()))
    }

    /// The geometry of cell number `cell`, which looks towards `outwards` (unit vector); none if its joints take all
    /// of it.
    pub fn dress(&self, claimed: &Polyhedron, outwards: DVec3, cell: u32) -> Option<BlockMesh> {
        let (turn, by) = self.out_of_true(outwards, cell);
        let body = claimed.shrunk()?.turned(turn, by);
        Some(Bevelled::new(&body, self.chamfer).facets())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::masonry::block::Plane;

    /// Each directed edge occurs once, and so does its opposite.
    pub fn is_closed(facets: &BlockMesh) -> bool {
        let edges = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut all: Vec<[u32; 2]> = facets.triangles.iter().flat_map(edges).collect();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        all.len() == count && all.iter().all(|&[a, b]| all.binary_search(&[b, a]).is_ok())
    }

    fn blocks() -> Vec<Polyhedron> {
        let brick = Polyhedron::cuboid(DVec3::ZERO, DVec3::new(0.25, 0.083, 0.125)).unwrap();
        let brick = brick.with_insets(|plane, _| if plane.normal.z > 0.5 { 0.0 } else { 0.005 });
        let mitre = Plane::through(DVec3::new(0.2, 0.04, 0.06), DVec3::new(1.0, 0.0, 1.0));
        let skewback = Plane::through(DVec3::new(0.1, 0.08, 0.0), DVec3::new(-0.3, 1.0, 0.2));
        let tip = Plane::through(DVec3::new(0.24, 0.08, 0.12), DVec3::ONE);
        let cuts = [mitre, skewback, tip].map(|plane| brick.cut(plane, 0.005).unwrap());
        let all = cuts[0].cut(skewback, 0.005).unwrap();
        [vec![brick, all], cuts.to_vec()].concat()
    }

    #[test]
    fn chamfered_blocks_are_closed_and_a_little_smaller() {
        for claimed in blocks() {
            let body = claimed.shrunk().unwrap();
            let facets = Bevelled::new(&body, 0.004).facets();
            assert!(is_closed(&facets), "{facets:?}");
            let share = facets.volume() / body.volume();
            assert!((0.9..1.0).contains(&share), "{share}");
            let planes: Vec<Plane> = body.planes().collect();
            let is_in = |p: &DVec3| planes.iter().all(|plane| plane.distance(*p) < 1e-9);
            assert!(facets.positions.iter().all(is_in));
        }
        let brick = blocks()[0].shrunk().unwrap();
        assert_eq!(Bevelled::new(&brick, 0.004).facets().triangles.len(), 44);
        // A bevel wider than the block still leaves a body.
        let wide = Bevelled::new(&brick, 0.5).facets();
        assert!(is_closed(&wide) && wide.volume() > 0.0);
    }

    #[test]
    fn dressed_blocks_differ_by_cell_and_stay_near_their_place() {
        let claimed = &blocks()[0];
        let dress = |cell, dressing: Dressing| dressing.dress(claimed, DVec3::Z, cell).unwrap();
        let plain = dress(
            1,
            Dressing {
                turn: 0.0,
                shift: 0.0,
                ..Dressing::BRICK
            },
        );
        let [a, b] = [1, 2].map(|cell| dress(cell, Dressing::BRICK));
        assert_eq!(a, dress(1, Dressing::BRICK));
        assert_ne!(a, b);
        for (p, q) in a.positions.iter().zip(&plain.positions) {
            assert!(p.distance(*q) < 0.002 + 0.006 * 0.14);
        }
        let gone = claimed.clone().with_insets(|_, _| 0.06);
        assert_eq!(Dressing::BRICK.dress(&gone, DVec3::Z, 1), None);
    }
}
