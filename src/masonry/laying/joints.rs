//! Moves joints of rows of bricks beside arches, so that few thin pieces are left there.
//!
//! The grid of a wall and the curve of an arch have nothing in common, so some joint of a row often meets the arch just
//! before the row ends there. A mason then moves that joint, and cuts two bricks to pieces of about equal size, or lays
//! one brick in the place of both.

use super::faces::GridBrick;
use super::site::Site;
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::grid_place::GridPlace;
use crate::masonry::occupancy::Coverage;
use crate::masonry::plan::is_wall;
use smallvec::{SmallVec, smallvec};
use std::ops::Range;

/// A piece is thin if it is narrower than this, in half bricks.
const THIN: f64 = 0.48;
/// The greatest length of a piece, in half bricks.
const LONGEST: f64 = 2.7;
/// Moved joints lie at multiples of this, in half bricks.
const STEP: f64 = 0.125;
/// Moved joints are at least this far from those of the next rows, in half bricks.
const APART: f64 = 0.2;
/// How much wider the narrowest piece must become for joints to move, in half bricks.
const GAIN: f64 = 0.03;
/// How much area moved joints may lose, in areas of half bricks.
const LOSS: f64 = 0.02;

/// Widths of pieces are compared in steps of a metre over this.
const WIDTHS: f64 = 500.0;

/// Widths that differ by less may be equal but for rounding (metres).
const ROUNDING: f64 = 1e-9;

/// Places of bricks in a row that lie beside each other.
type BrickPlaces = SmallVec<[GridPlace; 2]>;

/// How good places of bricks are, by the pieces that are laid in them.
#[derive(Clone, Copy, Debug)]
struct RowFit {
    /// The least width of a piece (metres).
    width: f64,
    /// The length of the longest piece (metres).
    length: f64,
    /// The area of all pieces, and of the smallest one (square metres).
    areas: [f64; 2],
}

impl Site {
    /// The bricks of a row of a wall with joints moved where a piece would be thin.
    pub(super) fn evened(&self, id: FaceId, mut bricks: Vec<GridBrick>) -> Vec<GridBrick> {
        if !is_wall(self.face(id)) || !self.face(id).surface.is_flat() {
            return bricks;
        }
        let mut next = 0;
        while next < bricks.len() {
            let moved = self.moved_joint(id, &bricks, next);
            next += 1;
            if let Some((span, places)) = moved {
                next = span.start + places.len();
                let area = bricks[span.clone()].iter().map(GridBrick::pair_area);
                let area = area.fold(0.0, f64::max);
                let pieces = places.into_iter().map(|place| GridBrick {
                    place,
                    area,
                    is_pair: true,
                });
                bricks.splice(span, pieces);
            }
        }
        bricks
    }

    /// Better places for a brick with a thin piece and for one beside it: the numbers of the bricks that they replace,
    /// and the places. None if the brick has no thin piece, or if no places are better.
    fn moved_joint(
        &self,
        id: FaceId,
        bricks: &[GridBrick],
        k: usize,
    ) -> Option<(Range<usize>, BrickPlaces)> {
        let half = self.plan.module.half;
        let own = self.fit(id, &[bricks[k].place], 0.0);
        let own = own.filter(|own| own.width < THIN * half)?;
        let spans = [
            Some(k..k + 1),
            k.checked_sub(1).map(|before| before..k + 1),
            (k + 1 < bricks.len()).then_some(k..k + 2),
        ];
        let mut best: Option<([i64; 3], Range<usize>, BrickPlaces)> = None;
        for span in spans.into_iter().flatten() {
            let places: Vec<GridPlace> = bricks[span.clone()].iter().map(|b| b.place).collect();
            let Some(now) = self.fit(id, &places, 0.0) else {
                continue;
            };
            for places in divisions(&places, half) {
                // Narrower pieces are not better, or not the best ones.
                let so_far = best.as_ref().map_or(0, |([width, ..], ..)| *width);
                let least = own.least_gain(half).max(RowFit::least_width(so_far));
                let fit = self.fit(id, &places, least - ROUNDING);
                let better = |fit: &RowFit| fit.is_better(&now, &own, half, &places);
                if let Some(fit) = fit.filter(better) {
                    let rank = fit.rank(places.len());
                    if best.as_ref().is_none_or(|(most, ..)| rank > *most) {
                        best = Some((rank, span.clone(), places));
                    }
                }
            }
        }
        best.map(|(_, span, places)| (span, places))
    }

