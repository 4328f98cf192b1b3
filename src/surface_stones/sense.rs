//! Makes the axes of cells on a surface agree, so that scales lean one way.
//!
//! If a flow is given, each cell takes the axis nearest to it: one of four for a square, of two for other cells.
//! Where the flow is unknown, axes are carried from cell to cell. Without any flow all axes agree as well as possible
//! ([`crate::solid::oriented`] on the surface's graph).

use super::links::spread;
use crate::solid::{Axis, best_turn, quarters, turns_to_agree};
use crate::surface_cells::SurfaceCell;
use crate::trimesh::{SurfacePoint, TangentFrame, log};
use glam::DVec2;
use std::cell::RefCell;

/// A flow: the direction at a point of the surface, in the point's tangent frame and of any length. `None` where it is
/// unknown.
pub type Flow<'a> = &'a dyn Fn(&SurfacePoint) -> Option<DVec2>;

/// Turns the axes of cells, by quarter turns for squares and half turns for others. `links` are the neighbours by
/// index, see [`super::links`].
pub fn make_one_sense(cells: &mut [SurfaceCell], links: &[Vec<u32>], flow: Flow) {
    let axis = |cell: &SurfaceCell| Axis {
        along: cell.axis,
        is_stiff: cell.kind.symmetry() != 4,
    };
    let axes: Vec<Axis> = cells.iter().map(axis).collect();
    let turns = turns(cells, &axes, links, flow);
    for (cell, turn) in cells.iter_mut().zip(turns) {
        cell.axis = quarters(cell.axis, turn);
    }
}

fn turns(cells: &[SurfaceCell], axes: &[Axis], links: &[Vec<u32>], flow: Flow) -> Vec<u8> {
    let wanted = |cell: &SurfaceCell| {
        let along = flow(&cell.centre)?.normalize_or_zero();
        (along != DVec2::ZERO && along.is_finite()).then_some(along)
    };
    let wanted: Vec<Option<DVec2>> = cells.iter().map(wanted).collect();
    let carried = |to: usize, from: usize, v: DVec2| carried(&cells[to], &cells[from], v);
    if wanted.iter().all(Option::is_none) {
        return turns_to_agree(axes, links, carried);
    }
    let step = |k: usize| if axes[k].is_stiff { 2 } else { 1 };
    let own = |k: usize| wanted[k].map_or(0, |way| best_turn(way, axes[k].along, step(k)).0);
    let turns = RefCell::new((0..cells.len()).map(own).collect::<Vec<u8>>());
    let best = |from: usize, to: usize| {
        let standing = quarters(axes[from].along, turns.borrow()[from]);
        best_turn(carried(to, from, standing), axes[to].along, step(to))
    };
    let known = wanted.iter().map(Option::is_some).collect();
    spread(
        links,
        known,
        |from, to| best(from, to).1,
        |from, to| {
            let turn = best(from, to).0;
            turns.borrow_mut()[to] = turn;
        },
    );
    turns.into_inner()
}

/// Carries a vector from the tangent frame of `from` to that of `to`.
fn carried(to: &SurfaceCell, from: &SurfaceCell, v: DVec2) -> DVec2 {
    match log(&to.centre, &from.centre) {
        Some(way) => way.turn.apply(v),
        None => {
            let [own, other] = [to, from].map(|cell| TangentFrame::of(cell.centre.normal));
            own.turn_from(&other).apply(v)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{rows, torus};
    use super::super::links;
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_flow_gives_the_sense_and_is_carried_where_there_is_none() {
        let rows = rows([24, 10], [true, true]);
        let shape = torus(0.4);
        let mut cells = rows.cells(&shape);
        let wanted: Vec<DVec2> = cells.iter().map(|cell| cell.axis).collect();
        for (k, cell) in cells.iter_mut().enumerate() {
            cell.axis = crate::solid::quarters(cell.axis, (k * k % 7) as u8);
        }
        let scrambled = cells.clone();
        let links = links(&cells);
        assert!(links.iter().all(|list| list.len() == 8));
        let around = |p: &SurfacePoint| {
            let along = DVec3::new(p.at.z, 0.0, -p.at.x);
            Some(TangentFrame::of(p.normal).within(along))
        };
        let half = |p: &SurfacePoint| around(p).filter(|_| p.at.x > 0.9);
        let nowhere = |_: &SurfacePoint| None;
        for (which, flow) in [&around as Flow, &half, &nowhere].into_iter().enumerate() {
            cells.clone_from(&scrambled);
            make_one_sense(&mut cells, &links, flow);
            let mut agreeing = 0;
            for (k, list) in links.iter().enumerate() {
                let own =
                    wanted[k].perp_dot(cells[k].axis).abs() + wanted[k].dot(cells[k].axis).abs();
                assert!((own - 1.0).abs() < 1e-9);
                for &j in list {
                    // All axes point along the torus, or all against it.
                    let [a, b] = [k, j as usize].map(|k| cells[k].axis.dot(wanted[k]));
                    agreeing += usize::from((a - b).abs() < 1e-6);
                }
            }
            assert_eq!(agreeing, 8 * cells.len(), "{which}");
            if which < 2 {
                let same = cells
                    .iter()
                    .zip(&wanted)
                    .all(|(cell, w)| cell.axis.dot(*w) > 0.999);
                assert!(same, "{which}");
            }
        }
    }
}
