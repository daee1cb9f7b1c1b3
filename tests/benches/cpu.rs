//! CPU time of this thread, and a table of it: median and 99th percentile of single rounds, and how many
//! times faster than the reference system that is.

#[cfg(not(target_arch = "wasm32"))]
use cpu_time::ThreadTime as Clock;
#[cfg(target_arch = "wasm32")]
use std::time::Instant as Clock;

/// One line of the table.
pub(crate) struct Row {
    name: &'static str,
    reference: Option<f64>,
    seconds: Vec<f64>,
}

/// The CPU seconds that `work` takes.
pub(crate) fn seconds(work: impl FnOnce()) -> f64 {
    let start = Clock::now();
    work();
    start.elapsed().as_secs_f64()
}

impl Row {
    /// Runs `work` for `rounds` (after one that is not counted), each given its number; `reference` is what
    /// the reference system needs, in CPU seconds.
    pub(crate) fn of(
        name: &'static str,
        rounds: u64,
        reference: Option<f64>,
        mut work: impl FnMut(u64),
    ) -> Self {
        work(0);
        let seconds = (1..=rounds).map(|round| seconds(|| work(round))).collect();
        Self { reference, ..Self::from_seconds(name, seconds) }
    }

    /// A line of what was measured elsewhere.
    pub(crate) fn from_seconds(name: &'static str, mut seconds: Vec<f64>) -> Self {
        seconds.sort_by(f64::total_cmp);
        Self { name, reference: None, seconds }
    }

    /// Says what the reference system needs, in CPU seconds.
    pub(crate) fn set_reference(&mut self, seconds: f64) {
        self.reference = Some(seconds);
    }

    /// The least of the times that so many per cent of the rounds did not exceed.
    fn percentile(&self, per_cent: usize) -> f64 {
        let last = self.seconds.len().saturating_sub(1);
        self.seconds.get(last * per_cent / 100).copied().unwrap_or(f64::NAN)
    }
}

/// Prints the rows under a head.
pub(crate) fn print_table(rows: &[Row]) {
    println!(
        "{:40} {:>10} {:>10} {:>10} {:>8}",
        "CPU time", "median", "99 %", "reference", "ratio"
    );
    for row in rows {
        let median = row.percentile(50);
        println!(
            "{:40} {:>10} {:>10} {:>10} {:>8}",
            row.name,
            readable(median),
            readable(row.percentile(99)),
            row.reference.map_or(String::new(), readable),
            row.reference.map_or(String::new(), |r| format!("{:.0}×", r / median)),
        );
    }
}

fn readable(seconds: f64) -> String {
    match seconds {
        s if s < 1e-3 => format!("{:.1} µs", s * 1e6),
        s if s < 1.0 => format!("{:.2} ms", s * 1e3),
        s => format!("{s:.2} s"),
    }
}
