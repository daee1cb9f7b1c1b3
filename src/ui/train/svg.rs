//! A picture that stands by itself, as a file: its looks are in it, light, and plain where there is no colour. Pure.

use std::fmt::Write;

/// The looks of its parts, by class.
const LOOKS: &str = "text{font:12px sans-serif;fill:#1b1d22}.dim{fill:#5c616b}.end{text-anchor:end}\
    .middle{text-anchor:middle}path{fill:none;stroke-width:1.75}.grid{stroke:#d9d6cf;stroke-width:1}\
    .first{stroke:#1f5fbf}.second{stroke:#9a5b00;stroke-dasharray:6 3}.third{stroke:#1b1d22;stroke-dasharray:2 3}\
    circle{stroke:none}circle.first{fill:#1f5fbf}circle.second{fill:#9a5b00}circle.third{fill:#1b1d22}\
    .area{stroke:none;opacity:.14}.area.first{fill:#1f5fbf}.area.second{fill:#9a5b00}.area.third{fill:#1b1d22}";

/// A picture that is being drawn.
#[derive(Clone, Debug)]
pub struct Svg(String);

impl Svg {
    /// An empty picture of this breadth and height.
    pub fn new(width: f64, height: f64) -> Svg {
        Svg(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
            height=\"{height:.0}\"><style>{LOOKS}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
        ))
    }

    /// What follows is moved so far.
    pub fn open(&mut self, x: f64, y: f64) {
        self.add(format_args!("<g transform=\"translate({x:.0} {y:.0})\">"));
    }

    /// What was moved ends here.
    pub fn close(&mut self) {
        self.add(format_args!("</g>"));
    }

    /// A line along a path.
    pub fn line(&mut self, class: &str, path: &str) {
        self.add(format_args!("<path class=\"{class}\" d=\"{path}\"/>"));
    }

    /// A point.
    pub fn dot(&mut self, class: &str, x: f64, y: f64) {
        self.add(format_args!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\"/>"));
    }

    /// Words, which must be [`escaped`] where they are a person's.
    pub fn text(&mut self, class: &str, x: f64, y: f64, words: &str) {
        self.add(format_args!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{words}</text>"));
    }

    /// The picture as a file.
    pub fn end(self) -> String {
        self.0 + "</svg>\n"
    }

    fn add(&mut self, part: std::fmt::Arguments<'_>) {
        // A string takes any text.
        let _ = self.0.write_fmt(part);
    }
}

/// Words that stand for themselves in a picture.
pub fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;")
}
