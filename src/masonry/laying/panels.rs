//! Panels: insets of another bond in a face (Legakis, Dorsey, Gortler 2001, section 5.5, fig. 8e).

use super::cell::{CellSort, Feature};
use super::site::Site;
use super::weave::Weave;
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::tree::GeneratorNode;

/// The fewest columns of a face with a panel: two of the panel, and two on each side, which the bricks of edges need.
const LEAST: usize = 6;
/// The value of `bond` for basket weave.
const BASKET: usize = 1;

impl Site {
    /// Lays a panel in the middle of a face, in a rectangle of whole columns and rows. False if it does not fit: the
    /// face has fewer than six columns, or something lies in the rectangle.
    pub fn panel(&mut self, id: FaceId, node: &GeneratorNode) -> bool {
        let module = self.plan.module;
        let weave = Weave::new(2.0 * module.half, module.course);
        let is_basket = node.count("bond") == BASKET;
        // A square of a basket weave is this many rows high.
        let unit = if is_basket { weave.count() } else { 1 };
        let Some(place) = self.panel_place(id, node, unit) else {
            return false;
        };
        let pieces = if is_basket {
            weave.basket(&place)
        } else {
            weave.herringbone(&place)
        };
        let depth = self.depth(id);
        for (piece, share) in pieces {
            let sort = if share > 0.999 {
                CellSort::Whole
            } else {
                CellSort::Special
            };
            let draft = self.face_draft(id, &piece, depth, sort);
            self.place(Feature::Face(id), node, draft);
        }
        self.faces[id.index()].enclose(&place);
        true
    }

    /// The rectangle of a face's panel, with a multiple of `unit` rows; none if it does not fit.
    fn panel_place(&self, id: FaceId, node: &GeneratorNode, unit: usize) -> Option<Footprint> {
        let grid = self.plan.grid(id);
        let [columns, rows] = [grid.column_lines(), grid.row_lines()].map(|lines| lines.len() - 1);
        let margin = node.count("margin");
        // With an even number of columns on each side, every other row there has whole bricks only, and the rows
        // between have one half brick.
        let across = middle(columns, node.count("width"), (margin, 2))?;
        let within = middle(rows, node.count("height"), (margin, 1))?;
        // In the rows below and above, no head joint continues the panel's side.
        let is_met = |[from, to]: [usize; 2]| {
            let border = across[0] as isize;
            !grid.starts(border, from - 1) && !grid.starts(border, to)
        };
        let up = rows_within(within, unit, is_met)?;
        let [low, high] = grid.block(across, up);
        let place = self.home(id, Footprint::rectangle(low, high)?);
        (columns >= LEAST && self.is_free(id, &place)).then_some(place)
    }
}

/// The rows of a panel within a range: a multiple of `unit`, two at least. Rows that `is_met` accepts are preferred,
/// then the most rows, then those nearest to the range's middle.
fn rows_within(
    [low, high]: [usize; 2],
    unit: usize,
    is_met: impl Fn([usize; 2]) -> bool,
) -> Option<[usize; 2]> {
    let all = (low..high).flat_map(|from| (from + 2..=high).map(move |to| [from, to]));
    let whole = all.filter(|[from, to]| (to - from) % unit == 0);
    whole.min_by_key(|&[from, to]| {
        let [below, above] = [from - low, high - to];
        (!is_met([from, to]), below + above, below.abs_diff(above))
    })
}

/// The middle of `count` intervals: at most `most`, and at least two of them. The number left at each end is at least
/// `margin`, and a multiple of `step` if two remain then.
fn middle(count: usize, most: usize, (margin, step): (usize, usize)) -> Option<[usize; 2]> {
    let least = margin.max(count.saturating_sub(most).div_ceil(2));
    let even = least.next_multiple_of(step);
    let left = if 2 * even + 2 <= count { even } else { least };
    (2 * left + 2 <= count).then(|| [left, count - left])
}

#[cfg(test)]
mod tests {
    use super::{middle, rows_within};

    #[test]
    fn panels_are_in_the_middle_with_even_margins() {
        let across = |count| middle(count, 6, (2, 2));
        assert_eq!([4, 5].map(across), [None; 2]);
        assert_eq!(
            [6, 7, 8, 10, 14].map(across),
            [[2, 4], [2, 5], [2, 6], [2, 8], [4, 10]].map(Some)
        );
        // If no even margin fits, an odd one is used.
        assert_eq!(middle(8, 2, (2, 2)), Some([3, 5]));
        assert_eq!(middle(17, 12, (2, 1)), Some([3, 14]));
    }

    #[test]
    fn rows_of_panels_are_as_many_as_are_met_well() {
        let is_odd = |[from, to]: [usize; 2]| from % 2 == 1 && to % 2 == 0;
        assert_eq!(rows_within([2, 12], 1, is_odd), Some([3, 12]));
        assert_eq!(rows_within([3, 15], 3, is_odd), Some([5, 14]));
        // If no rows are met well, the best of the others are used.
        assert_eq!(rows_within([2, 5], 3, is_odd), Some([2, 5]));
        assert_eq!(rows_within([2, 4], 3, is_odd), None);
    }
}
