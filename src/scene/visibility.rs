//! The visibility buffer: which triangle of which body is visible at each pixel, and how near it is.
//!
//! Bodies are drawn from the nearest to the farthest, each at the level of detail that its size on the screen needs.
//! A body is skipped if its bounding ball lies behind surfaces already drawn. Shading looks surfaces up again from
//! this buffer, so nothing is computed for hidden ones.

use super::cut::{Cut, Left};
use super::fill::{Fill, Vertex, some_of};
use super::four_pixels::{FourPixels, LANES, four_of};
use super::{Instance, Scene, View};
use crate::order::{self, pair};
use crate::solid::Surface;
use glam::Vec3;

/// The widths on the screen, in pixels, down to which a body is drawn at its finest level, the next one, and so on. A
/// body with fewer levels uses only the last widths.
const STEPS: [f32; 3] = [160.0, 60.0, 20.0];
/// Bodies with fewer pixels across are dots.
const DOT: f32 = 1.0;
/// Only balls with this many pixels across are tested for being hidden: larger ones rarely are, and take long to
/// test.
const MAY_HIDE: [f32; 2] = [4.0, 400.0];

/// In [`VisibilityBuffer::owner`]: nothing is there.
pub(super) const NOTHING: u32 = u32::MAX;
/// In [`VisibilityBuffer::owner`]: the floor.
pub(super) const FLOOR: u32 = u32::MAX - 1;
/// In [`VisibilityBuffer::triangle`]: a body that is a dot.
pub(super) const AS_DOT: u32 = u32::MAX;

/// In [`VisibilityBuffer::triangle`]: this bit marks a triangle seen from inside a body that is cut; the lower bits are
/// its number. Such pixels show the cap in the plane of the cut.
const CAP: u32 = 1 << 31;

/// Whether the entry has no triangle to look up.
pub(super) fn has_no_triangle(triangle: u32) -> bool {
    triangle >= CAP
}

/// The level of a body with this diameter in pixels, of `levels` in all.
pub(super) fn level_of(diameter: f32, levels: usize, coarse: bool) -> usize {
    let steps = &STEPS[STEPS.len() + 1 - levels.clamp(1, STEPS.len() + 1)..];
    let level = steps.iter().filter(|&&step| diameter <= step).count() + usize::from(coarse);
    level.min(levels.saturating_sub(1))
}

/// The visibility buffer, while it is drawn.
pub(super) struct VisibilityBuffer {
    fill: Fill,
    is_coarse: bool,
    cut: Option<Cut>,
    /// How many pixels have been searched for caps.
    capped: usize,
    /// For each pixel from the top, the index of the visible instance.
    pub owner: Vec<u32>,
    /// For each pixel the index of the triangle in its surface.
    pub triangle: Vec<u32>,
    /// For each pixel the inverse of the depth; 0 where there is nothing.
    pub inverse: Vec<f32>,
    /// For each instance the level at which it is drawn.
    pub levels: Vec<u8>,
    /// Instances in drawing order, as keys: the rank of their nearness, and their index.
    due: Vec<u64>,
    planned: usize,
    is_sorted: bool,
    drawn: usize,
    /// The corners of the current instance, and its next triangle; 0 before it has begun.
    corners: Vec<Vertex>,
    next: usize,
}

impl VisibilityBuffer {
    pub fn new(view: View) -> Self {
        let mut sight = Self {
            fill: Fill::new(view),
            is_coarse: false,
            cut: None,
            capped: 0,
            owner: Vec::new(),
            triangle: Vec::new(),
            inverse: Vec::new(),
            levels: Vec::new(),
            due: Vec::new(),
            planned: 0,
            is_sorted: false,
            drawn: 0,
            corners: Vec::new(),
            next: 0,
        };
        sight.begin(view, false, None);
        sight
    }

    /// Starts again, with bodies one level coarser or not, and cut by a plane.
    pub fn begin(&mut self, view: View, is_coarse: bool, cut: Option<Cut>) {
        (self.fill, self.is_coarse) = (Fill::new(view), is_coarse);
        (self.cut, self.capped) = (cut, 0);
        let pixels = view.size[0] * view.size[1] + LANES - 1;
        for list in [&mut self.owner, &mut self.triangle] {
            list.clear();
            list.reserve_exact(pixels);
        }
        self.inverse.clear();
        self.inverse.reserve_exact(pixels);
        self.levels.clear();
        self.due.clear();
        (self.planned, self.is_sorted, self.drawn, self.next) = (0, false, 0, 0);
    }

    /// Makes room for pixels up to `pixels`. All are needed before [`VisibilityBuffer::advance`].
    pub fn make_room(&mut self, pixels: usize) {
        let pixels = pixels + LANES - 1;
        self.owner.resize(pixels, NOTHING);
        self.triangle.resize(pixels, AS_DOT);
        self.inverse.resize(pixels, 0.0);
    }

    pub fn view(&self) -> &View {
        &self.fill.view
    }

