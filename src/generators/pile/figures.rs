//! The measures of a body, and the caption of a view.

use super::subject::ViewScene;
use super::views::PileView;
use super::{PileEngine, SCHEMA, keys};
use crate::component::Component;
use crate::notice::{Code, Notice};
use crate::pile::{Fate, Kind, contacts_of};

impl PileEngine {
    /// The measures of a body, words and numbers: its type and layer, from 1; how far it slid along the normal, and the
    /// ends of its range, in its diagonals; and how many other bodies it touches.
    pub(super) fn measures(&self, id: u32) -> Vec<(&'static str, f64)> {
        let (Some(body), Some(placed)) = (self.made.body(id), self.made.placed.made()) else {
            return Vec::new();
        };
        let kind = &placed.kinds[body.kind as usize];
        let diagonal = kind.shapes[body.shape as usize].diagonal * body.scale;
        let mut figures = vec![
            ("type", f64::from(body.kind) + 1.0),
            ("layer", f64::from(body.layer) + 1.0),
        ];
        if body.fate == Fate::Kept {
            figures.push(("slid", body.t / diagonal));
            figures.push(("inwards", body.range.0 / diagonal));
            figures.push(("outwards", body.range.1 / diagonal));
            let bodies = self.made.settled.made().map_or(&[][..], |s| s.bodies());
            let touched = contacts_of(body, bodies, &placed.kinds);
            figures.push(("touches", touched as f64));
        }
        figures
    }

    /// The word of a body's component.
    pub(super) fn named(&self, id: u32) -> Vec<(&'static str, String)> {
        let kind = self.made.body(id).map(|body| body.kind as usize);
        let word = kind.and_then(|kind| self.made.words().get(kind).copied());
        word.into_iter()
            .map(|word| ("type", word.to_owned()))
            .collect()
    }

    /// The caption of a view that is shown.
    pub(super) fn meaning(&self, words: &str) -> Option<Notice> {
        let view = PileView::of_words(words);
        let (key, subject) = self.picture.shown()?;
        let ViewScene::Diagram(diagram) = subject else {
            return None;
        };
        if key.view != view {
            return None;
        }
        match view {
            PileView::Darts => {
                let count = self.made.darts().darts.len();
                Some(Notice::new(Code::PileDarts).with("n", count))
            }
            PileView::Spheres => self.types(),
            PileView::Fates => Some(self.fates()),
            PileView::Overlap => {
                let deepest = crate::decimal::text_to(2, diagram.deepest?);
                Some(Notice::new(Code::PileOverlap).with("deepest", deepest))
            }
            _ => None,
        }
    }

    /// How many darts there were, and what became of them.
    fn fates(&self) -> Notice {
        let counts = [Fate::Kept, Fate::Merged, Fate::Walls, Fate::Removed];
        let [kept, merged, walls, removed] = counts.map(|fate| self.made.count(fate));
        Notice::new(Code::PileFates)
            .with("kept", kept)
            .with("merged", merged)
            .with("walls", walls)
            .with("removed", removed)
    }

    /// The numbers of all types.
    fn types(&self) -> Option<Notice> {
        let (kinds, components) = (
            &self.made.placed.made()?.kinds,
            self.made.components.made()?,
        );
        let words = self.made.words();
        let each = words.iter().zip(kinds.iter()).zip(components);
        let each = each.map(|((word, kind), variants)| of_type(word, kind, &variants.all[0]));
        let all: Vec<Notice> = each.collect();
        all.into_iter().rev().reduce(|others, first| {
            let notice = Notice::new(Code::PileTypes).with("first", first);
            notice.with("others", others)
        })
    }
}

/// The numbers of a type: R and d at its size, as the first variant has them, the number of its spheres, and the spacing
/// that follows from the component.
fn of_type(word: &'static str, kind: &Kind, component: &Component) -> Notice {
    let row = SCHEMA.row(keys::C1.0);
    let name = row.map_or_else(|| word.to_owned().into(), |row| row.word(word));
    let short = |number: f64| crate::decimal::text_to(2, number);
    Notice::new(Code::PileType)
        .with("name", name)
        .with("radius", short(kind.radius()))
        .with("diagonal", short(kind.diagonal()))
        .with("spheres", component.spheres.len())
        .with("spacing", short(component.density()))
}
