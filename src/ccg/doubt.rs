//! How likely an answer is what was meant: a logistic map (Platt 1999) of signs that a parse shows of itself, such as how
//! far the best reading leads, what was left out, and what the goal speaks of. The map is learned by `learn::calibrate` and
//! lives in the model.

use super::number::number;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// The name of the line that holds the threshold.
const THRESHOLD: &str = "threshold";

/// What a parse shows of itself: names and values, each about 0 to 1.
pub type Signs = Vec<(String, f64)>;

/// The map from the signs of an answer to the probability that it is right.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Doubt {
    /// The weight of each sign; other signs count nothing.
    pub weights: IndexMap<String, f64, FxBuildHasher>,
    /// Below this probability the person is asked.
    pub threshold: f64,
}

impl Doubt {
    /// Reads a map's lines, as [`Doubt::lines`] writes them; empty ones and those with `#` before them are passed over.
    ///
    /// # Errors
    /// With the line and what is wrong there.
    pub fn read(text: &str) -> Result<Doubt, String> {
        let mut doubt = Doubt::default();
        for (number, line) in (1..).zip(text.lines()) {
            let fields: Vec<&str> = line.split('\t').collect();
            match fields[..] {
                ["doubt", sign, value] => doubt.read_line(sign, value),
                _ if line.is_empty() || line.starts_with('#') => Ok(()),
                _ => Err("a line is doubt, a sign and a number, parted by tabs".to_owned()),
            }
            .map_err(|reason| format!("line {number}: {reason}"))?;
        }
        Ok(doubt)
    }

    /// Reads a line's sign and value.
    ///
    /// # Errors
    /// In words, when the value is no finite number.
    pub fn read_line(&mut self, sign: &str, value: &str) -> Result<(), String> {
        let number = number(value).ok_or_else(|| format!("{value:?} is no finite number"))?;
        match sign {
            THRESHOLD => self.threshold = number,
            _ => drop(self.weights.insert(sign.to_owned(), number)),
        }
        Ok(())
    }

    /// Its lines in a model file: a sign and its weight, last the threshold.
    pub fn lines(&self) -> Vec<String> {
        let line = |(sign, weight): (&String, &f64)| format!("doubt\t{sign}\t{weight}");
        let weights = self.weights.iter().map(line);
        weights.chain([format!("doubt\t{THRESHOLD}\t{}", self.threshold)]).collect()
    }

    /// The probability that an answer with these signs is right.
    pub fn probability(&self, signs: &Signs) -> f64 {
        let weigh = |(sign, value): &(String, f64)| value * self.weights.get(sign).unwrap_or(&0.0);
        logistic(signs.iter().fold(0.0, |sum, sign| sum + weigh(sign)))
    }

    /// Whether to ask first, at this probability.
    pub fn asks(&self, probability: f64) -> bool {
        probability < self.threshold
    }
}

/// 1 / (1 + e⁻ˣ)
pub fn logistic(x: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-x))
}
