//! A length of time as every language writes it.

/// Milliseconds as seconds, minutes and seconds, or hours and minutes.
pub(super) fn duration(ms: f64) -> String {
    let seconds = (ms / 1_000.0).round().max(0.0) as u64;
    match seconds {
        0..60 => format!("{seconds} s"),
        60..3_600 => format!("{} min {:02} s", seconds / 60, seconds % 60),
        _ => format!("{} h {:02} min", seconds / 3_600, seconds % 3_600 / 60),
    }
}
