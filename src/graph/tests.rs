use super::node::{AnyNode, Inputs, State};
use super::*;
use crate::notice::Code;

/// Counts up to its parameter, and adds the lent number.
type Counter = Node<u32, u32, u32>;

const A: Inputs = [1, 2, 0];
const B: Inputs = [2, 1, 0];

fn count(node: &mut Counter, lent: u32) -> Option<()> {
    node.advance(|&wanted, work| {
        let count = work.get_or_insert(0);
        *count += 1;
        match wanted {
            0 => Err(Code::NoCells.into()),
            _ => Ok((*count == wanted).then_some(wanted + lent)),
        }
    })
}

fn advance(node: &mut Counter, inputs: Inputs, lent: u32) {
    node.begin(inputs);
    count(node, lent);
}

fn want(node: &mut Counter, params: u32) {
    node.ask(params);
    node.take_up();
}

fn state(node: &Counter, inputs: Inputs) -> State {
    node.status().state(inputs)
}

#[test]
fn a_node_is_stale_by_its_parameters_and_inputs_only() {
    let mut node = Counter::new(2);
    assert_eq!(state(&node, A), State::Stale);
    advance(&mut node, A, 10);
    assert_eq!((state(&node, A), node.work()), (State::Stale, Some(&1)));
    advance(&mut node, A, 10);
    assert_eq!((state(&node, A), node.made()), (State::Fresh, Some(&12)));
    // These inputs differ, but their revisions have the same sum.
    assert_eq!(state(&node, B), State::Stale);
    want(&mut node, 2);
    assert_eq!(state(&node, A), State::Fresh);
    want(&mut node, 3);
    assert_eq!((state(&node, A), node.made()), (State::Stale, Some(&12)));
    // The parameter returns to its old value before another value was made, so there is nothing to do.
    advance(&mut node, A, 10);
    want(&mut node, 2);
    assert_eq!((state(&node, A), node.work()), (State::Fresh, None));
    node.forget();
    assert_eq!(state(&node, A), State::Stale);
}

#[test]
fn parameters_asked_for_wait_until_they_are_taken_up() {
    let mut node = Counter::new(1);
    advance(&mut node, A, 0);
    node.ask(3);
    assert_eq!((node.is_stale(), state(&node, A)), (true, State::Fresh));
    assert_eq!((node.params(), node.latest()), (&1, &3));
    node.ask(1);
    assert!(!node.is_stale());
    node.ask(3);
    node.take_up();
    assert_eq!((node.is_stale(), node.params()), (false, &3));
    assert_eq!(state(&node, A), State::Stale);
}

#[test]
fn work_on_other_inputs_is_begun_anew() {
    let mut node = Counter::new(3);
    advance(&mut node, A, 0);
    advance(&mut node, A, 0);
    advance(&mut node, B, 0);
    assert_eq!((node.work_of(B), node.work_of(A)), (Some(&1), None));
    assert_eq!((node.work(), node.passes()), (Some(&1), 2));
    advance(&mut node, B, 0);
    advance(&mut node, B, 7);
    assert_eq!((node.made_of(B), node.made_of(A)), (Some(&10), None));
    assert_eq!(node.revision(), 1);
}

#[test]
fn a_failure_stands_for_its_parameters_and_inputs() {
    let mut node = Counter::new(1);
    advance(&mut node, A, 4);
    want(&mut node, 0);
    advance(&mut node, A, 4);
    assert_eq!((state(&node, A), node.made()), (State::Failed, Some(&5)));
    assert_eq!(node.status().failure(), Some(&Code::NoCells.into()));
    assert_eq!(state(&node, B), State::Stale);
    want(&mut node, 1);
    assert_eq!(state(&node, A), State::Fresh);
    assert_eq!(node.status().failure(), None);
}

/// A base, two parts of one stage made from it, and their sum.
struct Sums {
    base: Counter,
    left: Counter,
    right: Counter,
    sum: Counter,
}

impl Wiring for Sums {
    type Stage = u32;

    const TASKS: &'static [Task<Self>] = &[
        task!(0, base, [], |all| count(&mut all.base, 0)),
        task!(1, left, [base], |all| count(
            &mut all.left,
            *all.base.made()?
        )),
        task!(1, right, [base], |all| count(
            &mut all.right,
            *all.base.made()?
        )),
        task!(2, sum, [left, right], |all| {
            let lent = all.left.made()? + all.right.made()?;
            count(&mut all.sum, lent)
        }),
    ];
}

