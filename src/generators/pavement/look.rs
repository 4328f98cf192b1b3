//! The words of views: a base, and overlays.
//!
//! Overlays have a fixed order, whatever the order of their words. On paper the first overlay is drawn in full colours.
//! Over any other base, overlays are light lines with dark rims, and their fillings are translucent.

/// The base of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// The packing as it forms, then the stones as they come, then the picture.
    Auto,
    /// The shaded picture.
    Picture,
    /// Paper with the bare outline.
    Paper,
    /// The packed cells in their shapes, on paper.
    Packed,
    /// The cells' polygons, on paper.
    Cells,
    /// The mesh of triangles and quadrilaterals, on paper.
    Mesh,
    /// The direction field, its sources, and its singular points, on paper.
    Direction,
    /// The bump plane in grey.
    Height,
    /// The bump plane's normals as colours.
    Normals,
    /// The colour plane, without light.
    Albedo,
    /// The roughness of the materials; white is rough.
    Roughness,
    /// The plane of ambient occlusion: white where all of the sky's light arrives.
    Occlusion,
    /// A colour for each stone.
    Ids,
    /// The potential around one cell of the recipe's kind.
    Potential,
}

/// A drawing over the base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The size in the field, as heat and contours.
    Size,
    /// The packed cells in their shapes, warm where pressed, cool where they have room.
    Packed,
    /// The potential energy of each packed cell.
    Energy,
    /// The cells' polygons.
    Cells,
    /// The mesh of triangles and quadrilaterals.
    Mesh,
    /// The aspect ratio in the field, as ellipses.
    Anisotropy,
    /// The direction field and its sources.
    Direction,
    /// The net force on each packed cell.
    Forces,
    /// The singular points of the direction with their index.
    Singularities,
}

/// A view: a base with overlays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PavementView {
    /// The base.
    pub base: Base,
    /// The overlays, a bit for each, by their indices in [`Overlay::ALL`].
    over: u16,
    /// The wanted number of pixels along a picture unit, 1 to 3.
    pub scale: u8,
}

impl Base {
    /// All bases with their words, in the order of the page, whose keys 0 to 9 select the first ten. A word that is
    /// also an overlay's, such as `mesh`, selects this base only if the view names no other base.
    pub const ALL: [(Base, &'static str); 14] = [
        (Base::Auto, "auto"),
        (Base::Picture, "picture"),
        (Base::Packed, "packed"),
        (Base::Cells, "cells"),
        (Base::Mesh, "mesh"),
        (Base::Direction, "direction"),
        (Base::Height, "height"),
        (Base::Normals, "normals"),
        (Base::Ids, "ids"),
        (Base::Potential, "potential"),
        (Base::Albedo, "albedo"),
        (Base::Roughness, "roughness"),
        (Base::Occlusion, "ao"),
        (Base::Paper, "paper"),
    ];
}

impl Overlay {
    /// All overlays with their words, in the order in which they are drawn.
    pub const ALL: [(Overlay, &'static str); 9] = [
        (Overlay::Size, "size"),
        (Overlay::Packed, "packed"),
        (Overlay::Energy, "energy"),
        (Overlay::Cells, "cells"),
        (Overlay::Mesh, "mesh"),
        (Overlay::Anisotropy, "anisotropy"),
        (Overlay::Direction, "direction"),
        (Overlay::Forces, "forces"),
        (Overlay::Singularities, "singularities"),
    ];

    const fn bit(self) -> u16 {
        1 << self as u16
    }

    /// The base that shows this overlay alone on paper, if there is such a base.
    const fn on_paper(self) -> Option<Base> {
        match self {
            Overlay::Packed => Some(Base::Packed),
            Overlay::Cells => Some(Base::Cells),
            Overlay::Mesh => Some(Base::Mesh),
            Overlay::Direction => Some(Base::Direction),
            _ => None,
        }
    }
}

impl Base {
    /// The words of the bases, in the order of [`Base::ALL`].
    pub(super) const WORDS: [&str; 14] = {
        let (mut words, mut k) = ([""; 14], 0);
        while k < 14 {
            words[k] = Base::ALL[k].1;
            k += 1;
        }
        words
    };
}

impl Overlay {
    /// The words of the overlays, in the order of [`Overlay::ALL`].
    pub(super) const WORDS: [&str; 9] = {
        let (mut words, mut k) = ([""; 9], 0);
        while k < 9 {
            words[k] = Overlay::ALL[k].1;
            k += 1;
        }
        words
    };
}

impl From<Base> for PavementView {
    fn from(base: Base) -> Self {
        Self {
            base,
            over: 0,
            scale: 1,
        }
    }
}

impl PavementView {
    /// The view of words joined by '+': at most one base, and overlays. Unknown words and further bases are ignored.
    /// Overlays without a base are drawn on paper, the first of them (in drawing order) in full colours if it is the
    /// packing, the cells, the mesh or the direction. Without any known word it is [`Base::Auto`]. The words 'x2' and
    /// 'x3' ask for two or three pixels along a picture unit.
    pub fn of_words(words: &str) -> PavementView {
        let (mut base, mut over, mut scale) = (None, 0, 1);
        for word in words.split('+') {
            if let [b'x', digit @ b'2'..=b'3'] = word.as_bytes() {
                scale = digit - b'0';
            } else if let Some((overlay, _)) = Overlay::ALL.iter().find(|(_, w)| *w == word) {
                over |= overlay.bit();
            } else if base.is_none() {
                let found = Base::ALL.iter().find(|(_, w)| *w == word);
                base = found.map(|&(base, _)| base);
            }
        }
        let view = |base: Base, over: u16| PavementView { base, over, scale };
        match base {
            // The potential is that of one cell, so overlays, which show the whole picture, do not fit it.
            Some(Base::Potential) => view(Base::Potential, 0),
            Some(base) => view(base, over),
            None => match view(Base::Paper, over).overlays().next() {
                None => view(Base::Auto, 0),
                Some(first) => match first.on_paper() {
                    None => view(Base::Paper, over),
                    Some(base) => view(base, over & !first.bit()),
                },
            },
        }
    }

    /// The overlays in the order in which they are drawn.
    pub fn overlays(self) -> impl Iterator<Item = Overlay> {
        let all = Overlay::ALL.iter().map(|&(overlay, _)| overlay);
        all.filter(move |&overlay| self.has(overlay))
    }

    /// Whether an overlay is drawn.
    pub fn has(self, overlay: Overlay) -> bool {
        self.over & overlay.bit() != 0
    }

    /// Whether nothing is drawn over the base.
    pub fn is_plain(self) -> bool {
        self.over == 0
    }
}
