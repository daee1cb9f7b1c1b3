//! How likely an answer is what was meant: a logistic map (Platt 1999) of what a parse shows of itself, such as how far
//! the best reading leads and what was left out. The map is learned by `learn::calibrate` and lives in the model.

/// What an answer is judged by, in the order of the weights; each is about 0 to 1.
pub const SIGNS: [&str; 15] = [
    "bias",
    "lead",
    "rivals",
    "score",
    "skipped",
    "skipped_known",
    "misspelt",
    "far",
    "learned",
    "weakest",
    "length",
    "closed",
    "unseen",
    "beside",
    "predicates",
];

/// Values of the signs.
pub type Signs = [f64; SIGNS.len()];

/// The map from the signs of an answer to the probability that it is right.
#[derive(Clone, Debug, PartialEq)]
pub struct Doubt {
    /// The weight of each sign.
    pub weights: Signs,
    /// Below this probability the person is asked.
    pub threshold: f64,
}

impl Doubt {
    /// Its lines in a model file: a sign and its weight, last the threshold.
    pub fn lines(&self) -> Vec<String> {
        let weights = SIGNS.iter().zip(self.weights);
        let weights = weights.map(|(sign, weight)| format!("doubt\t{sign}\t{weight}"));
        weights.chain([format!("doubt\tthreshold\t{}", self.threshold)]).collect()
    }

    /// Reads a line's sign and value.
    ///
    /// # Errors
    /// In words, when the sign is not known or the value is no finite number.
    pub fn read_line(&mut self, sign: &str, value: &str) -> Result<(), String> {
        let number = value.parse().ok().filter(|value: &f64| value.is_finite());
        let number = number.ok_or_else(|| format!("{value:?} is no finite number"))?;
        let place = SIGNS.iter().zip(&mut self.weights).find(|(known, _)| **known == sign);
        match place {
            Some((_, weight)) => *weight = number,
            None if sign == "threshold" => self.threshold = number,
            None => return Err(format!("there is no sign of doubt {sign:?}")),
        }
        Ok(())
    }

    /// Whether to ask first, at this probability.
    pub fn asks(&self, probability: f64) -> bool {
        probability < self.threshold
    }

    /// The probability that an answer with these signs is right.
    pub fn probability(&self, signs: &Signs) -> f64 {
        logistic(dot(&self.weights, signs))
    }
}

impl Default for Doubt {
    /// Even odds, and nothing asked.
    fn default() -> Self {
        Doubt { weights: [0.0; SIGNS.len()], threshold: 0.0 }
    }
}

/// Σ w·x, in the order of the signs.
pub fn dot(weights: &Signs, signs: &Signs) -> f64 {
    weights.iter().zip(signs).fold(0.0, |sum, (weight, sign)| sum + weight * sign)
}

/// 1 / (1 + e⁻ˣ)
pub fn logistic(x: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-x))
}
