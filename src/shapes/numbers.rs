//! The table of shapes: their names and their numbers.

use super::Shape;

/// One of the numbers of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeNumber {
    /// Its key in links, unique within the shape.
    pub word: &'static str,
    /// Its English label.
    pub label: &'static str,
    /// One English sentence that says more.
    pub help: &'static str,
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

/// The tables of shapes. A row has a word, a label, a sentence of help, a unit, the default, the least and the greatest
/// value, and the step.
macro_rules! numbers {
    ($($shape:ident { $($word:ident: $label:literal, $help:literal, $unit:literal, $default:expr, $range:expr;)* })*) => {
        $(pub(crate) const $shape: &[ShapeNumber] = &[$(ShapeNumber {
            word: stringify!($word),
            label: $label,
            help: $help,
            unit: $unit,
            default: $default,
            least: $range[0],
            most: $range[1],
            step: $range[2],
        }),*];)*
    };
}
pub(crate) use numbers;

/// The table of an enum of shapes or buildings by rule. A row has the key in links, the English label, and the numbers.
macro_rules! by_rule {
    ($of:ident { $($own:ident: $word:literal, $label:literal, $numbers:expr;)* }) => {
        impl $of {
            /// All of them.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$own),*];

            fn row(self) -> (&'static str, &'static str, &'static [$crate::shapes::ShapeNumber]) {
                match self {
                    $(Self::$own => ($word, $label, $numbers),)*
                }
            }

            /// Its key in links.
            pub fn word(self) -> &'static str {
                self.row().0
            }

            /// Its English label.
            pub fn label(self) -> &'static str {
                self.row().1
            }

            /// Its numbers with their ranges.
            pub fn numbers(self) -> &'static [$crate::shapes::ShapeNumber] {
                self.row().2
            }

            /// The one with this key.
            pub fn of_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|own| own.word() == word)
            }

            /// All its numbers: the nearest valid values to those given, and defaults for the rest.
            pub fn fitted(self, given: &[f64]) -> Vec<f64> {
                let each = self.numbers().iter().enumerate();
                each.map(|(k, number)| number.fitted(given.get(k).copied().unwrap_or(number.default)))
                    .collect()
            }
        }
    };
}
pub(crate) use by_rule;

