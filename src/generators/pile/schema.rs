//! The one table of a pile's parameters; see [`crate::recipe::Schema`].

use crate::generators::SampleRule;
use crate::generators::given::FileRules;
use crate::generators::rows::rows;
use crate::generators::rows::shapes;
use crate::generators::rows::shared;
use crate::notice::Notice;
use crate::recipe::parameter::{Parameter, choice, int, number, text};
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Item, Key, Recipe, Rows, Rules};

/// The word for a component or a shape that a file gives.
pub const FILE: &str = "file";

/// The word for no type.
pub const NONE: &str = "none";

/// The most types.
pub const TYPES: usize = 4;

/// The keys of one type's rows.
pub struct TypeKeys {
    pub component: Key,
    pub file: Key,
    pub up: Key,
    pub finish: Key,
    pub scale: Key,
    pub density: Key,
    pub turns: [Key; 3],
    pub range: Key,
}

/// The keys of each type's rows.
pub const TYPE_KEYS: [TypeKeys; TYPES] = [
    TypeKeys {
        component: keys::C1,
        file: keys::FILE1,
        up: keys::UP1,
        finish: keys::F1,
        scale: keys::K1,
        density: keys::SIGMA1,
        turns: [keys::TU1, keys::TV1, keys::TW1],
        range: keys::L1,
    },
    TypeKeys {
        component: keys::C2,
        file: keys::FILE2,
        up: keys::UP2,
        finish: keys::F2,
        scale: keys::K2,
        density: keys::SIGMA2,
        turns: [keys::TU2, keys::TV2, keys::TW2],
        range: keys::L2,
    },
    TypeKeys {
        component: keys::C3,
        file: keys::FILE3,
        up: keys::UP3,
        finish: keys::F3,
        scale: keys::K3,
        density: keys::SIGMA3,
        turns: [keys::TU3, keys::TV3, keys::TW3],
        range: keys::L3,
    },
    TypeKeys {
        component: keys::C4,
        file: keys::FILE4,
        up: keys::UP4,
        finish: keys::F4,
        scale: keys::K4,
        density: keys::SIGMA4,
        turns: [keys::TU4, keys::TV4, keys::TW4],
        range: keys::L4,
    },
];

/// The groups of the types' rows.
const GROUPS: [&str; TYPES] = ["Component", "Second type", "Third type", "Fourth type"];

/// A row of a type, which is shown while the type has a component.
const fn of_type(number: usize, row: Parameter) -> Parameter {
    let row = row.group(GROUPS[number]);
    match number {
        0 => row,
        _ => row.only_with(TYPE_KEYS[number].component),
    }
}

/// The row of a type's component.
const fn component(number: usize) -> Parameter {
    let words = match number {
        0 => COMPONENTS,
        _ => OTHERS,
    };
    let name = match number {
        0 => "Component",
        1 => "Second component",
        2 => "Third component",
        _ => "Fourth component",
    };
    choice(name, words).group(GROUPS[number])
}

/// The row of a type's file.
const fn file(number: usize) -> Parameter {
    let key = TYPE_KEYS[number].component;
    text("Model", Item::File)
        .group(GROUPS[number])
        .steady()
        .drawn_for(key, FILE)
        .only_for(key, &[FILE])
}

/// The key of the choice, a component or the shape, to which a file's key belongs.
pub fn choice_of(file: Key) -> Key {
    let of_type = TYPE_KEYS.iter().find(|own| own.file == file);
    of_type.map_or(keys::FORM, |own| own.component)
}

/// The rules for files: a file sets the choice to which it belongs. A component from a file is heaped as it is, without
/// bent versions, unless other types share their number with it.
pub struct PileRules;

impl Rules for PileRules {
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice> {
        let mut said = FileRules(choice_of).draw(recipe, key, rows)?;
        let mut others = TYPE_KEYS[1..].iter();
        if key == keys::FILE1 && others.all(|own| recipe.choice(own.component) == NONE) {
            said.extend(recipe.set(keys::VARIANTS.0, "1")?);
        }
        Ok(said)
    }
}

/// The row of a file's upright axis.
const fn up(number: usize) -> Parameter {
    choice("Upright axis", UPRIGHT)
        .group(GROUPS[number])
        .steady()
        .only_for(TYPE_KEYS[number].component, &[FILE])
}

