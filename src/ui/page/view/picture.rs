//! A world as a still picture: its scene in SVG, with what lies over it.

use super::sketch;
use crate::domain::State;
use crate::render::{Options, Scene};
use yew::{AttrValue, Html, Properties, component, html};

#[derive(PartialEq, Properties)]
pub(crate) struct Props {
    pub(crate) world: State,
    pub(crate) options: Options,
    pub(crate) label: AttrValue,
    /// What lies over it, in its units.
    #[prop_or_default]
    pub(crate) over: Html,
}

/// The picture of a world.
#[component]
pub(crate) fn Picture(props: &Props) -> Html {
    let scene = Scene::of(&props.world, &props.options);
    html! {
        <svg class="picture" role="img" aria-label={props.label.clone()} viewBox={sketch::view_box(&scene.extent)}>
            { sketch::quads(&scene) }
            { props.over.clone() }
        </svg>
    }
}

/// The way that the robot goes through states, in a picture's units; nothing where it stays.
pub(crate) fn line(class: &'static str, states: &[State]) -> Html {
    let cell = |state: &State| format!("{},{}", state.agent.x, -state.agent.y);
    let points: Vec<String> = states.iter().map(cell).collect();
    html! { if points.len() > 1 { <polyline {class} points={points.join(" ")} /> } }
}
