//! What the studio asks of a specimen.

use super::{Grid, Specimen, finish, grid};
use crate::export::{Map, MapKind, Report, maps};
use crate::generators::bigger::{Bigger, Picture};
use crate::generators::height_field::{Bodies, HeightField};
use crate::generators::{Clock, Engine, PictureSlice, Progress, common};
use crate::graph::State;
use crate::heightfield::Planes;
use crate::notice::{Code, Notice};
use crate::recipe::Recipe;

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
            &light.materials,
            light.shade.shininess,
        ))
    }

    fn picture_file(
        &mut self,
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        let mut kept = self.bigger.take();
        let picture = Picture {
            side: self.side(),
            revision: self.planes().map(|_| self.finish.light.revision()),
            bodies: self.bodies(),
        };
        let params = || finish(&self.working, order.0);
        let slice = Bigger::advance(&mut kept, &picture, (order, &params), clock, budget);
        self.bigger = kept;
        slice
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
