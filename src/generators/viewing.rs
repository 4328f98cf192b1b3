//! The words of the view in a link, for native programs. The page reads them in `www/state/asked-view.ts`.

use super::Generator;
use crate::scene::{Camera, Cut};

/// The part of a view that native programs can show: the view with its layers, the step at which the work stops, the
/// camera, a plane that cuts bodies away, and a step in the making of one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Viewing {
    /// The words of the view, joined by '+'.
    pub view: String,
    /// The step at which the work stops; `None` for finished work. Masonry counts blocks.
    pub step: Option<u32>,
    /// The camera; `None` if the link names none.
    pub camera: Option<Camera>,
    /// The word of [`Cut::read`] for bodies that are cut away; empty without one.
    pub cut: String,
    /// A body's id and the index of a step in its making, as `12:3`; empty for all bodies.
    pub body: String,
}

impl Viewing {
    /// A view of finished work with the usual camera. `view` holds words joined by '+'.
    pub fn of(view: &str) -> Self {
        Self {
            view: view.into(),
            step: None,
            camera: None,
            cut: String::new(),
            body: String::new(),
        }
    }

    /// Reads the words of a link or of a preset. There is no view if the text has none of the words `view`, `step`,
    /// `camera`, `cut` and `body`. Values that cannot be used are left out; each has a sentence in the returned list.
    pub fn read(text: &str, generator: &Generator) -> (Option<Self>, Vec<String>) {
        let fragment = text.rsplit('#').next().unwrap_or_default();
        let pairs = fragment.split('&').filter_map(|pair| pair.split_once('='));
        let mut asked = Self::of("auto");
        let (mut has_words, mut faults) = (false, Vec::new());
        for (key, value) in pairs {
            let told = match key {
                "view" => asked.take_view(value, generator),
                "step" => asked.take_step(value, generator),
                "camera" => asked.take_camera(value, generator),
                "cut" => asked.take_cut(value, generator),
                "body" => asked.take_body(value),
                _ => continue,
            };
            has_words = true;
            faults.extend(told.err());
        }
        (has_words.then_some(asked), faults)
    }

    fn take_view(&mut self, value: &str, generator: &Generator) -> Result<(), String> {
        let all = [generator.views.bases, generator.views.overlays].concat();
        match value.split('+').find(|word| !all.contains(word)) {
            Some(word) => Err(format!(
                "There is no view \"{word}\"; there are {}.",
                all.join(", ")
            )),
            None => {
                self.view = value.into();
                Ok(())
            }
        }
    }

    fn take_step(&mut self, value: &str, generator: &Generator) -> Result<(), String> {
        let step = value.parse().ok();
        self.step = step.filter(|_| generator.offers.contains(&"forming"));
        let said = || format!("The view cannot stop at step \"{value}\".");
        self.step.map(|_| ()).ok_or_else(said)
    }

    fn take_camera(&mut self, value: &str, generator: &Generator) -> Result<(), String> {
        let (camera, notices) = generator.camera().read(value);
        self.camera = Some(camera);
        match notices.first() {
            Some(notice) => Err(notice.to_string()),
            None => Ok(()),
        }
    }

    fn take_body(&mut self, value: &str) -> Result<(), String> {
        let numbers = value.split_once(':').map(|(id, step)| [id, step]);
        let are_numbers = |pair: [&str; 2]| pair.iter().all(|text| text.parse::<u32>().is_ok());
        if !numbers.is_some_and(are_numbers) {
            return Err(format!("The view cannot show \"{value}\" of a body."));
        }
        self.body = value.into();
        Ok(())
    }

    fn take_cut(&mut self, value: &str, generator: &Generator) -> Result<(), String> {
        let word = format!("whole={value}");
        if !generator.offers.contains(&"cut") || Cut::read(&word).is_none() {
            return Err(format!("The view cannot be cut by \"{value}\"."));
        }
        self.cut = word;
        Ok(())
    }
}
