//! A grid of plain squares: the least that a generator is. It stands in builds for tests only, where
//! all that runs generators is tried with it.

use super::bigger::{Bigger, Picture};
use super::height_field::{Bodies, HeightField, HeightFieldParams, Passes, PlaneParams, Revisions};
use super::{Clock, Engine, Generator, PictureSlice, Preset, Progress, Views, common};
use crate::cells::Cell;
use crate::domain::{Domain, Outline};
use crate::export::{Map, MapKind, Report, maps};
use crate::field::Kind;
use crate::graph::{Node, State};
use crate::notice::{Code, Notice};
use crate::recipe::parameter::{int, number};
use crate::recipe::schema::{NoRules, rows};
use crate::recipe::{Recipe, Schema, common as shared};
use crate::solid::{Spread, StoneKind, StoneParams};
use crate::texture::{ColourParams, Planes, TextureParams};
use glam::DVec2;

rows! {
    size SIZE => shared::SIZE;
    across ACROSS: "Squares along a side." =>
        int("", "Squares").range(1.0, 32.0, 1.0, 6.0).group("Grid").main();
    gap GAP: "Between squares, in parts of one." =>
        number("", "Gap").range(0.0, 0.9, 0.05, 0.2).group("Grid");
    seed SEED => shared::SEED;
    fd FD => shared::FD;
    af AF => shared::AF;
    palette PALETTE => shared::PALETTE;
    vary VARY => shared::VARY;
    ground GROUND => shared::GROUND;
    gloss GLOSS => shared::GLOSS;
    wear WEAR => shared::WEAR;
    moss MOSS => shared::MOSS;
    dirt DIRT => shared::DIRT;
    wet WET => shared::WET;
    light LIGHT => shared::LIGHT;
    az AZ => shared::AZ;
    el EL => shared::EL;
    lx LX => shared::LX;
    ly LY => shared::LY;
    lz LZ => shared::LZ;
    amb AMB => shared::AMB;
    diff DIFF => shared::DIFF;
    spec SPEC => shared::SPEC;
    shin SHIN => shared::SHIN;
    shadow SHADOW => shared::SHADOW;
    occl OCCL => shared::OCCL;
}

/// The parameters of a specimen.
pub static SCHEMA: Schema = Schema {
    word: "specimen",
    is_named: true,
    rows: ROWS,
    rules: &NoRules,
};

/// The generator.
pub static SPECIMEN: Generator = Generator {
    schema: &SCHEMA,
    title: "Squares",
    presets: &[
        Preset {
            name: "squares",
            title: "Squares",
            group: "Squares",
            figure: "",
            note: "As they are.",
            link: "v=1&make=specimen",
            timing: None,
        },
        Preset {
            name: "few-squares",
            title: "Few squares",
            group: "Squares",
            figure: "",
            note: "Three along a side.",
            link: "v=1&make=specimen&across=3",
            timing: None,
        },
    ],
    stages: &["grid", "planes", "weather", "shading"],
    views: Views {
        bases: &["auto", "picture", "albedo"],
        overlays: &[],
    },
    offers: &[],
    engine: |recipe| Box::new(Specimen::new(recipe)),
};

/// The seed that panics, so that what becomes of panics can be tried.
const PANICS: f64 = 4_294_967_295.0;

/// What the squares are made by.
#[derive(Clone, Copy, Debug, PartialEq)]
struct GridParams {
    across: usize,
    gap: f64,
    side: f64,
    panics: bool,
}

/// The squares, and what they lie in.
struct Grid {
    domain: Domain,
    cells: Vec<Cell>,
}

/// The machine.
struct Specimen {
    latest: Recipe,
    working: Recipe,
    grid: Node<GridParams, (), Grid>,
    finish: HeightField,
    bigger: Option<Bigger>,
    frame: Vec<u8>,
}

