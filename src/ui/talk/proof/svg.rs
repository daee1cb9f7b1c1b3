//! A derivation as a picture that stands for itself: dark on white, with its fonts named in it.

use super::font::Kind;
use super::layout::{Proof, Text};
use std::fmt::Write;

const SANS: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', sans-serif";
const CODE: &str = "ui-monospace, 'SF Mono', 'Cascadia Mono', 'DejaVu Sans Mono', monospace";

/// An SVG file.
pub fn svg(proof: &Proof) -> String {
    let (width, height) = (proof.width.ceil(), proof.height.ceil());
    let words = proof.texts.iter().filter(|text| matches!(text.kind, Kind::Word | Kind::Skipped));
    let mut in_order: Vec<&Text> = Vec::new();
    for word in words {
        in_order.insert(in_order.partition_point(|other| other.words <= word.words), word);
    }
    let title: Vec<String> = in_order.iter().map(|text| escaped(&text.text)).collect();
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        title.join(" ")
    );
    for line in &proof.lines {
        // Writing to a string does not fail.
        let _ = writeln!(
            out,
            "<path d=\"M{:.1} {:.1}H{:.1}\" fill=\"none\" stroke=\"#5c6373\"/>",
            line.left, line.y, line.right
        );
    }
    for text in &proof.texts {
        let (font, fill) = match text.kind {
            Kind::Word => (SANS, "#1e222b"),
            Kind::Skipped => (SANS, "#8a8f9c"),
            Kind::Rule => (SANS, "#5c6373"),
            Kind::Category => (CODE, "#1e222b"),
            Kind::Meaning => (CODE, "#5a3fe0"),
        };
        let weight = if text.kind == Kind::Word { " font-weight=\"600\"" } else { "" };
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\" font-family=\"{font}\" \
             font-size=\"{}\"{weight} fill=\"{fill}\">{}</text>",
            text.x,
            text.y,
            text.kind.size(),
            escaped(&text.text)
        );
    }
    out.push_str("</svg>\n");
    out
}

/// As XML has it; signs that it cannot hold at all are left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            _ if letter.is_control() || matches!(letter, '\u{fffe}' | '\u{ffff}') => {}
            _ => out.push(letter),
        }
    }
    out
}
