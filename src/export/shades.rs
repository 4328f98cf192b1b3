//! Few shades for the many tints of a scene's bodies.
//!
//! Each body has a tint of its own, so a file would have hundreds of materials. Programs list each of them, draw each by
//! itself, and can share a mesh only between bodies of one material. So the tints of a material become a few shades, by
//! cutting the box around them in two again and again (Heckbert 1982, Color image quantization for frame buffer display).

use crate::scene::{Paint, Scene};
use std::collections::BTreeMap;

/// The most shades of a material: neighbours differ by less than is seen.
pub(super) const MOST: usize = 24;

/// A tint, and how many bodies have it.
type Tint = ([u8; 3], usize);

/// The shade of each paint.
pub(super) struct Shades(BTreeMap<Paint, Paint>);

impl Shades {
    /// The shades of the bodies of a scene. A material with at most [`MOST`] tints keeps them.
    pub fn new(scene: &Scene) -> Self {
        let mut rows: BTreeMap<u8, BTreeMap<[u8; 3], usize>> = BTreeMap::new();
        for paint in scene.instances.iter().filter_map(|instance| instance.paint) {
            let tints = rows.entry(paint.material).or_default();
            *tints.entry(paint.tint).or_default() += 1;
        }
        let mut shades = BTreeMap::new();
        for (material, tints) in rows {
            let of = |tint| Paint { tint, material };
            for group in groups(tints.into_iter().collect()) {
                let shade = mean(&group).map(|c| (c + 0.5) as u8);
                shades.extend(group.iter().map(|&(tint, _)| (of(tint), of(shade))));
            }
        }
        Self(shades)
    }

    /// The shade of a paint of the scene.
    pub fn of(&self, paint: Paint) -> Paint {
        self.0.get(&paint).copied().unwrap_or(paint)
    }
}

/// Tints in at most [`MOST`] groups of similar ones. The group that spreads most is cut at its mean.
fn groups(tints: Vec<Tint>) -> Vec<Vec<Tint>> {
    let mut groups = vec![tints];
    while groups.len() < MOST {
        let widest = groups.iter().map(|group| spread(group)).enumerate();
        let widest = widest.reduce(|a, b| if b.1.1 > a.1.1 { b } else { a });
        let Some((k, (channel, spread))) = widest else {
            break;
        };
        if spread == 0.0 {
            break;
        }
        let middle = mean(&groups[k])[channel];
        let is_low = |&(tint, _): &Tint| f64::from(tint[channel]) <= middle;
        let (low, high) = groups[k].iter().partition(|tint| is_low(tint));
        groups[k] = low;
        groups.push(high);
    }
    groups
}

/// The mean of tints (sRGB, 0..255).
fn mean(tints: &[Tint]) -> [f64; 3] {
    let count: usize = tints.iter().map(|(_, count)| count).sum();
    [0, 1, 2].map(|k| {
        let sum: usize = tints.iter().map(|(tint, n)| usize::from(tint[k]) * n).sum();
        sum as f64 / count as f64
    })
}

/// The channel in which tints spread most, and the sum of their squared differences from the mean in it.
fn spread(tints: &[Tint]) -> (usize, f64) {
    let mean = mean(tints);
    let of = |k: usize| {
        let squares = tints.iter().map(|&(tint, count)| {
            let by = f64::from(tint[k]) - mean[k];
            count as f64 * by * by
        });
        (k, squares.sum::<f64>())
    };
    let [first, rest @ ..] = [0, 1, 2].map(of);
    rest.into_iter()
        .fold(first, |a, b| if b.1 > a.1 { b } else { a })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn few_tints_stay_as_they_are() {
        let tints: Vec<Tint> = (0..MOST as u8).map(|k| ([k, 9 * k, 7], 1)).collect();
        let groups = groups(tints);
        assert_eq!(groups.len(), MOST);
        assert!(groups.iter().all(|group| group.len() == 1));
    }

    #[test]
    fn shades_are_near_the_tints_of_a_brick() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        let mut tint = || {
            // Bricks of one kiln are lighter or darker, and a little redder or less red.
            let (light, red) = (0.75 + 0.5 * random.unit(), random.unit());
            let tint = [150.0 + 20.0 * red, 80.0, 60.0].map(|c| (c * light) as u8);
            (tint, 1)
        };
        let tints: Vec<Tint> = (0..2000).map(|_| tint()).collect();
        let groups = groups(tints);
        assert_eq!(groups.len(), MOST);
        let worst = groups.iter().flat_map(|group| {
            let shade = mean(group);
            let by = move |tint: [u8; 3], k: usize| (f64::from(tint[k]) - shade[k]).abs();
            let from = move |&(tint, _): &Tint| [0, 1, 2].map(|k| by(tint, k));
            group.iter().flat_map(from)
        });
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 9.0, "{worst}");
    }
}