const fn finish(number: usize) -> Parameter {
    of_type(number, choice("Finish", FINISHES))
}

const fn scale(number: usize) -> Parameter {
    of_type(number, number_of("s", "Size").range(0.2, 5.0, 0.05, 1.0))
}

const fn density(number: usize) -> Parameter {
    of_type(
        number,
        number_of("σ", "Spacing").range(0.0, 12.0, 0.05, 0.0),
    )
}

const fn turn(number: usize, symbol: &'static str, name: &'static str) -> Parameter {
    of_type(
        number,
        number_of(symbol, name)
            .range(0.0, 360.0, 5.0, 360.0)
            .unit("°"),
    )
}

const fn range(number: usize) -> Parameter {
    of_type(number, number_of("l", "Range").range(0.0, 12.0, 0.05, 2.0))
}

/// Stands in for the function `number` where an argument has that name.
const fn number_of(symbol: &'static str, name: &'static str) -> Parameter {
    number(symbol, name)
}

/// The components of the first type.
const COMPONENTS: &[Choice] = choices![
    rice: "Rice", pebble: "Pebble", smooth: "Smooth pebble", chestnut: "Chestnut",
    nut: "Nut", bolt: "Bolt", gear: "Gear", ball: "Ball", torus: "Ring", box: "Block",
    bean: "Bean", cashew: "Cashew", almond: "Almond", walnut: "Walnut",
    leaf: "Leaf", orange: "Orange", apple: "Apple", file: "From a file",
];

/// The components of the other types.
const OTHERS: &[Choice] = choices![
    none: "None",
    rice: "Rice", pebble: "Pebble", smooth: "Smooth pebble", chestnut: "Chestnut",
    nut: "Nut", bolt: "Bolt", gear: "Gear", ball: "Ball", torus: "Ring", box: "Block",
    bean: "Bean", cashew: "Cashew", almond: "Almond", walnut: "Walnut",
    leaf: "Leaf", orange: "Orange", apple: "Apple", file: "From a file",
];

/// The finishes; `own` is that of the component.
const FINISHES: &[Choice] = choices![
    own: "As it is", rice: "Rice", river: "River stones", basalt: "Basalt", quartz: "Quartz",
    chestnut: "Chestnut", brass: "Brass", steel: "Steel", copper: "Copper", wood: "Wood",
    walnut: "Dark wood", bean: "Red beans", blackbean: "Black beans", cashew: "Cashew",
    almond: "Almond", leaf: "Autumn leaves", greenleaf: "Green leaves", orange: "Orange",
    apple: "Red apples", greenapple: "Green apples", red: "Red", blue: "Blue", yellow: "Yellow",
    white: "White", toys: "Many paints", ivory: "Ivory", clay: "Clay", nutshell: "Nutshells", glass: "Glass",
];

/// Small heaps of the components, shapes with their darts, and vessels with their fill.
pub(super) const SAMPLES: [SampleRule; 3] = [
    SampleRule {
        keys: &["c1", "c2", "c3", "c4"],
        words: &[],
        without: &[NONE, FILE],
        link: "form=heap&ps=3.6&sigma1=1.2&variants=1",
        view: "",
    },
    SampleRule {
        keys: &["form"],
        words: &["bowl", "openbox"],
        without: &[],
        link: "c1=ball&f1=ivory&ps=6&sigma1=1.2&variants=1",
        view: "",
    },
    SampleRule {
        keys: &["form"],
        words: &[],
        without: &[FILE],
        link: "c1=ball&ps=9&sigma1=1.6&variants=1",
        view: "darts",
    },
];

const UPRIGHT: &[Choice] = choices![y: "y", z: "z"];

