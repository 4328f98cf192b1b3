//! A surface as the domain of a packing.

use super::packing_mesh::PackingMesh;
use super::walls::{SurfaceClosestPoint, SurfaceWalls};
use crate::packing::cell_fields::CellFields;
use crate::packing::clearance::{INSIDE_CLEARANCE, NARROW, NARROWEST};
use crate::packing::packing_domain::{Boundary, ClosestPoint, MetricSpace, PackingDomain};
use crate::packing::shape::CellShape;
use crate::packing::wall::CLOSEST;
use crate::packing::{BoundaryCondition, TUNING, Tuning};
use crate::random::Random;
use crate::trimesh::{SurfacePoint, Transport};
use glam::DVec2;

/// The step after which population control stops and cooling begins. On closed surfaces some cells beside singular
/// points never rest; after this step fewer than one new cell in a thousand comes.
const SETTLED: u32 = 50;
/// Two borders are the sides of a strip if the cosine between their directions is less than this.
const OPPOSITE: f64 = -0.5;
/// A part with less than this share of a cell's area stays empty.
const BARE: f64 = 0.25;

/// A mesh with the fields of the cells on it.
#[derive(Clone, Copy)]
pub(crate) struct SurfaceDomain<'a, F> {
    pub site: &'a PackingMesh,
    pub fields: F,
}

impl<F: CellFields<Place = SurfacePoint>> SurfaceDomain<'_, F> {
    /// The nearest foot within reach, and half the width of the strip between its border and an opposite one; the width
    /// is infinite without an opposite border. `None` if no border is within reach.
    pub fn strip(self, p: SurfacePoint, reach: f64) -> Option<(SurfaceClosestPoint, f64)> {
        if !self.walls().is_near(p) {
            return None;
        }
        let mut feet = Vec::new();
        self.walls().closest_points(p, reach, &mut feet);
        let nearest = *feet.first()?;
        let opposite = feet[1..]
            .iter()
            .find(|foot| foot.inward().dot(nearest.inward()) < OPPOSITE);
        let half = opposite.map_or(f64::INFINITY, |other| {
            0.5 * (nearest.distance() + other.distance())
        });
        Some((nearest, half))
    }

    /// Moves a place away from a border by `by`; `foot` is its foot on the border.
    pub fn pushed(
        self,
        p: SurfacePoint,
        foot: &SurfaceClosestPoint,
        by: f64,
    ) -> (SurfacePoint, Transport) {
        self.site.exp(p, foot.inward() * by)
    }
}

impl<'a, F: CellFields<Place = SurfacePoint>> PackingDomain for SurfaceDomain<'a, F> {
    type Place = SurfacePoint;
    type Fields = F;
    type Metric = &'a PackingMesh;
    type Walls = &'a SurfaceWalls;
    const TUNING: Tuning = Tuning {
        population_until: SETTLED,
        cooling_from: SETTLED,
        ..TUNING
    };

    fn fields(self) -> F {
        self.fields
    }

    fn metric(self) -> &'a PackingMesh {
        self.site
    }

    fn walls(self) -> &'a SurfaceWalls {
        &self.site.walls
    }

    fn boundary(self) -> BoundaryCondition {
        BoundaryCondition::Wall
    }

    fn moved(
        self,
        from: SurfacePoint,
        by: DVec2,
        shape: CellShape,
        is_clear: bool,
    ) -> (SurfacePoint, Transport) {
        let (to, turn) = self.site.exp(from, by);
        if is_clear {
            return (to, turn);
        }
        let reach = CLOSEST * shape.length();
        let Some((foot, half)) = self.strip(to, 2.0 * reach) else {
            return (to, turn);
        };
        let least = (CLOSEST * shape.seen(turn).extent(foot.inward())).min(half);
        if foot.distance() >= least {
            return (to, turn);
        }
        let (to, on) = self.pushed(to, &foot, least - foot.distance());
        (to, turn.then(on))
    }

    fn has_room(self, p: SurfacePoint) -> bool {
        let shape = CellShape::metric_at(self.fields, p);
        let nearest = self.strip(p, INSIDE_CLEARANCE * shape.length());
        nearest.is_none_or(|(foot, _)| {
            foot.distance() >= INSIDE_CLEARANCE * shape.extent(foot.inward())
        })
    }

    fn middle_of_narrow(self, p: SurfacePoint) -> Option<SurfacePoint> {
        let shape = CellShape::metric_at(self.fields, p);
        let (foot, half) = self.strip(p, shape.length())?;
        let extent = shape.extent(foot.inward());
        let is_narrow = half >= NARROWEST * extent && half < NARROW * extent;
        is_narrow.then(|| self.pushed(p, &foot, half - foot.distance()).0)
    }

    fn empty_parts(self, cells: &[SurfacePoint]) -> Vec<SurfacePoint> {
        let mut has_cell = vec![false; self.site.parts()];
        for cell in cells {
            has_cell[self.site.part(cell) as usize] = true;
        }
        let empty = (0..self.site.parts() as u32).filter(|&part| !has_cell[part as usize]);
        empty
            .map(|part| self.site.middle(part))
            .filter(|&(middle, area)| {
                let size = self.fields.size(middle);
                area >= BARE * size * size
            })
            .map(|(middle, _)| middle)
            .collect()
    }

    fn has_parts(self) -> bool {
        self.site.parts() > 1
    }

    fn anywhere(self, random: &mut Random) -> SurfacePoint {
        let share = random.unit();
        self.site
            .point(share, DVec2::new(random.unit(), random.unit()))
    }
}
