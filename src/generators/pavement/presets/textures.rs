//! Textures that repeat without a seam, to all sides, for use in other programs.

use super::Preset;

const TEXTURES: &str = "Seamless textures";

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    Preset::plain([TEXTURES, "arches", "Segmental arches"],
        "Granite setts in arcs that meet at right angles, as pavers lay them.",
        "v=1&tile=1&cs=26&spots=A6sGmzJ6sB.Ay5MmzJ6sB.A05MmzJ6sB.A05MmzJ6sB.Ay5MmzJ6sB.gggBrmzBmzJ6sB.Ay5MmzJ6sB.A05MmzJ6sB.A05MmzJ6sB.Ay5MmzJ6sB&dir=strokes&strokes=Am0O-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.A__vB-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD&reach=1&hs=24&dr=0.25&vary=1.2&az=215&el=36&amb=1.1&diff=1.25"),
    Preset::plain([TEXTURES, "wall", "Mossy wall"],
        "Rough blocks in level courses, moss in the joints.",
        "v=1&lines=A86DgggCA.___BqhHgggCA.___B4sGgggCA.___ByrHgggCA.___Bg3GgggCA.___B41HgggCA.___B6sGgggCA.___BqhHgggCA.___B41HgggCA&tile=1&cs=58&dir=constant&vs=0.18&seed=5&hs=42&dr=0.25&palette=mossy&ground=soil&moss=0.4&az=215&el=36&amb=1.1&diff=1.25"),
    Preset::plain([TEXTURES, "crazy", "Crazy paving"],
        "Sandstone as it breaks, fitted piece to piece.",
        "v=1&tile=1&kind=circle&cs=60&vs=0.33&seed=10&stone=flag&hs=13&dr=0.1&bh=0.08&palette=sandstone&vary=1.2&ground=mortar&az=215&el=38"),
    Preset::plain([TEXTURES, "python", "Python leather"],
        "Square scales on end, in brown lozenges.",
        "v=1&tile=1&cs=26&dir=constant&angle=45&stone=skin&sv=1.35&sr=0.6&tilt=0.12&sa=45&tc=0.3&flat=0.2&keel=0.2&af=0.03&palette=snake&ground=hide&gloss=glossy&pattern=rosettes&pn=0.5&el=36"),
    Preset::plain([TEXTURES, "fans", "Fans"],
        "Basalt setts in scallops, each with a pale border.",
        "v=1&lines=-E44N4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.8JA4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.j2vBggQ4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.8JA4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.j2vCggQ4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.8JA4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.j2vBggQ4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE.8JA4oBpsE6uCh7DmuD1_C4kE58BywE7UywE8U4kE68BmuD2_C6uCi7D4oBqsE&tile=1&cs=19&hs=12&palette=basalt&vary=0.8&pattern=lines&pn=0.03&pm=0.9&az=215&el=36&amb=1.1&diff=1.25"),
    Preset::plain([TEXTURES, "flags", "Limestone flags"],
        "Sawn slabs in courses, laid in mortar.",
        "v=1&lines=A86DgggCA.___BqhHgggCA.___B4sGgggCA.___ByrHgggCA.___Bg3GgggCA.___B41HgggCA.___B6sGgggCA.___BqhHgggCA.___B41HgggCA&tile=1&kind=rectangle&ca=1.8&cs=54&dir=constant&vs=0.12&seed=3&stone=flag&sv=0.98&hs=16&dr=0.12&bh=0.1&palette=limestone&vary=1.2&ground=mortar&soft=0.4&az=215&el=44&amb=1.3&diff=1.15&occl=0.7"),
    Preset::plain([TEXTURES, "street", "Cobbled street"],
        "Worn granite in plain rows, dust in the joints.",
        "v=1&tile=1&cs=37&dir=constant&vs=0.12&seed=2&hs=26&vary=1.2&ground=soil&wear=0.5&dirt=0.3&az=215&el=36&amb=1.1&diff=1.25"),
    Preset::plain([TEXTURES, "leather", "Crocodile leather"],
        "Plates of the belly pass into the small scales of the flanks, and back.",
        "v=1&tile=1&cs=44&gx=0.45&dir=constant&vs=0.12&seed=3&stone=skin&sv=1.2&sr=0.3&tc=0.15&flat=0.55&keel=0.15&af=0.03&palette=crocodile&ground=hide&gloss=glossy&rim=0.35&belly=0.7&ba=0&el=36&amb=1.15&diff=1.35"),
    Preset::plain([TEXTURES, "pangolin", "Pangolin"],
        "Horny scales with growth rings lie over each other like tiles on a roof.",
        "v=1&tile=1&kind=ellipse&ca=1.25&cs=52&dir=constant&angle=90&stone=skin&sv=1.75&sr=0.8&sc=1.8&tilt=0.16&sa=-90&tc=0.5&rings=5&fd=1.3&af=0.04&palette=pangolin&ground=hide&rim=0.2&el=36&amb=1.1&diff=1.4"),
];
