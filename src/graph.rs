//! Nodes: each keeps what a stage has made, and knows what it was made of.
//!
//! A [`Node`] is a memo. It is stale when its parameters differ from those that its value was made
//! by, or an input's revision from the one that it was made of, and nothing else decides that. Who
//! wires nodes together lends the inputs to every slice of work, so that work in progress holds no
//! borrows.

use crate::notice::Notice;

/// Whether a node has to work, for inputs of a certain revision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Its value is made by the wanted parameters, of these inputs.
    Fresh,
    /// Its value has still to be made.
    Stale,
    /// Its value cannot be made by these parameters, of these inputs.
    Failed,
}

/// A stage's memo: parameters `P`, work in progress `W`, and the value `T` that was made last, which
/// stays to be shown until the next one is there.
#[derive(Debug)]
pub struct Node<P, W, T> {
    params: P,
    /// The work, and the revision of the inputs that it or its failure is of.
    work: Option<W>,
    work_inputs: u64,
    failure: Option<Notice>,
    made: Option<Made<P, T>>,
    revision: u64,
    passes: u64,
    slices: u64,
}

/// A value, and what it was made of.
#[derive(Debug)]
struct Made<P, T> {
    value: T,
    params: P,
    inputs: u64,
    /// Is it by the parameters of the node?
    is_wanted: bool,
}

impl<P: Clone + PartialEq, W, T> Node<P, W, T> {
    /// A node that has made nothing yet.
    pub fn new(params: P) -> Self {
        Self {
            params,
            work: None,
            work_inputs: 0,
            failure: None,
            made: None,
            revision: 0,
            passes: 0,
            slices: 0,
        }
    }

    /// From now on the value is to be made by these parameters; work by others is dropped.
    pub fn want(&mut self, params: P) {
        if params == self.params {
            return;
        }
        self.drop_work();
        if let Some(made) = &mut self.made {
            made.is_wanted = made.params == params;
        }
        self.params = params;
    }

    /// Makes the value stale, whatever it was made of.
    pub fn forget(&mut self) {
        self.drop_work();
        if let Some(made) = &mut self.made {
            made.is_wanted = false;
        }
    }

    fn drop_work(&mut self) {
        (self.work, self.failure) = (None, None);
        self.slices += 1;
    }

    /// The parameters that the value is to be made by.
    pub fn params(&self) -> &P {
        &self.params
    }

    /// Its state for inputs of this revision. With several inputs it is the sum of their revisions, which
    /// never fall.
    pub fn state(&self, inputs: u64) -> State {
        let is_fresh = |made: &Made<P, T>| made.is_wanted && made.inputs == inputs;
        if self.made.as_ref().is_some_and(is_fresh) {
            State::Fresh
        } else if self.failure.is_some() && self.work_inputs == inputs {
            State::Failed
        } else {
            State::Stale
        }
    }

    /// One slice of the work, which `slice` begins, goes on with, or ends with a value. Work on other
    /// inputs is dropped before.
    pub fn advance(
        &mut self,
        inputs: u64,
        slice: impl FnOnce(&P, &mut Option<W>) -> Result<Option<T>, Notice>,
    ) {
        self.slices += 1;
        if self.work_inputs != inputs {
            (self.work, self.work_inputs) = (None, inputs);
        }
        self.failure = None;
        self.passes += u64::from(self.work.is_none());
        match slice(&self.params, &mut self.work) {
            Ok(None) => {}
            Ok(Some(value)) => {
                self.work = None;
                self.revision += 1;
                self.made = Some(Made {
                    value,
                    params: self.params.clone(),
                    inputs,
                    is_wanted: true,
                });
            }
            Err(why) => {
                self.work = None;
                self.failure = Some(why);
            }
        }
    }

    /// The value that was made last, stale or not.
    pub fn made(&self) -> Option<&T> {
        self.made.as_ref().map(|made| &made.value)
    }

