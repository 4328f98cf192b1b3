//! A packing at any of its steps, forward and back.
//!
//! A kept state is the whole run with its list of neighbours: forces are summed in the order of that list, so
//! the places alone would not give the same bits. States are kept every ten steps, and any step is made from the
//! nearest one before it.

use super::Packing;
use crate::domain::Domain;
use crate::field::Fields;

/// Steps between two kept states.
const EVERY: u32 = 10;

/// The most bodies in all kept states together. Beyond, every second state is dropped, and ways get longer.
const MOST_BODIES: usize = 200_000;

/// A packing with the states on its way.
#[derive(Clone, Debug)]
pub struct History {
    /// The states after 0, `every`, 2 `every` ... steps. The records of the run are those of `latest`.
    kept: Vec<Packing>,
    every: u32,
    /// The state that is shown.
    now: Packing,
    /// The state after the most steps so far.
    latest: Packing,
    /// The step asked for.
    asked: u32,
}

impl History {
    /// Begins with a packing of which no step has been made.
    pub fn new(first: Packing) -> Self {
        Self {
            kept: vec![first.compact()],
            every: EVERY,
            now: first.clone(),
            latest: first,
            asked: 0,
        }
    }

    /// The packing at the step that has been reached.
    pub fn packing(&self) -> &Packing {
        &self.now
    }

    /// The same packing, mutable, because it caches measures such as its energy.
    pub fn packing_mut(&mut self) -> &mut Packing {
        &mut self.now
    }

    /// Asks for a step. A run that ends earlier stays at its end.
    pub fn ask(&mut self, step: u32) {
        self.asked = step;
        let at = (step / self.every) as usize;
        let from = &self.kept[at.min(self.kept.len() - 1)];
        let from = match self.latest.run.report.step <= step {
            true => &self.latest,
            false => from,
        };
        let now = self.now.run.report.step;
        if now > step || now < from.run.report.step {
            self.now = from.clone();
            self.now.take_records(&self.latest);
        }
    }

    /// Makes one step towards the step asked for; true when it is reached, or the run has ended.
    pub fn advance(&mut self, domain: &Domain, fields: &Fields) -> bool {
        if self.is_there() {
            return true;
        }
        self.now.step(domain, fields);
        let step = self.now.run.report.step;
        if step == self.every * self.kept.len() as u32 {
            self.kept.push(self.now.compact());
            self.thin_out();
        }
        if step > self.latest.run.report.step {
            self.latest = self.now.clone();
        }
        self.is_there()
    }

    fn is_there(&self) -> bool {
        self.now.done() || self.now.run.report.step >= self.asked
    }

    fn thin_out(&mut self) {
        let bodies = self.kept.iter().map(|kept| kept.run.bodies.len());
        if bodies.sum::<usize>() > MOST_BODIES && self.kept.len() > 2 {
            let mut index = 0;
            self.kept.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.every *= 2;
        }
    }
}

impl Packing {
    /// The same state without its records, and without what the next step makes anew.
    fn compact(&self) -> Self {
        let mut kept = self.clone();
        kept.run.samples = Vec::new();
        kept.run.changes = Vec::new();
        kept.run.motion.compact();
        kept
    }

    /// Takes the records up to its own step from a later state of the same run.
    fn take_records(&mut self, later: &Packing) {
        let step = self.run.report.step;
        let samples = later.run.samples.iter();
        self.run.samples = samples.copied().filter(|row| row.step <= step).collect();
        let changes = later.run.changes.iter();
        self.run.changes = changes.copied().filter(|row| row.step <= step).collect();
    }
}
