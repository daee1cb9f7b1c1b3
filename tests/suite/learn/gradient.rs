//! The update of the weights, worked out by hand and as it must be for any readings.

use groundling::ccg::{Feature, Features, RuleId, Vector};
use groundling::learn::gradient;
use groundling::logic::{Terms, read};
use proptest::prelude::{Strategy, any, prop};
use proptest::{prop_assert, prop_assert_eq, proptest};
use std::rc::Rc;

/// Learned features of two kinds: one of scale 1, two of scale ½.
fn learned() -> [Feature; 3] {
    let mut terms = Terms::new();
    let of_entities = terms.types.read("<e,t>").unwrap();
    let red = terms.constant("red", of_entities);
    [Feature::Alone(red), Feature::Rule(RuleId(0)), Feature::Rule(RuleId(1))]
}

/// A reading's features and whether it is valid.
struct Judged {
    features: Vector,
    valid: bool,
}

/// The update by readings whose goals do not matter.
fn update(features: &mut Features, judged: &[Judged], margin: f64, moment: f64) -> bool {
    let form = read(&mut Terms::new(), "true:t").unwrap();
    let readings: Vec<_> =
        judged.iter().map(|reading| (form, Rc::new(reading.features.clone()))).collect();
    let valid: Vec<bool> = judged.iter().map(|reading| reading.valid).collect();
    let at = (margin, moment);
    gradient::update(features, &readings, &valid, at, Feature::is_learned).is_some()
}

fn weights(features: &Features) -> Vec<f64> {
    features.iter().map(|(_, weight, _)| weight).collect()
}

#[track_caller]
fn weights_are(features: &Features, wanted: [f64; 3]) {
    let found = weights(features);
    let near = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(near && found.len() == 3, "{found:?} is not {wanted:?}");
}

#[test]
fn a_step_is_what_was_worked_out_by_hand() {
    let mut features = Features::default();
    features.vector(&learned());
    let [alone, first, second] = learned();
    let judged = [
        Judged { features: features.vector(&[alone, first]), valid: true },
        Judged { features: features.vector(&[second]), valid: false },
    ];
    // Without margin both score 0 and are as probable: ½ · (1, ½, 0) and −½ · (0, 0, ½), each times the rate 0.3.
    assert!(update(&mut features, &judged, 0.0, 0.0));
    weights_are(&features, [0.15, 0.075, -0.075]);
    // With margin ln 3 ahead the invalid one has ¾ of the probability; the scores are now 0.1875 and −0.0375.
    let mut again = Features::default();
    again.vector(&learned());
    assert!(update(&mut again, &judged, f64::ln(3.0), 0.0));
    weights_are(&again, [0.225, 0.1125, -0.1125]);
    // Made at moment 1 of 2, the step was there half of the time.
    let mut late = Features::default();
    late.vector(&learned());
    assert!(update(&mut late, &judged, 0.0, 1.0));
    late.average(2.0);
    weights_are(&late, [0.075, 0.0375, -0.0375]);
}

#[test]
fn valid_readings_share_the_gain_by_how_probable_they_are() {
    let mut features = Features::default();
    features.vector(&learned());
    let [alone, first, second] = learned();
    // ½ · 2 ln 3 = ln 3: the second valid reading is thrice as probable as the first, which is as the invalid one.
    features.set(first, 2.0 * f64::ln(3.0));
    let judged = [[alone], [first], [second]]
        .into_iter()
        .zip([true, true, false])
        .map(|(occurring, valid)| Judged { features: features.vector(&occurring), valid });
    let judged: Vec<Judged> = judged.collect();
    assert!(update(&mut features, &judged, 0.0, 0.0));
    // ¼ − ⅕, ¾ − ⅗ and 0 − ⅕ of the rate, times the scales.
    weights_are(&features, [0.015, 2.0 * f64::ln(3.0) + 0.0225, -0.03]);
}

#[test]
fn what_it_costs_to_leave_words_out_is_no_lesson() {
    let prices = [Feature::Skip, Feature::Dropped, Feature::Lost];
    let mut features = Features::default();
    let [_, rule, _] = learned();
    let judged = [
        Judged { features: features.vector(&prices), valid: true },
        Judged { features: features.vector(&[rule]), valid: false },
    ];
    assert!(update(&mut features, &judged, 0.0, 0.0));
    assert!(prices.iter().all(|&price| features.weight(price) == 0.0));
    assert!(features.weight(rule) < 0.0);
}

#[test]
fn where_there_is_nothing_to_tell_apart_nothing_moves() {
    let mut features = Features::default();
    let vectors: Vec<Vector> = learned().map(|feature| features.vector(&[feature])).into();
    let all = |valid| vectors.iter().map(move |v| Judged { features: v.clone(), valid });
    for judged in [all(true).collect(), all(false).collect::<Vec<_>>(), Vec::new()] {
        assert!(!update(&mut features, &judged, 2.0, 0.0));
        weights_are(&features, [0.0; 3]);
    }
}

/// Readings over three features, as counts of each, and whether they are valid.
fn readings() -> impl Strategy<Value = Vec<(Vec<usize>, bool)>> {
    let counts = prop::collection::vec(0..4usize, 3);
    prop::collection::vec((counts, any::<bool>()), 0..6)
}

/// The log of the share that valid readings have of all probability, invalid ones `margin` ahead.
fn likelihood(features: &Features, judged: &[Judged], margin: f64) -> f64 {
    let share = |reading: &Judged| {
        let ahead = if reading.valid { 0.0 } else { margin };
        f64::exp(features.dot(&reading.features) + ahead)
    };
    let valid: f64 = judged.iter().filter(|reading| reading.valid).map(share).sum();
    (valid / judged.iter().map(share).sum::<f64>()).ln()
}

proptest! {
    #[test]
    fn valid_readings_gain_on_invalid_ones(
        readings in readings(), start in prop::collection::vec(-2.0..2.0f64, 3), margin in 0.0..3.0f64,
    ) {
        let mut features = Features::default();
        for (feature, weight) in learned().into_iter().zip(start) {
            features.set(feature, weight);
        }
        let judged: Vec<Judged> = readings.iter().map(|(counts, valid)| {
            let occurring: Vec<Feature> = learned().into_iter().zip(counts)
                .flat_map(|(feature, &count)| std::iter::repeat_n(feature, count)).collect();
            Judged { features: features.vector(&occurring), valid: *valid }
        }).collect();
        let before = features.clone();
        let updated = update(&mut features, &judged, margin, 0.0);
        let mixed = judged.iter().any(|r| r.valid) && judged.iter().any(|r| !r.valid);
        prop_assert_eq!(updated, mixed);
        if !mixed {
            prop_assert_eq!(weights(&features), weights(&before));
            return Ok(());
        }
        // It is a step along the gradient: the first part of it, at least, leads uphill.
        let step: Vec<f64> = weights(&features).iter().zip(weights(&before)).map(|(a, b)| a - b).collect();
        let mut partly = before.clone();
        for ((feature, weight), step) in learned().into_iter().zip(weights(&before)).zip(&step) {
            partly.set(feature, weight + 0.01 * step);
        }
        let [old, new] = [&before, &partly].map(|features| likelihood(features, &judged, margin));
        prop_assert!(new >= old - 1e-6, "{old} fell to {new} by {step:?}");
        if let [valid, invalid] = &judged[..] && valid.valid {
            let ahead = |f: &Features| f.dot(&valid.features) - f.dot(&invalid.features);
            prop_assert!(ahead(&features) >= ahead(&before));
        }
    }
}
