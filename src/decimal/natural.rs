//! Natural numbers of any size, as far as decimals need them.

use std::cmp::Ordering;

/// A natural number in limbs of 32 bits, the lowest first, without leading zeros.
#[derive(Default)]
pub(super) struct Natural(Vec<u32>);

impl Natural {
    pub fn one() -> Self {
        Self(vec![1])
    }

    /// Multiplies by `factor`, then adds `more`.
    pub fn scale(&mut self, factor: u32, more: u32) {
        let mut carry = u64::from(more);
        for limb in &mut self.0 {
            carry += u64::from(*limb) * u64::from(factor);
            *limb = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    /// How it compares with another number.
    pub fn compare(&self, other: &Self) -> Ordering {
        let length = self.0.len().cmp(&other.0.len());
        length.then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }

    /// Subtracts a number that is not greater.
    pub fn subtract(&mut self, other: &Self) {
        let mut borrow = false;
        for (k, limb) in self.0.iter_mut().enumerate() {
            let (less, first) = limb.overflowing_sub(other.0.get(k).copied().unwrap_or(0));
            let (less, second) = less.overflowing_sub(borrow.into());
            *limb = less;
            borrow = first || second;
        }
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }
}
