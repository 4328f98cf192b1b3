//! The stress on each packed cell: the depth of overlap with its neighbours, and the share of free sides.

use super::CornerBubbles;
use super::Particle;
use super::force::Pair;
use super::packing_domain::{MetricSpace, SpatialHash};
use crate::domain::Domain;
use crate::planar::unit_vector;
use glam::DVec2;

/// The stress on a packed cell as two numbers, each 0..=1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// Depth of the deepest overlap with a neighbour, scaled: 0 up to the overlap that is usual at rest, 1 from a limit
    /// on.
    pub pressed: f32,
    /// The share of its sides without a neighbour or the boundary.
    pub alone: f32,
}

/// An overlap of at least this share of the stable distance counts as 1.
const DEEP: f64 = 0.40;
/// An overlap of at most this share of the stable distance, usual for soft cells at rest, counts as 0.
const REST: f64 = 0.08;
/// A centre less than this far out from a side, in stable distances, occupies that side.
const OPEN: f64 = 1.35;
/// To occupy a side, a centre may lie aside by at most this share of its distance along the side's direction.
const ASIDE: f64 = 0.75;
/// Centres farther apart than this many mean sizes neither press nor stand beside each other: the far corner
/// of a side's search area is 1.55 off, and corners touch at 1.42.
const FAR: f64 = 1.6;
/// Sides of a cell with corners; `WAYS` is the number of directions around any other cell.
const SIDES: u32 = 4;
const WAYS: u32 = 12;

/// The stress on each particle, in the order of `particles`.
pub fn stress(domain: &Domain, particles: &[Particle]) -> Vec<Stress> {
    let goes_on = |centre: DVec2, by: DVec2| {
        domain.contains(centre + by) && !domain.is_parted(centre, centre + by)
    };
    stress_on(domain, particles, |_, _| true, goes_on)
}

/// Two cells of similar directions do not interact if they are farther apart than this, in their mean size. Each cell
/// measures the distance in its own half axes.
#[cfg(house)]
pub(crate) const BEYOND: f64 = 1.7;

/// The stress on each particle on any domain. `may_meet` is false for two particles farther apart than [`BEYOND`], and
/// `goes_on` tells whether the whole path from a place stays on the domain.
pub(crate) fn stress_on<S: MetricSpace>(
    ground: S,
    particles: &[Particle<S::Place>],
    may_meet: impl Fn(usize, usize) -> bool,
    goes_on: impl Fn(S::Place, DVec2) -> bool,
) -> Vec<Stress> {
    let mut surroundings = Surroundings::new(ground, particles);
    let of = |k: usize| {
        let depth = surroundings.meet(k, &may_meet);
        Stress {
            pressed: ((depth - REST) / (DEEP - REST)).clamp(0.0, 1.0) as f32,
            alone: surroundings.free_share(k, &goes_on),
        }
    };
    (0..particles.len()).map(of).collect()
}

/// The surroundings of a particle, found for one particle after another.
struct Surroundings<'a, S: MetricSpace> {
    ground: S,
    particles: &'a [Particle<S::Place>],
    grid: S::Hash,
    reach: f64,
    /// [`FAR`] times the largest root of an aspect ratio, in mean sizes of two cells.
    far: f64,
    /// The neighbours' centres in the frame of the particle, in stable distances.
    around: Vec<DVec2>,
}

impl<'a, S: MetricSpace> Surroundings<'a, S> {
    fn new(ground: S, particles: &'a [Particle<S::Place>]) -> Self {
        let most =
            |value: fn(&Particle<S::Place>) -> f64| particles.iter().map(value).fold(1.0, f64::max);
        let stretch = most(|p| p.aspect.sqrt());
        let longest = particles.iter().map(|p| p.size * p.aspect.sqrt());
        let reach = OPEN * longest.fold(f64::MIN_POSITIVE, f64::max);
        let mut grid = ground.grid(reach);
        particles.iter().for_each(|p| grid.push(p.centre));
        Self {
            ground,
            particles,
            grid,
            reach,
            far: FAR * stretch,
            around: Vec::new(),
        }
    }

    /// Finds the neighbours of a particle; gives the depth of the deepest overlap.
    fn meet(&mut self, own: usize, may_meet: &impl Fn(usize, usize) -> bool) -> f64 {
        let (ground, particle) = (self.ground, &self.particles[own]);
        let centre = particle.centre;
        let (e, f) = particle.half_axes();
        let mut depth = 0.0_f64;
        self.around.clear();
        let mut meet = |k: usize| {
            let other = &self.particles[k];
            let far = self.far * 0.5 * (particle.size + other.size);
            let way = || ground.log_within(centre, other.centre, far);
            let Some((r, turn)) = (k != own && may_meet(own, k)).then(way).flatten() else {
                return false;
            };
            if r.length_squared() < far * far && !ground.is_parted(centre, r) {
                let pair = Pair::seen(particle, other, turn, CornerBubbles::PAPERS);
                depth = depth.max(pair.penetration(r));
                let stable = 2.0 * pair.stable_distance() / particle.size;
                let q = DVec2::new(r.dot(e) / e.length_squared(), r.dot(f) / f.length_squared());
                self.around.push(q / stable);
            }
            false
        };
        ground.any_near(&self.grid, centre, self.reach, &mut meet);
        depth
    }

