//! What each stage has made, and one slice of each stage's work.

use super::translate;
use crate::cells::{self, Cell, Fitting, Graph, Scatter};
use crate::domain::{Domain, Outline};
use crate::field::{FieldBuilder, Fields};
use crate::mesh::{Mesh, Meshing};
use crate::packing::{Packing, Placing};
use crate::recipe::{Recipe, Stage};
use crate::render::Shader;
use crate::solid::{Quarry, oriented};
use crate::texture::{Coat, Coats, Painter, Planes};

/// Rows of the picture in one slice of the stages that go by rows.
const ROWS: usize = 16;
/// Cells whose neighbours are found, or whose coats are made, in one slice.
const CELLS: usize = 500;

/// The finished products of the stages, and those in the making.
pub(super) struct Products {
    pub outline: Outline,
    pub domain: Option<Domain>,
    builder: Option<FieldBuilder>,
    pub fields: Option<Fields>,
    placing: Option<Placing>,
    pub packing: Option<Packing>,
    /// Is `packing` of the pass at work, not of an earlier one?
    pub packing_begun: bool,
    meshing: Option<Meshing>,
    pub mesh: Option<Mesh>,
    scatter: Option<Scatter>,
    fitting: Option<Fitting>,
    pub cells: Vec<Cell>,
    /// The cells in which the flow has one sense, while there is skin.
    pub scales: Vec<Cell>,
    graph: Option<Graph>,
    pub quarry: Quarry,
    dresser: Option<Coats>,
    /// What the cells wear by rule; none while other cells form.
    pub coats: Vec<Coat>,
    pub painter: Option<Painter>,
    /// Is the ground laid in the pass at work?
    pub bedded: bool,
    /// Stones painted in the pass at work, or in the last one.
    pub stones: usize,
    pub planes: Option<Planes>,
    shader: Option<Shader>,
    /// Is the shader still to begin in the pass at work?
    lit_anew: bool,
    pub picture: Vec<u8>,
    /// Counts the passes over the stones.
    pub pass: u64,
    /// Is the pavement forming anew, so that older pictures are of another one?
    pub forming: bool,
}

impl Products {
    pub fn new(outline: Outline) -> Self {
        Self {
            outline,
            domain: None,
            builder: None,
            fields: None,
            placing: None,
            packing: None,
            packing_begun: false,
            meshing: None,
            mesh: None,
            scatter: None,
            fitting: None,
            cells: Vec::new(),
            scales: Vec::new(),
            graph: None,
            quarry: Quarry::new(),
            dresser: None,
            coats: Vec::new(),
            painter: None,
            bedded: false,
            stones: 0,
            planes: None,
            shader: None,
            lit_anew: true,
            picture: Vec::new(),
            pass: 0,
            forming: true,
        }
    }

    /// Drops the half-done work of a stage and of those after it. What is finished stays to be
    /// shown.
    pub fn forget_work(&mut self, from: Stage) {
        self.builder = None;
        self.placing = None;
        self.meshing = None;
        self.scatter = None;
        self.fitting = None;
        self.graph = None;
        self.lit_anew = true;
        if from < Stage::Planes {
            self.painter = None;
            self.bedded = false;
        }
        if from <= Stage::Cells {
            self.coats.clear();
        }
        if from <= Stage::Packing {
            self.packing_begun = false;
            self.forming = true;
        }
    }

    /// One slice of a stage's work; true when the stage is finished.
    pub fn slice(&mut self, stage: Stage, recipe: &Recipe) -> Result<bool, String> {
        match stage {
            Stage::Domain => self.slice_domain(recipe),
            Stage::Fields => self.slice_fields(recipe),
            Stage::Packing => self.slice_packing(recipe),
            Stage::Mesh => self.slice_mesh(),
            Stage::Cells => self.slice_cells(recipe),
            Stage::Solids => self.slice_solids(recipe),
            Stage::Planes => self.slice_planes(),
            Stage::Shading => self.slice_shading(recipe),
        }
    }

    fn slice_domain(&mut self, recipe: &Recipe) -> Result<bool, String> {
        self.domain = Some(translate::domain(recipe, &self.outline));
        Ok(true)
    }

    fn slice_fields(&mut self, recipe: &Recipe) -> Result<bool, String> {
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        let builder = self
            .builder
            .get_or_insert_with(|| FieldBuilder::new(domain, translate::fields(recipe, domain)));
        if !builder.advance(domain) {
            return Ok(false);
        }
        self.fields = self.builder.take().map(FieldBuilder::finish);
        Ok(true)
    }

    fn slice_packing(&mut self, recipe: &Recipe) -> Result<bool, String> {
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        let fields = self.fields.as_ref().ok_or(MISSING)?;
        if let (true, Some(packing)) = (self.packing_begun, &mut self.packing) {
            return Ok(packing.step(domain, fields).done);
        }
        let mut placing = match self.placing.take() {
            Some(placing) => placing,
            None => Placing::new(domain, fields, translate::packing(recipe))?,
        };
        if !placing.advance(domain, fields) {
            self.placing = Some(placing);
            return Ok(false);
        }
        let packing = placing.finish(domain, fields);
        if packing.report().cells == 0 {
            return Err(NO_CELLS.into());
        }
        self.packing = Some(packing);
        self.packing_begun = true;
        Ok(false)
    }

