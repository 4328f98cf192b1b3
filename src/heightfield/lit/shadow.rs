//! Height-field shadows at constant cost for each pixel.
//!
//! The shadow height passes from line to line of pixels away from the light: rows, or columns if the light
//! comes more from the side. The lamp has an extent: its upper and lower rim cast a shadow each, and the
//! penumbra lies between the two.
//!
//! On a tile the shadows of a parallel light continue at the opposite edge: the lines whose shadows reach so
//! far are scanned before the first one. Under a point light no picture can repeat, and nothing beyond its
//! edges casts a shadow.

use super::parallel::ParallelShadows;
use super::point::PointShadows;
use super::scan_order::{ColumnBlock, ScanOrder};
use crate::heightfield::Planes;
use crate::light::Light;
use crate::order::{greater, lesser};

/// Shadows reach through at most this many periods of a tile.
const FARTHEST: usize = 4;

/// The lamp's visible part at each pixel, in progress.
pub struct Shadows {
    side: usize,
    pixel_scale: usize,
    /// 255 where the whole lamp is visible.
    lit: Vec<u8>,
    caster: Caster,
    /// A stack of lines still to be done.
    orders: Vec<ScanOrder>,
    block: ColumnBlock,
    begun: bool,
}

/// The shadow algorithm for a kind of light.
enum Caster {
    Parallel(ParallelShadows),
    Point(PointShadows),
}

impl Shadows {
    /// Shadows of `light` in a picture of `side` pixels with `pixel_scale` for each picture unit.
    pub fn new(light: Light, side: usize, pixel_scale: usize) -> Self {
        let (caster, orders) = cast_by(light, side, pixel_scale);
        Self {
            side,
            pixel_scale,
            lit: vec![255; side * side],
            caster,
            orders,
            block: ColumnBlock::default(),
            begun: false,
        }
    }

    /// Starts again under another light.
    pub fn restart(&mut self, light: Light) {
        (self.caster, self.orders) = cast_by(light, self.side, self.pixel_scale);
        self.lit.fill(255);
        self.begun = false;
    }

    /// Does about `lines` lines; true when finished.
    pub fn advance(&mut self, planes: &Planes, lines: usize) -> bool {
        let bump = &planes.bump;
        if !std::mem::replace(&mut self.begun, true) {
            match &mut self.caster {
                Caster::Point(point) => point.raise(planes.ground),
                Caster::Parallel(_) if planes.tile => self.wrap(bump),
                Caster::Parallel(_) => {}
            }
        }
        let mut done = 0;
        while let Some(order) = self.orders.last_mut() {
            if done >= lines {
                return false;
            }
            let fresh = order.is_fresh();
            let span = order.take();
            let order = order.clone();
            if let (true, Caster::Point(point)) = (fresh, &mut self.caster) {
                point.begin(&order, bump);
            }
            done += span.len();
            self.cast(bump, &order, span);
            if order.is_over() {
                self.orders.pop();
            }
        }
        true
    }

    /// The lamp's visible part at each pixel so far, 255 for all of it.
    pub fn lit(&self) -> &[u8] {
        &self.lit
    }

    /// Lets the shadows of a parallel light enter from neighbouring periods.
    fn wrap(&mut self, bump: &[f32]) {
        let (Caster::Parallel(parallel), [order]) = (&mut self.caster, &self.orders[..]) else {
            return;
        };
        let mut range = (f32::MAX, f32::MIN);
        for &height in bump {
            range = (lesser(range.0, height), greater(range.1, height));
        }
        let mut before = parallel.wrap(range.1 - range.0).min(FARTHEST * self.side);
        // The nearest lines come last, so they are pushed first.
        let order = order.clone();
        while before > 0 {
            let lines = before.min(self.side);
            self.orders.push(order.last(lines));
            before -= lines;
        }
    }

    /// Casts the shadows on the lines of `span`.
    fn cast(&mut self, bump: &[f32], order: &ScanOrder, span: std::ops::Range<usize>) {
        let side = self.side;
        if order.columns {
            self.block.load(bump, &self.lit, side, &span);
        }
        for step in 0..span.len() {
            let place = if order.backwards {
                span.len() - 1 - step
            } else {
                step
            };
            let (heights, lit) = if order.columns {
                self.block.line(place)
            } else {
                let row = (span.start + place) * side..(span.start + place + 1) * side;
                (&bump[row.clone()], &mut self.lit[row])
            };
            match &mut self.caster {
                Caster::Parallel(parallel) => parallel.line(heights, lit),
                Caster::Point(point) => point.line(span.start + place, heights, lit),
            }
        }
        if order.columns {
            self.block.store(&mut self.lit, side, &span);
        }
    }
}

fn cast_by(light: Light, side: usize, pixel_scale: usize) -> (Caster, Vec<ScanOrder>) {
    match light {
        Light::Parallel { azimuth, elevation } => {
            let (parallel, order) = ParallelShadows::new(azimuth, elevation, [side, pixel_scale]);
            (Caster::Parallel(parallel), vec![order])
        }
        Light::Point { x, y, z } => {
            let (point, orders) = PointShadows::new(x, y, z, [side, pixel_scale]);
            (Caster::Point(point), orders.into())
        }
    }
}
