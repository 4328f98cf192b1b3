//! What is seen at each pixel: which triangle of which body, and how near.
//!
//! Bodies are drawn from the nearest to the farthest, each at the level of detail that its size on the screen
//! needs, and left out where the ball around them lies behind what is drawn. Surfaces are looked up again from
//! here when they are shaded, so nothing is worked out for what is hidden.

use super::clip::Planes;
use super::raster::{Corner, Grid};
use super::{Scene, View};
use crate::order::{self, pair};
use crate::solid::Surface;
use glam::Vec3;

/// From this many pixels across, a body is drawn at its finest level, or one coarser, and so on: the last
/// number is between the last two levels.
const STEPS: [f32; 3] = [160.0, 60.0, 20.0];
/// Smaller bodies are dots.
const DOT: f32 = 1.0;
/// Balls of so many pixels across may be hidden; larger ones rarely are, and take long to look at.
const MAY_HIDE: [f32; 2] = [4.0, 400.0];

/// In [`Sight::owner`]: nothing is there.
pub(super) const NOTHING: u32 = u32::MAX;
/// In [`Sight::owner`]: the floor.
pub(super) const FLOOR: u32 = u32::MAX - 1;
/// In [`Sight::triangle`]: a body that is a dot.
pub(super) const AS_DOT: u32 = u32::MAX;

/// The level of a body that is so many pixels across, of so many.
pub(super) fn level_of(diameter: f32, levels: usize, coarse: bool) -> usize {
    let steps = &STEPS[STEPS.len() + 1 - levels.clamp(1, STEPS.len() + 1)..];
    let level = steps.iter().filter(|&&step| diameter <= step).count() + usize::from(coarse);
    level.min(levels.saturating_sub(1))
}

/// What is seen, in the making.
pub(super) struct Sight {
    view: View,
    planes: Planes,
    is_coarse: bool,
    /// Place of the instance, by pixel from the top.
    pub owner: Vec<u32>,
    /// Place of the triangle in its surface.
    pub triangle: Vec<u32>,
    /// Inverse of the depth; 0 where nothing is.
    pub inverse: Vec<f32>,
    /// Of each instance the level that it is drawn at.
    pub levels: Vec<u8>,
    /// Instances in the order in which they are drawn: the rank of their nearness and their place.
    due: Vec<u64>,
    planned: usize,
    is_sorted: bool,
    drawn: usize,
    corners: Vec<Vertex>,
}

/// A vertex in the view, on the screen, and which planes it is beyond.
#[derive(Clone, Copy)]
struct Vertex {
    seen: Vec3,
    screen: Corner,
    beyond: u32,
}

impl Sight {
    pub fn new(view: View) -> Self {
        let mut sight = Self {
            view,
            planes: Planes::new(&view),
            is_coarse: false,
            owner: Vec::new(),
            triangle: Vec::new(),
            inverse: Vec::new(),
            levels: Vec::new(),
            due: Vec::new(),
            planned: 0,
            is_sorted: false,
            drawn: 0,
            corners: Vec::new(),
        };
        sight.begin(view, false);
        sight
    }

    /// Begins anew, with bodies a level coarser or not.
    pub fn begin(&mut self, view: View, is_coarse: bool) {
        let pixels = view.size[0] * view.size[1];
        (self.view, self.planes, self.is_coarse) = (view, Planes::new(&view), is_coarse);
        for (list, empty) in [(&mut self.owner, NOTHING), (&mut self.triangle, AS_DOT)] {
            list.clear();
            list.resize(pixels, empty);
        }
        self.inverse.clear();
        self.inverse.resize(pixels, 0.0);
        self.levels.clear();
        self.due.clear();
        (self.planned, self.is_sorted, self.drawn) = (0, false, 0);
    }

    pub fn view(&self) -> &View {
        &self.view
    }

    /// How much of it is done, 0..1.
    pub fn progress(&self) -> f64 {
        match self.is_sorted {
            true => self.drawn as f64 / self.due.len().max(1) as f64,
            false => 0.0,
        }
    }

