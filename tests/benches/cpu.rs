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

impl Row {
    /// Runs `work` for `rounds` (after one that is not counted), each given its number; `reference` is what
    /// the reference system needs, in CPU seconds.
    pub(crate) fn new(
        name: &'static str,
        rounds: u64,
        reference: Option<f64>,
        mut work: impl FnMut(u64),
    ) -> Self {
        work(0);
        let mut seconds: Vec<f64> = (1..=rounds)
            .map(|round| {
                let start = Clock::now();
                work(round);
                start.elapsed().as_secs_f64()
            })
            .collect();
        seconds.sort_by(f64::total_cmp);
        Self { name, reference, seconds }
    }

    fn at(&self, share: f64) -> f64 {
        let last = self.seconds.len().saturating_sub(1);
        self.seconds.get((last as f64 * share) as usize).copied().unwrap_or(f64::NAN)
    }
}

/// Prints the rows under a head.
pub(crate) fn print_table(rows: &[Row]) {
    println!(
        "{:48} {:>12} {:>12} {:>12} {:>9}",
        "CPU time", "median", "99 %", "reference", "ratio"
    );
    for row in rows {
        let (median, high) = (row.at(0.5), row.at(0.99));
        let reference = row.reference.map_or(String::new(), readable);
        let ratio = row.reference.map_or(String::new(), |r| format!("{:.0}×", r / median));
        println!(
            "{:48} {:>12} {:>12} {reference:>12} {ratio:>9}",
            row.name,
            readable(median),
            readable(high)
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