fn grid(recipe: &Recipe) -> GridParams {
    GridParams {
        across: recipe.number(keys::ACROSS) as usize,
        gap: recipe.number(keys::GAP),
        side: recipe.side(),
        panics: recipe.number(keys::SEED) == PANICS,
    }
}

fn finish(recipe: &Recipe, fine: usize) -> HeightFieldParams {
    let size = recipe.side() / recipe.number(keys::ACROSS);
    let texture = TextureParams {
        side: common::side(recipe),
        fine,
        seed: common::seed(recipe),
        size,
        stone: StoneParams {
            kind: StoneKind::Flagstone,
            height: 0.3 * size,
            spread: Spread::Uniform,
            seed: common::seed(recipe),
            ..StoneParams::default()
        },
        dimension: recipe.number(keys::FD),
        amplitude: recipe.number(keys::AF),
        palette: recipe.choice(keys::PALETTE),
        ground: recipe.choice(keys::GROUND),
        vary: recipe.number(keys::VARY),
        colour: ColourParams::default(),
        tile: false,
    };
    HeightFieldParams {
        planes: PlaneParams { texture, finer: 0 },
        weather: common::weather(recipe),
        light: common::light(recipe),
    }
}

impl Grid {
    fn new(params: &GridParams) -> Self {
        assert!(!params.panics, "a panic that was asked for");
        let GridParams {
            across, gap, side, ..
        } = *params;
        let size = side / across as f64;
        let half = 0.5 * size * (1.0 - gap);
        let cell = |k: usize| {
            let place = DVec2::new((k % across) as f64 + 0.5, (k / across) as f64 + 0.5);
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let corner = |(x, y)| size * place + half * DVec2::new(x, y);
            Cell {
                id: k as u32,
                centre: size * place,
                kind: Kind::Square,
                size,
                aspect: 1.0,
                axis: DVec2::X,
                ring: corners.map(corner).to_vec(),
            }
        };
        let ring = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)];
        let outline = Outline {
            rings: vec![ring.map(DVec2::from).to_vec()],
            lines: Vec::new(),
        };
        Self {
            domain: Domain::from_checked(&outline),
            cells: (0..across * across).map(cell).collect(),
        }
    }
}

impl Specimen {
    fn new(recipe: &Recipe) -> Self {
        Self {
            latest: recipe.clone(),
            working: recipe.clone(),
            grid: Node::new(grid(recipe)),
            finish: HeightField::new(finish(recipe, 1), Passes::Many, usize::MAX),
            bigger: None,
            frame: Vec::new(),
        }
    }

    fn inputs(&self) -> Revisions {
        Revisions {
            domain: self.grid.revision(),
            cells: self.grid.revision(),
        }
    }

    fn bodies(&self) -> Option<Bodies<'_>> {
        let grid = self.grid.made()?;
        Some(Bodies {
            domain: &grid.domain,
            cells: &grid.cells,
            coats: &[],
        })
    }

    fn planes(&self) -> Option<&Planes> {
        self.finish.weather.made().filter(|_| self.at().is_none())
    }
}

impl Engine for Specimen {
    fn ask(&mut self, recipe: &Recipe) {
        self.latest = recipe.clone();
    }

    fn stale(&self) -> Option<usize> {
        let [old, new] = [&self.working, &self.latest];
        let finishes = [finish(old, 1), finish(new, 1)];
        let differences = [
            grid(old) != grid(new),
            finishes[0].planes != finishes[1].planes,
            finishes[0].weather != finishes[1].weather,
            finishes[0].light != finishes[1].light,
        ];
        differences.into_iter().position(|differs| differs)
    }

    fn take_up(&mut self) {
        self.working = self.latest.clone();
        self.grid.want(grid(&self.working));
        self.finish.want(finish(&self.working, 1));
    }

    fn forget(&mut self) {
        self.grid.forget();
    }

    fn side(&self) -> usize {
        common::side(&self.working)
    }

    fn at(&self) -> Option<usize> {
        if self.grid.state(0) != State::Fresh {
            return Some(0);
        }
        let (stage, _) = self.finish.due(self.inputs())?;
        Some(1 + stage as usize)
    }

