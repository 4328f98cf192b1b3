//! Adds cells where there is room and removes them where it is too tight.
//!
//! Miyata, Itoh, Shimada (2000), section 4.3; the rule with the smallest w is that of Itoh, Miyata,
//! Shimada (2003), section 5.1. Attraction keeps the smallest w near 1 beside the largest gaps, so
//! by default the places around a cell, four of squares and six of round cells, are tested for an empty
//! one instead. Rows and columns hold a whole number of cells: what is left over may lie in several
//! gaps, none of them as wide as a cell, so rows are measured over some cells, too.

use super::Surroundings;
use super::clearance::{has_room, middle_of_narrow};
use super::front::slots;
use super::grid::Grid;
use super::shape::Shape;
use super::{Body, BoundaryCondition, PackingParams, Population};
use crate::domain::{Domain, Projection};
use crate::field::{Fields, Kind};
use crate::order;
use glam::DVec2;

/// Two distances, in stable ones: a cell is removed where its nearest neighbour is nearer than the
/// first, and one is added where the nearest is at least as far as the second. Round cells have six
/// neighbours that share a gap: a smaller one takes a cell, and the six make room.
const fn limits(kind: Kind) -> (f64, f64) {
    if kind.has_corners() {
        (0.66, 0.72)
    } else {
        (0.74, 0.63)
    }
}
/// The papers' rule adds beside a cell whose nearest neighbour is farther than this.
const LONELY: f64 = 1.02;
/// Rows and columns: one more cell comes into the widest gap of a row that is looser than so many
/// stable distances, gaps taken together ...
const LOOSE: f64 = 0.6;
/// ... over so many gaps on each side of it ...
const WINDOW: usize = 3;
/// ... where that gap is at least so wide ...
const GAP: f64 = 1.2;
/// ... and its middle at least so far from all cells.
const SQUEEZED: f64 = 0.58;
/// The next cell of a row is nearer than this to where it would touch.
const ROW: f64 = 0.55;
/// The largest share of the cells that is removed, or added, at once.
const MOST_CHANGED: f64 = 0.1;

/// What to change: `remove[i]` for the body i, and the centres of new cells.
pub(super) struct Change {
    pub remove: Vec<bool>,
    pub add: Vec<DVec2>,
}

/// A place for one more cell.
struct Site {
    place: DVec2,
    /// The shape of a cell there.
    shape: Shape,
    /// All cells have to be this far from it, in stable distances.
    room: f64,
}

impl Site {
    fn new(place: DVec2, shape: Shape) -> Self {
        let room = limits(shape.kind()).1;
        Self { place, shape, room }
    }
}

struct Census<'a> {
    domain: &'a Domain,
    bodies: &'a [Body],
    shapes: Vec<Shape>,
    grid: Grid,
    longest: f64,
}

pub(super) fn change(around: Surroundings, bodies: &[Body], params: &PackingParams) -> Change {
    let Surroundings { domain, fields, .. } = around;
    let shapes: Vec<Shape> = bodies.iter().map(|b| Shape::of(&b.particle)).collect();
    let longest = shapes.iter().fold(0.0_f64, |m, s| m.max(s.length()));
    let (lo, hi) = domain.bounds();
    let mut census = Census {
        domain,
        bodies,
        shapes,
        grid: Grid::new(lo, hi, longest),
        longest,
    };
    for body in bodies {
        census.grid.push(body.particle.centre);
    }
    let nearest: Vec<f64> = (0..bodies.len()).map(|i| census.nearest(i)).collect();
    let most = (MOST_CHANGED * bodies.len() as f64).ceil() as usize;
    let remove = census.crowded(&nearest, most);
    let mut add: Vec<DVec2> = Vec::new();
    // In the order of ids, not of memory: the order in memory follows the moves of all.
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order::sort(&mut order, |&i| (bodies[i].particle.id.into(), 0));
    for i in order {
        if add.len() >= most || remove[i] {
            continue;
        }
        if params.population == Population::Smallest && nearest[i] < LONELY {
            continue;
        }
        for site in census.sites(i, fields) {
            add.extend(census.fitting(site, &add, around));
        }
    }
    Change { remove, add }
}

/// A new cell may not stand between two walls that are nearer to each other than a cell.
fn clear_of_walls(place: DVec2, shape: &Shape, around: Surroundings) -> bool {
    let mut near = Vec::new();
    around.walls.project(place, shape.length(), &mut near);
    let least = match around.boundary {
        BoundaryCondition::Wall => 0.4,
        BoundaryCondition::On => 0.7,
    };
    let is_clear = |wall: &Projection| wall.distance >= least * shape.extent(wall.inward);
    near.iter().all(is_clear)
}