    /// The share of free sides of a particle, whose neighbours were found before.
    fn free_share(&self, own: usize, goes_on: &impl Fn(S::Place, DVec2) -> bool) -> f32 {
        let particle = &self.particles[own];
        let (e, f) = particle.half_axes();
        let count = match particle.kind.has_corners() {
            true => SIDES,
            false => WAYS,
        };
        let is_free = |k: &u32| {
            let turn = std::f64::consts::TAU * f64::from(*k) / f64::from(count);
            let way = unit_vector(turn);
            let taken = self.around.iter().any(|q| {
                let (along, across) = (way.dot(*q), way.perp_dot(*q).abs());
                along < OPEN && across < ASIDE * along.clamp(0.0, 1.0)
            });
            !taken && goes_on(particle.centre, 2.2 * (way.x * e + way.y * f))
        };
        (0..count).filter(is_free).count() as f32 / count as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    fn row(places: &[(f64, f64)]) -> Vec<Stress> {
        lots(crate::field::CellKind::Square, places)
    }

    fn lots(kind: crate::field::CellKind, places: &[(f64, f64)]) -> Vec<Stress> {
        let ring = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)];
        let domain = Domain::from_checked(&Outline {
            rings: vec![ring.map(DVec2::from).to_vec()],
            ..Outline::default()
        });
        stress(&domain, &particles(kind, places))
    }

    fn particles(kind: crate::field::CellKind, places: &[(f64, f64)]) -> Vec<Particle> {
        (0..)
            .zip(places)
            .map(|(id, &(x, y))| Particle {
                id,
                centre: DVec2::new(x, y),
                kind,
                size: 10.0,
                aspect: 1.0,
                axis: DVec2::X,
                fixed: false,
            })
            .collect()
    }

    #[test]
    fn neighbours_over_the_edge_of_a_tile_are_parted_only_by_lines_between_them() {
        let places = [(1.0, 20.0), (96.0, 20.0), (52.0, 80.0), (47.0, 80.0)];
        let line = [(50.0, 5.0), (50.0, 95.0)].map(DVec2::from).to_vec();
        let torus = Domain::torus(100.0, &[line]);
        let lots = stress(&torus, &particles(crate::field::CellKind::Square, &places));
        assert_eq!((lots[0].pressed, lots[1].pressed), (1.0, 1.0));
        assert_eq!((lots[2].pressed, lots[3].pressed), (0.0, 0.0));
    }

    #[test]
    fn one_large_cell_changes_nothing_for_small_ones_far_away() {
        let mut cells = particles(
            crate::field::CellKind::Square,
            &[(20.0, 20.0), (25.0, 20.0), (80.0, 80.0)],
        );
        let torus = Domain::torus(100.0, &[]);
        let before = stress(&torus, &cells[..2]);
        cells[2].size = 30.0;
        assert_eq!(stress(&torus, &cells)[..2], before);
    }

    #[test]
    fn a_cell_among_its_equals_is_at_ease() {
        let places: Vec<(f64, f64)> = (0..9)
            .map(|k| {
                (
                    40.0 + 10.0 * f64::from(k % 3),
                    40.0 + 10.0 * f64::from(k / 3),
                )
            })
            .collect();
        assert_eq!(row(&places)[4], Stress::default());
    }

    #[test]
    fn overlaps_press_and_gaps_leave_alone() {
        let lots = row(&[(50.0, 50.0), (55.0, 50.0), (20.0, 80.0)]);
        assert_eq!(lots[0].pressed, 1.0);
        assert_eq!(lots[0].alone, 0.75);
        assert_eq!(
            lots[2],
            Stress {
                pressed: 0.0,
                alone: 1.0
            }
        );
    }

    #[test]
    fn the_boundary_is_company() {
        assert_eq!(row(&[(5.0, 5.0)])[0].alone, 0.5);
    }

    #[test]
    fn round_cells_have_six_neighbours_at_any_turn() {
        for turn in [0.0, 0.3, 0.5] {
            let around = |k: i32| {
                let angle = turn + std::f64::consts::FRAC_PI_3 * f64::from(k);
                (
                    50.0 + 10.0 * libm::cos(angle),
                    50.0 + 10.0 * libm::sin(angle),
                )
            };
            let mut places = vec![(50.0, 50.0)];
            places.extend((0..6).map(around));
            let six = lots(crate::field::CellKind::Circle, &places);
            assert_eq!(six[0], Stress::default(), "{turn}");
            assert!(six[1].alone > 0.3);
            let five = lots(crate::field::CellKind::Circle, &places[..6]);
            assert!(five[0].alone > 0.0 && five[0].alone < 0.2, "{turn}");
        }
    }
}