    /// How good places are; none if nothing is laid in one of them, or a piece that is narrower than `least` (metres).
    fn fit(&self, id: FaceId, places: &[GridPlace], least: f64) -> Option<RowFit> {
        let mut fit = RowFit {
            width: f64::MAX,
            length: 0.0,
            areas: [0.0, f64::MAX],
        };
        for place in places {
            // No piece is wider than its place.
            if (place.high - place.low).min_element() < least {
                return None;
            }
            let whole = place.footprint();
            let pieces = match self.faces[id.index()].coverage_of(place) {
                Coverage::Occupied => return None,
                Coverage::Free => smallvec![whole],
                Coverage::Partly => self.free_parts(id, &whole),
            };
            pieces.iter().for_each(|piece| fit.add(piece));
            if pieces.is_empty() || fit.width < least {
                return None;
            }
        }
        Some(fit)
    }
}

impl RowFit {
    fn add(&mut self, piece: &Footprint) {
        let ([low, high], area) = (piece.bounds(), piece.area());
        self.width = self.width.min(piece.least_width());
        self.length = self.length.max(high.x - low.x);
        self.areas = [self.areas[0] + area, self.areas[1].min(area)];
    }

    /// Pieces that are narrower are not better than these (metres).
    fn least_gain(&self, half: f64) -> f64 {
        self.width + GAIN * half
    }

    /// Narrower pieces have a lower rank than those whose rank begins with this number (metres).
    fn least_width(rank: i64) -> f64 {
        (rank as f64 - 0.5) / WIDTHS
    }

    /// Whether pieces in `places` are better than those of today, of which `own` is the thin one.
    fn is_better(&self, now: &Self, own: &Self, half: f64, places: &[GridPlace]) -> bool {
        let height = places[0].high.y - places[0].low.y;
        let is_short = self.length <= (LONGEST * half).max(now.length + 1e-9);
        let has_lost = now.areas[0] - self.areas[0] > LOSS * half * height;
        self.width > own.least_gain(half) && is_short && !has_lost
    }

    /// The greater, the better: by the least width ([`WIDTHS`]), by the number of places, and by the smallest area (1 square
    /// centimetre). Whole numbers, so that rounding decides nothing.
    fn rank(&self, places: usize) -> [i64; 3] {
        let [width, area] = [WIDTHS * self.width, 1e4 * self.areas[1]].map(f64::round);
        [width as i64, -(places as i64), area as i64]
    }
}

/// The places that the space of one or two neighbours may be divided into: one, or two with a joint between them that
/// keeps away from those of the next rows.
fn divisions(places: &[GridPlace], half: f64) -> Vec<BrickPlaces> {
    let Some(whole) = places[1..]
        .iter()
        .try_fold(places[0], |whole, place| whole.with(place))
    else {
        return Vec::new();
    };
    let joint = places[0].high.x;
    let step = STEP * half;
    let count = ((whole.high.x - whole.low.x) / step).floor() as i64;
    let shifts = (-count..=count).filter(|shift| {
        let by = *shift as f64 * STEP;
        // Joints of the next rows are a column away from those of this row.
        ((by.abs() % 2.0) - 1.0).abs() >= APART
    });
    let divided = shifts.filter_map(|shift| {
        let at = joint + shift as f64 * step;
        let (mut first, mut second) = (whole, whole);
        (first.high.x, second.low.x) = (at, at);
        let are_wide = [first, second]
            .iter()
            .all(|part| part.high.x - part.low.x > THIN * half);
        are_wide.then(|| smallvec![first, second])
    });
    let one: BrickPlaces = smallvec![whole];
    std::iter::once(one).chain(divided).collect()
}