rows! {
    c1 C1: "The thing that is heaped." => component(0).main();
    file1 FILE1: "The digest and the name of the component's file: a link does not hold the file itself." => file(0).main();
    up1 UP1: "Which way is up in the component's file." => up(0);
    f1 F1: "Colours and gloss of the bodies." => finish(0).main();
    k1 K1: "Size of the bodies, as a factor of the component." => scale(0).main();
    sigma1 SIGMA1: "Least distance of two darts, in radii of the largest inner sphere: below 1 tight, above 1 loose. At 0 it follows from the component." => density(0).main();
    tu1 TU1: "How far bodies turn about the horizontal axis u." => turn(0, "θu", "Turn about u");
    tv1 TV1: "How far bodies turn about the surface's normal v." => turn(0, "θv", "Turn about v");
    tw1 TW1: "How far bodies turn about the axis w." => turn(0, "θw", "Turn about w");
    l1 L1: "How far a body may slide along the surface's normal, in its diagonals. At 0 bodies stay where their darts are." => range(0).main();

    c2 C2: "A second thing in the pile." => component(1);
    file2 FILE2: "The digest and the name of the second component's file." => file(1);
    up2 UP2: "Which way is up in the second component's file." => up(1);
    f2 F2: "Colours and gloss of the second type." => finish(1);
    k2 K2: "Size of the second type." => scale(1);
    sigma2 SIGMA2: "Least distance of two darts of the second type; at 0 it follows from the component." => density(1);
    tu2 TU2: "How far bodies of the second type turn about u." => turn(1, "θu", "Turn about u");
    tv2 TV2: "How far bodies of the second type turn about v." => turn(1, "θv", "Turn about v");
    tw2 TW2: "How far bodies of the second type turn about w." => turn(1, "θw", "Turn about w");
    l2 L2: "How far a body of the second type may slide, in its diagonals." => range(1);

    c3 C3: "A third thing in the pile." => component(2);
    file3 FILE3: "The digest and the name of the third component's file." => file(2);
    up3 UP3: "Which way is up in the third component's file." => up(2);
    f3 F3: "Colours and gloss of the third type." => finish(2);
    k3 K3: "Size of the third type." => scale(2);
    sigma3 SIGMA3: "Least distance of two darts of the third type; at 0 it follows from the component." => density(2);
    tu3 TU3: "How far bodies of the third type turn about u." => turn(2, "θu", "Turn about u");
    tv3 TV3: "How far bodies of the third type turn about v." => turn(2, "θv", "Turn about v");
    tw3 TW3: "How far bodies of the third type turn about w." => turn(2, "θw", "Turn about w");
    l3 L3: "How far a body of the third type may slide, in its diagonals." => range(2);

    c4 C4: "A fourth thing in the pile." => component(3);
    file4 FILE4: "The digest and the name of the fourth component's file." => file(3);
    up4 UP4: "Which way is up in the fourth component's file." => up(3);
    f4 F4: "Colours and gloss of the fourth type." => finish(3);
    k4 K4: "Size of the fourth type." => scale(3);
    sigma4 SIGMA4: "Least distance of two darts of the fourth type; at 0 it follows from the component." => density(3);
    tu4 TU4: "How far bodies of the fourth type turn about u." => turn(3, "θu", "Turn about u");
    tv4 TV4: "How far bodies of the fourth type turn about v." => turn(3, "θv", "Turn about v");
    tw4 TW4: "How far bodies of the fourth type turn about w." => turn(3, "θw", "Turn about w");
    l4 L4: "How far a body of the fourth type may slide, in its diagonals." => range(3);

    variants VARIANTS: "Bent, tapered and bulged versions of each component: no two bodies need be alike." =>
        int("", "Variants").range(1.0, 12.0, 1.0, 8.0).group("Component");
    jitter JITTER: "How much the sizes of bodies differ." =>
        number("", "Size variation").range(0.0, 0.5, 0.01, 0.08).group("Component");

    form FORM: "The shape that bodies are heaped on or in: one by rule, or that of a file." =>
        choice("Shape", choices![
            riceball: "Rice ball", heap: "Heap", dome: "Dome", block: "Box", bowl: "Bowl", openbox: "Open box",
            terrain: "Terrain", slope: "Slope", stairs: "Stairs", cylinder: "Cylinder", sphere: "Sphere", torus: "Torus", knot: "Knot", horn: "Horn", leg: "Leg", tail: "Tail", fish: "Fish", turtle: "Turtle's back", egg: "Egg", vase: "Vase", letter: "Letter", file: "From a file",
        ]).group("Shape").main();
    ..[shapes::PILED];
    ..[shapes::NUMBERS];
    model MODEL: "The digest and the name of the shape's file: a link does not hold the file itself." =>
        text("Shape's model", Item::File).group("Shape").steady()
            .drawn_for(keys::FORM, FILE).only_for(keys::FORM, &[FILE]);
    up UP: "Which way is up in the file." =>
        choice("Upright axis", UPRIGHT).group("Shape").steady().only_for(keys::FORM, &[FILE]);
    ps PS: "Half of the shape's longest side, in halves of a component's length." =>
        number("", "Shape's size").range(3.0, 40.0, 0.5, 10.0).group("Shape").main();
    core CORE: "Whether the shape itself is seen between the bodies." =>
        choice("Shape's surface", choices![own: "As it suits", seen: "Seen", hidden: "Hidden"]).group("Shape");
    layers LAYERS: "Layers of bodies: the outer one, and inner ones below it." =>
        int("", "Layers").range(1.0, 5.0, 1.0, 1.0).group("Shape");
    yaw YAW: "Turns the pile about its upright axis, under the same light." =>
        shared::YAW.group("Shape");
    size SIZE: "Side of the square picture." => shared::SIZE;

    darts DARTS: "The order in which darts are thrown: row by row, rows show." =>
        choice("Darts", choices![random: "By chance", scan: "Row by row"]).group("Placing");
    merge MERGE: "Whether darts of a smaller type go where one of a larger type is near." =>
        choice("Types", choices![merged: "Merged", alone: "Each for itself"]).group("Placing");
    frame FRAME: "The axes from which bodies turn: those of the surface at each place, or those of space." =>
        choice("Axes", choices![local: "Surface", global: "Space"]).group("Placing");
    seed SEED: "Names the random numbers: another seed, another pile." => shared::SEED.group("Placing");

    refine REFINE: "How a body's place is found: exactly, or by the paper's golden section." =>
        choice("Search", choices![exact: "Exact", golden: "Golden section"]).group("Refinement");
    reading READING: "The settled bodies that the cost of the golden section looks at." =>
        choice("Cost", choices![nearest: "The nearest body", all: "All bodies"]).group("Refinement")
            .only_for(keys::REFINE, &["golden"]);
    iterations ITERATIONS: "Iterations of the golden section." =>
        int("", "Iterations").range(1.0, 40.0, 1.0, 15.0).group("Refinement").only_for(keys::REFINE, &["golden"]);
    reach REACH: "The range as it is given, or so long that three to five bodies are met along a normal." =>
        choice("Range", choices![given: "As given", natural: "By itself"]).group("Refinement");
    offset OFFSET: "How deep bodies may overlap and still count as touching, in radii of the smaller one's largest inner sphere." =>
        number("T", "Offset").range(0.0, 0.5, 0.01, 0.15).group("Refinement").main();
    removal REMOVAL: "How much deeper they may overlap before the later one is removed." =>
        number("D", "Removal").range(0.0, 0.3, 0.01, 0.05).group("Refinement");
    alpha ALPHA: "Share of the range that lies inside of the shape: 0 heaps outwards as in the paper, 1 keeps the outline." =>
        number("α", "Inward share").range(0.0, 1.0, 0.05, 0.75).group("Refinement");
    order ORDER: "The order in which bodies settle: row by row, rows show." =>
        choice("Order", choices![random: "By chance", scan: "Row by row"]).group("Refinement");
    first FIRST: "Whether the larger types settle first." =>
        choice("Large ones", choices![large: "First", mixed: "Mixed with small ones"]).group("Refinement");
    retries RETRIES: "New turns that are tried before a body is removed." =>
        int("", "Retries").range(0.0, 3.0, 1.0, 1.0).group("Refinement");

    vary VARY: "Variation of tone from body to body." => shared::VARY.group("Look");
    gloss GLOSS: "How bodies shine." => shared::GLOSS.group("Look");
    wet WET: "Wets the pile from below, up to this share of its height." =>
        number("", "Wet").range(0.0, 1.0, 0.05, 0.0).group("Look").main();

    ..[shared::LIGHTING];
    az AZ => shared::AZ.range(0.0, 360.0, 1.0, 85.0);
    el EL => shared::EL.range(5.0, 90.0, 1.0, 45.0);
}
