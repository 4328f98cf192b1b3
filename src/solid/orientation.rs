//! Orients the cells' axes consistently: neighbours point alike, so that scales lean the same way.
//!
//! Itoh, Miyata, Shimada (2003), section 6.1, take an oriented flow vector as given. Axes of cells have no
//! orientation: four directions of a square are equivalent, two of other cells. So neighbours are joined to
//! groups, the pairs with the best agreement first (Kruskal's spanning forest), and each cell is turned to
//! agree with the one it is joined to. Each group as a whole is then turned so that most of its cells keep
//! their axes. Beside a singular point two cells may agree the wrong way round; therefore a pair's agreement
//! is at most that of either cell with a common neighbour.

use crate::cells::Cell;
use crate::order;
use glam::DVec2;

/// The cells with their axes turned, by quarter turns for squares and by half turns for others, so that
/// neighbours point alike. `links` are the neighbours by index: see [`crate::cells::graph`]. Groups as a
/// whole follow `flow`, which gives a vector for each cell, or zero where it is unknown.
pub fn oriented(cells: &[Cell], links: &[Vec<u32>], flow: impl Fn(&Cell) -> DVec2) -> Vec<Cell> {
    let flow: Vec<DVec2> = cells.iter().map(flow).collect();
    let turns = turns_along(&axes(cells), links, &flow, |_, _, axis| axis);
    let turned = |(cell, turn): (&Cell, u8)| Cell {
        axis: quarters(cell.axis, turn),
        ..cell.clone()
    };
    cells.iter().zip(turns).map(turned).collect()
}

fn axes(cells: &[Cell]) -> Vec<Axis> {
    let axis = |cell: &Cell| Axis {
        along: cell.axis,
        is_stiff: cell.kind.symmetry() != 4,
    };
    cells.iter().map(axis).collect()
}

/// The axis of a cell on any domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    /// Unit vector, or zero, in the cell's own frame.
    pub along: DVec2,
    /// Whether the axis can be turned by half turns only.
    pub is_stiff: bool,
}

/// The number of quarter turns of each axis that makes neighbours point alike. `carried` takes two cells and
/// transports a vector from the second one's frame into the first one's; in the plane it is the identity.
#[cfg(house)]
pub(crate) fn turns_to_agree(
    axes: &[Axis],
    links: &[Vec<u32>],
    carried: impl Fn(usize, usize, DVec2) -> DVec2,
) -> Vec<u8> {
    let kept: Vec<DVec2> = axes.iter().map(|axis| axis.along).collect();
    turns_along(axes, links, &kept, carried)
}

/// Like `turns_to_agree`, but each group as a whole follows `flow`, the wanted direction of each axis.
fn turns_along(
    axes: &[Axis],
    links: &[Vec<u32>],
    flow: &[DVec2],
    carried: impl Fn(usize, usize, DVec2) -> DVec2,
) -> Vec<u8> {
    let mut groups = Groups {
        parent: (0..axes.len()).map(|k| (k, 0)).collect(),
        stiff: axes.iter().map(|a| a.is_stiff).collect(),
    };
    let mut pairs: Vec<(usize, usize, f64)> = Vec::new();
    let seen = |a: usize, b: usize| carried(a, b, axes[b].along);
    for (i, list) in links.iter().enumerate() {
        for j in list.iter().map(|&j| j as usize).filter(|&j| j > i) {
            let agreement = |a: usize, b: usize| best_turn(axes[a].along, seen(a, b), 1).1;
            let mut least = agreement(i, j);
            for k in list.iter().filter(|k| links[j].contains(k)) {
                let k = *k as usize;
                least = least.min(agreement(i, k)).min(agreement(j, k));
            }
            pairs.push((i, j, least));
        }
    }
    order::sort(&mut pairs, |&(i, j, agreement)| {
        (order::rank(-agreement), order::pair(i as u32, j as u32))
    });
    for (i, j, _) in pairs {
        groups.join(axes[i].along, seen(i, j), [i, j]);
    }
    let turns: Vec<(usize, u8)> = (0..axes.len()).map(|k| groups.root(k)).collect();
    let whole = whole_turns(axes, flow, &turns, &groups.stiff);
    let turn = |&(root, turn): &(usize, u8)| (turn + whole[root]) % 4;
    turns.iter().map(turn).collect()
}

/// The number of quarter turns of each group, by its root, with which most cells follow the flow.
fn whole_turns(axes: &[Axis], flow: &[DVec2], turns: &[(usize, u8)], stiff: &[bool]) -> Vec<u8> {
    let mut kept = vec![[0.0f64; 4]; axes.len()];
    for ((axis, flow), &(root, turn)) in axes.iter().zip(flow).zip(turns) {
        for whole in 0..4 {
            let now = quarters(axis.along, turn + whole);
            kept[root][usize::from(whole)] += now.dot(*flow);
        }
    }
    let best = |(root, kept): (usize, &[f64; 4])| {
        let step = if stiff[root] { 2 } else { 1 };
        let mut best = 0;
        for whole in (0..4).step_by(step) {
            // A margin, because groups that close in a circle would otherwise depend on rounding.
            if kept[whole] > kept[best] + 1e-6 {
                best = whole;
            }
        }
        best as u8
    };
    kept.iter().enumerate().map(best).collect()
}

