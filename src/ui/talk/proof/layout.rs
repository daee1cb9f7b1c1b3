//! Where everything of a derivation lies, in CSS pixels from the top left corner, y downwards: widths from the parts
//! to the whole, then places from the whole to its parts.

use super::font::Kind;
use crate::worker::protocol::Node;

/// Between columns.
const GAP: f32 = 18.0;
/// Between a line and its rule's name.
const RULE_GAP: f32 = 5.0;
/// Around it all.
const MARGIN: f32 = 6.0;
/// Above a line.
const STEP: f32 = 7.0;
/// Below a line.
const BELOW: f32 = 3.0;
/// Where the letters stand in a line of text, from its top.
const BASE: f32 = 0.75;

/// A derivation laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// Its breadth.
    pub width: f32,
    /// Its height.
    pub height: f32,
    /// Everything that is written.
    pub texts: Vec<Text>,
    /// The lines of the steps.
    pub lines: Vec<Line>,
    /// For every node the box that holds what it alone adds: words, category, meaning.
    pub boxes: Vec<Area>,
}

/// Something written.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// What it is.
    pub kind: Kind,
    /// The node that it belongs to; no node has a word that was left out.
    pub node: Option<usize>,
    /// The words that it stands for: the first, and one past the last.
    pub words: (usize, usize),
    /// Its middle.
    pub x: f32,
    /// Its base line.
    pub y: f32,
    /// The room that it has.
    pub width: f32,
    /// What is written.
    pub text: String,
}

/// The line of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The node that was made.
    pub node: usize,
    /// Its left end.
    pub left: f32,
    /// Its right end.
    pub right: f32,
    /// Where it runs.
    pub y: f32,
}

/// A rectangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Area {
    /// Its left edge.
    pub x: f32,
    /// Its upper edge.
    pub y: f32,
    /// Its breadth.
    pub width: f32,
    /// Its height.
    pub height: f32,
}

impl Proof {
    /// A derivation laid out, meanings and all: `nodes` has parts before what was made of them, the whole last. A
    /// part that does not come before its whole is left out.
    pub fn new(words: &[String], nodes: &[Node]) -> Self {
        Self::lay_out(words, nodes, true)
    }

    /// The same without its meanings.
    pub fn bare(words: &[String], nodes: &[Node]) -> Self {
        Self::lay_out(words, nodes, false)
    }

    fn lay_out(words: &[String], nodes: &[Node], meanings: bool) -> Self {
        let mut plans = Vec::with_capacity(nodes.len());
        for node in nodes {
            plans.push(plan(words, node, nodes, &plans, meanings));
        }
        let whole: Vec<usize> = (0..nodes.len()).next_back().into_iter().collect();
        let sentence = columns(nodes, (0, words.len()), &whole);
        let lowest = plans.iter().map(|plan| plan.bottom).fold(Kind::Word.height(), f32::max);
        let proof = Self {
            width: breadth(words, &sentence, &plans) + 2.0 * MARGIN,
            height: lowest + 2.0 * MARGIN,
            texts: Vec::new(),
            lines: Vec::new(),
            boxes: vec![Area::default(); nodes.len()],
        };
        let mut drawing = Drawing { words, plans, lefts: vec![0.0; nodes.len()], proof };
        drawing.put(&sentence, None, MARGIN);
        // From the whole to its parts: each has been told where it begins when its turn comes.
        for (i, node) in nodes.iter().enumerate().rev() {
            drawing.draw(i, node, meanings);
        }
        drawing.proof
    }
}

impl Text {
    /// The rectangle that it takes up.
    pub fn area(&self) -> Area {
        let (width, height) = (self.width, self.kind.height());
        Area { x: self.x - width / 2.0, y: self.y - height * BASE, width, height }
    }
}

/// What is laid out side by side: a node's parts, its own words, and words that were left out between them.
#[derive(Clone, Copy)]
enum Column {
    Word(usize),
    Skipped(usize),
    Part(usize),
}

/// What is known of a node before it has its place.
struct Plan {
    columns: Vec<Column>,
    /// The breadth of its columns.
    inner: f32,
    /// The breadth of all it needs but the rule's name.
    own: f32,
    /// The room for the rule's name, with its gap.
    rule: f32,
    /// Where it begins, below its parts.
    top: f32,
    /// Where it ends.
    bottom: f32,
}

/// What a node needs, its parts being planned.
fn plan(words: &[String], node: &Node, nodes: &[Node], plans: &[Plan], meanings: bool) -> Plan {
    let parts: Vec<usize> = node.parts.iter().copied().filter(|part| *part < plans.len()).collect();
    let columns = columns(nodes, node.words, &parts);
    let inner = breadth(words, &columns, plans);
    let meaning = if meanings { Kind::Meaning.width(&meaning(node)) } else { 0.0 };
    let own = inner.max(Kind::Category.width(&node.category)).max(meaning);
    let rule = match &*node.rule {
        "" => 0.0,
        rule => RULE_GAP + Kind::Rule.width(rule),
    };
    let above = parts.iter().filter_map(|part| plans.get(*part)).map(|part| part.bottom);
    let above = above.fold(Kind::Word.height(), f32::max);
    let top = if parts.is_empty() { above } else { above + STEP };
    let height = Kind::Category.height() + if meanings { Kind::Meaning.height() } else { 0.0 };
    Plan { columns, inner, own, rule, top, bottom: top + BELOW + height }
}