    fn slice_mesh(&mut self) -> Result<bool, String> {
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        let packing = self.packing.as_ref().ok_or(MISSING)?;
        let meshing = self
            .meshing
            .get_or_insert_with(|| Meshing::new(domain, packing.particles()));
        let Some(mesh) = meshing.advance(domain) else {
            return Ok(false);
        };
        self.meshing = None;
        self.mesh = Some(mesh);
        Ok(true)
    }

    fn slice_cells(&mut self, recipe: &Recipe) -> Result<bool, String> {
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        let packing = self.packing.as_ref().ok_or(MISSING)?;
        let cells = if translate::as_packed(recipe) {
            cells::packed(&packing.particles())
        } else {
            let Some(fitting) = &mut self.fitting else {
                return self.begin_fitting(recipe);
            };
            if !fitting.advance(domain) {
                return Ok(false);
            }
            self.fitting.take().map_or(Vec::new(), Fitting::finish)
        };
        if cells.is_empty() {
            return Err(NO_CELLS.into());
        }
        self.cells = cells;
        self.scales.clear();
        Ok(true)
    }

    /// The way to the fitting: that of the packed cells at once, that of scattered points when they
    /// have come to rest.
    fn begin_fitting(&mut self, recipe: &Recipe) -> Result<bool, String> {
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        let fields = self.fields.as_ref().ok_or(MISSING)?;
        let packing = self.packing.as_ref().ok_or(MISSING)?;
        self.fitting = match translate::scatter(recipe, packing.report().cells) {
            None => Some(Fitting::new(packing.particles())),
            Some(params) => {
                let scatter = self
                    .scatter
                    .get_or_insert_with(|| Scatter::new(domain, params));
                if !scatter.advance(domain) {
                    return Ok(false);
                }
                let points = self.scatter.take();
                points.map(|s| Fitting::voronoi(s.particles(fields)))
            }
        };
        Ok(false)
    }

    /// One slice of finding one sense for the flow; true when there is nothing left to find.
    fn slice_flow(&mut self) -> Result<bool, String> {
        if !self.scales.is_empty() {
            return Ok(true);
        }
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        let graph = self
            .graph
            .get_or_insert_with(|| Graph::new(domain, &self.cells));
        if graph.advance(domain, CELLS) {
            let links = self.graph.take().map_or(Vec::new(), Graph::finish);
            self.scales = oriented(&self.cells, &links);
        }
        Ok(false)
    }

    fn slice_solids(&mut self, recipe: &Recipe) -> Result<bool, String> {
        if recipe.is_skin() && !self.slice_flow()? {
            return Ok(false);
        }
        let Some(painter) = &mut self.painter else {
            let params = translate::texture(recipe);
            self.painter = Some(Painter::new(params));
            self.dresser = Some(Coats::new(&params));
            self.bedded = false;
            self.stones = 0;
            self.pass += 1;
            return Ok(false);
        };
        if let Some(dresser) = &mut self.dresser {
            let domain = self.domain.as_ref().ok_or(MISSING)?;
            if dresser.advance(domain, &self.cells, CELLS) {
                let coats = self.dresser.take().map(|d| d.finish(domain, &self.cells));
                self.coats = coats.unwrap_or_default();
                painter.dress(&self.coats);
            }
            return Ok(false);
        }
        if !self.bedded {
            self.bedded = painter.prepare(ROWS);
            return Ok(false);
        }
        let cells = match recipe.is_skin() {
            true => &self.scales,
            false => &self.cells,
        };
        if let Some(cell) = cells.get(self.stones) {
            let done = painter.paint_slice(&mut self.quarry, cell, self.stones);
            self.stones += usize::from(done);
        }
        Ok(self.stones >= cells.len())
    }

    fn slice_planes(&mut self) -> Result<bool, String> {
        let painter = self.painter.as_mut().ok_or(MISSING)?;
        let domain = self.domain.as_ref().ok_or(MISSING)?;
        if !painter.weather(domain, ROWS) || !painter.finish(ROWS) {
            return Ok(false);
        }
        self.planes = self.painter.take().map(Painter::into_planes);
        Ok(true)
    }

    fn slice_shading(&mut self, recipe: &Recipe) -> Result<bool, String> {
        let planes = self.planes.as_ref().ok_or(MISSING)?;
        let params = translate::shading(recipe);
        // Under another light the same shader goes on: its tables stay.
        let kept = self.shader.take().filter(|s| s.side() == planes.side);
        let shader = self
            .shader
            .insert(kept.unwrap_or_else(|| Shader::new(&params, planes.side, planes.fine)));
        if std::mem::take(&mut self.lit_anew) {
            shader.restart(&params);
        }
        let optics = translate::optics(recipe);
        if !shader.advance(planes, &optics, ROWS) {
            return Ok(false);
        }
        self.picture.clear();
        self.picture.extend_from_slice(shader.rgba());
        self.forming = false;
        Ok(true)
    }
}

/// Said where a stage would run before the ones it needs, which the order of stages rules out.
const MISSING: &str = "A stage is missing what it works on. Begin again (R).";

/// Said where nothing is left of a packing.
const NO_CELLS: &str =
    "Not one cell fits into the outline. Choose a smaller cell size or a larger outline.";
