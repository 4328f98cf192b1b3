//! Recipes with names: things that everybody knows, the rows of table 1 of Sakurai, Miyata (2014), Modelling of
//! Non-Periodic Aggregates Having a Pile Structure, and others of its figures. Components and shapes of the paper's
//! figures are guesses where its text has lost them: notes say so, and docs/deviations.md lists these.

use crate::generators::{MeasuredPart, Preset, Timing};

/// A row of the paper's table, with its seconds and its number of components.
const fn figure(
    [name, title, figure]: [&'static str; 3],
    note: &'static str,
    link: &'static str,
    (seconds, bodies): (f64, u32),
) -> Preset {
    Preset {
        timing: Some(Timing {
            machine: "Core i7 950, 3.07 GHz",
            first: MeasuredPart {
                name: "piling",
                stages: &["darts", "refine"],
                seconds,
            },
            second: None,
            bodies: Some(bodies),
        }),
        ..Preset::drawn(["The paper's table", name, title, figure], note, link)
    }
}

/// A preset whose view has a colour for each layer, and no front half, so that the layers below the surface are seen.
const fn cut_open(preset: Preset) -> Preset {
    Preset {
        view: "view=layers&cut=0.5,0,0.866,0",
        ..preset
    }
}

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    Preset::plain(
        ["Showpieces", "rice-ball", "Rice ball"],
        "Damp grains of every length lie packed without a hole, as if pressed by hand.",
        "v=1&make=pile&k1=0.85&sigma1=1.15&riceball_thick=0.48&riceball_round=0.6&ps=9.5&yaw=-20",
    ),
    Preset::plain(
        ["Showpieces", "chestnut-box", "Chestnut box"],
        "Lacquered chestnuts fill an open box, and none of them cuts through the wood.",
        "v=1&make=pile&c1=chestnut&sigma1=0.6&l1=5&form=openbox&openbox_full=0.95&ps=8&alpha=0.85",
    ),
    Preset::plain(
        ["Showpieces", "fruit-basket", "Basket of fruit"],
        "Apples and oranges sink into a bed of walnuts, with a second layer below the first.",
        "v=1&make=pile&c1=apple&sigma1=1.3&l1=2.5&c2=apple&f2=greenapple&sigma2=1.6&l2=2.5&c3=orange&k3=0.9&sigma3=1.3&l3=2.5&c4=walnut&k4=0.5&sigma4=1.5&l4=2.5&form=bowl&bowl_full=0.55&ps=8&layers=2&merge=alone&seed=3&first=mixed",
    ),
    Preset::plain(
        ["Showpieces", "oranges", "Oranges in a bowl"],
        "Every orange has its pores, and here and there a stalk end looks up.",
        "v=1&make=pile&c1=orange&k1=0.9&sigma1=0.4&l1=4&form=bowl&bowl_full=0.3&ps=8&offset=0.2&alpha=0.8&retries=3",
    ),
    Preset::plain(
        ["Showpieces", "wet-pebbles", "Wet pebbles"],
        "River pebbles shine dark below the waterline and lie pale and dry above it.",
        "v=1&make=pile&c1=smooth&f1=river&sigma1=0.7&l1=4&form=heap&heap_height=0.42&ps=11&offset=0.2&gloss=matt&wet=0.45",
    ),
    Preset::plain(
        ["Showpieces", "chestnut-rice", "Chestnut rice"],
        "Chestnuts sit deep in the rice, as their range is short and they settle first.",
        "v=1&make=pile&c1=chestnut&k1=1.2&sigma1=5&l1=0.1&c2=rice&k2=0.8&sigma2=1&l2=3&riceball_thick=0.5&yaw=-20&merge=alone&alpha=0.9",
    ),
    Preset::plain(
        ["Showpieces", "nuts-bolts", "Nuts and bolts"],
        "Brass nuts lie among steel bolts, and both metals mirror the sky.",
        "v=1&make=pile&c1=nut&k1=1.1&sigma1=2.8&l1=4&c2=bolt&sigma2=1.6&l2=4&form=heap&heap_height=0.38&ps=11&merge=alone&offset=0.1&first=mixed",
    ),
    Preset::plain(
        ["Showpieces", "toys", "Toys"],
        "Rings, balls and blocks share one heap, each shape in its own paint.",
        "v=1&make=pile&c1=torus&f1=yellow&k1=1.1&sigma1=2.6&l1=4.6&c2=ball&k2=1.05&sigma2=0.9&l2=4.6&c3=box&f3=blue&sigma3=1.2&l3=4.6&form=heap&heap_height=0.42&ps=9&merge=alone&offset=0.2&first=mixed",
    ),
    Preset::plain(
        ["Showpieces", "cashews", "Cashews"],
        "Cream kernels with darker tips curl around each other in a bowl.",
        "v=1&make=pile&c1=cashew&k1=1.2&sigma1=0.9&tu1=150&tw1=150&l1=4&form=bowl&ps=9&offset=0.2",
    ),
    Preset::plain(
        ["Showpieces", "autumn-leaves", "Autumn leaves"],
        "Low light from the side shines through the leaves of a raked heap.",
        "v=1&make=pile&c1=leaf&k1=2&sigma1=4.6&tu1=40&tw1=40&form=heap&heap_height=0.38&ps=12&seed=5&offset=0.05&alpha=0.5&az=225&el=30&amb=1.2&diff=1.2",
    ),
    Preset::plain(
        ["Showpieces", "bean-letter", "Bean letter"],
        "The edges of the letter stay crisp, since the beans slide inwards more than outwards.",
        "v=1&make=pile&c1=bean&k1=0.75&sigma1=1.2&tu1=90&tw1=90&form=letter&letter_letter=5&letter_weight=0.2&letter_round=0.35&ps=11&yaw=-15&alpha=0.85",
    ),
    Preset::plain(
        ["Showpieces", "stones-hill", "Stones on a hill"],
        "Large dark stones lie half buried in the ground, and white pebbles gather between them.",
        "v=1&make=pile&c1=smooth&f1=basalt&k1=2.2&sigma1=2.2&tu1=60&tw1=60&l1=0.3&c2=smooth&k2=0.7&sigma2=0.7&l2=3&form=terrain&terrain_hills=2&terrain_height=0.5&ps=16&yaw=50&merge=alone&seed=3&alpha=0.85&retries=3",
    ),
    Preset::plain(
        ["Shapes and vessels", "nut-bowl", "Bowl of nuts"],
        "Walnuts, almonds and cashews are mixed in equal parts in a white bowl.",
        "v=1&make=pile&c1=walnut&sigma1=1.4&l1=1.5&c2=almond&k2=0.9&sigma2=2.2&c3=cashew&sigma3=2.6&form=bowl&bowl_full=0.6&ps=8.5&merge=alone&alpha=0.7&first=mixed",
    ),
    Preset::plain(
        ["Shapes and vessels", "leaf-dome", "Hedge"],
        "Green leaves cover a dome as thickly as a clipped hedge.",
        "v=1&make=pile&c1=leaf&f1=greenleaf&k1=1.8&sigma1=6&tu1=60&tw1=60&l1=1&form=dome&ps=12&alpha=0.6",
    ),
    Preset::plain(
        ["Shapes and vessels", "toy-box", "Box of blocks"],
        "Blue and white blocks tumble into a wooden box.",
        "v=1&make=pile&c1=box&f1=blue&sigma1=2&c2=box&f2=white&sigma2=2&form=openbox&ps=8&merge=alone&alpha=0.6&first=mixed",
    ),
    Preset::plain(
        ["Shapes and vessels", "quartz-egg", "Quartz egg"],
        "Smooth white pebbles cover an egg, and no two of them are alike.",
        "v=1&make=pile&c1=smooth&sigma1=1.25&form=egg&ps=11&alpha=0.9",
    ),
    Preset::plain(
        ["Shapes and vessels", "sea-glass", "Sea glass"],
        "Rounded glass of five colours fills a white bowl, as if gathered on a beach.",
        "v=1&make=pile&c1=smooth&f1=glass&sigma1=0.6&l1=4&form=bowl&bowl_full=0.35&ps=9&offset=0.2&retries=3",
    ),
    Preset::plain(
        ["Shapes and vessels", "leaf-fish", "Fish of leaves"],
        "Green and autumn leaves lie flat on a fish, like scales.",
        "v=1&make=pile&c1=leaf&f1=greenleaf&k1=1.8&sigma1=7&tu1=20&tv1=40&tw1=20&l1=0.8&c2=leaf&k2=1.8&sigma2=9&tu2=20&tv2=40&tw2=20&l2=0.8&form=fish&ps=24&merge=alone&offset=0.2&alpha=0.6&first=mixed",
    ),
    Preset::plain(
        ["Shapes and vessels", "ivory-knot", "Ivory knot"],
        "Ivory beans follow a knot all along its three lobes.",
        "v=1&make=pile&c1=bean&f1=ivory&sigma1=2&tu1=120&tw1=120&l1=1.2&form=knot&knot_tube=0.6&ps=17&alpha=1",
    ),
    Preset::plain(
        ["Shapes and vessels", "nut-letter", "Letter of nuts"],
        "Large brass nuts make an S, and small steel nuts fill the gaps.",
        "v=1&make=pile&c1=nut&sigma1=4.4&tu1=60&tw1=60&l1=1&c2=nut&f2=steel&k2=0.6&sigma2=4.4&tu2=60&tw2=60&form=letter&letter_letter=19&letter_weight=0.2&letter_depth=0.3&letter_round=0.35&ps=16&alpha=1",
    ),
    Preset::plain(
        ["Shapes and vessels", "copper-globe", "Copper globe"],
        "Copper nuts lean on a ball, and their rings catch the sky on every side.",
        "v=1&make=pile&c1=nut&f1=copper&sigma1=4.2&tu1=60&tw1=60&l1=1&form=sphere&ps=11&alpha=0.8",
    ),
    Preset::plain(
        ["Shapes and vessels", "gear-ring", "Ring of gears"],
        "Steel gears and small brass ones lie flat around a ring.",
        "v=1&make=pile&c1=gear&sigma1=7.6&tu1=0&tw1=0&l1=0.5&c2=gear&f2=brass&k2=0.65&sigma2=7.6&tu2=0&tw2=0&l2=0.5&form=torus&torus_tube=0.33&ps=16",
    ),
    Preset::plain(
        ["Shapes and vessels", "ammonite", "Ammonite"],
        "White pebbles trace a coiled shell from the wide mouth to the tip.",
        "v=1&make=pile&c1=smooth&sigma1=1.6&tu1=60&tw1=60&l1=1&form=horn&horn_rise=0&ps=17&alpha=1",
    ),
    Preset::plain(
        ["Shapes and vessels", "basalt-stairs", "Basalt stairs"],
        "Dark pebbles cover three steps, treads and risers alike.",
        "v=1&make=pile&c1=smooth&f1=basalt&sigma1=0.9&tu1=30&tw1=30&form=stairs&stairs_steps=3&stairs_width=0.6&ps=20&yaw=20&offset=0.2&alpha=0.8",
    ),
    figure(
        ["pile9-a", "Fig. 9 (a)", "Fig. 9 (a) of 2014"],
        "Grains of rice turn about the normal only and lie flat on the surface. The paper's text has lost component and shape: both are guesses.",
        "v=1&make=pile&sigma1=1&tu1=0&tw1=0&riceball_thick=0.5&ps=11.3&offset=0.2&alpha=0&retries=0",
        (324.2, 4524),
    ),
    figure(
        ["pile9-c", "Fig. 9 (c)", "Fig. 9 (c) of 2014"],
        "Pebbles turn about the normal only and lie flat on a heap. The paper's text has lost component and shape: both are guesses.",
        "v=1&make=pile&c1=smooth&f1=river&sigma1=1&tu1=0&tw1=0&form=heap&ps=13.2&offset=0.2&alpha=0&retries=0",
        (246.5, 1234),
    ),
    figure(
        ["pile9-e", "Fig. 9 (e)", "Fig. 9 (e) of 2014"],
        "Beans turn about the normal only and lie flat in a bowl. The paper's text has lost component and shape: both are guesses.",
        "v=1&make=pile&c1=bean&sigma1=1&tu1=0&tw1=0&form=bowl&bowl_full=0.2&ps=16.8&offset=0.2&alpha=0&retries=0",
        (182.2, 2089),
    ),
    figure(
        ["pile10-a", "Fig. 10 (a)", "Fig. 10 (a) of 2014"],
        "Rings, balls and blocks have spacings of 4, 2 and 1, and ranges of 1, 2 and 3. The paper's text has lost shape, angles and order: they are guesses.",
        "v=1&make=pile&c1=torus&sigma1=4&l1=1&c2=ball&sigma2=2&c3=box&sigma3=1&l3=3&form=heap&heap_height=0.42&ps=26.9&offset=0.2&alpha=0&first=mixed&retries=0",
        (51.1, 2523),
    ),
    figure(
        ["pile10-b", "Fig. 10 (b)", "Fig. 10 (b) of 2014"],
        "Chestnuts with a range of 0.1 stay deep in rice with a range of 1.5. The large component, its size, the shape and the angles are guesses; the paper's number of bodies may read 7,400 or 97,400.",
        "v=1&make=pile&c1=chestnut&k1=3&sigma1=3&l1=0.1&c2=rice&sigma2=1&l2=1.5&riceball_thick=0.5&ps=24.7&offset=0.2&alpha=0&retries=0",
        (161.99, 7400),
    ),
    figure(
        ["pile11-a", "Fig. 11 (a)", "Fig. 11 (a) of 2014"],
        "Walnuts keep clear of each other, because the offset T is 0. The paper's text has lost component, shape and angles: they are guesses.",
        "v=1&make=pile&c1=walnut&sigma1=1&l1=8&form=sphere&ps=8.8&offset=0&alpha=0&retries=0",
        (240.3, 1124),
    ),
    figure(
        ["pile11-b", "Fig. 11 (b)", "Fig. 11 (b) of 2014"],
        "Walnuts may overlap by an offset T of 0.2, and the gaps close. Component, shape and angles are guesses, and so is how we split the paper's digits into seconds and bodies.",
        "v=1&make=pile&c1=walnut&sigma1=1&l1=8&form=sphere&ps=18.3&offset=0.2&alpha=0&retries=0",
        (1454.9, 4805),
    ),
    figure(
        ["pile13-a", "Fig. 13 (a)", "Fig. 13 (a) of 2014"],
        "Blocks follow the surface, as their turns start from its own axes. The paper's text has lost component, shape and angles: they are guesses.",
        "v=1&make=pile&c1=box&sigma1=2&tu1=10&tv1=10&tw1=10&l1=3&form=egg&ps=22&offset=0.2&alpha=0&retries=0",
        (339.0, 2856),
    ),
    figure(
        ["pile13-b", "Fig. 13 (b)", "Fig. 13 (b) of 2014"],
        "Blocks lie in level courses, as their turns start from the axes of space. The paper's text has lost component, shape and angles: they are guesses.",
        "v=1&make=pile&c1=box&sigma1=2&tu1=10&tv1=10&tw1=10&l1=3&form=egg&ps=20.5&frame=global&offset=0.2&alpha=0&retries=0",
        (270.6, 2557),
    ),
    cut_open(figure(
        ["pile14-a", "Fig. 14 (a)", "Fig. 14 (a) of 2014"],
        "Layers of oranges fill a ball below its surface. The paper's text has lost component, shape and angles: they are guesses.",
        "v=1&make=pile&c1=orange&sigma1=1&form=sphere&ps=14&layers=3&offset=0.2&alpha=0&retries=0",
        (203.9, 2986),
    )),
    cut_open(figure(
        ["pile14-b", "Fig. 14 (b)", "Fig. 14 (b) of 2014"],
        "Layers of oranges fill an egg with the numbers of Figure 14 (a). Component, shape and angles are guesses here, too.",
        "v=1&make=pile&c1=orange&sigma1=1&form=egg&ps=18.5&layers=3&offset=0.2&alpha=0&retries=0",
        (244.0, 3686),
    )),
    figure(
        ["pile15-a", "Fig. 15 (a)", "Fig. 15 (a) of 2014"],
        "Loose rings lie flat and let the light through a vase. The paper's text has lost component and shape: both are guesses.",
        "v=1&make=pile&c1=torus&sigma1=7.5&tu1=0&tw1=0&l1=6&form=vase&vase_lip=1.2&ps=18.8&seed=3&offset=0.2&alpha=0&retries=0",
        (19.5, 490),
    ),
    figure(
        ["pile15-b", "Fig. 15 (b)", "Fig. 15 (b) of 2014"],
        "Nuts with a spacing of 7 and bolts with one of 2 share a range of 3. The paper's text has lost shape, angles and order: they are guesses.",
        "v=1&make=pile&c1=nut&sigma1=7&l1=3&c2=bolt&sigma2=2&l2=3&form=heap&heap_height=0.4&ps=16.5&offset=0.2&alpha=0&first=mixed&retries=0",
        (45.4, 1148),
    ),
    figure(
        ["pile15-c", "Fig. 15 (c)", "Fig. 15 (c) of 2014"],
        "Gears lie flat on a ball like plates of armour. The paper's text has lost component and shape: both are guesses.",
        "v=1&make=pile&c1=gear&sigma1=6&tu1=0&tw1=0&l1=3&form=sphere&ps=10.5&offset=0.2&alpha=0&retries=0",
        (101.7, 897),
    ),
    figure(
        ["pile15-d", "Fig. 15 (d)", "Fig. 15 (d) of 2014"],
        "Few nuts lie among many bolts, and both have a range of 10. The paper's text has lost shape, angles and order: they are guesses.",
        "v=1&make=pile&c1=nut&sigma1=10&l1=10&c2=bolt&sigma2=2&l2=10&form=heap&heap_height=0.5&ps=17&offset=0.2&alpha=0&first=mixed&retries=0",
        (129.6, 1132),
    ),
    Preset::drawn(
        ["The paper's figures", "pile6-alone", "Fig. 6 (a)", "Fig. 6 (a) of 2014"],
        "Rice takes the places of the chestnuts, as the two types are not merged. The paper has a rice ball in place of the dome; the numbers are guesses.",
        "v=1&make=pile&c1=chestnut&k1=1.6&sigma1=2.6&l1=1&c2=rice&sigma2=1.1&form=dome&dome_height=0.35&merge=alone&alpha=0.4&first=mixed",
    ),
    Preset::drawn(
        ["The paper's figures", "pile6-merged", "Fig. 6 (b)", "Fig. 6 (b) of 2014"],
        "Rice leaves room for the chestnuts, as no grain starts within their radius. The paper has a rice ball in place of the dome; the numbers are guesses.",
        "v=1&make=pile&c1=chestnut&k1=1.6&sigma1=2.6&l1=1&c2=rice&sigma2=1.1&form=dome&dome_height=0.35&alpha=0.4&first=mixed",
    ),
    Preset::drawn(
        ["The paper's figures", "pile8-strict", "Fig. 8 (a)", "Fig. 8 (a) of 2014"],
        "Oranges with a short range stay sunk among the pebbles. Components, shape and numbers are guesses.",
        "v=1&make=pile&c1=orange&k1=1.6&sigma1=2.2&l1=0.3&c2=smooth&k2=0.8&l2=1.2&form=egg&ps=12&offset=0.2&alpha=0&first=mixed",
    ),
    Preset::drawn(
        ["The paper's figures", "pile8-loose", "Fig. 8 (b)", "Fig. 8 (b) of 2014"],
        "Oranges with a long range stick out of the pebbles. Components, shape and numbers are guesses.",
        "v=1&make=pile&c1=orange&k1=1.6&sigma1=2.2&l1=3&c2=smooth&k2=0.8&l2=1.2&form=egg&ps=12&offset=0.2&alpha=0&first=mixed",
    ),
    Preset::drawn(
        ["The paper's figures", "pile12-normal", "Fig. 12 (b)", "Fig. 12 (b) of 2014"],
        "Almonds do not tilt and lie flat on a vase. Component, shape and numbers are guesses.",
        "v=1&make=pile&c1=almond&sigma1=1.9&tu1=0&tw1=0&l1=1&form=vase&ps=11&alpha=0.7",
    ),
    Preset::drawn(
        ["The paper's figures", "pile12-random", "Fig. 12 (c)", "Fig. 12 (c) of 2014"],
        "Almonds turn in all directions and make the same vase rough. Component, shape and numbers are guesses.",
        "v=1&make=pile&c1=almond&sigma1=1.9&l1=1&form=vase&ps=11&alpha=0.7",
    ),
];
