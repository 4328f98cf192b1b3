//! Rasterises the triangles of a view, from world coordinates to pixels.

use super::View;
use super::clip::ClipPlanes;
use super::four_pixels::FourPixels;
use super::raster::{Corner, PixelGrid};
use glam::Vec3;

/// Pixels that cost about as much as one triangle.
pub(super) const PIXELS: usize = 32;

/// A corner in the view and on the screen, and the planes it is outside of.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    seen: Vec3,
    screen: Corner,
    beyond: u32,
}

impl Vertex {
    /// A corner that is certainly on the screen.
    pub fn on_screen(screen: Corner) -> Self {
        Self {
            seen: Vec3::ZERO,
            screen,
            beyond: 0,
        }
    }
}

/// A view with its clipping planes.
#[derive(Clone, Copy)]
pub(super) struct Fill {
    pub view: View,
    planes: ClipPlanes,
}

impl Fill {
    pub fn new(view: View) -> Self {
        let planes = ClipPlanes::new(&view);
        Self { view, planes }
    }

    #[inline(always)]
    pub fn vertex(&self, p: Vec3) -> Vertex {
        let seen = self.view.of(p);
        Vertex {
            seen,
            screen: Corner::new(self.view.on_screen(seen)),
            beyond: self.planes.beyond(seen),
        }
    }

    /// The part of a line inside the clipping planes, in view coordinates; `None` if there is none.
    pub fn part_of_line(&self, line: [Vec3; 2]) -> Option<[Vec3; 2]> {
        self.planes.part_of_line(line.map(|p| self.view.of(p)))
    }

    /// Draws a triangle (see [`super::raster::PixelGrid::triangle`]); gives the work done.
    #[inline(always)]
    pub fn triangle(&self, [a, b, c]: [Vertex; 3], mut put: impl FnMut(FourPixels)) -> usize {
        if a.beyond & b.beyond & c.beyond != 0 {
            return 1;
        }
        let [width, height] = self.view.size;
        let grid = PixelGrid { width, height };
        let beyond = a.beyond | b.beyond | c.beyond;
        if beyond == 0 {
            return 1 + grid.triangle([a.screen, b.screen, c.screen], &mut put) / PIXELS;
        }
        let cut = self.planes.cut([a.seen, b.seen, c.seen], beyond);
        let screen = |k: usize| Corner::new(self.view.on_screen(cut.corners[k]));
        let pieces = 2..cut.count;
        let pixels = pieces.map(|k| grid.triangle([screen(0), screen(k - 1), screen(k)], &mut put));
        1 + pixels.sum::<usize>() / PIXELS
    }
}

/// Draws a list of triangles from an index on, for about this much work; gives the next index and the work
/// done.
#[inline(always)]
pub(super) fn some_of(
    triangles: &[[u32; 3]],
    from: usize,
    most: usize,
    mut draw: impl FnMut(usize, [u32; 3]) -> usize,
) -> (usize, usize) {
    let (mut at, mut work) = (from, 0);
    while at < triangles.len() && work < most {
        work += draw(at, triangles[at]);
        at += 1;
    }
    (at, work)
}
