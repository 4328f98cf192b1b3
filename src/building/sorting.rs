//! Faces of a draft in an order that does not depend on their order in a file.

use super::draft::{Draft, DraftFace};
use crate::order::rank;
use glam::DVec3;

impl Draft {
    /// The draft with its faces sorted by the places of their corners: patterns number features in this order.
    pub fn sorted(mut self) -> Self {
        let vertices = &self.vertices;
        self.faces.sort_by_cached_key(|face| key(face, vertices));
        self
    }
}

/// The ranks of the coordinates of a face's corners, each loop from its least corner on.
fn key(face: &DraftFace, vertices: &[DVec3]) -> Vec<Vec<[u64; 3]>> {
    let place = |v: &u32| vertices.get(*v as usize).map(|p| p.to_array().map(rank));
    let loops = face.loops.iter().map(|ring| {
        let mut places: Vec<[u64; 3]> = ring.iter().filter_map(place).collect();
        let least = (0..places.len()).min_by_key(|&k| places[k]);
        places.rotate_left(least.unwrap_or(0));
        places
    });
    loops.collect()
}

#[cfg(test)]
mod tests {
    use super::super::rules::{Module, Rule};

    #[test]
    fn the_order_of_faces_is_forgotten() {
        for rule in Rule::ALL {
            let draft = rule.draft(&Module::NORMAL, &[]);
            let mut other = draft.clone();
            other.faces.reverse();
            assert_eq!(draft.sorted(), other.sorted(), "{}", rule.word());
        }
    }
}
