//! Rounded, rough stones that may be seen from all sides.
//!
//! The control mesh of a stone is the bevelled block with support rings ([`Bevelled::supported`]). Loop's scheme rounds
//! it (Loop 1987, Smooth subdivision surfaces based on triangles), and noise moves its vertices along their normals. A
//! stone stays inside of the space that it claims; only at exposed sides it may bulge out.

use super::bevel::{Bevelled, BlockMesh};
use super::plane::Plane;
use super::polyhedron::Polyhedron;
use crate::material::NoiseTile;
use crate::random::{Purpose, Random};
use crate::solid::Stencil;
use glam::{DVec3, Vec3};
use std::collections::BTreeMap;

/// Noise values for each step of the coarse grid.
const DENSE: f64 = 8.0;
/// Base-2 logarithms of the noise tile's side and of its coarse step, counted in values.
const TILE: [u32; 2] = [7, 3];
/// The fractal dimension of the noise's profiles.
const DIMENSION: f64 = 1.25;
/// The distance from the bevel to the support rings, in widths of the bevel.
const SUPPORT: f64 = 1.2;
/// The most Loop steps.
const MOST_STEPS: u32 = 4;

/// The shape of rounded stones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rough {
    /// Width of the rounded edges (metres, at least 0).
    pub bevel: f64,
    /// Height of bumps on all sides: noise moves vertices by up to this height out or in (metres, at least 0). The
    /// roughness of a side is added to it.
    pub height: f64,
    /// Waves of the widest bumps in a metre, above 0.
    pub frequency: f64,
    /// How far the stone may stand out of its exposed sides (metres, at least 0).
    pub bulge: f64,
    /// Loop steps of the finest level, at most 4.
    pub steps: u32,
    /// The seed.
    pub seed: u64,
}

impl Rough {
    /// Ashlar and rubble: edges of 26 mm, bumps of 12 mm at 9 a metre.
    pub const STONE: Self = Self {
        bevel: 0.026,
        height: 0.012,
        frequency: 9.0,
        bulge: 0.006,
        steps: 2,
        seed: crate::random::SEED,
    };
    /// Cast stones: edges of 8 mm, and bumps of 16 a metre where a side is marked as rough.
    pub const CAST: Self = Self {
        bevel: 0.008,
        height: 0.0,
        frequency: 16.0,
        bulge: 0.012,
        steps: 3,
        seed: crate::random::SEED,
    };
}

/// Makes rounded stones. Blocks with the same connectivity share the weights of their subdivision.
pub struct Stonecutter {
    rough: Rough,
    noise: NoiseTile,
    stencils: BTreeMap<(u32, Vec<[u32; 3]>), Stencil>,
}

impl Stonecutter {
    /// A maker of stones of this shape.
    pub fn new(rough: Rough) -> Self {
        let [log_side, levels] = TILE;
        Self {
            rough,
            noise: NoiseTile::new(rough.seed, 0, log_side, levels, DIMENSION),
            stencils: BTreeMap::new(),
        }
    }

    /// The surface of cell number `cell` at each level of detail, the finest first; none if its joints take all of it.
    pub fn levels(&mut self, claimed: &Polyhedron, cell: u32) -> Option<Vec<BlockMesh>> {
        let body = claimed.shrunk()?;
        let control = self.control(&body);
        let limits = Limits::new(claimed, self.rough.bulge);
        let steps = (0..=self.rough.steps.min(MOST_STEPS)).rev();
        Some(
            steps
                .map(|steps| self.level(&control, &limits, steps, cell))
                .collect(),
        )
    }

    /// The control mesh. Narrow blocks get narrower edges, so that supports do not fold over.
    fn control(&self, body: &Polyhedron) -> BlockMesh {
        let [low, high] = body.bounds();
        let bevel = self.rough.bevel.min(0.3 * (high - low).min_element());
        Bevelled::new(body, bevel).supported(SUPPORT * bevel)
    }

    fn level(&mut self, control: &BlockMesh, limits: &Limits, steps: u32, cell: u32) -> BlockMesh {
        let middle = control.positions.iter().sum::<DVec3>() / control.positions.len() as f64;
        let (positions, triangles) = self.refined(control, steps, middle);
        let offset = offset(self.rough.seed, cell);
        let refined = BlockMesh {
            positions,
            triangles,
        };
        let normals = refined.normals();
        let moved = refined.positions.iter().zip(&normals).map(|(&p, &normal)| {
            let noise = self.noise_at((p - middle) * self.rough.frequency + offset);
            let wanted = (self.rough.height + limits.roughness(normal)) * noise;
            middle + limits.limited(p - middle, normal, wanted, middle)
        });
        BlockMesh {
            positions: moved.collect(),
            triangles: refined.triangles,
        }
    }

