//! Materials: how surfaces reflect light, and the rows of a picture's table of materials.

/// Phong's optical attributes (Miyata, Itoh, Shimada 2000, section 3.2: A, D, S, N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Share of the sky's light reflected, 0..1 (A).
    pub ambient: f32,
    /// Share of the lamp's light scattered, 0..1 (D).
    pub diffuse: f32,
    /// Share of the lamp's light mirrored, 0..1 (S).
    pub specular: f32,
    /// Exponent of the highlight, 1..200 (N).
    pub shininess: f32,
    /// How much the surface mirrors its surroundings at grazing angles, 0..1; only in space.
    pub mirror: f32,
    /// How far highlights and mirrored surroundings have the surface's colour, as those of metal, 0..1; only in space.
    pub metal: f32,
    /// How far the surroundings that it mirrors are a room with windows instead of an even sky, 0..1; only in space.
    pub room: f32,
    /// Share of the lamp's light that shines through from behind, 0..1; only in space, where it is for thin bodies.
    pub thin: f32,
}

impl Material {
    /// Brass, polished: its colour is in the highlights.
    pub const BRASS: Self = Self {
        mirror: 1.0,
        metal: 1.0,
        room: 1.0,
        ..Self::new(0.16, 0.16, 0.85, 60.0)
    };
    /// Steel and copper of small parts, which lie in a room.
    pub const TURNED: Self = Self {
        mirror: 1.0,
        metal: 1.0,
        room: 1.0,
        ..Self::new(0.12, 0.14, 0.9, 40.0)
    };
    /// Cooked rice, damp: it shines, and some light goes through.
    pub const DAMP_RICE: Self = Self {
        mirror: 0.7,
        thin: 0.25,
        ..Self::new(1.1, 0.9, 0.35, 70.0)
    };
    /// A leaf: thin, with a waxy side.
    pub const LEAF: Self = Self {
        mirror: 0.25,
        thin: 0.75,
        ..Self::new(1.0, 0.85, 0.15, 22.0)
    };
    /// Glass of bottles and blocks. It is opaque, and mirrors the sky and the ground.
    pub const GLASS: Self = Self {
        mirror: 1.0,
        ..Self::new(0.75, 0.4, 0.9, 180.0)
    };

    /// Steel, turned: its highlights are broader than those of brass.
    pub const STEEL: Self = Self {
        mirror: 1.0,
        metal: 1.0,
        ..Self::new(0.25, 0.22, 0.9, 40.0)
    };
    /// A varnished shell, as that of a fresh chestnut or a bean.
    pub const LACQUER: Self = Self {
        mirror: 0.85,
        ..Self::new(1.0, 0.88, 0.5, 80.0)
    };
    /// A waxed peel, or a toy's paint.
    pub const WAXED: Self = Self {
        mirror: 0.55,
        ..Self::new(1.0, 0.92, 0.35, 48.0)
    };
    /// A pebble that is still wet.
    pub const WET_STONE: Self = Self {
        mirror: 0.8,
        ..Self::new(1.0, 0.9, 0.4, 46.0)
    };
    /// A pebble that has dried, or fired clay.
    pub const DRY_STONE: Self = Self::new(1.0, 0.96, 0.06, 10.0);
    /// Oiled wood, a rough peel, or the skin of a kernel.
    pub const OILED: Self = Self {
        mirror: 0.2,
        ..Self::new(1.0, 0.94, 0.16, 20.0)
    };

    /// Moss and grass, which absorb some light.
    pub const PADS: Self = Self::new(0.97, 0.98, 0.0, 4.0);

    /// Phong's four attributes; it mirrors nothing, and no light goes through.
    pub const fn new(ambient: f32, diffuse: f32, specular: f32, shininess: f32) -> Self {
        Self {
            ambient,
            diffuse,
            specular,
            shininess,
            mirror: 0.0,
            metal: 0.0,
            room: 0.0,
            thin: 0.0,
        }
    }

    /// The same material with a film that mirrors its surroundings.
    const fn with_film(self, mirror: f32) -> Self {
        Self { mirror, ..self }
    }
}

/// Finishes of a stone; each palette has this many materials.
pub const FINISHES: usize = 3;

/// Hewn faces, worn ones, and ones polished by feet.
pub(super) const HEWN: [Material; FINISHES] = [
    Material::new(1.0, 0.96, 0.03, 6.0),
    Material::new(1.0, 0.95, 0.06, 10.0),
    Material::new(1.0, 0.93, 0.10, 16.0),
];

