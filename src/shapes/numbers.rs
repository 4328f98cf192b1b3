//! The table of shapes: their names and their numbers.

use super::Shape;

/// One of the numbers of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeNumber {
    /// Its key in links, unique within the shape.
    pub word: &'static str,
    /// Its English label.
    pub label: &'static str,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// Its value when a link does not set it.
    pub default: f64,
    /// Its least value.
    pub least: f64,
    /// Its greatest value.
    pub most: f64,
    /// The step of a control. For a count, only whole numbers of steps above the least value are valid.
    pub step: f64,
}

impl ShapeNumber {
    /// Whether it is a count or a choice, with no value between two steps.
    pub const fn is_count(&self) -> bool {
        self.step >= 1.0 && self.unit.is_empty()
    }

    /// The nearest valid value; the default for a number that is not finite.
    pub fn fitted(&self, number: f64) -> f64 {
        if !number.is_finite() {
            return self.default;
        }
        let within = number.clamp(self.least, self.most);
        if self.is_count() {
            let steps = ((within - self.least) / self.step).round();
            return (self.least + steps * self.step).min(self.most);
        }
        within
    }
}

const fn number(
    [word, label, unit]: [&'static str; 3],
    default: f64,
    [least, most, step]: [f64; 3],
) -> ShapeNumber {
    ShapeNumber {
        word,
        label,
        unit,
        default,
        least,
        most,
        step,
    }
}

pub(crate) const TERRAIN: &[ShapeNumber] = &[
    number(["hills", "Hills across", ""], 2.5, [1.0, 5.0, 0.1]),
    number(
        ["height", "Height over width of a hill", ""],
        0.4,
        [0.0, 0.6, 0.02],
    ),
    number(["lane", "Depth of the lane", ""], 0.6, [0.0, 1.0, 0.05]),
    number(["wind", "How the lane winds", ""], 0.5, [0.0, 1.0, 0.05]),
    number(["hill", "Which hills", ""], 1.0, [1.0, 999.0, 1.0]),
];
pub(crate) const SLOPE: &[ShapeNumber] = &[
    number(["rise", "Angle of the slope", "°"], 22.0, [0.0, 50.0, 1.0]),
    number(
        ["landing", "Level ground at each end", ""],
        0.2,
        [0.0, 0.4, 0.02],
    ),
    number(["width", "Width over length", ""], 0.6, [0.2, 1.5, 0.05]),
    number(
        ["round", "Roundness of the bends", ""],
        0.5,
        [0.0, 1.0, 0.05],
    ),
];
pub(crate) const STAIRS: &[ShapeNumber] = &[
    number(["steps", "Steps", ""], 5.0, [2.0, 12.0, 1.0]),
    number(["pitch", "Riser over tread", ""], 0.55, [0.3, 1.2, 0.05]),
    number(["width", "Width over length", ""], 0.8, [0.3, 1.5, 0.05]),
    number(
        ["landing", "Landing at the top, in treads", ""],
        1.0,
        [1.0, 4.0, 0.25],
    ),
];
pub(crate) const CYLINDER: &[ShapeNumber] = &[
    number(
        ["height", "Height over diameter", ""],
        1.2,
        [0.3, 3.0, 0.05],
    ),
    number(
        ["top", "Width at the top over that below", ""],
        1.0,
        [0.4, 1.6, 0.05],
    ),
    number(
        ["belly", "Belly, or waist below 0", ""],
        0.0,
        [-0.35, 0.5, 0.05],
    ),
    number(["caps", "Ends closed", ""], 1.0, [0.0, 1.0, 1.0]),
];
pub(crate) const SPHERE: &[ShapeNumber] = &[
    number(["height", "Height over width", ""], 1.0, [0.4, 2.0, 0.05]),
    number(["depth", "Depth over width", ""], 1.0, [0.4, 2.0, 0.05]),
    number(["square", "Squareness", ""], 2.0, [2.0, 6.0, 0.1]),
];
pub(crate) const TORUS: &[ShapeNumber] = &[
    number(
        ["tube", "Radius of the tube over that of the ring", ""],
        0.4,
        [0.12, 0.75, 0.01],
    ),
    number(
        ["height", "Height of the tube over its width", ""],
        1.0,
        [0.5, 2.0, 0.05],
    ),
    number(["waves", "Waves around", ""], 0.0, [0.0, 8.0, 1.0]),
    number(
        ["swell", "Depth of the waves, of what they may have", ""],
        0.5,
        [0.0, 1.0, 0.05],
    ),
];
pub(crate) const KNOT: &[ShapeNumber] = &[
    number(
        ["turns", "Turns around the middle", ""],
        2.0,
        [2.0, 3.0, 1.0],
    ),
    number(["lobes", "Lobes", ""], 3.0, [3.0, 8.0, 1.0]),
    number(
        ["tube", "Thickness, of the room there is", ""],
        0.7,
        [0.35, 0.85, 0.05],
    ),
    number(
        ["swing", "How far lobes swing in and out", ""],
        0.42,
        [0.25, 0.52, 0.01],
    ),
    number(
        ["height", "Height over depth of the swing", ""],
        0.9,
        [0.6, 1.4, 0.05],
    ),
];
pub(crate) const HORN: &[ShapeNumber] = &[
    number(["turns", "Turns", ""], 2.0, [0.25, 3.0, 0.05]),
    number(
        ["rise", "How far it winds out of its plane", ""],
        1.0,
        [0.0, 2.0, 0.05],
    ),
    number(
        ["taper", "Width of the tip over that of the root", ""],
        0.14,
        [0.08, 0.6, 0.01],
    ),
    number(
        ["girth", "Thickness, of the room there is", ""],
        0.7,
        [0.35, 0.85, 0.05],
    ),
];
pub(crate) const LEG: &[ShapeNumber] = &[
    number(["toes", "Toes", ""], 4.0, [3.0, 5.0, 1.0]),
    number(
        ["spread", "Angle between toes", "°"],
        27.0,
        [21.0, 34.0, 1.0],
    ),
    number(["bend", "Bend of the knee", "°"], 34.0, [0.0, 55.0, 1.0]),
    number(["girth", "Thickness", ""], 1.0, [0.75, 1.25, 0.05]),
    number(["reach", "Length of the toes", ""], 1.0, [0.7, 1.35, 0.05]),
];
pub(crate) const TAIL: &[ShapeNumber] = &[
    number(["curl", "Curl", "°"], 290.0, [0.0, 450.0, 5.0]),
    number(
        ["taper", "Width of the tip over that of the root", ""],
        0.2,
        [0.1, 0.6, 0.01],
    ),
    number(
        ["girth", "Width of the root over the length", ""],
        0.17,
        [0.08, 0.26, 0.01],
    ),
    number(
        ["lift", "How far it winds out of its plane", ""],
        0.3,
        [0.0, 1.0, 0.05],
    ),
];
pub(crate) const FISH: &[ShapeNumber] = &[
    number(
        ["height", "Height of the body over the length", ""],
        0.36,
        [0.22, 0.52, 0.01],
    ),
    number(
        ["width", "Width of the body over its height", ""],
        0.46,
        [0.34, 0.7, 0.02],
    ),
    number(["tail", "Size of the tail", ""], 1.0, [0.7, 1.3, 0.05]),
    number(["fins", "Size of the fins", ""], 1.0, [0.7, 1.3, 0.05]),
    number(["swim", "Bend to the side", "°"], 14.0, [-40.0, 40.0, 2.0]),
];
pub(crate) const TURTLE: &[ShapeNumber] = &[
    number(["width", "Width over length", ""], 0.8, [0.6, 1.0, 0.01]),
    number(
        ["height", "Height over length", ""],
        0.34,
        [0.18, 0.55, 0.01],
    ),
    number(["rim", "Rim", ""], 0.5, [0.0, 1.0, 0.05]),
    number(["keel", "Keels along the back", ""], 0.4, [0.0, 1.0, 0.05]),
];
pub(crate) const EGG: &[ShapeNumber] = &[
    number(["height", "Height over width", ""], 1.35, [0.8, 1.9, 0.05]),
    number(
        ["point", "How pointed the top is", ""],
        0.2,
        [0.0, 0.4, 0.02],
    ),
    number(["base", "How flat it stands", ""], 0.0, [0.0, 0.3, 0.01]),
];
pub(crate) const VASE: &[ShapeNumber] = &[
    number(["height", "Height over width", ""], 1.5, [1.0, 2.4, 0.05]),
    number(
        ["shoulder", "Height of the widest place", ""],
        0.52,
        [0.35, 0.65, 0.01],
    ),
    number(
        ["neck", "Width of the neck over the widest", ""],
        0.42,
        [0.3, 0.8, 0.01],
    ),
    number(
        ["lip", "Width of the lip over that of the neck", ""],
        1.35,
        [1.0, 1.7, 0.05],
    ),
    number(
        ["hollow", "Depth inside over the height", ""],
        0.6,
        [0.2, 0.85, 0.05],
    ),
];
pub(crate) const LETTER: &[ShapeNumber] = &[
    number(["letter", "Letter, A is 1", ""], 1.0, [1.0, 26.0, 1.0]),
    number(
        ["weight", "Width of strokes over height", ""],
        0.18,
        [0.13, 0.22, 0.01],
    ),
    number(["depth", "Depth over height", ""], 0.26, [0.14, 0.5, 0.02]),
    number(["round", "Roundness of edges", ""], 0.6, [0.35, 1.0, 0.05]),
    number(["lean", "Lean", "°"], 0.0, [-10.0, 20.0, 1.0]),
];

impl Shape {
    /// The shape's key, its English label, and its three to five numbers.
    fn row(self) -> (&'static str, &'static str, &'static [ShapeNumber]) {
        match self {
            Self::Terrain => ("terrain", "Terrain", TERRAIN),
            Self::Slope => ("slope", "Slope", SLOPE),
            Self::Stairs => ("stairs", "Stairs", STAIRS),
            Self::Cylinder => ("cylinder", "Cylinder", CYLINDER),
            Self::Sphere => ("sphere", "Sphere", SPHERE),
            Self::Torus => ("torus", "Torus", TORUS),
            Self::Knot => ("knot", "Knot", KNOT),
            Self::Horn => ("horn", "Horn", HORN),
            Self::Leg => ("leg", "Leg", LEG),
            Self::Tail => ("tail", "Tail", TAIL),
            Self::Fish => ("fish", "Fish", FISH),
            Self::Turtle => ("turtle", "Turtle's back", TURTLE),
            Self::Egg => ("egg", "Egg", EGG),
            Self::Vase => ("vase", "Vase", VASE),
            Self::Letter => ("letter", "Letter", LETTER),
        }
    }

    /// The shape's key in links.
    pub fn word(self) -> &'static str {
        self.row().0
    }

    /// The shape's English label.
    pub fn label(self) -> &'static str {
        self.row().1
    }

    /// The shape's numbers, three to five.
    pub fn numbers(self) -> &'static [ShapeNumber] {
        self.row().2
    }

    /// The shape with this key.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|shape| shape.word() == word)
    }

    /// All numbers of the shape: the nearest valid values to those given, and defaults for the rest.
    pub fn fitted(self, given: &[f64]) -> Vec<f64> {
        let each = self.numbers().iter().enumerate();
        each.map(|(k, number)| number.fitted(given.get(k).copied().unwrap_or(number.default)))
            .collect()
    }
}