    /// The control mesh after `steps` Loop steps. Positions are taken relative to `middle`, as the weights are single
    /// precision.
    fn refined(
        &mut self,
        control: &BlockMesh,
        steps: u32,
        middle: DVec3,
    ) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        if steps == 0 {
            return (control.positions.clone(), control.triangles.clone());
        }
        let key = (steps, control.triangles.clone());
        let new = || Stencil::new(control.positions.len(), &control.triangles, steps);
        let stencil = self.stencils.entry(key).or_insert_with(new);
        let local: Vec<Vec3> = control
            .positions
            .iter()
            .map(|&p| (p - middle).as_vec3())
            .collect();
        let positions = stencil
            .apply(&local)
            .into_iter()
            .map(|p| middle + p.as_dvec3());
        (positions.collect(), stencil.triangles.to_vec())
    }

    /// Noise from -1 to 1, of deviation about 0.5: the sum of noise in three planes at right angles.
    fn noise_at(&self, p: DVec3) -> f64 {
        let p = p * DENSE;
        let plane = |x: f64, y: f64| f64::from(self.noise.between(x as f32, y as f32));
        let sum = plane(p.x, p.y) + plane(p.y + 19.0, p.z + 7.0) + plane(p.z + 41.0, p.x + 23.0);
        (sum / 3f64.sqrt()).clamp(-2.0, 2.0) * 0.5
    }
}

/// The planes that a stone must not pass: the sides of its claim, exposed ones moved out by the bulge. The number
/// beside each plane is the roughness of its side (metres).
struct Limits(Vec<(Plane, f64)>);

impl Limits {
    fn new(claimed: &Polyhedron, bulge: f64) -> Self {
        let sides = claimed.planes().zip(claimed.sides());
        let limits = sides.map(|(plane, side)| {
            let by = if side.inset > 0.0 { 0.0 } else { -bulge };
            (plane.inset(by), side.roughness)
        });
        Self(limits.collect())
    }

    /// The height of bumps where the surface looks towards `normal`: a mean over the sides, which weighs most those
    /// that look there, too.
    fn roughness(&self, normal: DVec3) -> f64 {
        let (mut sum, mut all) = (0.0, 0.0);
        for (plane, height) in &self.0 {
            let near = plane.normal.dot(normal).max(0.0);
            let weight = near * near * near * near;
            sum += weight * height;
            all += weight;
        }
        if all > 0.0 { sum / all } else { 0.0 }
    }

    /// A vertex moved along its normal by `wanted`, or by less so that it stays inside of all planes. `p` and the
    /// result are relative to `middle`.
    fn limited(&self, p: DVec3, normal: DVec3, wanted: f64, middle: DVec3) -> DVec3 {
        let room = self.0.iter().map(|(plane, _)| {
            let (slope, left) = (plane.normal.dot(normal), -plane.distance(p + middle));
            if slope > 1e-6 {
                left.max(0.0) / slope
            } else {
                f64::MAX
            }
        });
        p + normal * room.fold(wanted, f64::min)
    }
}