impl Sums {
    fn new() -> Self {
        Self {
            base: Node::new(1),
            left: Node::new(2),
            right: Node::new(3),
            sum: Node::new(4),
        }
    }

    /// Works until nothing is due; returns the stage of each slice.
    fn finish(&mut self) -> Vec<u32> {
        let mut stages = Vec::new();
        while self.failure().is_none()
            && let Some(stage) = self.at()
        {
            self.advance();
            stages.push(stage);
        }
        stages
    }
}

#[test]
fn a_value_is_current_if_all_values_before_it_are() {
    let mut sums = Sums::new();
    sums.finish();
    sums.base.ask(2);
    sums.take_up();
    // The last base stays until the next one is made.
    assert_eq!(sums.current(&sums.sum), Some(&11));
    sums.advance();
    sums.advance();
    // The inputs of the sum are those that it was made of, but they were made of another base.
    assert_eq!(sums.base.made(), Some(&2));
    assert_eq!(
        (sums.current(&sums.left), sums.current(&sums.sum)),
        (None, None)
    );
    sums.finish();
    assert_eq!(sums.current(&sums.sum), Some(&13));
}

#[test]
fn a_wiring_makes_what_is_stale_in_the_order_of_its_tasks() {
    let mut sums = Sums::new();
    assert_eq!(sums.finish(), [0, 1, 1, 1, 1, 1, 2, 2, 2, 2]);
    assert_eq!((sums.sum.made(), sums.runs()), (Some(&11), vec![1; 3]));
    sums.right.ask(1);
    assert_eq!((sums.stale(), sums.at()), (Some(1), None));
    sums.take_up();
    assert_eq!((sums.stale(), sums.at()), (None, Some(1)));
    assert_eq!(sums.finish(), [1, 2, 2, 2, 2]);
    // A stage has run as often as its last task.
    assert_eq!((sums.sum.made(), sums.runs()), (Some(&9), vec![1, 2, 2]));
    sums.left.ask(1);
    sums.take_up();
    sums.finish();
    assert_eq!((sums.sum.made(), sums.runs()), (Some(&8), vec![1, 2, 3]));
}

#[test]
fn a_step_back_makes_nothing() {
    let mut sums = Sums::new();
    sums.finish();
    let (runs, slices) = (sums.runs(), sums.slices());
    sums.base.ask(5);
    sums.take_up();
    sums.advance();
    sums.base.ask(1);
    sums.take_up();
    assert_eq!((sums.at(), sums.runs()), (None, runs));
    assert!(sums.slices() > slices);
}

#[test]
fn values_and_work_of_other_inputs_are_not_current() {
    let mut sums = Sums::new();
    sums.finish();
    sums.left.ask(7);
    sums.take_up();
    sums.advance();
    assert_eq!(sums.current(&sums.left), Some(&3));
    assert_eq!(sums.begun(&sums.left), Some(&1));
    assert!(!sums.is_fresh(&sums.left) && sums.is_fresh(&sums.right));
    sums.base.forget();
    sums.advance();
    assert_eq!((sums.current(&sums.base), sums.at()), (Some(&1), Some(1)));
    assert_eq!(
        (sums.current(&sums.left), sums.begun(&sums.left)),
        (None, None)
    );
}

#[test]
fn a_failure_ends_the_work_until_something_else_is_asked() {
    let mut sums = Sums::new();
    sums.left.ask(0);
    sums.take_up();
    assert_eq!(sums.finish(), [0, 1]);
    assert_eq!(sums.failure(), Some(&Code::NoCells.into()));
    let slices = sums.slices();
    sums.advance();
    assert_eq!(sums.slices(), slices);
    sums.left.ask(2);
    sums.take_up();
    sums.finish();
    assert_eq!((sums.failure(), sums.sum.made()), (None, Some(&11)));
}

/// A table with one task, whose input never exists.
struct Torn {
    sum: Counter,
    missing: Counter,
}

impl Wiring for Torn {
    type Stage = u32;

    const TASKS: &'static [Task<Self>] = &[task!(0, sum, [missing], |all| count(
        &mut all.sum,
        *all.missing.made()?
    ))];
}

#[test]
fn a_missing_input_is_a_failure_and_no_endless_loop() {
    let [sum, missing] = [1; 2].map(Counter::new);
    let mut torn = Torn { sum, missing };
    torn.advance();
    assert_eq!(torn.failure(), Some(&Code::NoCells.into()));
}
