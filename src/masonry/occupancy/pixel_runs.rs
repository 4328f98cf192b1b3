//! Rectangles of equal pixels of a face's map.

use super::bitmap::Bitmap;
use super::claims::Claims;
use glam::DVec2;
use std::collections::BTreeMap;

/// A rectangle of pixels that are all free, or that one cell has claimed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelRun {
    /// Its least (s, t), metres.
    pub low: DVec2,
    /// Its greatest (s, t), metres.
    pub high: DVec2,
    /// The number of the cell; none if the pixels are free.
    pub claim: Option<u32>,
    /// Columns and rows of pixels.
    size: [usize; 2],
}

impl PixelRun {
    /// The number of its pixels.
    pub fn count(&self) -> usize {
        self.size[0] * self.size[1]
    }
}

/// The first column of a run in a row and the column behind its last, and the claim.
type Span = ([usize; 2], Option<u32>);

impl Bitmap {
    /// The empty pixels of the map as rectangles. Each rectangle is free, or under a single claim; the last of several
    /// claims counts. Equal runs in neighbouring rows are joined.
    pub fn runs(&self, claims: &Claims) -> Vec<PixelRun> {
        let (owners, width) = self.owners(claims.list());
        let mut open: BTreeMap<Span, usize> = BTreeMap::new();
        let mut found = Vec::new();
        let rows = owners.len() / width;
        for row in 0..=rows {
            let pixels = &owners[row * width..((row + 1) * width).min(owners.len())];
            let spans = spans(pixels);
            let ended: Vec<Span> = open
                .keys()
                .filter(|span| spans.binary_search(span).is_err())
                .copied()
                .collect();
            for span in ended {
                let first = open.remove(&span).unwrap_or(row);
                found.push(self.run(span, [first, row]));
            }
            for span in spans {
                open.entry(span).or_insert(row);
            }
        }
        found
    }

    fn run(&self, ([from, to], claim): Span, [first, end]: [usize; 2]) -> PixelRun {
        PixelRun {
            low: self.corner([from, first]),
            high: self.corner([to, end]),
            claim,
            size: [to - from, end - first],
        }
    }
}

/// The runs of equal pixels in a row, by their columns.
fn spans(pixels: &[Option<Option<u32>>]) -> Vec<Span> {
    let mut found: Vec<Span> = Vec::new();
    for (column, pixel) in pixels.iter().enumerate() {
        let Some(claim) = *pixel else { continue };
        match found.last_mut() {
            Some(([_, to], own)) if *to == column && *own == claim => *to += 1,
            _ => found.push(([column, column + 1], claim)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::masonry::footprint::Footprint;
    use crate::masonry::occupancy::Claim;
    use crate::masonry::region::Region;

    #[test]
    fn runs_cover_each_pixel_once() {
        let ring = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let hole = [(0.5, 0.5), (0.5, 0.7), (0.7, 0.7), (0.7, 0.5)];
        let region = Region {
            loops: [ring, hole]
                .map(|ring| ring.map(DVec2::from).to_vec())
                .to_vec(),
        };
        let map = Bitmap::new(&region, 0.1);
        let mut claims = Claims::new([DVec2::ZERO, DVec2::ONE]);
        for (cell, from) in [(3, 0.0), (4, 0.2)] {
            let polygon = Footprint::rectangle(DVec2::new(from, 0.1), DVec2::new(from + 0.3, 0.4));
            claims.add(Claim {
                polygon: polygon.expect("a rectangle"),
                cell,
            });
        }
        let runs = map.runs(&claims);
        let count = |claim: Option<u32>| -> usize {
            let own = runs.iter().filter(|run| run.claim == claim);
            own.map(PixelRun::count).sum()
        };
        assert_eq!([count(Some(3)), count(Some(4)), count(None)], [6, 9, 81]);
        assert!(runs.iter().all(|run| run.low.cmplt(run.high).all()));
        assert_eq!(runs.iter().filter(|run| run.claim.is_some()).count(), 2);
    }
}
