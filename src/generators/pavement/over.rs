//! Overlays, which are drawn over a base.

use super::{Overlay, Pavement, PavementView, Stage};
use crate::draw::{self, Board, size::HeatMap};
use crate::generators::Engine;
use crate::packing::{Packing, stress};

impl Pavement {
    /// Draws the overlays of a view. Each one appears as soon as the present pavement has something to show in it.
    pub(super) fn draw_over(&mut self, view: PavementView, board: &mut Board, heat: &mut HeatMap) {
        let side = self.side();
        let [meshed, celled] = [Stage::Mesh, Stage::Cells].map(|stage| self.is_past(stage));
        let packs = self.packs();
        let domain = self.made.domain.made();
        if domain.is_some_and(|domain| domain.space().period().is_some()) {
            board.repeat();
        }
        for overlay in view.overlays() {
            let loads = match overlay {
                Overlay::Energy | Overlay::Forces if packs => self.packing_mut(),
                _ => None,
            };
            let loads = loads.map(|(packing, domain)| packing.net_forces(domain));
            let made = &self.made;
            let Some((domain, fields)) = made.ground() else {
                return;
            };
            match overlay {
                Overlay::Size => {
                    // In a new domain the last fields keep their colours.
                    let revision = made.fields.revision();
                    heat.draw(board, revision, side, domain, fields);
                }
                Overlay::Packed => {
                    let packing = self.held().or(made.shown_packing()).filter(|_| packs);
                    let particles = packing.map_or(Vec::new(), Packing::particles);
                    let stress = stress(domain, &particles);
                    board.draw(&draw::over::packed(&particles, &stress));
                }
                Overlay::Energy | Overlay::Forces => {
                    let of_loads = match overlay {
                        Overlay::Energy => draw::forces::energy,
                        _ => draw::forces::forces,
                    };
                    board.draw(&of_loads(&loads.unwrap_or_default()));
                }
                Overlay::Cells if celled => board.draw(&draw::over::cells(made.cells())),
                Overlay::Mesh if meshed => {
                    if let Some(mesh) = made.mesh() {
                        board.draw(&draw::over::mesh(mesh, fields));
                    }
                }
                Overlay::Cells | Overlay::Mesh => {}
                Overlay::Anisotropy => {
                    board.draw(&draw::over::anisotropy(domain, fields, side as f64));
                }
                Overlay::Direction => {
                    board.draw(&draw::field::direction_over(domain, fields, side as f64));
                }
                Overlay::Singularities => {
                    board.draw(&draw::field::singularities(domain, fields, side as f64));
                }
            }
        }
    }
}
