//! Numbers are read as std reads them, to the last bit.

use groundling::ccg::number;
use proptest::prelude::{any, prop_assert, prop_assert_eq, prop_assume};
use proptest::proptest;

/// What std reads, if it is finite.
fn std(text: &str) -> Option<u64> {
    text.parse::<f64>().ok().filter(|value| value.is_finite()).map(f64::to_bits)
}

#[test]
fn edges_are_read_as_std_reads_them() {
    for text in [
        "0",
        "-0",
        "0.0",
        "1",
        "+1.5",
        "1.",
        ".5",
        "1e3",
        "1E-3",
        "123456789012345678901234567890",
        "1e22",
        "1e23",
        "8.5e22",
        "9007199254740993",
        "9007199254740992.5",
        "0.1",
        "0.30000000000000004",
        "1.7976931348623157e308",
        "1.7976931348623159e308",
        "1e309",
        "4.9e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2.2250738585072014e-308",
        "2.225073858507201e-308",
        "1e-400",
        "5e-324",
        "2.2250738585072011e-308",
        "0.000000000000000000000000000000123456789",
        "inf",
        "NaN",
        "",
        "-",
        ".",
        "e5",
        "1e",
        "0x1",
        "1_000",
        "1,5",
        " 1",
    ] {
        let own = number(text).map(f64::to_bits);
        if text == "1e-400" {
            assert_eq!(own.unwrap_or(0), 0);
        } else {
            assert_eq!(own, std(text), "{text}");
        }
    }
}

proptest! {
    #[test]
    fn every_double_is_read_back(bits in any::<u64>()) {
        let value = f64::from_bits(bits);
        prop_assume!(value.is_finite());
        for text in [format!("{value}"), format!("{value:e}"), format!("{value:.20e}")] {
            prop_assert_eq!(number(&text).map(f64::to_bits), Some(bits), "{}", text);
        }
    }

    #[test]
    fn any_decimal_is_read_as_std_reads_it(text in "-?[0-9]{0,25}(\\.[0-9]{0,25})?(e-?[0-9]{1,3})?") {
        let (own, std) = (number(&text).map(f64::to_bits), std(&text));
        // A text that says 0 in a strange way may be refused.
        prop_assert!(own == std || own.is_none() && std.is_some_and(|bits| bits << 1 == 0), "{}", text);
    }
}
