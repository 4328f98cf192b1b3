//! The finisher of pictures in the plane: stones are painted into planes, then weathered, then lit.

use super::lighting::LightParams;
use crate::cells::Cell;
use crate::domain::Domain;
use crate::graph::Node;
use crate::heightfield::{Painted, Painter, Planes, Shader, TextureParams, Weathering};
use crate::material::{Coat, WeatherParams};
use crate::solid::Solids;

/// Rows of the picture in one slice.
pub(super) const ROWS: usize = 16;

/// The parameters of painting stones into planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlaneParams {
    pub texture: TextureParams,
    /// Loop steps of skin beyond those that a picture needs.
    pub finer: i32,
}

/// The parameters of all stages of the finisher.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HeightFieldParams {
    pub planes: PlaneParams,
    pub weather: WeatherParams,
    pub light: LightParams,
}

/// The three stages of the finisher with their results: planes, weather and light.
pub(super) struct HeightField {
    /// The last planes, 13 bytes a pixel and their ground, are kept while stones are painted again. If the recipe
    /// returns to the parameters of the kept planes, nothing has to be painted.
    pub planes: Node<PlaneParams, Painting, Painted>,
    pub weather: Node<WeatherParams, Weathering, Planes>,
    /// The picture: opaque RGBA, row after row from the top.
    pub light: Node<LightParams, (), Vec<u8>>,
    solids: Solids,
    shader: Option<Shader>,
}

/// The inputs of the finisher.
#[derive(Clone, Copy)]
pub(super) struct Bodies<'a> {
    pub domain: &'a Domain,
    /// The cells of the stones. `coats` holds the coat that the rule of colours gives each of them.
    pub cells: &'a [Cell],
    pub coats: &'a [Coat],
}

impl HeightField {
    /// Starts with nothing made.
    pub fn new(params: HeightFieldParams) -> Self {
        Self {
            solids: solids(&params.planes),
            planes: Node::new(params.planes),
            weather: Node::new(params.weather),
            light: Node::new(params.light),
            shader: None,
        }
    }

    /// Notes the parameters of the latest recipe.
    pub fn ask(&mut self, params: HeightFieldParams) {
        self.planes.ask(params.planes);
        self.weather.ask(params.weather);
        self.light.ask(params.light);
    }

    /// Paints some of the bodies into planes.
    pub fn paint(&mut self, bodies: Bodies) -> Option<()> {
        let solids = &mut self.solids;
        self.planes.advance(|params, work| {
            let Some(painting) = work else {
                *work = Some(Painting::new(params, bodies.coats, usize::MAX));
                return Ok(None);
            };
            if !painting.advance(solids, bodies.cells) {
                return Ok(None);
            }
            let painting = work.take();
            Ok(painting.map(Painting::finish))
        })
    }

    /// Does one slice of the weather.
    pub fn weather(&mut self, domain: &Domain) -> Option<()> {
        let painted = self.planes.made()?;
        self.weather.advance(|params, work| {
            work.get_or_insert_with(|| Weathering::new(*params, painted.clone()));
            let over = work.take_if(|weathering| weathering.advance(domain, ROWS));
            Ok(over.map(Weathering::finish))
        })
    }

    /// Shades some rows of the picture.
    pub fn shade(&mut self) -> Option<()> {
        let planes = self.weather.made()?;
        let kept = &mut self.shader;
        self.light.advance(|params, begun| {
            // Under another light the same shader continues and keeps its tables.
            let fits = kept.take().filter(|shader| shader.side() == planes.side);
            let new = || Shader::new(&params.shade, planes.side, planes.pixel_scale);
            let shader = kept.insert(fits.unwrap_or_else(new));
            if begun.replace(()).is_none() {
                shader.restart(&params.shade);
            }
            let done = shader.advance(planes, &params.materials, ROWS);
            Ok(done.then(|| shader.rgba().to_vec()))
        })
    }

    /// The present parameters, for a picture with `pixel_scale` pixels for each unit.
    pub fn params(&self, pixel_scale: usize) -> HeightFieldParams {
        let mut planes = *self.planes.params();
        planes.texture.pixel_scale = pixel_scale;
        HeightFieldParams {
            planes,
            weather: *self.weather.params(),
            light: self.light.params().clone(),
        }
    }
}

/// The greatest detail of solids, in pixels for each unit. More triangles would show nothing new, because bodies are
/// smooth, and would take most of the memory.
const MOST_DETAIL: usize = 4;

/// A maker of solids with the detail that these planes need.
pub(super) fn solids(params: &PlaneParams) -> Solids {
    Solids::for_picture(params.texture.pixel_scale.min(MOST_DETAIL), params.finer)
}

/// Planes that are being painted.
pub(super) struct Painting {
    painter: Painter,
    is_bedded: bool,
    stones: usize,
}

impl Painting {
    /// Starts the painting. Stones are painted into `band` rows at a time.
    pub fn new(params: &PlaneParams, coats: &[Coat], band: usize) -> Self {
        let mut painter = Painter::banded(params.texture, band);
        painter.set_coats(coats);
        Self {
            painter,
            is_bedded: false,
            stones: 0,
        }
    }

    /// Does one slice: some ground or a stone; true when all stones are in the band's rows.
    pub fn advance(&mut self, solids: &mut Solids, cells: &[Cell]) -> bool {
        if !self.is_bedded {
            self.is_bedded = self.painter.lay_ground(ROWS);
            return false;
        }
        if let Some(cell) = cells.get(self.stones) {
            let done = self.painter.paint_slice(solids, cell, self.stones);
            self.stones += usize::from(done);
        }
        self.stones >= cells.len()
    }

    /// Goes on to the next band; false if none is left.
    pub fn next_band(&mut self) -> bool {
        (self.is_bedded, self.stones) = (false, 0);
        self.painter.next_band()
    }

    /// The number of stones that are painted in the present band.
    pub fn stones(&self) -> usize {
        self.stones
    }

    /// Whether the ground is laid.
    pub fn is_bedded(&self) -> bool {
        self.is_bedded
    }

    /// The planes as painted so far.
    pub fn planes(&self) -> &Planes {
        self.painter.planes()
    }

    /// Ids of the band's rows.
    pub fn ids(&self) -> &[u32] {
        self.painter.band_ids()
    }

    /// The planes with all stones in them.
    pub fn finish(self) -> Painted {
        self.painter.finish()
    }
}