    /// The same, for values that keep the answers to some questions.
    pub fn made_mut(&mut self) -> Option<&mut T> {
        self.made.as_mut().map(|made| &mut made.value)
    }

    /// The value if it was made of inputs of this revision, by whatever parameters.
    pub fn made_of(&self, inputs: u64) -> Option<&T> {
        let made = self.made.as_ref().filter(|made| made.inputs == inputs);
        made.map(|made| &made.value)
    }

    /// The work in progress on inputs of this revision.
    pub fn work_of(&self, inputs: u64) -> Option<&W> {
        self.work.as_ref().filter(|_| self.work_inputs == inputs)
    }

    /// The work in progress, of whatever inputs: it stays to be shown until it is begun anew.
    pub fn work(&self) -> Option<&W> {
        self.work.as_ref()
    }

    /// The same, for work that keeps the answers to some questions.
    pub fn work_mut(&mut self) -> Option<&mut W> {
        self.work.as_mut()
    }

    /// Why the value cannot be made.
    pub fn failure(&self) -> Option<&Notice> {
        self.failure.as_ref()
    }

    /// How many values were made so far; readers tell by it whether they have seen the last one.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// How often the work was begun, from the start or anew.
    pub fn passes(&self) -> u64 {
        self.passes
    }

    /// Grows with every slice of work, and where work is dropped.
    pub fn slices(&self) -> u64 {
        self.slices
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::notice::Code;

    /// Counts up to its parameter, plus what is lent.
    type Counter = Node<u32, u32, u32>;

    fn advance(node: &mut Counter, inputs: u64, lent: u32) {
        node.advance(inputs, |&wanted, work| {
            let count = work.get_or_insert(0);
            *count += 1;
            match wanted {
                0 => Err(Code::NoCells.into()),
                _ => Ok((*count == wanted).then_some(wanted + lent)),
            }
        });
    }

    #[test]
    fn a_node_is_stale_by_its_parameters_and_inputs_only() {
        let mut node = Counter::new(2);
        assert_eq!(node.state(5), State::Stale);
        advance(&mut node, 5, 10);
        assert_eq!((node.state(5), node.work()), (State::Stale, Some(&1)));
        advance(&mut node, 5, 10);
        assert_eq!((node.state(5), node.made()), (State::Fresh, Some(&12)));
        assert_eq!(node.state(6), State::Stale);
        node.want(2);
        assert_eq!(node.state(5), State::Fresh);
        node.want(3);
        assert_eq!((node.state(5), node.made()), (State::Stale, Some(&12)));
        // Back again before anything else was made: there is nothing to do.
        advance(&mut node, 5, 10);
        node.want(2);
        assert_eq!((node.state(5), node.work()), (State::Fresh, None));
        node.forget();
        assert_eq!(node.state(5), State::Stale);
    }

    #[test]
    fn work_on_other_inputs_is_begun_anew() {
        let mut node = Counter::new(3);
        advance(&mut node, 1, 0);
        advance(&mut node, 1, 0);
        advance(&mut node, 2, 0);
        assert_eq!((node.work_of(2), node.work_of(1)), (Some(&1), None));
        assert_eq!((node.work(), node.passes()), (Some(&1), 2));
        advance(&mut node, 2, 0);
        advance(&mut node, 2, 7);
        assert_eq!((node.made_of(2), node.made_of(1)), (Some(&10), None));
        assert_eq!(node.revision(), 1);
    }

    #[test]
    fn a_failure_stands_for_its_parameters_and_inputs() {
        let mut node = Counter::new(1);
        advance(&mut node, 1, 4);
        node.want(0);
        advance(&mut node, 1, 4);
        assert_eq!((node.state(1), node.made()), (State::Failed, Some(&5)));
        assert_eq!(node.failure(), Some(&Code::NoCells.into()));
        assert_eq!(node.state(2), State::Stale);
        node.want(1);
        assert_eq!((node.state(1), node.failure()), (State::Fresh, None));
    }
}
