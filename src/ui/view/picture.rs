//! A world as a still picture: its scene in SVG, with each room's letter, so that colour is never the only sign.

use super::sketch;
use crate::domain::State;
use crate::render::{Options, Scene, Theme};
use crate::ui::describe;
use yew::{AttrValue, Html, Properties, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) world: State,
    pub(super) theme: Theme,
    pub(super) label: AttrValue,
}

/// The picture of a world.
#[component]
pub(super) fn Picture(props: &Props) -> Html {
    let options = Options { theme: props.theme, ..Options::default() };
    let scene = Scene::of(&props.world, &options);
    html! {
        <svg class="picture" role="img" aria-label={props.label.clone()} viewBox={sketch::view_box(&scene)}>
            { sketch::quads(&scene) }
            { letters(&props.world) }
        </svg>
    }
}

/// The first letter of every room's colour, pale on its floor.
pub(super) fn letters(world: &State) -> Html {
    world.rooms.iter().map(|room| {
        let b = room.bounds;
        let (x, y) = (f64::from(b.left + b.right) / 2.0, f64::from(b.bottom + b.top) / 2.0);
        let letter = describe::color(room.color).chars().next().unwrap_or(' ').to_ascii_uppercase();
        html! { <text class="letter" x={x.to_string()} y={(-y).to_string()} aria-hidden="true">{ letter }</text> }
    }).collect()
}
