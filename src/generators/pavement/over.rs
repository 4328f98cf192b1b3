//! Overlays: what is drawn over a base.

use super::{Overlay, Pavement, Stage, View};
use crate::generators::common;
use crate::packing::Packing;
use crate::render::overlay::Board;
use crate::render::overlay_size::Veil;
use crate::render::overlay_stress::stress;
use crate::render::{overlay_field, overlay_loads, overlay_over};

impl Pavement {
    /// Draws a view's overlays, each as soon as there is something to show of the pavement at work.
    pub(super) fn draw_over(&mut self, view: View, board: &mut Board, veil: &mut Veil) {
        let side = common::side(&self.working.recipe);
        let [meshed, celled] = [Stage::Mesh, Stage::Cells].map(|stage| self.is_past(stage));
        let packs = self.made.is_packing();
        let domain = self.made.terrain.domain.made();
        if domain.is_some_and(|domain| domain.period().is_some()) {
            board.repeat();
        }
        for overlay in view.overlays() {
            let loads = match overlay {
                Overlay::Energy | Overlay::Forces if packs => self.made.packing_mut(),
                _ => None,
            };
            let loads = loads.map(|(packing, domain)| packing.loads(domain));
            let made = &self.made;
            let Some((domain, fields)) = made.terrain.made() else {
                return;
            };
            match overlay {
                Overlay::Size => {
                    veil.lay(board, made.terrain.revision(), side, domain, fields);
                }
                Overlay::Packed => {
                    let packing = made.packing().filter(|_| packs);
                    let particles = packing.map_or(Vec::new(), Packing::particles);
                    overlay_over::packed(board, &particles, &stress(domain, &particles));
                }
                Overlay::Energy | Overlay::Forces => {
                    let draw = match overlay {
                        Overlay::Energy => overlay_loads::energy,
                        _ => overlay_loads::forces,
                    };
                    draw(board, &loads.unwrap_or_default());
                }
                Overlay::Cells if celled => overlay_over::cells(board, made.cells()),
                Overlay::Mesh if meshed => {
                    if let Some(mesh) = made.mesh() {
                        overlay_over::mesh(board, mesh, fields);
                    }
                }
                Overlay::Cells | Overlay::Mesh => {}
                Overlay::Anisotropy => overlay_over::anisotropy(board, domain, fields, side as f64),
                Overlay::Direction => {
                    overlay_field::direction_over(board, domain, fields, side as f64);
                }
                Overlay::Singularities => {
                    overlay_field::singularities(board, domain, fields, side as f64);
                }
            }
        }
    }
}
