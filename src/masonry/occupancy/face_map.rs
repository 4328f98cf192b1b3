//! The occupancy map of a face: a bitmap, exact claims, and convex obstacles around and in the face.

use super::bitmap::{Bitmap, Coverage};
use super::claims::{Claim, Claims};
use crate::masonry::footprint::{Footprint, shared_box};
use crate::masonry::free_space::remainder;
use crate::masonry::grid_place::GridPlace;
use crate::masonry::region::Region;
use glam::DVec2;
use smallvec::SmallVec;

/// Polygons that a cell must not overlap. There are few beside a brick.
pub type Obstacles<'a> = SmallVec<[&'a Footprint; 16]>;

/// The side of a cell of the hash grid of claims, in modules. A brick meets few such cells.
const CELL: f64 = 3.0;

/// The map of a face.
#[derive(Clone, Debug)]
pub struct FaceMap {
    /// Length after which s comes back to the same place, on a whole cylinder (metres).
    period: Option<f64>,
    bitmap: Bitmap,
    claims: Claims,
    /// The face itself as convex polygons.
    inside: Vec<Footprint>,
    /// The bounding boxes of the polygons in `inside`.
    inside_boxes: Vec<[DVec2; 2]>,
    /// The face's holes, its surroundings and the outlines of its insets (panels), as convex polygons.
    outside: Claims,
}

impl FaceMap {
    /// The map of a face with this outline. `module` is the pattern's unit W (metres, above 0), and this many `pixels`
    /// lie along it. On a whole cylinder the region covers one `period` of s.
    pub fn new(region: &Region, (module, pixels): (f64, f64), period: Option<f64>) -> Self {
        let parts = region.convex_parts(Self::margin(module, period));
        Self::with_parts(region, parts, (module, pixels), period)
    }

    /// The margin around the region's bounding box in which the map has obstacles (metres along s and t).
    pub fn margin(module: f64, period: Option<f64>) -> DVec2 {
        // Obstacles need to be as wide as anything that may be laid across the border.
        let margin = 8.0 * module;
        DVec2::new(if period.is_some() { 0.0 } else { margin }, margin)
    }

    /// The map for the convex parts of the region and of its complement, in a box that is wider by [`Self::margin`].
    pub fn with_parts(
        region: &Region,
        [inside, around]: [Vec<Footprint>; 2],
        (module, pixels): (f64, f64),
        period: Option<f64>,
    ) -> Self {
        let bounds = region.bounds().unwrap_or_default();
        let mut map = Self {
            period,
            bitmap: Bitmap::new(region, module / pixels),
            claims: Claims::with_cell(bounds, CELL * module),
            inside_boxes: inside.iter().map(Footprint::bounds).collect(),
            inside,
            outside: Claims::new(bounds),
        };
        for polygon in around {
            map.enclose(&polygon);
        }
        map
    }

