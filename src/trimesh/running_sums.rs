//! Running sums of weights, to draw an item with a probability in proportion to its weight.

use super::TriMesh;

/// The running sums of the weights of some items, such as the areas of triangles.
///
/// A guide table (Chen, Asau 1974, On Generating Random Variates from an Empirical Distribution) divides the total into as
/// many equal parts as there are items, and knows the first item of each part. So a search looks at few items, however
/// many there are.
#[derive(Clone, Debug, Default)]
pub(crate) struct RunningSums {
    sums: Vec<f64>,
    /// For each part of the total, the first item whose sum is greater than the part's begin. Empty before
    /// [`RunningSums::index`].
    guide: Vec<u32>,
}

impl RunningSums {
    /// No items yet, with room for `count`.
    pub fn with_capacity(count: usize) -> Self {
        Self {
            sums: Vec::with_capacity(count),
            guide: Vec::new(),
        }
    }

    /// The indexed sums of some weights.
    pub fn of(weights: impl IntoIterator<Item = f64>) -> Self {
        let mut sums = Self::default();
        for weight in weights {
            sums.push(weight);
        }
        sums.index();
        sums
    }

    /// The indexed sums of the areas of a mesh's triangles.
    pub fn of_areas(mesh: &TriMesh) -> Self {
        Self::of((0..mesh.triangles().len() as u32).map(|t| mesh.area_of(t)))
    }

    /// Adds an item; weights are at least 0.
    pub fn push(&mut self, weight: f64) {
        self.sums.push(self.total() + weight);
    }

    /// Makes searches fast; all items have been added.
    pub fn index(&mut self) {
        let count = self.sums.len();
        let part = self.total() / count as f64;
        let mut item = 0;
        self.guide.clear();
        self.guide.extend((0..count).map(|k| {
            while item + 1 < count && self.sums[item] <= k as f64 * part {
                item += 1;
            }
            item as u32
        }));
    }

    /// The number of items.
    pub fn len(&self) -> usize {
        self.sums.len()
    }

    /// The sum of all weights.
    pub fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The first item whose running sum is greater than `sum`; the last item if there is none. There is at least one
    /// item.
    pub fn item(&self, sum: f64) -> usize {
        let count = self.sums.len();
        let part = (sum / self.total() * count as f64) as usize;
        let begin = self.guide.get(part).map_or(0, |&item| item as usize);
        let end = self
            .guide
            .get(part + 1)
            .map_or(count, |&item| item as usize);
        let within = &self.sums[begin..end];
        let mut item = begin + within.partition_point(|&end| end <= sum);
        // Rounding may have led to the part beside the right one.
        while item > 0 && self.sums[item - 1] > sum {
            item -= 1;
        }
        while item + 1 < count && self.sums[item] <= sum {
            item += 1;
        }
        item.min(count - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::RunningSums;
    use crate::random::{Purpose, Random};

    #[test]
    fn an_item_is_that_of_a_search_in_all_sums() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        for count in [1, 2, 7, 400] {
            // Some weights are 0, and some are far greater than others.
            let weights: Vec<f64> = (0..count)
                .map(|k| match k % 5 {
                    3 => 0.0,
                    4 => 1e3 * random.unit(),
                    _ => 1e-3 * random.unit(),
                })
                .collect();
            let sums = RunningSums::of(weights.iter().copied());
            let total = sums.total();
            let borders = sums
                .sums
                .iter()
                .flat_map(|&s| [s, s.next_down(), s.next_up()]);
            let drawn: Vec<f64> = (0..500).map(|_| total * random.unit()).collect();
            for sum in borders.chain(drawn).chain([0.0, total, 2.0 * total]) {
                let expected = sums.sums.partition_point(|&end| end <= sum).min(count - 1);
                assert_eq!(sums.item(sum), expected, "{count} items, {sum} of {total}");
            }
        }
    }

    #[test]
    fn weights_of_zero_give_the_last_item() {
        let sums = RunningSums::of([0.0; 3]);
        assert_eq!(sums.item(0.0), 2);
    }
}
