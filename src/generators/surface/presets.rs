//! Recipes with names: hides after figures 18 and 19 of Itoh, Miyata, Shimada (2003), Generation of Organic Textures
//! with Controlled Anisotropy and Directionality via Packing Rectangular and Elliptical Cells, and others; stones on
//! slopes and undulating ground as in section 4 of Miyata, Itoh, Shimada (2001), Generating Pavement Textures via Close
//! Packing of Squares (in Japanese), and on things. The paper prints no seconds for its figures of legs.

use crate::generators::Preset;

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    Preset::plain(
        ["Hides in the round", "dragon-egg", "Dragon's egg"],
        "Scales that grow smaller upwards, from gold to crimson.",
        "v=1&make=surface&form=egg&kind=ellipse&ca=1.2&cn=520&taper=0.5&along=up&stone=skin&sv=1.45&sc=1.1&tilt=0.22&keel=0.5&palette=dragon&ground=hide&gloss=glossy&rim=-0.4&belly=0.9&ba=80&az=85&el=40&diff=1.25",
    ),
    Preset::plain(
        ["Hides in the round", "saurian-leg", "Saurian leg"],
        "After figure 18 of 2003, which tells no seconds: plates in columns from the cut thigh to the claws.",
        "v=1&make=surface&form=leg&ends=cut&kind=rectangle&ca=1.3&cn=2300&taper=0.45&stone=skin&sv=1.38&sr=0.35&sc=0.25&tilt=0.15&flat=0.25&palette=crocodile&vary=1.2&ground=hide&gloss=glossy&rim=0.3&soft=0.4&belly=0.9&ba=60&az=85&el=40&amb=1.15&diff=1.45",
    ),
    Preset::plain(
        ["Hides in the round", "cone-round", "Pine cone"],
        "Woody scales around the cone.",
        "v=1&make=surface&form=egg&egg_height=1.6&egg_point=0.4&kind=ellipse&ca=1.1&cn=300&taper=0.6&along=up&stone=skin&sv=1.5&sr=0.6&sc=1.1&tilt=0.35&fd=1.3&af=0.06&palette=cone&ground=hide&rim=-0.3&az=85&el=40&diff=1.35",
    ),
    Preset::plain(
        ["Hides in the round", "koi-round", "Koi"],
        "White and orange scales from the mouth over the fins.",
        "v=1&make=surface&form=fish&kind=ellipse&ca=1.2&cn=1900&stone=skin&sv=1.6&sr=0.25&sc=1.1&tilt=0.1&tc=0.3&keel=0&palette=koi&vary=0.5&ground=hide&gloss=wet&pattern=blotches&pn=0.35&pc=0.4&rim=0.15&az=85&el=45",
    ),
    Preset::plain(
        ["Hides in the round", "coral-snake", "Coral snake"],
        "Diamond rows all around, and bands that close into rings.",
        "v=1&make=surface&form=tail&tail_curl=450&tail_taper=0.3&tail_girth=0.1&tail_lift=0.1&kind=rectangle&ca=1.3&cn=2400&taper=0.6&angle=45&stone=skin&sv=1.4&sr=0.3&sc=0.35&tilt=0.12&keel=0.3&palette=coral&ground=hide&gloss=glossy&pattern=bands&pn=0.22&ps=0.95&pc=0.35&rim=0.15&pt=body&az=85&el=40&diff=1.35",
    ),
    Preset::plain(
        ["Hides in the round", "dragon-tail", "Dragon's tail"],
        "Rows of keeled scales that shrink to a quarter towards a tip of horn.",
        "v=1&make=surface&form=tail&tail_curl=250&tail_girth=0.14&ends=cut&kind=rectangle&ca=1.25&cn=1000&taper=0.25&stone=skin&sv=1.4&sc=0.8&tilt=0.25&keel=0.7&palette=dragon&ground=hide&gloss=glossy&rim=-0.4&belly=0.9&az=85&el=40&diff=1.3",
    ),
    Preset::plain(
        ["Hides in the round", "lizard-leg", "Lizard's leg"],
        "After figure 19 of 2003: rectangles in columns, marked by a reaction and diffusion that runs around the leg.",
        "v=1&make=surface&form=leg&leg_toes=5&leg_bend=12&leg_girth=1.15&ends=cut&kind=rectangle&ca=1.2&cn=2400&taper=0.5&stone=skin&sv=1.35&sr=0.35&sc=0.2&tilt=0.12&keel=0&palette=lizard&ground=hide&gloss=glossy&pattern=turing&pn=0.16&ps=0.95&pc=0.3&rim=0.2&belly=0.5&ba=60&az=85&el=40&amb=1.2&diff=1.3",
    ),
    Preset::plain(
        ["Hides in the round", "pineapple", "Pineapple"],
        "Squares set on their corners make the spirals that one can count both ways.",
        "v=1&make=surface&form=egg&egg_height=1.45&egg_point=0.05&kind=rectangle&ca=1&cn=300&angle=45&stone=skin&sc=0.1&tilt=0.1&tc=0.75&flat=0.15&keel=0.5&palette=desert&vary=1.5&ground=hide&gloss=glossy&rim=0.6&belly=0.5&az=85&el=40",
    ),
    Preset::plain(
        ["Hides in the round", "feathered-knot", "Feathered knot"],
        "Silver scales follow a knot without beginning or end.",
        "v=1&make=surface&form=knot&kind=ellipse&ca=1.6&cn=2200&stone=skin&sv=1.5&sc=1.2&tilt=0.2&keel=0.15&palette=fish&vary=0.6&ground=hide&gloss=wet&pattern=blotches&pn=0.3&pc=0.3&rim=-0.4&az=85&el=45",
    ),
    Preset::plain(
        ["Hides in the round", "turtle-back", "Turtle's back"],
        "Six-sided scutes with rings of growth.",
        "v=1&make=surface&form=turtle&turtle_height=0.45&turtle_rim=0&turtle_keel=0&kind=circle&cn=120&stone=skin&sv=1.02&sr=0.22&sc=0&tilt=0&tc=0.3&flat=0.5&keel=0&rings=5&palette=tortoise&ground=dark&gloss=glossy&rim=0.45&az=85&el=45",
    ),
    Preset::plain(
        ["Hides in the round", "beaded-fish", "Beaded creature"],
        "Circles as small as the bending asks: beads crowd where the body is thin.",
        "v=1&make=surface&form=fish&kind=circle&cn=1700&cc=10&ch=1.4&stone=skin&sv=1.2&sr=0.5&sc=0&tilt=0&tc=0.3&keel=0&palette=coral&ground=hide&gloss=glossy&soft=0.3&belly=0.8&az=85&el=45&diff=1.3",
    ),
    Preset::plain(
        ["Hides in the round", "pangolin-ball", "Pangolin, rolled up"],
        "Horny scales, each over the next, around a body that hides its belly.",
        "v=1&make=surface&form=horn&horn_turns=1.2&horn_rise=0&horn_taper=0.35&horn_girth=0.85&kind=ellipse&ca=1.2&cn=620&taper=0.5&stone=skin&sv=1.5&sc=1.2&tilt=0.3&rings=4&palette=pangolin&ground=hide&rim=-0.25&az=85&el=40&diff=1.3",
    ),
    Preset::plain(
        ["Stones on surfaces", "mosaic-vase", "Mosaic vase"],
        "Small tiles around the lip and down inside, in rings of light and dark marble.",
        "v=1&make=surface&form=vase&cn=3600&stone=flag&sv=0.95&hs=0.12&dr=0.05&palette=marble&vary=1.3&ground=dark&gloss=glossy&pattern=bands&pn=0.22&ps=1&pc=0.35&soft=0.6&pt=body&az=85&el=45",
    ),
    Preset::plain(
        ["Stones on surfaces", "cobbled-hill", "Cobbled hill"],
        "A pale lane between dark hills: setts follow it, and moss lies in the joints.",
        "v=1&make=surface&terrain_hills=2&terrain_height=0.6&terrain_lane=1&terrain_wind=0&terrain_hill=5&yaw=-20&cn=1500&hs=0.55&dr=0.25&palette=basalt&ground=moss&pattern=bands&pn=1&ps=0.95&pc=0.25&wear=0.3&moss=0.45&az=60&el=35&amb=1.1&diff=1.3",
    ),
    Preset::plain(
        ["Stones on surfaces", "brick-stairs", "Brick stairs"],
        "The surface is cut along its edges, so each tread and riser has rows of its own.",
        "v=1&make=surface&form=stairs&stairs_steps=4&stairs_width=1&crease=cut&kind=rectangle&ca=2.2&cn=430&dir=border&vs=0.12&stone=flag&sv=0.96&hs=0.28&dr=0.05&palette=terracotta&vary=1.3&ground=mortar&wear=0.3&moss=0.25&dirt=0.2&az=85&el=45",
    ),
    Preset::plain(
        ["Stones on surfaces", "drum", "Round tower"],
        "Limestone in courses around a tower, grass on its top.",
        "v=1&make=surface&form=cylinder&cylinder_height=1.3&cylinder_top=0.85&cylinder_caps=0&crease=cut&open=capped&kind=rectangle&ca=1.7&cn=260&dir=border&vs=0.16&sv=0.99&hs=0.35&dr=0.05&palette=limestone&vary=1.3&ground=mortar&wear=0.3&moss=0.35&dirt=0.2&az=85&el=40",
    ),
    Preset::plain(
        ["Stones on surfaces", "tiled-dome", "Tiled dome"],
        "Courses rise to the crown, where three or five tiles meet.",
        "v=1&make=surface&form=egg&egg_height=0.8&egg_base=0.3&cn=2200&stone=flag&sv=0.96&hs=0.1&dr=0.05&palette=slate&ground=mortar&gloss=glossy&pattern=bands&pn=0.16&ps=1&pc=0.4&soft=0.4&pt=body&az=85&el=45",
    ),
    Preset::plain(
        ["Stones on surfaces", "stone-letter", "Letter of stone"],
        "Terracotta over every edge of an A.",
        "v=1&make=surface&form=letter&cn=1100&stone=flag&sv=0.95&hs=0.2&dr=0.05&palette=terracotta&vary=1.3&ground=mortar&gloss=glossy&soft=0.5&az=85&el=45",
    ),
    Preset::plain(
        ["Stones on surfaces", "tiled-ring", "Tiled ring"],
        "Terracotta set on its corners closes around a ring both ways.",
        "v=1&make=surface&form=torus&torus_tube=0.5&cn=1100&angle=45&stone=flag&sv=0.95&hs=0.15&dr=0.05&palette=terracotta&vary=1.3&ground=mortar&gloss=glossy&pattern=size&az=85&el=45",
    ),
    Preset::plain(
        ["Stones on surfaces", "paved-slope", "Paved slope"],
        "Sandstone from one level to the next, in tones of one bed of stone.",
        "v=1&make=surface&form=slope&slope_rise=34&slope_landing=0.15&slope_width=0.9&cn=340&dir=border&vs=0.25&stone=flag&hs=0.3&dr=0.1&palette=sandstone&vary=1.2&ground=moss&soft=0.4&wear=0.4&moss=0.3&az=85&el=40",
    ),
];
