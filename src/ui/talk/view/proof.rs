//! A derivation as a picture to point at: every node takes the focus in turn (arrow keys walk from one to the next),
//! and what is pointed at here or elsewhere is shown by its words.
use crate::ui::page::view::host;
use crate::ui::talk::proof::{self, Kind, Text, Toward, step};
use crate::worker::protocol::{Node, Piece};
use std::rc::Rc;
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;
use yew::{
    AttrValue, Callback, FocusEvent, Html, KeyboardEvent, Properties, UseStateSetter, classes,
    component, html, use_memo, use_state_eq,
};

/// What a [`Proof`] shows, and whom it tells. Words are a span: the first, and one past the last.
#[derive(PartialEq, Properties)]
pub(super) struct Props {
    /// Tells this picture's elements from those of others in the page.
    #[prop_or(AttrValue::Static("proof"))]
    pub(super) id: AttrValue,
    /// What it is, in words.
    pub(super) label: AttrValue,
    /// The words of the command.
    pub(super) words: Rc<[String]>,
    /// Parts before what was made of them, the whole last.
    pub(super) nodes: Rc<[Node]>,
    /// Whether meanings are written under categories.
    #[prop_or(true)]
    pub(super) meanings: bool,
    /// The words to emphasise, here and in the meanings.
    pub(super) linked: Option<(usize, usize)>,
    /// Told whose words are pointed at.
    pub(super) on_link: Callback<Option<(usize, usize)>>,
    /// The node that more is shown of.
    pub(super) chosen: Option<usize>,
    /// Told which node is pressed.
    pub(super) on_choose: Callback<usize>,
}

/// The picture, in a box that scrolls sideways.
#[component]
pub(super) fn Proof(props: &Props) -> Html {
    let Props { id, label, words, nodes, meanings, .. } = props;
    let drawn = (words.clone(), nodes.clone(), *meanings);
    let proof = use_memo(drawn, |(words, nodes, meanings)| match meanings {
        true => proof::Proof::new(words, nodes),
        false => proof::Proof::bare(words, nodes),
    });
    let last = nodes.len().saturating_sub(1);
    let at = use_state_eq(|| last);
    let here = (*at).min(last);
    let (width, height) = (proof.width.to_string(), proof.height.to_string());
    // A node's name says nothing of the rule, so the rule is not written within it.
    let beside = proof.texts.iter().filter(|text| text.node.is_none() || text.kind == Kind::Rule);
    html! {
        <div class="proof" role="tree" aria-label={label.clone()} data-testid={id.clone()}
            onkeydown={keys(props, here)}>
            <svg viewBox={format!("0 0 {width} {height}")} {width} {height}>
                <g aria-hidden="true">{ for beside.map(|text| written(text, props)) }</g>
                { for (0..nodes.len()).map(|i| node(i, &proof, props, i == here, &at.setter())) }
            </svg>
        </div>
    }
}

/// Arrow keys walk through the drawing, the others choose where they stand.
fn keys(props: &Props, here: usize) -> Callback<KeyboardEvent> {
    let (nodes, id, choose) = (props.nodes.clone(), props.id.clone(), props.on_choose.clone());
    Callback::from(move |event: KeyboardEvent| {
        let to = match &*event.key() {
            "ArrowUp" => step(&nodes, here, Toward::Part),
            "ArrowDown" => step(&nodes, here, Toward::Whole),
            "ArrowLeft" => step(&nodes, here, Toward::Left),
            "ArrowRight" => step(&nodes, here, Toward::Right),
            "Home" => step(&nodes, here, Toward::First),
            "End" => step(&nodes, here, Toward::Last),
            "Enter" | " " => {
                choose.emit(here);
                None
            }
            _ => return,
        };
        event.prevent_default();
        if let Some(to) = to {
            focus(&id, to);
        }
    })
}