    /// A polygon at all places where it may be met: on a cylinder also one period to either side.
    fn images<'a>(&self, polygon: &'a Footprint) -> impl Iterator<Item = Footprint> + use<'a> {
        let turns = [Some(0.0), self.period.map(|period| -period), self.period];
        let shifts = turns.into_iter().flatten();
        shifts.map(move |shift| polygon.clone().moved(DVec2::new(shift, 0.0)))
    }

    /// Claims a polygon for a cell.
    pub fn claim(&mut self, polygon: &Footprint, cell: u32) {
        for polygon in self.images(polygon) {
            self.bitmap.occupy(&polygon);
            self.claims.add(Claim { polygon, cell });
        }
    }

    /// Adds the outline of an inset to the obstacles, after its cells have claimed the space. Cells beside it are then
    /// cut along the outline, and not along the sides of single cells.
    pub fn enclose(&mut self, outline: &Footprint) {
        for polygon in self.images(outline) {
            let cell = u32::MAX;
            self.outside.add(Claim { polygon, cell });
        }
    }

    /// The bitmap of empty pixels.
    pub fn bitmap(&self) -> &Bitmap {
        &self.bitmap
    }

    /// The claims; on a cylinder each one also stands a period to either side.
    pub fn claims(&self) -> &Claims {
        &self.claims
    }

    /// Whether a place is free, partly free or occupied, judged by pixels.
    pub fn coverage(&self, polygon: &Footprint) -> Coverage {
        self.bitmap.coverage(polygon)
    }

    /// As [`Self::coverage`], for a rectangle along s and t. On a cylinder it may lie over the seam.
    pub fn coverage_of(&self, place: &GridPlace) -> Coverage {
        let low = self.bitmap.low().x;
        let (before, after) = (place.low.x < low, |end| place.high.x > end);
        match self.period {
            Some(period) if before || after(low + period) => {
                let turn = DVec2::new(period, 0.0);
                let first = if before { place.moved(turn) } else { *place };
                let (mut first, mut second) = (first, first.moved(-turn));
                first.high.x = first.high.x.min(low + period);
                second.low.x = second.low.x.max(low);
                self.bitmap.coverage_of_all(&[first, second])
            }
            _ => self.bitmap.coverage_of(place),
        }
    }

    /// The share of a polygon that earlier claims cover, summed over the claims: above 1 if they overlap.
    pub fn claimed_share(&self, polygon: &Footprint) -> f64 {
        self.claims.shared_area(polygon, None) / polygon.area()
    }

    /// The holes, surroundings and claims that a polygon may meet.
    pub fn obstacles(&self, polygon: &Footprint) -> Obstacles<'_> {
        let outside = self.outside.polygons_near(polygon);
        outside.chain(self.claims.polygons_near(polygon)).collect()
    }

    /// The claims that a polygon may meet.
    pub fn claimed_near(&self, polygon: &Footprint) -> Obstacles<'_> {
        self.claims.polygons_near(polygon).collect()
    }

    /// Whether more than the share `least` of a polygon lies on the face itself (0 to 1).
    pub fn has_inside(&self, polygon: &Footprint, least: f64) -> bool {
        let (mut area, whole) = (0.0, polygon.area());
        for image in self.images(polygon) {
            let (before, mut own) = (area, 0.0);
            let around = image.bounds();
            for (part, part_box) in self.inside.iter().zip(&self.inside_boxes) {
                if shared_box(*part_box, around).is_some() {
                    own += part.shared_area(&image);
                    area = before + own;
                    // Further parts can only add to the area.
                    if area / whole > least {
                        return true;
                    }
                }
            }
        }
        false
    }

    /// The face's area, in square metres.
    pub fn area(&self) -> f64 {
        self.inside.iter().map(Footprint::area).sum()
    }

    /// The parts of the face under no claim, as convex polygons.
    pub fn gaps(&self) -> Vec<Footprint> {
        self.unclaimed(self.inside.iter().cloned())
    }

    /// The parts of a polygon that lie on the face under no claim, as convex polygons.
    pub fn gaps_in(&self, polygon: &Footprint) -> Vec<Footprint> {
        self.unclaimed(
            self.inside
                .iter()
                .filter_map(|part| part.intersection(polygon)),
        )
    }

    fn unclaimed(&self, parts: impl Iterator<Item = Footprint>) -> Vec<Footprint> {
        parts
            .flat_map(|part| remainder(&part, &self.claimed_near(&part)))
            .collect()
    }

    /// The area of the face under no claim, in square metres.
    pub fn gap(&self) -> f64 {
        self.gaps().iter().map(Footprint::area).sum()
    }

    /// The area of the face that claims cover, summed over the claims (square metres).
    pub fn claimed(&self) -> f64 {
        self.inside
            .iter()
            .map(|part| self.claims.shared_area(part, None))
            .sum()
    }

    /// The area of the face that is under two claims of different cells, counted once for each pair (square metres).
    pub fn overlap(&self) -> f64 {
        match self.period {
            None => self.claims.overlap(),
            // Each pair also stands a period to either side, so only parts within the face count.
            Some(_) => self
                .inside
                .iter()
                .map(|part| self.overlap_within(part))
                .sum(),
        }
    }

    fn overlap_within(&self, part: &Footprint) -> f64 {
        let mut within = Claims::new(part.bounds());
        for k in self.claims.near(part.bounds()) {
            let claim = &self.claims.list()[k as usize];
            if let Some(polygon) = claim.polygon.intersection(part) {
                within.add(Claim {
                    polygon,
                    cell: claim.cell,
                });
            }
        }
        within.overlap()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    const W: f64 = 0.125;

    fn rectangle(low: (f64, f64), high: (f64, f64)) -> Footprint {
        Footprint::rectangle(low.into(), high.into()).unwrap()
    }

    fn ring(corners: &[(f64, f64)]) -> Vec<DVec2> {
        corners.iter().map(|&p| p.into()).collect()
    }

    /// A wall of 3 m by 2 m with a window from (1, 0.5) to (2, 1.5).
    fn wall() -> Region {
        let outer = ring(&[(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)]);
        let window = ring(&[(1.0, 0.5), (1.0, 1.5), (2.0, 1.5), (2.0, 0.5)]);
        Region {
            loops: vec![outer, window],
        }
    }

    #[test]
    fn a_face_begins_free_and_its_window_occupied() {
        let map = FaceMap::new(&wall(), (W, 8.0), None);
        assert_eq!(
            map.coverage(&rectangle((0.0, 0.0), (1.0, 0.5))),
            Coverage::Free
        );
        assert_eq!(
            map.coverage(&rectangle((1.0, 0.5), (2.0, 1.5))),
            Coverage::Occupied
        );
        assert_eq!(
            map.coverage(&rectangle((0.75, 0.5), (1.25, 0.75))),
            Coverage::Partly
        );
        assert_eq!(
            map.coverage(&rectangle((-0.25, 0.5), (0.25, 0.75))),
            Coverage::Partly
        );
        assert_eq!(
            map.coverage(&rectangle((3.5, 0.5), (4.0, 0.75))),
            Coverage::Occupied
        );
        assert!((map.area() - 5.0).abs() < 1e-9 && (map.gap() - 5.0).abs() < 1e-9);
        assert!((map.bitmap().empty_area() - 5.0).abs() < 0.05);
    }

    #[test]
    fn claims_and_gap_make_the_face() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        for period in [None, Some(3.0)] {
            let mut map = FaceMap::new(&wall(), (W, 8.0), period);
            // Rows of bricks with slanted ends that do not overlap. Some reach beyond the border.
            for row in 0..16 {
                let y = 0.125 * f64::from(row);
                let mut s = -0.1 * random.unit();
                let start = s;
                for cell in 0.. {
                    let end = s + 0.1 + 0.3 * random.unit();
                    if end > if period.is_some() { start + 3.0 } else { 3.2 } {
                        break;
                    }
                    let corners = ring(&[
                        (s, y),
                        (end, y),
                        (end + 0.03, y + 0.125),
                        (s + 0.03, y + 0.125),
                    ]);
                    map.claim(&Footprint::new(&corners).unwrap(), 100 * row + cell);
                    s = end;
                }
            }
            assert!(map.overlap() < 1e-9, "{}", map.overlap());
            let sum = map.claimed() + map.gap();
            assert!((sum - map.area()).abs() < 1e-6, "{sum} {}", map.area());
            assert!(map.gap() > 0.01);
            // One more claim on top is all overlap.
            let extra = rectangle((0.2, 0.1), (0.7, 0.3));
            let covered = map.claims().shared_area(&extra, None);
            map.claim(&extra, u32::MAX - 1);
            assert!(
                (map.overlap() - covered).abs() < 1e-9,
                "{} {covered}",
                map.overlap()
            );
        }
    }

    #[test]
    fn a_claim_over_the_seam_of_a_cylinder_is_met_from_both_sides() {
        let mut map = FaceMap::new(&wall(), (W, 8.0), Some(3.0));
        map.claim(&rectangle((2.75, 0.0), (3.25, 0.25)), 1);
        for place in [
            rectangle((2.75, 0.0), (3.0, 0.25)),
            rectangle((0.0, 0.0), (0.25, 0.25)),
        ] {
            assert_eq!(map.coverage(&place), Coverage::Occupied);
            assert!((map.claimed_share(&place) - 1.0).abs() < 1e-9);
        }
        assert!((map.claimed() - 0.125).abs() < 1e-9 && map.overlap() < 1e-12);
    }

    #[test]
    fn free_places_over_the_seam_of_a_cylinder_are_free() {
        let mut map = FaceMap::new(&wall(), (W, 8.0), Some(3.0));
        // Some of them reach over the seam by less than a pixel.
        for over in [0.001, 0.01, 0.06, 0.12, 0.124] {
            // Places are asked for on the turn on which their centres lie.
            let s = if 2.0 * over < W { -over } else { 3.0 - over };
            let low = DVec2::new(s, 0.25);
            let place = GridPlace::new(low, low + W).unwrap();
            assert_eq!(map.coverage_of(&place), Coverage::Free, "{over}");
        }
        map.claim(&rectangle((0.0, 0.25), (0.07, 0.25 + W)), 1);
        let low = DVec2::new(-0.06, 0.25);
        let place = GridPlace::new(low, low + W).unwrap();
        assert_eq!(map.coverage_of(&place), Coverage::Partly);
    }

    #[test]
    fn cells_are_clipped_by_holes_surroundings_and_claims() {
        use crate::masonry::free_space::{LEAST_SHARE, clip};
        let mut map = FaceMap::new(&wall(), (W, 8.0), None);
        map.claim(&rectangle((0.0, 1.0), (0.25, 1.25)), 1);
        let cell = rectangle((-0.25, 1.0), (1.25, 1.25));
        let part = clip(&cell, &map.obstacles(&cell), 0.005, LEAST_SHARE).unwrap();
        assert!((part.area() - 0.75 * 0.25).abs() < 1e-6, "{}", part.area());
        assert!(map.claims().shared_area(&part, None) < 1e-9);
    }
}