/// Dense stone that takes a sheen.
pub(super) const DENSE: [Material; FINISHES] = [
    Material::new(1.0, 0.95, 0.07, 9.0),
    Material::new(1.0, 0.93, 0.13, 16.0),
    Material::new(1.0, 0.92, 0.20, 26.0),
];

/// Sawn and polished.
pub(super) const POLISHED: [Material; FINISHES] = [
    Material::new(1.0, 0.92, 0.14, 22.0),
    Material::new(1.0, 0.90, 0.22, 34.0),
    Material::new(1.0, 0.90, 0.28, 48.0),
];

/// Powdery: brick, sandstone.
pub(super) const DULL: [Material; FINISHES] = [
    Material::new(1.0, 1.0, 0.01, 4.0),
    Material::new(1.0, 0.98, 0.03, 6.0),
    Material::new(1.0, 0.97, 0.05, 9.0),
];

/// Dry, soft skin.
pub(super) const LEATHER: [Material; FINISHES] = [
    Material::new(1.0, 0.98, 0.05, 7.0),
    Material::new(1.0, 0.96, 0.08, 10.0),
    Material::new(1.0, 0.95, 0.11, 13.0),
];

/// Scales with a satin sheen.
pub(super) const SATIN: [Material; FINISHES] = [
    Material::new(1.0, 0.94, 0.12, 13.0),
    Material::new(1.0, 0.93, 0.17, 18.0),
    Material::new(1.0, 0.92, 0.22, 24.0),
];

/// Horn: plates and claws.
pub(super) const HORN: [Material; FINISHES] = [
    Material::new(1.0, 0.94, 0.14, 20.0),
    Material::new(1.0, 0.92, 0.22, 30.0),
    Material::new(1.0, 0.91, 0.28, 42.0),
];

/// Fish, thinly coated and silvery.
pub(super) const PEARL: [Material; FINISHES] = [
    Material::new(1.06, 0.88, 0.30, 22.0),
    Material::new(1.06, 0.86, 0.40, 32.0),
    Material::new(1.08, 0.84, 0.50, 46.0),
];

/// Earth does not shine.
pub(super) const EARTH: Material = Material::new(1.0, 1.0, 0.0, 4.0);

/// Still water: its colour contains the sky's reflection.
pub(super) const POOL: Material = Material::new(1.15, 0.55, 0.85, 150.0).with_film(1.0);

/// Gloss of a palette's finishes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gloss {
    /// As the palette has it.
    #[default]
    Own,
    /// Powdery.
    Matt,
    /// Waxed.
    Glossy,
    /// Under a film of water.
    Wet,
}

impl Gloss {
    /// The gloss with this word, or [`Gloss::Own`].
    pub fn of_word(word: &str) -> Gloss {
        match word {
            "matt" => Gloss::Matt,
            "glossy" => Gloss::Glossy,
            "wet" => Gloss::Wet,
            _ => Gloss::Own,
        }
    }

    pub(crate) fn applied_to(self, own: Material) -> Material {
        // Factor of the diffuse part; factor and gain of the specular part, and of the exponent; the film.
        let [diffuse, specular, more, exponent, narrower, mirror] = match self {
            Gloss::Own => return own,
            Gloss::Matt => [1.0, 0.2, 0.0, 0.6, 0.0, 0.0],
            Gloss::Glossy => [0.97, 1.5, 0.15, 1.6, 8.0, 0.6],
            Gloss::Wet => [0.92, 1.4, 0.55, 1.2, 22.0, 1.0],
        };
        Material {
            ambient: own.ambient,
            diffuse: own.diffuse * diffuse,
            specular: own.specular * specular + more,
            shininess: own.shininess * exponent + narrower,
            mirror,
            ..own
        }
    }
}

/// The first row of the table: the ground. The finishes follow, from rough to smooth.
pub(crate) const GROUND_ROW: u8 = 0;
/// The two rows after the finishes.
pub(crate) const MOSS: u8 = FINISHES as u8 + 1;
pub(super) const DIRT: u8 = MOSS + 1;
/// All these rows occur three times: dry, damp, wet.
pub(super) const ROWS: u8 = DIRT + 1;
/// The last row.
pub(super) const WATER: u8 = 3 * ROWS;