/// What one node adds to its parts.
fn node(
    i: usize,
    proof: &proof::Proof,
    props: &Props,
    in_turn: bool,
    at: &UseStateSetter<usize>,
) -> Html {
    let (Some(node), Some(area)) = (props.nodes.get(i), proof.boxes.get(i)) else {
        return Html::default();
    };
    let texts = proof.texts.iter().filter(|t| t.node == Some(i) && t.kind != Kind::Rule);
    let line = proof.lines.iter().find(|line| line.node == i);
    let words = node.words;
    let point = props.on_link.reform(move |()| Some(words));
    let leave = props.on_link.reform(|()| None);
    let choose = props.on_choose.reform(move |_| i);
    let onfocus = {
        let (point, at) = (point.clone(), at.clone());
        Callback::from(move |_: FocusEvent| {
            at.set(i);
            point.emit(());
        })
    };
    let linked = props.linked.is_some_and(|linked| within(words, linked));
    let chosen = props.chosen == Some(i);
    let level = 1 + above(&props.nodes, i);
    html! {
        <g id={format!("{}-{i}", props.id)} role="treeitem" aria-label={label(node, &props.words)}
            aria-level={level.to_string()} aria-selected={chosen.to_string()}
            tabindex={if in_turn { "0" } else { "-1" }}
            class={classes!("proof-node", linked.then_some("linked"), chosen.then_some("chosen"))}
            onmouseenter={point.reform(|_| ())} onmouseleave={leave.reform(|_| ())}
            {onfocus} onblur={leave.reform(|_| ())} onclick={choose}>
            <rect class="proof-box" x={(area.x - 4.0).to_string()} y={area.y.to_string()} rx="5"
                width={(area.width + 8.0).to_string()} height={area.height.to_string()} />
            if let Some(line) = line {
                <path class="proof-line" d={format!("M{} {}H{}", line.left, line.y, line.right)} />
            }
            // Apart, as they are in the name.
            <g aria-hidden="true">{ for texts.map(|text| html! { <>{ written(text, props) }{" "}</> }) }</g>
        </g>
    }
}

fn written(text: &Text, props: &Props) -> Html {
    let class = match text.kind {
        Kind::Word => "proof-word",
        Kind::Skipped => "proof-word skipped",
        Kind::Category => "proof-category",
        Kind::Meaning => "proof-meaning",
        Kind::Rule => "proof-rule",
    };
    let on = |words: (usize, usize)| props.linked.is_some_and(|linked| within(words, linked));
    let word = matches!(text.kind, Kind::Word | Kind::Skipped);
    let node = text.node.filter(|_| text.kind == Kind::Meaning);
    let content = match node.and_then(|i| props.nodes.get(i)) {
        Some(node) => {
            html! { <>{ for node.meaning.iter().map(|piece| part(piece, node, props)) }</> }
        }
        None => html! { &text.text },
    };
    html! {
        <text x={text.x.to_string()} y={text.y.to_string()}
            class={classes!(class, (word && on(text.words)).then_some("linked"))}>{ content }</text>
    }
}

/// A piece of a node's meaning, which can be pointed at by itself.
fn part(piece: &Piece, node: &Node, props: &Props) -> Html {
    let Some(words) = piece.words else { return html! { &piece.text } };
    let point = |words| props.on_link.reform(move |_| Some(words));
    let linked = props.linked.is_some_and(|linked| within(words, linked)).then_some("linked");
    html! {
        <tspan class={classes!(linked)} onmouseenter={point(words)} onmouseleave={point(node.words)}>
            { &piece.text }
        </tspan>
    }
}

/// A node read out: its words, its category, its meaning.
fn label(node: &Node, words: &[String]) -> String {
    let words = words.get(node.words.0..node.words.1).unwrap_or_default().join(" ");
    let meaning: String = node.meaning.iter().map(|piece| &*piece.text).collect();
    format!("{words}: {}, {meaning}", node.category)
}

fn within((begin, end): (usize, usize), (first, after): (usize, usize)) -> bool {
    first <= begin && end <= after
}

/// How many steps lie between a node and the whole.
fn above(nodes: &[Node], mut of: usize) -> usize {
    let mut steps = 0;
    while let Some(whole) = step(nodes, of, Toward::Whole).filter(|whole| *whole > of) {
        of = whole;
        steps += 1;
    }
    steps
}

fn focus(id: &str, i: usize) {
    if let Some(element) = host::element(&format!("{id}-{i}")) {
        // An SVG element takes the focus just as an HTML element does; a refusal changes nothing.
        let _ = element.unchecked_into::<HtmlElement>().focus();
    }
}