numbers! {
    TERRAIN {
        hills: "Hills across", "One of the numbers that the surface is made by.", "", 2.5, [1.0, 5.0, 0.1];
        height: "Height over width of a hill", "One of the numbers that the surface is made by.", "", 0.4, [0.0, 0.6, 0.02];
        lane: "Depth of the lane", "One of the numbers that the surface is made by.", "", 0.6, [0.0, 1.0, 0.05];
        wind: "How the lane winds", "One of the numbers that the surface is made by.", "", 0.5, [0.0, 1.0, 0.05];
        hill: "Which hills", "One of the numbers that the surface is made by.", "", 1.0, [1.0, 999.0, 1.0];
    }
    SLOPE {
        rise: "Angle of the slope", "One of the numbers that the surface is made by.", "°", 22.0, [0.0, 50.0, 1.0];
        landing: "Level ground at each end", "One of the numbers that the surface is made by.", "", 0.2, [0.0, 0.4, 0.02];
        width: "Width over length", "One of the numbers that the surface is made by.", "", 0.6, [0.2, 1.5, 0.05];
        round: "Roundness of the bends", "One of the numbers that the surface is made by.", "", 0.5, [0.0, 1.0, 0.05];
    }
    STAIRS {
        steps: "Steps", "One of the numbers that the surface is made by.", "", 5.0, [2.0, 12.0, 1.0];
        pitch: "Riser over tread", "One of the numbers that the surface is made by.", "", 0.55, [0.3, 1.2, 0.05];
        width: "Width over length", "One of the numbers that the surface is made by.", "", 0.8, [0.3, 1.5, 0.05];
        landing: "Landing at the top, in treads", "One of the numbers that the surface is made by.", "", 1.0, [1.0, 4.0, 0.25];
    }
    CYLINDER {
        height: "Height over diameter", "One of the numbers that the surface is made by.", "", 1.2, [0.3, 3.0, 0.05];
        top: "Width at the top over that below", "One of the numbers that the surface is made by.", "", 1.0, [0.4, 1.6, 0.05];
        belly: "Belly, or waist below 0", "One of the numbers that the surface is made by.", "", 0.0, [-0.35, 0.5, 0.05];
        caps: "Ends", "One of the numbers that the surface is made by.", "", 1.0, [0.0, 1.0, 1.0];
    }
    SPHERE {
        height: "Height over width", "One of the numbers that the surface is made by.", "", 1.0, [0.4, 2.0, 0.05];
        depth: "Depth over width", "One of the numbers that the surface is made by.", "", 1.0, [0.4, 2.0, 0.05];
        square: "Squareness", "One of the numbers that the surface is made by.", "", 2.0, [2.0, 6.0, 0.1];
    }
    TORUS {
        tube: "Radius of the tube over that of the ring", "One of the numbers that the surface is made by.", "", 0.4, [0.12, 0.75, 0.01];
        height: "Height of the tube over its width", "One of the numbers that the surface is made by.", "", 1.0, [0.5, 2.0, 0.05];
        waves: "Waves around", "One of the numbers that the surface is made by.", "", 0.0, [0.0, 8.0, 1.0];
        swell: "Depth of the waves over the greatest possible", "One of the numbers that the surface is made by.", "", 0.5, [0.0, 1.0, 0.05];
    }
    KNOT {
        turns: "Turns around the middle", "One of the numbers that the surface is made by.", "", 2.0, [2.0, 3.0, 1.0];
        lobes: "Lobes", "One of the numbers that the surface is made by.", "", 3.0, [3.0, 8.0, 1.0];
        tube: "Thickness over the room there is", "One of the numbers that the surface is made by.", "", 0.7, [0.35, 0.85, 0.05];
        swing: "How far lobes swing in and out", "One of the numbers that the surface is made by.", "", 0.42, [0.25, 0.52, 0.01];
        height: "Height over depth of the swing", "One of the numbers that the surface is made by.", "", 0.9, [0.6, 1.4, 0.05];
    }
    HORN {
        turns: "Turns", "One of the numbers that the surface is made by.", "", 2.0, [0.25, 3.0, 0.05];
        rise: "How far it winds out of its plane", "One of the numbers that the surface is made by.", "", 1.0, [0.0, 2.0, 0.05];
        taper: "Width of the tip over that of the root", "One of the numbers that the surface is made by.", "", 0.14, [0.08, 0.6, 0.01];
        girth: "Thickness over the room there is", "One of the numbers that the surface is made by.", "", 0.7, [0.35, 0.85, 0.05];
    }
    LEG {
        toes: "Toes", "One of the numbers that the surface is made by.", "", 4.0, [3.0, 5.0, 1.0];
        spread: "Angle between toes", "One of the numbers that the surface is made by.", "°", 27.0, [21.0, 34.0, 1.0];
        bend: "Bend of the knee", "One of the numbers that the surface is made by.", "°", 34.0, [0.0, 55.0, 1.0];
        girth: "Thickness", "One of the numbers that the surface is made by.", "", 1.0, [0.75, 1.25, 0.05];
        reach: "Length of the toes", "One of the numbers that the surface is made by.", "", 1.0, [0.7, 1.35, 0.05];
    }
    TAIL {
        curl: "Curl", "One of the numbers that the surface is made by.", "°", 290.0, [0.0, 450.0, 5.0];
        taper: "Width of the tip over that of the root", "One of the numbers that the surface is made by.", "", 0.2, [0.1, 0.6, 0.01];
        girth: "Width of the root over the length", "One of the numbers that the surface is made by.", "", 0.17, [0.08, 0.26, 0.01];
        lift: "How far it winds out of its plane", "One of the numbers that the surface is made by.", "", 0.3, [0.0, 1.0, 0.05];
    }
    FISH {
        height: "Height of the body over the length", "One of the numbers that the surface is made by.", "", 0.36, [0.22, 0.52, 0.01];
        width: "Width of the body over its height", "One of the numbers that the surface is made by.", "", 0.46, [0.34, 0.7, 0.02];
        tail: "Size of the tail", "One of the numbers that the surface is made by.", "", 1.0, [0.7, 1.3, 0.05];
        fins: "Size of the fins", "One of the numbers that the surface is made by.", "", 1.0, [0.7, 1.3, 0.05];
        swim: "Bend to the side", "One of the numbers that the surface is made by.", "°", 14.0, [-40.0, 40.0, 2.0];
    }
    TURTLE {
        width: "Width over length", "One of the numbers that the surface is made by.", "", 0.8, [0.6, 1.0, 0.01];
        height: "Height over length", "One of the numbers that the surface is made by.", "", 0.34, [0.18, 0.55, 0.01];
        rim: "Rim", "One of the numbers that the surface is made by.", "", 0.5, [0.0, 1.0, 0.05];
        keel: "Keels along the back", "One of the numbers that the surface is made by.", "", 0.4, [0.0, 1.0, 0.05];
    }
    EGG {
        height: "Height over width", "One of the numbers that the surface is made by.", "", 1.35, [0.8, 1.9, 0.05];
        point: "How pointed the top is", "One of the numbers that the surface is made by.", "", 0.2, [0.0, 0.4, 0.02];
        base: "How flat it stands", "One of the numbers that the surface is made by.", "", 0.0, [0.0, 0.3, 0.01];
    }
    VASE {
        height: "Height over width", "One of the numbers that the surface is made by.", "", 1.5, [1.0, 2.4, 0.05];
        shoulder: "Height of the widest place", "One of the numbers that the surface is made by.", "", 0.52, [0.35, 0.65, 0.01];
        neck: "Width of the neck over the widest", "One of the numbers that the surface is made by.", "", 0.42, [0.3, 0.8, 0.01];
        lip: "Width of the lip over that of the neck", "One of the numbers that the surface is made by.", "", 1.35, [1.0, 1.7, 0.05];
        hollow: "Depth inside over the height", "One of the numbers that the surface is made by.", "", 0.6, [0.2, 0.85, 0.05];
    }
    LETTER {
        letter: "Letter", "One of the numbers that the surface is made by.", "", 1.0, [1.0, 26.0, 1.0];
        weight: "Width of strokes over height", "One of the numbers that the surface is made by.", "", 0.18, [0.13, 0.22, 0.01];
        depth: "Depth over height", "One of the numbers that the surface is made by.", "", 0.26, [0.14, 0.5, 0.02];
        round: "Roundness of edges", "One of the numbers that the surface is made by.", "", 0.6, [0.35, 1.0, 0.05];
        lean: "Lean", "One of the numbers that the surface is made by.", "°", 0.0, [-10.0, 20.0, 1.0];
    }
}

by_rule! {
    Shape {
        Terrain: "terrain", "Terrain", TERRAIN;
        Slope: "slope", "Slope", SLOPE;
        Stairs: "stairs", "Stairs", STAIRS;
        Cylinder: "cylinder", "Cylinder", CYLINDER;
        Sphere: "sphere", "Sphere", SPHERE;
        Torus: "torus", "Torus", TORUS;
        Knot: "knot", "Knot", KNOT;
        Horn: "horn", "Horn", HORN;
        Leg: "leg", "Leg", LEG;
        Tail: "tail", "Tail", TAIL;
        Fish: "fish", "Fish", FISH;
        Turtle: "turtle", "Turtle's back", TURTLE;
        Egg: "egg", "Egg", EGG;
        Vase: "vase", "Vase", VASE;
        Letter: "letter", "Letter", LETTER;
    }
}
