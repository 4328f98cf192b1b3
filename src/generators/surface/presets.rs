//! Recipes with names: hides after figures 18 and 19 of Itoh, Miyata, Shimada (2003), Generation of Organic Textures
//! with Controlled Anisotropy and Directionality via Packing Rectangular and Elliptical Cells, and others; stones on
//! slopes and undulating ground, of which Miyata, Itoh, Shimada (2001), Reducing Human Labor Cost in Designing Pavement
//! Textures, section 4, speaks, and on things. The paper prints no seconds for its figures of legs.

use crate::generators::Preset;

const fn preset(
    [group, name, title]: [&'static str; 3],
    note: &'static str,
    link: &'static str,
) -> Preset {
    Preset {
        name,
        title,
        group,
        figure: "",
        note,
        link,
        timing: None,
    }
}

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    preset(
        ["Hides in the round", "saurian-leg", "Saurian leg"],
        "After figure 18 of 2003, which tells no seconds: keeled scales from the thigh to the toes.",
        "v=1&make=surface&form=leg&kind=rectangle&ca=1.3&cn=2860&taper=0.55&stone=skin&palette=crocodile&ground=hide&belly=0.5&ba=60",
    ),
    preset(
        ["Hides in the round", "lizard-leg", "Lizard's leg"],
        "After figure 19 of 2003: smooth ellipses, marked by a reaction and diffusion that runs around the leg.",
        "v=1&make=surface&form=leg&leg_toes=5&leg_bend=12&leg_girth=1.15&kind=ellipse&ca=1.5&cn=2200&taper=0.5&stone=skin&sc=0.6&tilt=0.2&keel=0&palette=lizard&ground=hide&gloss=glossy&pattern=turing&pn=0.06&pc=0.4",
    ),
    preset(
        ["Hides in the round", "dragon-tail", "Dragon's tail"],
        "Rows of scales that shrink to a quarter towards the tip.",
        "v=1&make=surface&form=tail&kind=rectangle&ca=1.3&cn=1270&taper=0.25&stone=skin&palette=dragon&ground=hide&gloss=glossy",
    ),
    preset(
        ["Hides in the round", "pangolin-ball", "Pangolin, rolled up"],
        "Horny scales, each over the next, around a body that hides its belly.",
        "v=1&make=surface&form=horn&horn_turns=1.2&horn_rise=0&horn_taper=0.35&horn_girth=0.85&kind=ellipse&ca=1.2&cn=420&taper=0.5&stone=skin&sv=1.5&sc=1.2&tilt=0.3&palette=pangolin&ground=hide",
    ),
    preset(
        ["Hides in the round", "coral-snake", "Coral snake"],
        "Diamond rows all around, and bands that close into rings.",
        "v=1&make=surface&form=tail&tail_curl=450&tail_taper=0.3&tail_girth=0.08&tail_lift=0.25&kind=rectangle&ca=1.6&cn=3200&taper=0.6&angle=45&stone=skin&sr=0.3&sc=0.5&tilt=0.15&keel=0.2&palette=coral&ground=hide&gloss=glossy&pattern=bands&pn=0.2",
    ),
    preset(
        ["Hides in the round", "koi-round", "Koi"],
        "White and orange scales from the mouth over the fins.",
        "v=1&make=surface&form=fish&kind=circle&cn=2400&stone=skin&sr=0.3&sc=0.5&tilt=0.15&keel=0&palette=koi&ground=hide&gloss=wet&pattern=blotches&pn=0.3",
    ),
    preset(
        ["Hides in the round", "turtle-back", "Turtle's back"],
        "Sixty scutes with rings of growth.",
        "v=1&make=surface&form=turtle&kind=circle&cn=60&stone=skin&sr=0.25&sc=0&tilt=0&flat=0.7&keel=0&rings=7&palette=tortoise&ground=hide",
    ),
    preset(
        ["Hides in the round", "feathered-knot", "Feathered knot"],
        "Long ellipses follow a knot without beginning or end.",
        "v=1&make=surface&form=knot&kind=ellipse&cn=2450&stone=skin&keel=0.15&palette=fish&ground=hide&gloss=glossy",
    ),
    preset(
        ["Hides in the round", "beaded-fish", "Beaded creature"],
        "Circles as small as the bending asks: beads crowd where the body is thin.",
        "v=1&make=surface&form=fish&kind=circle&cn=1800&cc=12&ch=1.6&stone=skin&sv=0.98&sc=0&tilt=0&tc=0.35&keel=0&palette=coral&ground=dark&gloss=glossy",
    ),
    preset(
        ["Hides in the round", "dragon-egg", "Dragon's egg"],
        "Scales that grow smaller upwards, with a gleam.",
        "v=1&make=surface&form=egg&kind=ellipse&ca=1.5&cn=900&taper=0.5&along=up&stone=skin&keel=0.3&palette=dragon&ground=hide&gloss=glossy",
    ),
    preset(
        ["Hides in the round", "cone-round", "Pine cone"],
        "Woody scales around the cone.",
        "v=1&make=surface&form=egg&egg_height=1.6&egg_point=0.4&kind=rectangle&ca=1&cn=500&taper=0.6&along=up&stone=skin&sr=0.6&sc=1.2&tilt=0.4&palette=cone&ground=hide",
    ),
    preset(
        ["Hides in the round", "pineapple", "Pineapple"],
        "Squares set on their corners make the spirals that one can count both ways.",
        "v=1&make=surface&form=egg&egg_height=1.5&egg_point=0.1&cn=420&angle=45&stone=skin&sr=0.6&sc=0.5&tilt=0.2&tc=0.55&keel=0.6&palette=desert&ground=hide",
    ),
    preset(
        ["Stones on surfaces", "cobbled-hill", "Cobbled hill"],
        "A lane between hills: setts follow it, moss lies in the hollow.",
        "v=1&make=surface&cn=1085&hs=0.5&ground=soil&moss=0.25",
    ),
    preset(
        ["Stones on surfaces", "brick-stairs", "Brick stairs"],
        "The surface is cut along its edges, so each tread and riser has rows of its own.",
        "v=1&make=surface&form=stairs&crease=cut&kind=rectangle&cn=915&dir=border&stone=flag&sv=0.93&hs=0.28&palette=terracotta&ground=mortar",
    ),
    preset(
        ["Stones on surfaces", "paved-slope", "Paved slope"],
        "Sandstone from one level to the next.",
        "v=1&make=surface&form=slope&kind=rectangle&ca=1.6&cn=700&stone=flag&sv=0.93&hs=0.3&palette=sandstone&wear=0.3",
    ),
    preset(
        ["Stones on surfaces", "tiled-ring", "Tiled ring"],
        "Marble tiles close around a ring both ways.",
        "v=1&make=surface&form=torus&cn=1210&stone=flag&sv=0.92&hs=0.15&palette=marble&ground=mortar&gloss=glossy",
    ),
    preset(
        ["Stones on surfaces", "mosaic-vase", "Mosaic vase"],
        "Small tiles around the lip and down inside.",
        "v=1&make=surface&form=vase&cn=3600&stone=flag&sv=0.93&hs=0.12&palette=marble&vary=1.4&ground=mortar&gloss=glossy&pattern=bands&pn=0.22&pa=90&pc=0.35",
    ),
    preset(
        ["Stones on surfaces", "tiled-dome", "Tiled dome"],
        "Courses rise to the crown, where three or five tiles meet.",
        "v=1&make=surface&form=egg&egg_height=0.8&egg_base=0.3&cn=2200&stone=flag&sv=0.95&hs=0.1&palette=slate&ground=mortar&gloss=glossy&pattern=bands&pn=0.2&pa=90",
    ),
    preset(
        ["Stones on surfaces", "drum", "Round tower"],
        "Limestone around a drum, cut along its rim.",
        "v=1&make=surface&form=cylinder&crease=cut&kind=rectangle&cn=700&dir=axis&angle=90&stone=flag&sv=0.93&hs=0.2&palette=limestone&ground=mortar&moss=0.2",
    ),
    preset(
        ["Stones on surfaces", "stone-letter", "Letter of stone"],
        "Slate over every edge of an A.",
        "v=1&make=surface&form=letter&cn=1400&stone=flag&hs=0.2&palette=slate",
    ),
];
