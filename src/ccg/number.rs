//! Numbers as model files have them: what std reads and rounds alike, without its tables, which would be a thirtieth of
//! what the page loads. Exact: a number is kept as a fraction of whole numbers and rounded once, to nearest, ties to
//! even.

use std::cmp::Ordering;

/// Digits that are read; shortest forms have 17.
const MOST_DIGITS: usize = 800;

/// Powers of ten that a double holds exactly.
const EXACT: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// The finite number that a text such as `-12.5` or `3e-7` is nearest to; nothing where it is none, or out of range.
pub fn number(text: &str) -> Option<f64> {
    let (sign, text) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let (digits, exponent) = match text.split_once(['e', 'E']) {
        Some((digits, exponent)) => (digits, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let mut all = whole.bytes().chain(part.bytes());
    let count = whole.len() + part.len();
    if count == 0 || count > MOST_DIGITS || !all.all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    let exponent = exponent.checked_sub(i32::try_from(part.len()).ok()?)?;
    let digits = whole.bytes().chain(part.bytes()).map(|digit| u32::from(digit - b'0'));
    let value = rounded(digits, exponent)?;
    value.is_finite().then_some(sign * value)
}

/// The whole number of these digits times that power of ten.
fn rounded(digits: impl Iterator<Item = u32> + Clone, exponent: i32) -> Option<f64> {
    let mut short = Some(0_u64);
    for digit in digits.clone() {
        short = short.and_then(|value| value.checked_mul(10)?.checked_add(digit.into()));
    }
    if let Some(value @ 0..=0x20_0000_0000_0000) = short {
        let power = EXACT.get(exponent.unsigned_abs() as usize);
        match power {
            Some(power) if exponent < 0 => return Some(value as f64 / power),
            Some(power) => return Some(value as f64 * power),
            None if value == 0 => return Some(0.0),
            None => {}
        }
    }
    if let Some(value) = short
        && (-19..0).contains(&exponent)
    {
        // Nearly all that a model has: the fraction fits into a register or two.
        let shift = value.leading_zeros() + 64;
        let (above, below) = (u128::from(value) << shift, 10_u128.pow(exponent.unsigned_abs()));
        return Some(nearest(above / below, above % below > 0, shift.into()));
    }
    // Nothing of so many digits is further from 1 and still in range.
    if exponent.unsigned_abs() > 1_200 {
        return None;
    }
    let mut above = Whole::default();
    digits.for_each(|digit| above.scale(10, digit));
    let mut below = Whole(vec![1]);
    let side = if exponent < 0 { &mut below } else { &mut above };
    (0..exponent.unsigned_abs()).for_each(|_| side.scale(10, 0));
    Some(quotient(above, below))
}

/// A fraction as the nearest double.
fn quotient(mut above: Whole, mut below: Whole) -> f64 {
    if above.bits() == 0 {
        return 0.0;
    }
    // The quotient is to have 64 bits or 65, but no more behind the point than the smallest double and two.
    let shift = (64 + below.bits() - above.bits()).min(1_076);
    if shift < 0 {
        below.shift(-shift)
    } else {
        above.shift(shift)
    }
    let mut whole = 0_u128;
    below.shift(66);
    for _ in 0..=66 {
        whole <<= 1;
        if above.cmp(&below) != Ordering::Less {
            above.subtract(&below);
            whole |= 1;
        }
        below.halve();
    }
    nearest(whole, above.bits() > 0, shift)
}

/// The double that is nearest to a whole number, and a rest if there is one, divided by 2 so many times.
fn nearest(whole: u128, rest: bool, shift: i64) -> f64 {
    let bits = 128 - i64::from(whole.leading_zeros());
    let drop = (bits - 53).max(shift - 1_074).max(0);
    let half = (1_u128 << drop) >> 1;
    let (kept, left) = (whole >> drop, whole & ((1 << drop) - 1));
    let up = left > half || left == half && drop > 0 && (rest || kept & 1 == 1);
    let kept = (kept + u128::from(up)) as f64;
    let power = drop - shift;
    if power > 971 { f64::INFINITY } else { kept * two(power) }
}

/// A power of two that a double holds.
fn two(power: i64) -> f64 {
    let bits = if power < -1_022 { 1 << (power + 1_074) } else { (power + 1_023) << 52 };
    f64::from_bits(bits as u64)
}

/// A whole number of any size, its lowest 32 bits first, its highest not 0.
#[derive(Default)]
struct Whole(Vec<u32>);

impl Whole {
    fn bits(&self) -> i64 {
        let top = self.0.last().map_or(0, |top| i64::from(top.leading_zeros()));
        32 * self.0.len() as i64 - top
    }

    fn scale(&mut self, by: u32, plus: u32) {
        let mut carry = u64::from(plus);
        for part in &mut self.0 {
            carry += u64::from(*part) * u64::from(by);
            *part = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    fn shift(&mut self, bits: i64) {
        (0..bits % 32).for_each(|_| self.scale(2, 0));
        if !self.0.is_empty() {
            self.0.splice(0..0, (0..bits / 32).map(|_| 0));
        }
    }

    fn halve(&mut self) {
        let mut carry = 0;
        for part in self.0.iter_mut().rev() {
            (*part, carry) = (*part >> 1 | carry << 31, *part & 1);
        }
        self.trim();
    }

    fn cmp(&self, other: &Whole) -> Ordering {
        let length = self.0.len().cmp(&other.0.len());
        length.then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }

    /// Takes a smaller number away.
    fn subtract(&mut self, other: &Whole) {
        let mut borrow = false;
        let others = other.0.iter().copied().chain(std::iter::repeat(0));
        for (part, other) in self.0.iter_mut().zip(others) {
            let (less, first) = part.overflowing_sub(other);
            let (less, second) = less.overflowing_sub(u32::from(borrow));
            (*part, borrow) = (less, first || second);
        }
        self.trim();
    }

    fn trim(&mut self) {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }
}