/// A vector after a number of quarter turns from x towards y.
pub(crate) fn quarters(v: DVec2, count: u8) -> DVec2 {
    match count % 4 {
        0 => v,
        1 => v.perp(),
        2 => -v,
        _ => -v.perp(),
    }
}

/// The number of quarter turns of `b`, a multiple of `step`, that agrees best with `a`; and the agreement.
pub(crate) fn best_turn(a: DVec2, b: DVec2, step: u8) -> (u8, f64) {
    let mut best = (0, f64::MIN);
    for own in (0..4).step_by(usize::from(step)) {
        let agreement = a.dot(quarters(b, own));
        if agreement > best.1 + 1e-9 {
            best = (own, agreement);
        }
    }
    best
}

/// Cells joined to groups, each with its quarter turns relative to the group's root.
struct Groups {
    parent: Vec<(usize, u8)>,
    /// For roots: whether the group can be turned by half turns only.
    stiff: Vec<bool>,
}

impl Groups {
    fn root(&mut self, k: usize) -> (usize, u8) {
        let (mut root, mut turn) = (k, 0);
        while self.parent[root].0 != root {
            let (next, step) = self.parent[root];
            turn = (turn + step) % 4;
            root = next;
        }
        self.parent[k] = (root, turn);
        (root, turn)
    }

    /// Joins two cells with axes `own` and `seen`, both in the frame of the first one.
    fn join(&mut self, own: DVec2, seen: DVec2, [i, j]: [usize; 2]) {
        let ((a, turn), (b, other)) = (self.root(i), self.root(j));
        if a == b {
            return;
        }
        let step = if self.stiff[a] && self.stiff[b] { 2 } else { 1 };
        // In its group `j` is already turned by `other`; the whole group is turned by the rest.
        let standing = quarters(seen, other);
        let (more, _) = best_turn(quarters(own, turn), standing, step);
        // A stiff group is not turned.
        if self.stiff[b] {
            self.parent[a] = (b, (4 - more) % 4);
        } else {
            self.parent[b] = (a, more);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::CellKind;
    use crate::planar::unit_vector;

    fn ring(kind: CellKind, count: usize) -> (Vec<Cell>, Vec<Vec<u32>>) {
        let cell = |k: usize| {
            let angle = k as f64 / count as f64 * std::f64::consts::TAU;
            let out = unit_vector(angle);
            Cell {
                id: k as u32,
                centre: 100.0 * out,
                kind,
                size: 10.0,
                aspect: 1.0,
                axis: quarters(
                    out.perp(),
                    (k * k % 7) as u8 * if kind == CellKind::Square { 1 } else { 2 },
                ),
                ring: Vec::new(),
            }
        };
        let next = |k: usize| {
            let mut list = vec![((k + 1) % count) as u32, ((k + count - 1) % count) as u32];
            list.sort_unstable();
            list
        };
        (
            (0..count).map(cell).collect(),
            (0..count).map(next).collect(),
        )
    }

    #[test]
    fn flow_goes_round_a_ring() {
        for kind in [CellKind::Square, CellKind::Ellipse] {
            let (cells, links) = ring(kind, 40);
            let flow = oriented(&cells, &links, |cell| cell.axis);
            for k in 0..40 {
                let (a, b) = (flow[k].axis, flow[(k + 1) % 40].axis);
                assert!(a.dot(b) > 0.98, "{kind:?} {k}: {a} {b}");
                let turned = (0..4).any(|q| quarters(cells[k].axis, q) == flow[k].axis);
                assert!(turned);
            }
        }
    }

    #[test]
    fn what_agrees_stays_as_it_is() {
        let (mut cells, links) = ring(CellKind::Rectangle, 12);
        cells.iter_mut().for_each(|c| c.axis = DVec2::new(0.6, 0.8));
        assert_eq!(oriented(&cells, &links, |cell| cell.axis), cells);
        // With the reversed flow all are reversed.
        let back = oriented(&cells, &links, |cell| -cell.axis);
        let is_back = |(a, b): (&Cell, &Cell)| a.axis == -b.axis;
        assert!(back.iter().zip(&cells).all(is_back));
    }

    #[test]
    fn squares_beside_ellipses_give_way() {
        let (mut cells, links) = ring(CellKind::Square, 12);
        for cell in &mut cells {
            cell.axis = if cell.id < 6 { DVec2::X } else { DVec2::Y };
            cell.kind = if cell.id < 6 {
                CellKind::Square
            } else {
                CellKind::Ellipse
            };
        }
        let flow = oriented(&cells, &links, |cell| cell.axis);
        assert!(flow.iter().all(|c| c.axis.x.abs() < 1e-12), "{flow:?}");
    }
}
