//! The finisher of what lies in the plane: stones painted into planes, the weather over them, and
//! their light.

use super::lighting::LightParams;
use crate::cells::Cell;
use crate::domain::Domain;
use crate::graph::{Node, State};
use crate::heightfield::{Painted, Painter, Planes, Shader, TextureParams, Weathering};
use crate::material::{Coat, WeatherParams};
use crate::notice::Notice;
use crate::solid::Solids;

/// The stages of the finisher, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Finish {
    /// Bodies, painted as they are made into planes of bump, colour, material and id.
    Planes,
    /// What years and weather do to the planes, and how much of the sky each place sees.
    Weather,
    /// The picture.
    Shading,
}

/// Rows of the picture in one slice.
pub(super) const ROWS: usize = 16;

/// What planes are made by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlaneParams {
    pub texture: TextureParams,
    /// Loop steps of skin beyond those that a picture needs.
    pub finer: i32,
}

/// What is asked of all its stages.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HeightFieldParams {
    pub planes: PlaneParams,
    pub weather: WeatherParams,
    pub light: LightParams,
}

/// Planes, weather and light.
pub(super) struct HeightField {
    /// While stones are painted anew the last ones stay, 13 bytes a pixel and their ground: after a step back
    /// nothing has to be painted.
    pub planes: Node<PlaneParams, Painting, Painted>,
    pub weather: Node<WeatherParams, Weathering, Planes>,
    /// The picture: opaque RGBA, row after row from the top.
    pub light: Node<LightParams, (), Vec<u8>>,
    solids: Solids,
    shader: Option<Shader>,
}

/// What it is made of.
#[derive(Clone, Copy)]
pub(super) struct Bodies<'a> {
    pub domain: &'a Domain,
    /// The cells that stones are made of, and what they wear by rule.
    pub cells: &'a [Cell],
    pub coats: &'a [Coat],
}

/// Revisions of its inputs.
#[derive(Clone, Copy)]
pub(super) struct Revisions {
    pub domain: u64,
    /// Of the cells and coats, summed up.
    pub cells: u64,
}

impl HeightField {
    /// Nothing made yet.
    pub fn new(params: HeightFieldParams) -> Self {
        Self {
            solids: solids(&params.planes),
            planes: Node::new(params.planes),
            weather: Node::new(params.weather),
            light: Node::new(params.light),
            shader: None,
        }
    }

    /// What its stages are to be made by from now on.
    pub fn want(&mut self, params: HeightFieldParams) {
        if params.planes.finer != self.planes.params().finer {
            self.solids = solids(&params.planes);
        }
        self.planes.want(params.planes);
        self.weather.want(params.weather);
        self.light.want(params.light);
    }

    /// The first of its stages that is not fresh.
    pub fn due(&self, inputs: Revisions) -> Option<(Finish, State)> {
        let states = [
            (Finish::Planes, self.planes.state(inputs.cells)),
            (
                Finish::Weather,
                self.weather.state(self.weather_inputs(inputs)),
            ),
            (Finish::Shading, self.light.state(self.weather.revision())),
        ];
        let mut states = states.into_iter();
        states.find(|&(_, state)| state != State::Fresh)
    }

    fn weather_inputs(&self, inputs: Revisions) -> u64 {
        inputs.domain + self.planes.revision()
    }

    /// One slice of a stage.
    pub fn advance(&mut self, stage: Finish, bodies: Bodies, inputs: Revisions) {
        match stage {
            Finish::Planes => self.paint(bodies, inputs.cells),
            Finish::Weather => self.weather(bodies.domain, self.weather_inputs(inputs)),
            _ => self.shade(),
        }
    }

    fn paint(&mut self, bodies: Bodies, inputs: u64) {
        let solids = &mut self.solids;
        self.planes.advance(inputs, |params, work| {
            let Some(painting) = work else {
                *work = Some(Painting::new(params, bodies.coats, usize::MAX));
                return Ok(None);
            };
            if !painting.advance(solids, bodies.cells) {
                return Ok(None);
            }
            let painting = work.take();
            Ok(painting.map(Painting::finish))
        });
    }

    fn weather(&mut self, domain: &Domain, inputs: u64) {
        let Some(painted) = self.planes.made() else {
            return;
        };
        self.weather.advance(inputs, |params, work| {
            work.get_or_insert_with(|| Weathering::new(*params, painted.clone()));
            let over = work.take_if(|weathering| weathering.advance(domain, ROWS));
            Ok(over.map(Weathering::finish))
        });
    }

    fn shade(&mut self) {
        let Some(planes) = self.weather.made() else {
            return;
        };
        let kept = &mut self.shader;
        self.light
            .advance(self.weather.revision(), |params, begun| {
                // Under another light the same shader goes on: its tables stay.
                let fits = kept.take().filter(|shader| shader.side() == planes.side);
                let new = || Shader::new(&params.shade, planes.side, planes.pixel_scale);
                let shader = kept.insert(fits.unwrap_or_else(new));
                if begun.replace(()).is_none() {
                    shader.restart(&params.shade);
                }
                let done = shader.advance(planes, &params.materials, ROWS);
                Ok(done.then(|| shader.rgba().to_vec()))
            });
    }

    /// Why a stage cannot go on.
    pub fn failure(&self) -> Option<&Notice> {
        self.weather.failure()
    }

    /// Grows with every slice of work.
    pub fn slices(&self) -> u64 {
        self.planes.slices() + self.weather.slices() + self.light.slices()
    }

    /// The painting at work.
    fn painting(&self, inputs: Revisions) -> Option<&Painting> {
        self.planes.work_of(inputs.cells)
    }

    /// Stones painted by now.
    pub fn stones_coming(&self, inputs: Revisions) -> usize {
        self.painting(inputs).map_or(0, |painting| painting.stones)
    }

    /// Is the ground laid?
    pub fn is_bedded(&self, inputs: Revisions) -> bool {
        self.painting(inputs)
            .is_some_and(|painting| painting.is_bedded)
    }

    /// The planes as they are by now, while planes or weather are at work.
    pub fn planes_coming(&self, stage: Finish, inputs: Revisions) -> Option<&Planes> {
        match stage {
            Finish::Planes => Some(self.painting(inputs)?.painter.planes()),
            Finish::Weather => match self.weather.work_of(self.weather_inputs(inputs)) {
                Some(weathering) => Some(weathering.planes()),
                None => Some(&self.planes.made()?.planes),
            },
            _ => None,
        }
    }
}

/// More triangles than for so many pixels of a unit show nothing new: bodies are smooth, and take most of the memory.
const MOST_DETAIL: usize = 4;

/// Solids as detailed as these planes need them.
pub(super) fn solids(params: &PlaneParams) -> Solids {
    Solids::for_picture(params.texture.pixel_scale.min(MOST_DETAIL), params.finer)
}

/// Planes on their way.
pub(super) struct Painting {
    painter: Painter,
    is_bedded: bool,
    stones: usize,
}

impl Painting {
    /// Stones are to be put into `band` rows at a time.
    pub fn new(params: &PlaneParams, coats: &[Coat], band: usize) -> Self {
        let mut painter = Painter::banded(params.texture, band);
        painter.set_coats(coats);
        Self {
            painter,
            is_bedded: false,
            stones: 0,
        }
    }

    /// One slice: some ground or a stone; true when all stones are in the band's rows.
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

    /// Goes on to the next band; false where there is none left.
    pub fn next_band(&mut self) -> bool {
        (self.is_bedded, self.stones) = (false, 0);
        self.painter.next_band()
    }

    /// Stones painted by now, of the band at work.
    pub fn stones(&self) -> usize {
        self.stones
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
