//! Rectangles along s and t: the places of bricks in the grid of a face.

use super::footprint::{Footprint, are_one};
use glam::DVec2;

/// A rectangle along s and t with an area. It stands for the polygon of [`Footprint::rectangle`] in a quarter of the
/// memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPlace {
    /// Its least s and t (metres).
    pub low: DVec2,
    /// Its greatest s and t (metres).
    pub high: DVec2,
}

impl GridPlace {
    /// The rectangle between two corners; none if it has no area.
    pub fn new(low: DVec2, high: DVec2) -> Option<Self> {
        let place = Self { low, high };
        let is_right = low.cmplt(high).all() && low.is_finite() && high.is_finite();
        let size = high - low;
        let is_thin = are_one(size.x * size.x) || are_one(size.y * size.y);
        (is_right && !is_thin && Footprint::has_area(place.area())).then_some(place)
    }

    /// Its area, in square metres.
    pub fn area(&self) -> f64 {
        let size = self.high - self.low;
        size.x * size.y
    }

    /// The rectangle as a polygon, without insets.
    pub fn footprint(&self) -> Footprint {
        Footprint::between(self.low, self.high)
    }

    /// The smallest rectangle that holds this one and another.
    pub fn with(&self, other: &Self) -> Option<Self> {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// The rectangle moved by `by` (metres).
    pub fn moved(self, by: DVec2) -> Self {
        Self {
            low: self.low + by,
            high: self.high + by,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn places_are_the_rectangles_that_polygons_make() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        for k in 0..400 {
            // Sizes from nothing to a metre, also below zero.
            let scale = [1.0, 1e-5, 1e-9, 2e-9][k % 4];
            let low = DVec2::new(random.signed(), random.signed());
            let size = DVec2::new(random.unit(), random.unit() - 0.1) * scale;
            let (place, polygon) = (
                GridPlace::new(low, low + size),
                Footprint::rectangle(low, low + size),
            );
            assert_eq!(place.map(|place| place.footprint()), polygon);
            if let (Some(place), Some(polygon)) = (place, polygon) {
                assert_eq!(place.area().to_bits(), polygon.area().to_bits());
                assert_eq!([place.low, place.high], polygon.bounds());
            }
        }
    }
}
