//! Overlays: what is drawn over a base.

use super::{Overlay, Studio, View};
use crate::packing::Packing;
use crate::recipe::Stage;
use crate::render::overlay::Board;
use crate::render::overlay_size::Veil;
use crate::render::overlay_stress::stress;
use crate::render::{overlay_field, overlay_loads, overlay_over};

impl Studio {
    /// Draws a view's overlays, each as soon as there is something to show of the pavement at work.
    pub(super) fn draw_over(&mut self, view: View, board: &mut Board, veil: &mut Veil) {
        let side = self.side();
        // While the fields are made anew, the last ones are shown.
        let stamp = match self.is_past(Stage::Fields) {
            true => self.changes[..=Stage::Fields as usize].iter().sum(),
            false => veil.stamp(),
        };
        let [meshed, celled] = [Stage::Mesh, Stage::Cells].map(|stage| self.is_past(stage));
        let made = &mut self.made;
        let (Some(domain), Some(fields)) = (&made.domain, &made.fields) else {
            return;
        };
        if domain.period().is_some() {
            board.repeat();
        }
        let begun = made.packing_begun;
        let mut packing = made.packing.as_mut().filter(|_| begun);
        for overlay in view.overlays() {
            match overlay {
                Overlay::Size => veil.lay(board, stamp, side, domain, fields),
                Overlay::Packed => {
                    let particles = packing.as_deref().map_or(Vec::new(), Packing::particles);
                    overlay_over::packed(board, &particles, &stress(domain, &particles));
                }
                Overlay::Energy | Overlay::Forces => {
                    let loads = packing.as_deref_mut().map(|packing| packing.loads(domain));
                    let draw = match overlay {
                        Overlay::Energy => overlay_loads::energy,
                        _ => overlay_loads::forces,
                    };
                    draw(board, &loads.unwrap_or_default());
                }
                Overlay::Cells if celled => overlay_over::cells(board, &made.cells),
                Overlay::Mesh if meshed => {
                    if let Some(mesh) = &made.mesh {
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