/// The place in the noise at which a cell begins: 0 to 16 along each axis.
fn offset(seed: u64, cell: u32) -> DVec3 {
    let mut random = Random::new(seed, Purpose::Distortion, u64::from(cell));
    DVec3::new(random.unit(), random.unit(), random.unit()) * 16.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::masonry::footprint::Footprint;
    use glam::DVec2;

    fn stone(size: DVec3) -> Polyhedron {
        let body = Polyhedron::cuboid(DVec3::ZERO, size).unwrap();
        // The stone of a corner: two sides are exposed.
        body.with_insets(|plane, _| {
            if plane.normal.x > 0.5 || plane.normal.z > 0.5 {
                0.0
            } else {
                0.007
            }
        })
    }

    fn claims() -> Vec<Polyhedron> {
        let tip = Plane::through(DVec3::new(0.3, 0.2, 0.15), DVec3::new(1.0, 0.4, 0.0));
        let pentagon = [
            (0.0, 0.0),
            (0.4, 0.0),
            (0.5, 0.2),
            (0.2, 0.35),
            (-0.05, 0.2),
        ]
        .map(DVec2::from);
        let pentagon = Footprint::new(&pentagon).unwrap().with_insets(|_| 0.007);
        vec![
            stone(DVec3::new(0.375, 0.25, 0.25)),
            stone(DVec3::new(0.3, 0.05, 0.2)),
            stone(DVec3::new(0.375, 0.25, 0.25))
                .cut(tip, 0.007)
                .unwrap(),
            Polyhedron::prism(&pentagon, [-0.125, 0.0], [0.007, 0.0], |p, z| p.extend(z)),
        ]
    }

    fn is_closed(facets: &BlockMesh) -> bool {
        let edges = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut all: Vec<[u32; 2]> = facets.triangles.iter().flat_map(edges).collect();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        all.len() == count && all.iter().all(|&[a, b]| all.binary_search(&[b, a]).is_ok())
    }

    #[test]
    fn stones_are_closed_and_stay_within_their_claims() {
        let mut cutter = Stonecutter::new(Rough::STONE);
        for (cell, claimed) in (0..).zip(claims()) {
            let levels = cutter.levels(&claimed, cell).unwrap();
            assert_eq!(levels.len(), 3);
            assert!(
                levels
                    .windows(2)
                    .all(|w| w[0].triangles.len() == 4 * w[1].triangles.len())
            );
            for facets in levels {
                assert!(is_closed(&facets));
                let share = facets.volume() / claimed.shrunk().unwrap().volume();
                assert!((0.7..1.03).contains(&share), "{cell}: {share}");
                for (plane, side) in claimed.planes().zip(claimed.sides()) {
                    let slack = if side.inset > 0.0 {
                        0.0
                    } else {
                        Rough::STONE.bulge
                    };
                    let out = facets.positions.iter().map(|&p| plane.distance(p) - slack);
                    assert!(out.fold(f64::MIN, f64::max) < 1e-6);
                }
            }
        }
    }

    #[test]
    fn normals_point_outwards_and_faces_are_rough() {
        let claimed = &claims()[0];
        let mut cutter = Stonecutter::new(Rough::STONE);
        let rough = cutter.levels(claimed, 5).unwrap().remove(0);
        let smooth = Stonecutter::new(Rough {
            height: 0.0,
            ..Rough::STONE
        })
        .levels(claimed, 5)
        .unwrap()
        .remove(0);
        let middle = claimed.centre();
        let normals = smooth.normals();
        assert!(
            smooth
                .positions
                .iter()
                .zip(normals)
                .all(|(p, n)| n.dot(*p - middle) > 0.0)
        );
        let ways = rough
            .positions
            .iter()
            .zip(&smooth.positions)
            .map(|(p, q)| p.distance(*q));
        let largest = ways.fold(0.0, f64::max);
        assert!((0.004..=0.0121).contains(&largest), "{largest}");
        assert_eq!(
            rough,
            Stonecutter::new(Rough::STONE).levels(claimed, 5).unwrap()[0]
        );
        assert_ne!(rough, cutter.levels(claimed, 6).unwrap()[0]);
        let other = Rough {
            seed: 9,
            ..Rough::STONE
        };
        assert_ne!(
            rough,
            Stonecutter::new(other).levels(claimed, 5).unwrap()[0]
        );
    }

    #[test]
    fn sides_marked_as_rough_are_rough_and_others_smooth() {
        let plain = stone(DVec3::new(0.375, 0.25, 0.25));
        let marked = plain
            .clone()
            .with_roughness(|plane| if plane.normal.z > 0.5 { 0.01 } else { 0.0 });
        let smooth = Rough {
            height: 0.0,
            steps: 3,
            ..Rough::STONE
        };
        let mesh = |body| Stonecutter::new(smooth).levels(body, 3).unwrap().remove(0);
        let [before, after] = [&plain, &marked].map(mesh);
        let normals = before.normals();
        let moved = |is_rough: bool| {
            let places = before.positions.iter().zip(&after.positions).zip(&normals);
            let own = places.filter(|(_, n)| (n.z > 0.9) == is_rough && (is_rough || n.z < 0.02));
            own.map(|((p, q), _)| p.distance(*q)).fold(0.0, f64::max)
        };
        assert!(moved(true) > 0.003, "{}", moved(true));
        assert!(moved(false) < 1e-6, "{}", moved(false));
    }

    #[test]
    fn a_flat_side_keeps_its_size() {
        // Support rings keep the outline: a stone without noise reaches all its sides.
        let claimed = &claims()[0];
        let smooth = Rough {
            height: 0.0,
            ..Rough::STONE
        };
        let facets = Stonecutter::new(smooth)
            .levels(claimed, 0)
            .unwrap()
            .remove(0);
        for plane in claimed.shrunk().unwrap().planes() {
            let reach = facets
                .positions
                .iter()
                .map(|&p| plane.distance(p))
                .fold(f64::MIN, f64::max);
            assert!(reach.abs() < 1e-3, "{reach}");
        }
    }
}
