//! The rules by which cells are marked, and their result for a cell.

/// The rule by which cells are marked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pattern {
    /// No cell is marked.
    #[default]
    Plain,
    /// Wavy bands.
    Bands,
    /// Round spots, scattered evenly.
    Spots,
    /// Round spots with a paler middle.
    Rosettes,
    /// Clouds of noise.
    Blotches,
    /// A reaction and diffusion from cell to cell: spots, a labyrinth or a net.
    Turing,
    /// Large cells.
    Size,
    /// Cells near the boundary.
    Boundary,
    /// Cells near constraint lines.
    Lines,
    /// Cells that point in a direction.
    Direction,
}

impl Pattern {
    /// All patterns with their words.
    pub const ALL: [(Pattern, &'static str); 10] = [
        (Pattern::Plain, "none"),
        (Pattern::Bands, "bands"),
        (Pattern::Spots, "spots"),
        (Pattern::Rosettes, "rosettes"),
        (Pattern::Blotches, "blotches"),
        (Pattern::Turing, "turing"),
        (Pattern::Size, "size"),
        (Pattern::Boundary, "boundary"),
        (Pattern::Lines, "lines"),
        (Pattern::Direction, "direction"),
    ];

    /// The pattern with this word, or [`Pattern::Plain`].
    pub fn of_word(word: &str) -> Pattern {
        let found = Self::ALL.iter().find(|(_, w)| *w == word);
        found.map_or(Pattern::Plain, |&(pattern, _)| pattern)
    }
}

/// Parameters of the cells' colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourParams {
    /// The rule by which cells are marked.
    pub pattern: Pattern,
    /// Distance between marks, or the reach of marks from the boundary or a line, in picture units.
    pub scale: f64,
    /// Direction across bands, or the direction of marked cells: radians from +x, clockwise on screen.
    pub angle: f64,
    /// Sharpness of the border between marked cells and others, 0..1.
    pub sharpness: f64,
    /// Share of marked cells, 0..1.
    pub share: f64,
    /// Share of the mark's colour in marked cells, 0..1.
    pub amount: f64,
    /// Darkens the rim of each cell if positive, its centre if negative, -1..1.
    pub rim: f64,
    /// How much tones change softly over the picture or body instead of from stone to stone, 0..1.
    pub soft: f64,
    /// Share of the belly's colour on the belly's side, 0..1.
    pub belly: f64,
    /// Direction towards the belly, radians from +x, clockwise on screen.
    pub belly_angle: f64,
}

impl ColourParams {
    /// No marks and no belly.
    pub const DEFAULT: Self = Self {
        pattern: Pattern::Plain,
        scale: 61.44,
        angle: 0.0,
        sharpness: 0.7,
        share: 0.5,
        amount: 1.0,
        rim: 0.0,
        soft: 0.0,
        belly: 0.0,
        belly_angle: std::f64::consts::FRAC_PI_2,
    };
}

impl Default for ColourParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The coat of one cell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coat {
    /// Share of the mark's colour, 0..1.
    pub mark: f32,
    /// Share of the belly's colour, 0..1.
    pub belly: f32,
    /// How much of the stone's tone comes from its place, 0..1.
    pub soft: f32,
    /// The tone of the cell's place: noise with standard deviation about 1.
    pub tone: f32,
}