    fn failure(&self) -> Option<&Notice> {
        None
    }

    fn advance(&mut self) {
        let inputs = self.inputs();
        let Some((stage, _)) = self.finish.due(inputs).filter(|_| self.at() != Some(0)) else {
            return self
                .grid
                .advance(0, |params, _| Ok(Some(Grid::new(params))));
        };
        let Some(grid) = self.grid.made() else {
            return;
        };
        let bodies = Bodies {
            domain: &grid.domain,
            cells: &grid.cells,
            coats: &[],
        };
        self.finish.advance(stage, bodies, inputs);
    }

    fn finisher(&self) -> usize {
        1
    }

    fn is_forming(&self) -> bool {
        self.at() == Some(0)
    }

    fn runs(&self) -> Vec<u64> {
        let HeightField {
            planes,
            weather,
            light,
            ..
        } = &self.finish;
        let finish = [planes.revision(), weather.revision(), light.revision()];
        [&[self.grid.revision()][..], &finish].concat()
    }

    fn progress(&self) -> Progress {
        let cells = self.grid.made().map_or(0, |grid| grid.cells.len());
        Progress {
            cells,
            stones: match self.at() {
                None => cells,
                Some(_) => self.finish.stones_coming(self.inputs()),
            },
            ..Progress::default()
        }
    }

    fn view(&mut self, words: &str) -> &[u8] {
        let albedo = self.planes().filter(|_| words == "albedo");
        let shown = albedo.map(|planes| {
            let pixel = |&[r, g, b]: &[u8; 3]| [r, g, b, 255];
            planes.colour.iter().flat_map(pixel).collect()
        });
        self.frame = shown.unwrap_or_else(|| self.picture().to_vec());
        let bytes = 4 * self.side() * self.side();
        if self.frame.len() != bytes {
            self.frame = vec![255; bytes];
        }
        &self.frame
    }

    fn prepare(&mut self, _: &str, _: Clock, _: f64) -> bool {
        true
    }

    fn absences(&mut self, _: &str) -> Vec<(&'static str, &'static str)> {
        Vec::new()
    }

    fn picture(&self) -> &[u8] {
        self.finish.light.made().map_or(&[], Vec::as_slice)
    }

    fn digest(&self) -> String {
        self.planes().map_or(String::new(), Planes::digest)
    }

    fn map(&self, kind: MapKind) -> Result<Map, Notice> {
        let planes = self.planes().ok_or(Code::NotYet)?;
        let light = common::light(&self.working);
        Ok(maps::map(
            kind,
            planes,
            &light.optics,
            light.shade.shininess,
        ))
    }

    fn picture_file(
        &mut self,
        scale: usize,
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        let mut kept = self.bigger.take();
        let picture = Picture {
            side: self.side(),
            revision: self.planes().map(|_| self.finish.light.revision()),
            bodies: self.bodies(),
        };
        let params = || finish(&self.working, scale);
        let slice = Bigger::advance(&mut kept, &picture, (scale, &params), clock, budget);
        self.bigger = kept;
        slice
    }

    fn bigger_map(&self, kind: MapKind) -> Result<Map, Notice> {
        let revision = self.finish.light.revision();
        let planes = self
            .bigger
            .as_ref()
            .and_then(|bigger| bigger.planes(revision));
        let planes = planes.ok_or(Code::NoBiggerPicture)?;
        let light = common::light(&self.working);
        Ok(maps::map(
            kind,
            planes,
            &light.optics,
            light.shade.shininess,
        ))
    }

    fn stop_file(&mut self) {
        self.bigger = None;
    }

    fn report(&mut self, report: &mut Report) {
        report.cells = self.progress().cells;
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)> {
        let cells = self.grid.made().map_or(&[][..], |grid| &grid.cells);
        vec![("cells.json", crate::export::cells_json(cells))]
    }
}