    /// Goes on for about the work of so many triangles; true when all is drawn.
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
        let mut left = amount as i64;
        while left > 0 {
            let Some(&due) = self.due.get(self.drawn) else {
                return true;
            };
            left -= self.draw(scene, due as u32) as i64;
            self.drawn += 1;
        }
        self.drawn == self.due.len()
    }

    /// Finds out where instances are, and how fine they are to be.
    fn plan(&mut self, scene: &Scene, amount: usize) {
        let end = scene.instances.len().min(self.planned + amount);
        for place in self.planned..end {
            let instance = &scene.instances[place];
            let levels = scene.bodies[instance.body as usize].levels.len();
            let (middle, radius) = scene.ball_of(instance);
            let seen = self.view.of(middle);
            let diameter = self.view.diameter(seen, radius);
            self.levels
                .push(level_of(diameter, levels, self.is_coarse) as u8);
            if levels > 0 && self.view.may_see(seen, radius) {
                let near = order::rank(f64::from(seen.z - radius));
                self.due.push(pair((near >> 32) as u32, place as u32));
            }
        }
        self.planned = end;
    }

    /// Draws an instance; answers with the work that it was.
    fn draw(&mut self, scene: &Scene, place: u32) -> usize {
        let instance = &scene.instances[place as usize];
        let (middle, radius) = scene.ball_of(instance);
        let seen = self.view.of(middle);
        let diameter = self.view.diameter(seen, radius);
        if diameter < DOT {
            self.dot(seen, place);
            return 1;
        }
        if self.is_hidden(seen, radius, diameter) {
            return 16;
        }
        let level = usize::from(self.levels[place as usize]);
        let surface = &scene.bodies[instance.body as usize].levels[level];
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        corners.extend(surface.positions.iter().map(|&p| {
            let seen = self.view.of(instance.place.of(p));
            Vertex {
                seen,
                screen: self.view.on_screen(seen),
                beyond: self.planes.beyond(seen),
            }
        }));
        self.fill(surface, &corners, place);
        self.corners = corners;
        surface.triangles.len()
    }

    fn fill(&mut self, surface: &Surface, corners: &[Vertex], place: u32) {
        let [width, height] = self.view.size;
        let grid = Grid { width, height };
        for (number, triangle) in (0..).zip(&surface.triangles) {
            let [a, b, c] = triangle.map(|v| corners[v as usize]);
            if a.beyond & b.beyond & c.beyond != 0 {
                continue;
            }
            let (owner, triangles) = (&mut self.owner, &mut self.triangle);
            let inverse = &mut self.inverse;
            let mut put = |at: usize, near: f32| {
                if near > inverse[at] {
                    (inverse[at], owner[at], triangles[at]) = (near, place, number);
                }
            };
            let beyond = a.beyond | b.beyond | c.beyond;
            if beyond == 0 {
                grid.triangle([a.screen, b.screen, c.screen], &mut put);
                continue;
            }
            let cut = self.planes.cut([a.seen, b.seen, c.seen], beyond);
            let screen = |k: usize| self.view.on_screen(cut.corners[k]);
            for k in 2..cut.count {
                grid.triangle([screen(0), screen(k - 1), screen(k)], &mut put);
            }
        }
    }

    /// A body too small to have a shape.
    fn dot(&mut self, seen: Vec3, place: u32) {
        if seen.z <= self.view.near {
            return;
        }
        let [width, height] = self.view.size;
        let [x, y, near] = self.view.on_screen(seen);
        if x >= 0.0 && y >= 0.0 && x < width as f32 && y < height as f32 {
            let at = y as usize * width + x as usize;
            if near > self.inverse[at] {
                (self.inverse[at], self.owner[at], self.triangle[at]) = (near, place, AS_DOT);
            }
        }
    }

    /// Whether something nearer than a ball was met wherever it was looked for.
    fn is_hidden(&self, seen: Vec3, radius: f32, diameter: f32) -> bool {
        let may_hide = MAY_HIDE[0]..=MAY_HIDE[1];
        if !may_hide.contains(&diameter) || seen.z <= radius + self.view.near {
            return false;
        }
        let nearest = 1.0 / (seen.z - radius);
        let [x, y, _] = self.view.on_screen(seen);
        // A ball's outline is an ellipse, a little larger than the circle.
        let reach = 0.5 * diameter * seen.z * nearest + 1.0;
        let [width, height] = self.view.size;
        let span = |middle: f32, size: usize| {
            let first = (middle - reach) as i64;
            let end = (middle + reach) as i64 + 1;
            (first.max(0), end.min(size as i64))
        };
        let ((x0, x1), (y0, y1)) = (span(x, width), span(y, height));
        let mut rows = (y0..y1).step_by(2);
        rows.all(|row| {
            let row = row as usize * width;
            let mut columns = (x0..x1).step_by(2);
            columns.all(|column| self.inverse[row + column as usize] > nearest)
        })
    }
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