/// What stands side by side over some words: their parts and the words that were left out between them, or the words
/// themselves where there are no parts.
fn columns(nodes: &[Node], (first, end): (usize, usize), parts: &[usize]) -> Vec<Column> {
    if parts.is_empty() {
        return (first..end).map(Column::Word).collect();
    }
    let mut columns = Vec::new();
    let mut at = first;
    for part in parts {
        let (begin, after) = nodes.get(*part).map_or((at, at), |node| node.words);
        columns.extend((at..begin).map(Column::Skipped));
        columns.push(Column::Part(*part));
        at = after;
    }
    columns.extend((at..end).map(Column::Skipped));
    columns
}

fn column_width(words: &[String], column: Column, plans: &[Plan]) -> f32 {
    match column {
        Column::Word(i) | Column::Skipped(i) => Kind::Word.width(word(words, i)),
        Column::Part(part) => plans.get(part).map_or(0.0, |plan| plan.own + plan.rule),
    }
}

fn breadth(words: &[String], columns: &[Column], plans: &[Plan]) -> f32 {
    let widths = columns.iter().map(|column| column_width(words, *column, plans) + GAP);
    (widths.sum::<f32>() - GAP).max(0.0)
}

fn word(words: &[String], i: usize) -> &str {
    words.get(i).map_or("", String::as_str)
}

fn meaning(node: &Node) -> String {
    node.meaning.iter().map(|piece| &*piece.text).collect()
}

/// A drawing in the making.
struct Drawing<'a> {
    words: &'a [String],
    plans: Vec<Plan>,
    /// Where every node begins.
    lefts: Vec<f32>,
    proof: Proof,
}

impl Drawing<'_> {
    /// Gives columns their places from left to right: words are written, parts are told where they begin.
    fn put(&mut self, columns: &[Column], node: Option<usize>, mut left: f32) {
        for column in columns {
            let width = column_width(self.words, *column, &self.plans);
            let written = match *column {
                Column::Word(i) => Some((i, Kind::Word, node)),
                Column::Skipped(i) => Some((i, Kind::Skipped, None)),
                Column::Part(part) => {
                    self.lefts[part] = left;
                    None
                }
            };
            if let Some((i, kind, node)) = written {
                let (x, text) = (left + width / 2.0, word(self.words, i).to_owned());
                self.write(kind, node, (i, i + 1), [x, MARGIN], width, text);
            }
            left += width + GAP;
        }
    }

    /// Draws what a node adds to its parts.
    fn draw(&mut self, i: usize, node: &Node, meanings: bool) {
        let Some(plan) = self.plans.get(i) else { return };
        let (left, own, rule, inner) = (self.lefts[i], plan.own, plan.rule, plan.inner);
        let (top, bottom, columns) =
            (MARGIN + plan.top, MARGIN + plan.bottom, plan.columns.clone());
        self.put(&columns, Some(i), left + (own - inner) / 2.0);
        let middle = left + own / 2.0;
        let category = Kind::Category.width(&node.category);
        let mut below = top + BELOW;
        self.write(
            Kind::Category,
            Some(i),
            node.words,
            [middle, below],
            category,
            node.category.clone(),
        );
        below += Kind::Category.height();
        let mut label = category;
        if meanings {
            let meaning = meaning(node);
            let width = Kind::Meaning.width(&meaning);
            label = label.max(width);
            self.write(Kind::Meaning, Some(i), node.words, [middle, below], width, meaning);
        }
        if !node.parts.is_empty() {
            self.proof.lines.push(Line { node: i, left, right: left + own, y: top });
        }
        if rule > 0.0 {
            let width = rule - RULE_GAP;
            let x = left + own + RULE_GAP + width / 2.0;
            let y = top - Kind::Rule.height() / 2.0;
            self.write(Kind::Rule, Some(i), node.words, [x, y], width, node.rule.clone());
        }
        let (y, width) =
            if node.parts.is_empty() { (MARGIN, label.max(inner)) } else { (top, label) };
        self.proof.boxes[i] = Area { x: middle - width / 2.0, y, width, height: bottom - y };
    }

    /// Writes a text about a middle, below `top`.
    fn write(
        &mut self,
        kind: Kind,
        node: Option<usize>,
        words: (usize, usize),
        [x, top]: [f32; 2],
        width: f32,
        text: String,
    ) {
        let y = top + kind.height() * BASE;
        self.proof.texts.push(Text { kind, node, words, x, y, width, text });
    }
}
