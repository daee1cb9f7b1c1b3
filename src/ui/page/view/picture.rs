//! A world as a still picture: its scene in SVG.

use super::sketch;
use crate::domain::State;
use crate::render::{Options, Scene};
use yew::{AttrValue, Html, Properties, component, html};

#[derive(PartialEq, Properties)]
pub(crate) struct Props {
    pub(crate) world: State,
    pub(crate) options: Options,
    pub(crate) label: AttrValue,
}

/// The picture of a world.
#[component]
pub(crate) fn Picture(props: &Props) -> Html {
    let scene = Scene::of(&props.world, &props.options);
    html! {
        <svg class="picture" role="img" aria-label={props.label.clone()} viewBox={sketch::view_box(&scene.extent)}>
            { sketch::quads(&scene) }
        </svg>
    }
}