    /// How far the surface drawn at a pixel may lie off the body's own surface, in the world.
    #[inline(always)]
    pub fn slack(&self, at: usize) -> f32 {
        let pixels = if self.is_coarse { 1.0 } else { 0.5 };
        pixels * self.view().slope / self.inverse[at]
    }

    pub fn fill(&self) -> &Fill {
        &self.fill
    }

    /// The share of the work that is done, 0..1.
    pub fn progress(&self) -> f64 {
        match self.is_sorted {
            true => self.drawn as f64 / self.due.len().max(1) as f64,
            false => 0.0,
        }
    }

    /// Does the work of about `amount` triangles; true when all is drawn.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        if self.planned < scene.instances.len() {
            self.plan(scene, amount);
            return false;
        }
        if !self.is_sorted {
            self.due.sort_unstable();
            self.is_sorted = true;
            return false;
        }
        let mut left = amount;
        while left > 0 {
            let Some(&due) = self.due.get(self.drawn) else {
                return self.put_caps(amount);
            };
            let (work, is_drawn) = self.draw(scene, due as u32, left);
            left = left.saturating_sub(work);
            self.drawn += usize::from(is_drawn);
        }
        self.drawn == self.due.len() && self.cut.is_none()
    }

    /// The normal of the cap that is visible at a pixel; `None` if there is none.
    #[inline(always)]
    pub fn cap(&self, at: usize) -> Option<Vec3> {
        let triangle = self.triangle[at];
        let is_cap = triangle >= CAP && triangle != AS_DOT;
        self.cut.filter(|_| is_cap).map(|cut| cut.normal)
    }

    /// Moves caps from the far side of their bodies into the plane of the cut, for about this many pixels; true when
    /// all are there.
    fn put_caps(&mut self, amount: usize) -> bool {
        let view = *self.view();
        let pixels = view.size[0] * view.size[1];
        let Some(cut) = self.cut else {
            return true;
        };
        let end = pixels.min(self.capped.saturating_add(8 * amount));
        for at in self.capped..end {
            if self.cap(at).is_none() {
                continue;
            }
            let (x, y) = (at % view.size[0], at / view.size[0]);
            let depth = cut.depth(view.eye, view.ray(x as f32 + 0.5, y as f32 + 0.5));
            // If the surface has an opening, its inside may be nearer than the plane: then there is no cap.
            if depth > view.near && depth * self.inverse[at] < 1.0 {
                self.inverse[at] = 1.0 / depth;
            }
        }
        self.capped = end;
        end == pixels
    }

    /// Chooses the levels of instances and their order.
    fn plan(&mut self, scene: &Scene, amount: usize) {
        let end = scene
            .instances
            .len()
            .min(self.planned.saturating_add(amount));
        for place in self.planned..end {
            let instance = &scene.instances[place];
            let levels = scene.bodies[instance.body as usize].levels.len();
            let (middle, radius) = scene.ball_of(instance);
            let seen = self.view().of(middle);
            let diameter = self.view().diameter(seen, radius);
            self.levels
                .push(level_of(diameter, levels, self.is_coarse) as u8);
            let ball = (middle, radius);
            let is_left = self.cut.is_none_or(|cut| cut.left_of(ball) != Left::None);
            if levels > 0 && is_left && self.view().may_see(seen, radius) {
                let near = order::rank(f64::from(seen.z - radius));
                self.due.push(pair((near >> 32) as u32, place as u32));
            }
        }
        self.planned = end;
    }

    /// Draws an instance, or continues it; returns the work done, and whether the instance is complete.
    fn draw(&mut self, scene: &Scene, place: u32, most: usize) -> (usize, bool) {
        let instance = &scene.instances[place as usize];
        let level = usize::from(self.levels[place as usize]);
        let surface = &scene.bodies[instance.body as usize].levels[level];
        let mut work = 0;
        if self.next == 0 {
            let (middle, radius) = scene.ball_of(instance);
            let seen = self.view().of(middle);
            let diameter = self.view().diameter(seen, radius);
            if diameter < DOT {
                self.dot(seen, place);
                return (1, true);
            }
            if self.is_hidden(seen, radius, diameter) {
                return (16, true);
            }
            self.corners.clear();
        }
        if let Some(cut) = self.cut
            && cut.left_of(scene.ball_of(instance)) == Left::Some
        {
            return self.draw_cut(&cut, surface, instance, place, most);
        }
        if self.next == 0 {
            let (fill, points) = (&self.fill, surface.positions.iter());
            self.corners
                .extend(points.map(|&p| fill.vertex(instance.place.of(p))));
            work = surface.positions.len() / 4;
        }
        let (fill, corners) = (&self.fill, &self.corners);
        let (inverse, owner) = (&mut self.inverse[..], &mut self.owner[..]);
        let triangles = &mut self.triangle[..];
        let most = most.saturating_sub(work).max(1);
        let (next, drawn) = some_of(&surface.triangles, self.next, most, |number, triangle| {
            let corners = triangle.map(|v| corners[v as usize]);
            fill.triangle(corners, |four| {
                put(
                    four,
                    [&mut *owner, &mut *triangles],
                    inverse,
                    [place, number as u32],
                );
            })
        });
        let is_drawn = next == surface.triangles.len();
        self.next = if is_drawn { 0 } else { next };
        (work + drawn, is_drawn)
    }

    /// Like `draw`, for an instance that is cut: draws the part of each triangle that is left, from both sides.
    fn draw_cut(
        &mut self,
        cut: &Cut,
        surface: &Surface,
        instance: &Instance,
        place: u32,
        most: usize,
    ) -> (usize, bool) {
        let fill = &self.fill;
        let (inverse, owner) = (&mut self.inverse[..], &mut self.owner[..]);
        let triangles = &mut self.triangle[..];
        let (next, work) = some_of(&surface.triangles, self.next, most, |number, triangle| {
            let corners = triangle.map(|v| instance.place.of(surface.positions[v as usize]));
            let rest = cut.rest_of(corners);
            let corners = rest.corners.map(|p| fill.vertex(p));
            let mut work = 1;
            for k in 2..rest.count {
                let [a, b, c] = [corners[0], corners[k - 1], corners[k]];
                for (sides, mark) in [([a, b, c], 0), ([a, c, b], CAP)] {
                    let numbers = [place, mark | number as u32];
                    work += fill.triangle(sides, |four| {
                        put(four, [&mut *owner, &mut *triangles], inverse, numbers);
                    });
                }
            }
            work
        });
        let is_drawn = next == surface.triangles.len();
        self.next = if is_drawn { 0 } else { next };
        (work, is_drawn)
    }

    /// Draws a body that is too small to have a shape.
    fn dot(&mut self, seen: Vec3, place: u32) {
        if seen.z <= self.view().near {
            return;
        }
        let [width, height] = self.view().size;
        let [x, y, near] = self.view().on_screen(seen);
        if x >= 0.0 && y >= 0.0 && x < width as f32 && y < height as f32 {
            let at = y as usize * width + x as usize;
            if near > self.inverse[at] {
                (self.inverse[at], self.owner[at], self.triangle[at]) = (near, place, AS_DOT);
            }
        }
    }

    /// Whether something nearer covers all pixels of a ball.
    fn is_hidden(&self, seen: Vec3, radius: f32, diameter: f32) -> bool {
        let may_hide = MAY_HIDE[0]..=MAY_HIDE[1];
        if !may_hide.contains(&diameter) || seen.z <= radius + self.view().near {
            return false;
        }
        let nearest = 1.0 / (seen.z - radius);
        let view = self.view();
        let [width, height] = view.size;
        // The exact span of a ball on the screen, also far from the middle, from the slopes of the planes that touch
        // it.
        let span = |along: f32, middle: f32, size: usize| {
            let deep = seen.z * seen.z - radius * radius;
            let root = (along * along + deep).sqrt() * radius;
            let slope = |side: f32| (along * seen.z + side * root) / deep * view.focal;
            let (first, last) = (middle + slope(-1.0) - 1.0, middle + slope(1.0) + 1.0);
            ((first as i64).max(0), (last as i64 + 1).min(size as i64))
        };
        let (x0, x1) = span(seen.x, view.middle[0], width);
        let (y0, y1) = span(-seen.y, view.middle[1], height);
        // While something moves, gaps of one pixel may be missed.
        let step = if self.is_coarse { 2 } else { 1 };
        let mut rows = (y0..y1).step_by(step);
        rows.all(|row| {
            let row = row as usize * width;
            let mut columns = (x0..x1).step_by(step);
            columns.all(|column| self.inverse[row + column as usize] > nearest)
        })
    }
}

/// Stores an instance and its triangle at pixels where they are the nearest.
#[inline(always)]
fn put(
    four: FourPixels,
    [owner, triangles]: [&mut [u32]; 2],
    inverse: &mut [f32],
    [place, number]: [u32; 2],
) {
    let Some(inverse) = four_of(inverse, four.at) else {
        return;
    };
    let wins = four.wins(inverse);
    if !wins.any() {
        return;
    }
    let (Some(owner), Some(triangles)) = (four_of(owner, four.at), four_of(triangles, four.at))
    else {
        return;
    };
    wins.near(inverse);
    wins.put(place, owner);
    wins.put(number, triangles);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smaller_bodies_are_coarser() {
        let three = |diameter| level_of(diameter, 3, false);
        assert_eq!([200.0, 61.0, 60.0, 21.0, 5.0].map(three), [0, 0, 1, 1, 2]);
        assert_eq!(level_of(161.0, 4, false), 0);
        assert_eq!(level_of(61.0, 4, true), 2);
        assert_eq!(level_of(1.0, 1, true), 0);
        assert_eq!(level_of(1.0, 9, true), 4);
    }
}
