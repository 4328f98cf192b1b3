//! Derives from a table of tasks which one is due.

use super::node::{AnyNode, Inputs, Node, State};
use crate::notice::{Code, Notice};

/// A task of a wiring; see [`task!`].
pub struct Task<S: Wiring> {
    /// The stage of the task. A stage has run when the last of its tasks has.
    pub stage: S::Stage,
    /// The node that keeps the value.
    pub node: fn(&S) -> &dyn AnyNode,
    /// The same node, mutable.
    pub node_mut: fn(&mut S) -> &mut dyn AnyNode,
    /// The revisions of the inputs.
    pub inputs: fn(&S) -> Inputs,
    /// The nodes of the inputs, if each input is a node.
    pub sources: fn(&S) -> Vec<&dyn AnyNode>,
    /// Does one slice of the work; `None` if an input is missing.
    pub make: fn(&mut S) -> Option<()>,
}

/// A task: its stage, the field of its node, the fields of its inputs (or a function that returns their revisions),
/// and the function that makes the value.
macro_rules! task {
    ($stage:expr, $($node:ident).+, [$($($input:ident).+),*], $make:expr) => {
        $crate::graph::Task {
            sources: |_all| vec![$(&_all.$($input).+),*],
            ..$crate::graph::task!($stage, $($node).+, |_all| {
                $crate::graph::inputs([$(_all.$($input).+.revision()),*])
            }, $make)
        }
    };
    ($stage:expr, $($node:ident).+, $inputs:expr, $make:expr) => {
        $crate::graph::Task {
            stage: $stage,
            node: |all| &all.$($node).+,
            node_mut: |all| &mut all.$($node).+,
            inputs: $inputs,
            sources: |_| Vec::new(),
            make: $make,
        }
    };
}

pub(crate) use task;

/// The revisions of some inputs.
pub fn inputs<const N: usize>(revisions: [u64; N]) -> Inputs {
    let mut inputs = Inputs::default();
    inputs[..N].copy_from_slice(&revisions);
    inputs
}

/// The nodes of a generator, and the table of their tasks.
pub trait Wiring: Sized + 'static {
    /// A stage: one task, or several in a row.
    type Stage: Copy + PartialEq;

    /// The tasks in their order: each one uses only the values of earlier ones.
    const TASKS: &'static [Task<Self>];

    /// The first task that is not fresh, with its state.
    fn due(&self) -> Option<(&'static Task<Self>, State)> {
        let state = |task: &Task<Self>| (task.node)(self).status().state((task.inputs)(self));
        let mut states = Self::TASKS.iter().map(|task| (task, state(task)));
        states.find(|&(_, state)| state != State::Fresh)
    }

    /// The stage of the first task that is not fresh; `None` if all is done.
    fn at(&self) -> Option<Self::Stage> {
        self.due().map(|(task, _)| task.stage)
    }

    /// Why the first task that is not fresh has failed; `None` if it has not.
    fn failure(&self) -> Option<&Notice> {
        let (task, _) = self.due().filter(|&(_, state)| state == State::Failed)?;
        (task.node)(self).status().failure()
    }

    /// Does one slice of the first task that is not fresh, unless it has failed.
    fn advance(&mut self) {
        let Some((task, State::Stale)) = self.due() else {
            return;
        };
        let inputs = (task.inputs)(self);
        (task.node_mut)(self).begin(inputs);
        if (task.make)(self).is_none() {
            (task.node_mut)(self).fail(Code::NoCells.into());
        }
    }

    /// The first stage whose parameters differ in the latest recipe.
    fn stale(&self) -> Option<Self::Stage> {
        let mut tasks = Self::TASKS.iter();
        let found = tasks.find(|task| (task.node)(self).is_stale());
        found.map(|task| task.stage)
    }

    /// Makes the latest recipe the present one.
    fn take_up(&mut self) {
        for task in Self::TASKS {
            (task.node_mut)(self).take_up();
        }
    }

    /// How often each stage has run.
    fn runs(&self) -> Vec<u64> {
        let stages = Self::TASKS.chunk_by(|a, b| a.stage == b.stage);
        let last = stages.filter_map(|tasks| tasks.last());
        last.map(|task| (task.node)(self).status().revision())
            .collect()
    }

    /// Increases whenever views may change.
    fn slices(&self) -> u64 {
        let nodes = Self::TASKS.iter().map(|task| (task.node)(self));
        nodes.map(|node| node.status().slices()).sum()
    }

    /// The task of a node.
    fn task_of(&self, node: &dyn AnyNode) -> Option<&'static Task<Self>> {
        let is_of = |task: &&Task<Self>| std::ptr::addr_eq((task.node)(self), node);
        Self::TASKS.iter().find(is_of)
    }

    /// The present inputs of a node.
    fn inputs_of(&self, node: &dyn AnyNode) -> Inputs {
        let task = self.task_of(node);
        task.map_or(Inputs::default(), |task| (task.inputs)(self))
    }

    /// Whether the values of all inputs of a node were made from the present values of theirs, and so on, with any
    /// parameters. If not, the node's value and those of its inputs do not belong together.
    fn has_current_inputs(&self, node: &dyn AnyNode) -> bool {
        let task = self.task_of(node);
        let sources = task.map_or(Vec::new(), |task| (task.sources)(self));
        sources.into_iter().all(|source| {
            source.status().was_made_of(self.inputs_of(source)) && self.has_current_inputs(source)
        })
    }

    /// Whether a node's value was made with the present parameters from the present inputs.
    #[cfg(house)]
    fn is_fresh(&self, node: &dyn AnyNode) -> bool {
        node.status().state(self.inputs_of(node)) == State::Fresh
    }

    /// A node's value, if it was made from the present inputs, and these from theirs, with any parameters. So it fits
    /// the values of all nodes before it.
    fn current<'a, P, W, T>(&self, node: &'a Node<P, W, T>) -> Option<&'a T>
    where
        P: Clone + PartialEq,
    {
        let value = node.made_of(self.inputs_of(node));
        value.filter(|_| self.has_current_inputs(node))
    }

    /// A node's work, if it was begun on the present inputs, and these were made from theirs.
    fn begun<'a, P, W, T>(&self, node: &'a Node<P, W, T>) -> Option<&'a W>
    where
        P: Clone + PartialEq,
    {
        let work = node.work_of(self.inputs_of(node));
        work.filter(|_| self.has_current_inputs(node))
    }
}