impl Census<'_> {
    /// The places for one more cell beside a body.
    fn sites(&self, i: usize, fields: &Fields) -> Vec<Site> {
        let centre = self.bodies[i].particle.centre;
        let at = |p: DVec2| {
            let place = self.domain.space().wrap(p);
            Site::new(place, Shape::metric_at(fields, place))
        };
        let mut sites = Vec::with_capacity(8);
        for place in slots(centre, self.shapes[i], fields) {
            let site = at(place);
            let has_corners = site.shape.kind().has_corners();
            sites.push(site);
            if has_corners && let Some(middle) = self.in_loose_row(i, place) {
                sites.push(Site {
                    room: SQUEEZED,
                    ..at(middle)
                });
            }
        }
        sites
    }

    /// The place of a site where there is room for one more cell; where the outline is narrow, the
    /// middle there.
    fn fitting(
        &self,
        Site { place, shape, room }: Site,
        add: &[DVec2],
        around: Surroundings,
    ) -> Option<DVec2> {
        let is_free = |place: DVec2, shape: &Shape| {
            let is_near = |&other: &DVec2| {
                let way = around.domain.space().shortest(other - place);
                shape.is_closer(shape, way, room)
            };
            self.is_free(place, shape, room) && !add.iter().any(is_near)
        };
        if !is_free(place, &shape) {
            return None;
        }
        if has_room(place, around) && clear_of_walls(place, &shape, around) {
            return Some(place);
        }
        middle_of_narrow(place, around)
            .filter(|&middle| is_free(middle, &Shape::metric_at(around.fields, middle)))
    }

    /// The middle of the gap between a body and the next one of its row at `to`, where the row
    /// around is loose and has no wider gap.
    fn in_loose_row(&self, i: usize, to: DVec2) -> Option<DVec2> {
        if !self.shapes[i].kind().has_corners() {
            return None;
        }
        let (next, way, gap) = self.next(i, to)?;
        if gap < GAP {
            return None;
        }
        let mut slack = gap - 1.0;
        for (mut at, mut along) in [(next, way), (i, -way)] {
            for _ in 0..WINDOW {
                let touching = along / self.shapes[at].cells_along(along);
                let to = self.bodies[at].particle.centre + touching;
                let Some((beyond, further, width)) = self.next(at, to) else {
                    break;
                };
                if width > gap {
                    return None;
                }
                slack += width - 1.0;
                (at, along) = (beyond, further);
            }
        }
        (slack > LOOSE).then(|| self.bodies[i].particle.centre + 0.5 * way)
    }

    /// The next body of a row, that at the place where it would touch this one: with the way to it,
    /// and how far that is in stable distances.
    fn next(&self, i: usize, to: DVec2) -> Option<(usize, DVec2, f64)> {
        let (centre, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        let mut best = None;
        let mut least = ROW;
        self.any_near(to, shape, ROW, |k, r| {
            let far = shape.normalised_distance(&self.shapes[k], r);
            if k != i && far < least && !self.domain.is_parted(to, to + r) {
                (least, best) = (far, Some(k));
            }
            false
        });
        let k = best?;
        let way = self.bodies[k].particle.centre - centre;
        let way = self.domain.space().shortest(way);
        Some((k, way, shape.normalised_distance(&self.shapes[k], way)))
    }

    /// The smallest w between a body and the others (2 where none is near).
    fn nearest(&self, i: usize) -> f64 {
        let (at, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        let mut least = 2.0_f64;
        self.any_near(at, shape, 1.0, |k, r| {
            let far = shape.normalised_distance(&self.shapes[k], r);
            if k != i && far < least && !self.domain.is_parted(at, at + r) {
                least = far;
            }
            false
        });
        least
    }

    /// Is every body at least `room` stable distances away from this place?
    fn is_free(&self, at: DVec2, shape: &Shape, room: f64) -> bool {
        !self.any_near(at, shape, room, |k, r| {
            shape.is_closer(&self.shapes[k], r, room) && !self.domain.is_parted(at, at + r)
        })
    }

    /// Does it hold for any body that may be nearer than `w` stable distances? It is told the body's
    /// number and the way to it, which walls may cut.
    fn any_near(
        &self,
        at: DVec2,
        shape: &Shape,
        w: f64,
        mut test: impl FnMut(usize, DVec2) -> bool,
    ) -> bool {
        let space = self.domain.space();
        let reach = w * 0.5 * (shape.length() + self.longest);
        self.grid.any_near(space, at, reach, |k| {
            test(k, space.shortest(self.bodies[k].particle.centre - at))
        })
    }

    /// The bodies to remove: the tightest first, and no two neighbours at once.
    fn crowded(&self, nearest: &[f64], most: usize) -> Vec<bool> {
        let mut tight: Vec<usize> = (0..nearest.len())
            .filter(|&i| nearest[i] < limits(self.shapes[i].kind()).0)
            .filter(|&i| !self.bodies[i].particle.fixed)
            .collect();
        order::sort(&mut tight, |&i| {
            let id = u64::from(self.bodies[i].particle.id);
            (order::rank(nearest[i]), !id)
        });
        let mut remove = vec![false; nearest.len()];
        let mut count = 0;
        for i in tight {
            let (centre, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
            let (space, reach) = (self.domain.space(), 1.5 * self.longest);
            let beside = self.grid.any_near(space, centre, reach, |k| {
                let r = self.bodies[k].particle.centre - centre;
                remove[k] && shape.is_closer(shape, space.shortest(r), 1.5)
            });
            if !beside && count < most {
                remove[i] = true;
                count += 1;
            }
        }
        remove
    }
}
