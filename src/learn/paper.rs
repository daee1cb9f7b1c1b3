//! The figures that the paper reports (Williams, Gopalan, Rhee and Tellex, ICRA 2018), to stand beside ours.

/// Where the figures are from.
pub const SOURCE: &str = "Williams et al. 2018, Tables II and III";

/// A row of Table II: F1 on held-out commands, by training set and demonstrations a command.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the columns of the table")]
pub struct Supervision {
    pub set: &'static str,
    pub demonstrations: u32,
    pub f1: f64,
}

/// Table II.
pub const TABLE_2: [Supervision; 4] = [
    Supervision { set: "raw", demonstrations: 3, f1: 0.64 },
    Supervision { set: "pruned", demonstrations: 3, f1: 0.82 },
    Supervision { set: "pruned", demonstrations: 2, f1: 0.75 },
    Supervision { set: "pruned", demonstrations: 1, f1: 0.71 },
];

/// A row of Table III: 50 commands to learn from, 20 to be judged on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the columns of the table")]
pub struct Horizon {
    /// Actions a plan may have; `None` without planning.
    pub horizon: Option<u32>,
    pub seconds: f64,
    pub f1: f64,
}

/// Table III. Its times with planning are printed without a decimal point; they are in seconds as the hours beside
/// them tell (1,202 s are 20 minutes, 47,598 s are 13.22 hours).
pub const TABLE_3: [Horizon; 4] = [
    Horizon { horizon: Some(1), seconds: 1_201.953, f1: 0.0 },
    Horizon { horizon: Some(10), seconds: 24_024.701, f1: 0.667 },
    Horizon { horizon: Some(20), seconds: 47_597.724, f1: 0.667 },
    Horizon { horizon: None, seconds: 87.18, f1: 0.72 },
];

/// The paper's F1 on a set of Table II.
pub fn table_2(set: &str, demonstrations: u32) -> Option<f64> {
    let is_it = |row: &&Supervision| row.set == set && row.demonstrations == demonstrations;
    TABLE_2.iter().find(is_it).map(|row| row.f1)
}

/// The paper's row of Table III for a horizon.
pub fn table_3(horizon: Option<u32>) -> Option<Horizon> {
    TABLE_3.iter().find(|row| row.horizon == horizon).copied()
}
