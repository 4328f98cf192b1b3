//! Overlays, which are drawn over a base.

use super::{Overlay, Pavement, PavementView, Stage};
use crate::draw::{self, Board, Sketch, size::HeatMap};
use crate::generators::Engine;
use crate::packing::{Packing, stress};

impl Pavement {
    /// The overlays of a view on a board. Each one appears as soon as the present pavement has something to show in it.
    pub(super) fn sketch_over(
        &mut self,
        view: PavementView,
        mut board: Board,
        heat: &mut HeatMap,
    ) -> Sketch {
        let mut layers = Vec::new();
        let (side, scale) = (self.side(), board.scale());
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
            let loads = loads.unwrap_or_default();
            let made = &self.made;
            let Some((domain, fields)) = made.ground() else {
                break;
            };
            layers.extend(match overlay {
                Overlay::Size => {
                    // While a new domain has no fields of its own yet, the colours of the last fields stay.
                    let revision = made.fields.revision();
                    heat.draw(&mut board, revision, side, domain, fields);
                    Vec::new()
                }
                Overlay::Packed => {
                    let packing = self.held().or(made.shown_packing()).filter(|_| packs);
                    let particles = packing.map_or(Vec::new(), Packing::particles);
                    let stress = stress(domain, &particles);
                    draw::over::packed(&particles, &stress, scale)
                }
                Overlay::Energy => draw::forces::energy(&loads, scale),
                Overlay::Forces => draw::forces::forces(&loads),
                Overlay::Cells if celled => draw::over::cells(made.cells()).into(),
                Overlay::Mesh if meshed => made
                    .mesh()
                    .map_or(Vec::new(), |mesh| draw::over::mesh(mesh, fields)),
                Overlay::Cells | Overlay::Mesh => Vec::new(),
                Overlay::Anisotropy => draw::over::anisotropy(domain, fields, side as f64, scale),
                Overlay::Direction => draw::field::direction_over(domain, fields, side as f64),
                Overlay::Singularities => draw::field::singularities(domain, fields, side as f64),
            });
        }
        Sketch::new(board, layers)
    }
}
