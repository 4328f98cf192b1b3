//! The first stage: the components of all types, with their variants.

use super::params::{ComponentParams, ComponentSource};
use crate::component::{Component, ComponentFault, Original, OriginalMaking, VariantMaking};
use crate::generators::scene_picture::Loaded;
use crate::notice::Notice;
use crate::trimesh::Soup;
use std::rc::Rc;
use std::sync::Arc;

/// Triangles, samples or balls in a slice.
const SLICE: usize = 150;

/// A component's variants.
#[derive(Clone)]
pub(super) struct Variants {
    pub source: ComponentSource,
    /// The variants; the first one is the component itself.
    pub all: Vec<Arc<Component>>,
    /// Notices about faults of its file.
    pub notices: Vec<Notice>,
    key: (u64, u64),
}

/// The components of all types.
pub(super) type Components = Vec<Rc<Variants>>;

/// Components in progress.
#[derive(Default)]
pub(super) struct ComponentsMaking {
    made: Components,
    part: Part,
}

#[derive(Default)]
enum Part {
    #[default]
    Next,
    Original(Box<OriginalMaking>),
    Variants {
        original: Arc<Original>,
        made: Vec<Arc<Component>>,
        making: Box<VariantMaking>,
    },
}

impl ComponentsMaking {
    /// Does one slice. Components that were made before are taken from `kept`, and new ones are added to it.
    ///
    /// # Errors If a file of the recipe gives no component.
    pub fn advance(
        params: &ComponentParams,
        work: &mut Option<ComponentsMaking>,
        loaded: &Loaded,
        kept: &mut Components,
    ) -> Result<Option<Components>, Notice> {
        let making = work.get_or_insert_default();
        let Some(&source) = params.sources.get(making.made.len()) else {
            *kept = making.made.clone();
            return Ok(Some(std::mem::take(&mut making.made)));
        };
        let key = (params.seed, params.variants);
        if let Some(variants) = making.next((source, key), loaded, kept)? {
            making.made.push(variants);
            making.part = Part::Next;
        }
        Ok(None)
    }

    fn next(
        &mut self,
        (source, key): (ComponentSource, (u64, u64)),
        loaded: &Loaded,
        kept: &Components,
    ) -> Result<Option<Rc<Variants>>, Notice> {
        let (seed, count) = key;
        match &mut self.part {
            Part::Next => {
                let before = kept.iter().chain(&self.made);
                let mut same = before.filter(|one| one.source == source && one.key == key);
                if let Some(same) = same.next() {
                    return Ok(Some(same.clone()));
                }
                self.part = Part::Original(Box::new(begin(source, loaded)));
            }
            Part::Original(making) => {
                if let Some(original) = making.advance(SLICE) {
                    let original = Arc::new(original.map_err(ComponentFault::notice)?);
                    self.part = Part::Variants {
                        making: Box::new(VariantMaking::new(original.clone(), seed, 0)),
                        made: Vec::new(),
                        original,
                    };
                }
            }
            Part::Variants {
                original,
                made,
                making,
            } => {
                if let Some(variant) = making.advance(SLICE) {
                    made.push(Arc::new(variant));
                    let number = made.len() as u64;
                    if number == count {
                        return Ok(Some(Rc::new(Variants {
                            source,
                            all: std::mem::take(made),
                            notices: original.notices.clone(),
                            key,
                        })));
                    }
                    **making = VariantMaking::new(original.clone(), seed, number);
                }
            }
        }
        Ok(None)
    }
}

fn begin(source: ComponentSource, loaded: &Loaded) -> OriginalMaking {
    match source {
        ComponentSource::Kind(kind) => OriginalMaking::of_kind(kind),
        ComponentSource::File(number, _) => {
            let mesh = &loaded.meshes[number];
            OriginalMaking::of_file(unit_size(Soup {
                positions: mesh.positions().to_vec(),
                triangles: mesh.triangles().to_vec(),
            }))
        }
    }
}

/// The same triangles, moved and scaled so that half of their longest side is 1, as components by rule are.
fn unit_size(mut soup: Soup) -> Soup {
    let first = soup.positions[0];
    let (low, high) = soup
        .positions
        .iter()
        .fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low).max_element());
    for p in &mut soup.positions {
        *p = (*p - middle) / half;
    }
    soup
}
