//! Why a view or an overlay shows nothing.

use super::{Base, Overlay, Pavement, PavementView, Stage};
use crate::domain::Domain;
use crate::draw;
use glam::DVec2;

/// Why a view or an overlay shows nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Absence {
    /// The content has not been made yet.
    NotYet,
    /// No force on a cell is large enough for an arrow.
    AtRest,
    /// The direction field has no singular point.
    NoPoint,
    /// There are too few cells for a mesh.
    NoMesh,
    /// The size field is constant.
    OneSize,
    /// The aspect ratio is 1 everywhere.
    AllEven,
}

impl Absence {
    /// The page's word for the reason.
    pub fn word(self) -> &'static str {
        match self {
            Absence::NotYet => "not_yet",
            Absence::AtRest => "at_rest",
            Absence::NoPoint => "no_point",
            Absence::NoMesh => "no_mesh",
            Absence::OneSize => "one_size",
            Absence::AllEven => "all_even",
        }
    }
}

/// Places along a side of the picture at which fields are sampled.
const PLACES: usize = 32;
/// A field whose values differ by less than this counts as constant: aspect ratios, or sizes over the recipe's size.
const SAME: f64 = 0.01;

impl Pavement {
    /// The words of those parts of a view that show nothing, with the reasons. The base comes first, then the overlays
    /// in their order.
    pub(super) fn missing(&mut self, view: PavementView) -> Vec<(&'static str, Absence)> {
        let mut found = Vec::new();
        if let Some(why) = self.base_absence(view.base) {
            let word = Base::ALL.iter().find(|(base, _)| *base == view.base);
            found.extend(word.map(|&(_, word)| (word, why)));
        }
        for overlay in view.overlays() {
            if let Some(why) = self.overlay_absence(overlay) {
                let word = Overlay::ALL.iter().find(|(other, _)| *other == overlay);
                found.extend(word.map(|&(_, word)| (word, why)));
            }
        }
        found
    }

    fn base_absence(&mut self, base: Base) -> Option<Absence> {
        match base {
            Base::Auto | Base::Picture | Base::Paper | Base::Direction | Base::Potential => None,
            Base::Packed => self.overlay_absence(Overlay::Packed),
            Base::Cells => self.overlay_absence(Overlay::Cells),
            Base::Mesh => self.overlay_absence(Overlay::Mesh),
            _ => self.planes_to_show().is_none().then_some(Absence::NotYet),
        }
    }

    fn overlay_absence(&mut self, overlay: Overlay) -> Option<Absence> {
        let [packs, meshed, celled] = [
            self.packs(),
            self.is_past(Stage::Mesh),
            self.is_past(Stage::Cells),
        ];
        let not_yet = |there: bool| (!there).then_some(Absence::NotYet);
        if overlay == Overlay::Forces && packs {
            let packing = self.packing_mut();
            let loads = packing.map(|(packing, domain)| packing.net_forces(domain));
            let still = loads.is_some_and(|loads| draw::forces::at_rest(&loads));
            return still.then_some(Absence::AtRest);
        }
        let made = &self.made;
        let Some((domain, fields)) = made.ground() else {
            return Some(Absence::NotYet);
        };
        match overlay {
            Overlay::Packed | Overlay::Energy | Overlay::Forces => not_yet(packs),
            Overlay::Cells => not_yet(celled),
            Overlay::Mesh => not_yet(meshed).or_else(|| {
                let some = made.mesh().is_some_and(|mesh| !mesh.faces.is_empty());
                (!some).then_some(Absence::NoMesh)
            }),
            Overlay::Size => {
                let same = is_even(domain, &|p| fields.size(p) / fields.params().size, None);
                same.then_some(Absence::OneSize)
            }
            Overlay::Anisotropy => {
                let same = is_even(domain, &|p| fields.aspect(p), Some(1.0));
                same.then_some(Absence::AllEven)
            }
            Overlay::Direction => None,
            Overlay::Singularities => {
                let none = fields.singularities(domain).is_empty();
                none.then_some(Absence::NoPoint)
            }
        }
    }
}

/// Whether a field is about constant in the outline. If `wanted` is given, it must also have about this value.
fn is_even(domain: &Domain, field: &dyn Fn(DVec2) -> f64, wanted: Option<f64>) -> bool {
    let (low, high) = domain.bounds();
    let places = (0..PLACES * PLACES).map(|k| {
        let cell = DVec2::new((k % PLACES) as f64 + 0.5, (k / PLACES) as f64 + 0.5);
        low + (high - low) * cell / PLACES as f64
    });
    let values = places.filter(|&p| domain.contains(p)).map(field);
    let start = wanted.map_or((f64::MAX, f64::MIN), |wanted| (wanted, wanted));
    let (least, most) = values.fold(start, |(low, high), v| (low.min(v), high.max(v)));
    most - least < SAME
}
