//! The world's picture, moving: drawn by the renderer once it has come, as SVG until then and where there is no
//! GPU or it was lost. A step glides from cell to cell; a jump, or a person who prefers less motion, does not.

use super::{host, sketch};
use crate::domain::State;
use crate::render::link::{self, LinkError, View};
use crate::render::{Motion, Options, Scene, Theme};
use crate::ui::describe;
use crate::ui::playback::STEP_MS;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen_futures::spawn_local;
use web_sys::{HtmlCanvasElement, ResizeObserver};
use yew::{Component, Context, Html, NodeRef, Properties, html};

/// How long a step glides: a little less than it lasts.
const GLIDE_MS: f64 = STEP_MS as f64 - 30.0;

/// So many canvases are tried before the page stays with SVG.
const CANVASES: u32 = 2;

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) shown: State,
    pub(super) theme: Theme,
    pub(super) reduced_motion: bool,
}

pub(super) enum Message {
    Attached(u32, Result<View, LinkError>),
    Lost(u32),
    Frame,
    Resized,
}

/// The stage's picture.
pub(super) struct Canvas {
    node: NodeRef,
    /// Which canvas this is: a lost one is replaced by a fresh one.
    canvas: u32,
    /// Which canvas the renderer was last given.
    given: Option<u32>,
    view: Option<View>,
    motion: Option<(Motion, f64)>,
    /// Whether a frame has been asked for.
    awaited: bool,
    observer: Option<Observer>,
}

/// Watches the canvas's size.
struct Observer {
    observer: ResizeObserver,
    _resized: Closure<dyn FnMut()>,
}

impl Drop for Observer {
    fn drop(&mut self) {
        self.observer.disconnect();
    }
}

impl Component for Canvas {
    type Message = Message;
    type Properties = Props;

    fn create(_ctx: &Context<Self>) -> Canvas {
        Canvas {
            node: NodeRef::default(),
            canvas: 0,
            given: None,
            view: None,
            motion: None,
            awaited: false,
            observer: None,
        }
    }

    fn changed(&mut self, ctx: &Context<Self>, old: &Props) -> bool {
        let new = ctx.props();
        if old.shown != new.shown {
            let motion = Motion::between(&old.shown, &new.shown);
            let glides = !new.reduced_motion && one_step(&old.shown, &new.shown);
            self.motion = glides.then(|| (motion, host::now()));
            self.next_frame(ctx);
        }
        true
    }

    fn update(&mut self, ctx: &Context<Self>, message: Message) -> bool {
        match message {
            Message::Attached(canvas, Ok(view)) if canvas == self.canvas => {
                let link = ctx.link().clone();
                view.on_lost(move |_| link.send_message(Message::Lost(canvas)));
                self.view = Some(view);
                self.observe(ctx);
                true
            }
            Message::Attached(canvas, Err(_)) if canvas == self.canvas => {
                self.canvas = CANVASES;
                true
            }
            Message::Lost(canvas) if canvas == self.canvas => {
                self.view = None;
                self.observer = None;
                self.canvas += 1;
                true
            }
            Message::Attached(..) | Message::Lost(_) => false,
            Message::Frame => {
                self.awaited = false;
                let over = |(_, begun): &(Motion, f64)| host::now() - begun >= GLIDE_MS;
                let ended = self.motion.take_if(|motion| over(motion)).is_some();
                if self.motion.is_some() {
                    self.next_frame(ctx);
                }
                if self.view.is_some() && !ended {
                    self.paint(ctx);
                    return false;
                }
                true
            }
            Message::Resized => {
                self.paint(ctx);
                false
            }
        }
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        let shown = &ctx.props().shown;
        let scene = self.scene(ctx);
        let backend = self.view.as_ref().map_or_else(|| "svg".to_owned(), View::backend);
        let drawn = self.view.is_some();
        html! {
            <div class="stage" data-testid="stage" data-backend={backend}
                data-still={self.motion.is_none().to_string()}
                data-robot-x={shown.agent.x.to_string()} data-robot-y={shown.agent.y.to_string()}
                data-robot-place={describe::place(shown, shown.agent.x, shown.agent.y)}>
                if self.canvas < CANVASES {
                    <canvas key={self.canvas} ref={self.node.clone()} aria-hidden="true" />
                }
                <svg class="picture" role="img" aria-label={describe::world(shown)}
                    viewBox={sketch::view_box(&scene)}>
                    if !drawn { { sketch::quads(&scene) } }
                </svg>
            </div>
        }
    }

    fn rendered(&mut self, ctx: &Context<Self>, _first: bool) {
        if self.view.is_some() {
            self.paint(ctx);
        } else if self.given != Some(self.canvas) {
            self.attach(ctx);
        }
    }

    fn destroy(&mut self, _ctx: &Context<Self>) {
        if let Some(view) = self.view.take() {
            view.detach();
        }
    }
}

impl Canvas {
    fn scene(&self, ctx: &Context<Self>) -> Scene {
        let Props { shown, theme, .. } = ctx.props();
        let options = Options { theme: *theme, letters: true, ..Options::default() };
        match &self.motion {
            Some((motion, begun)) => {
                let t = ((host::now() - begun) / GLIDE_MS) as f32;
                motion.scene_at(t, &options)
            }
            None => Scene::of(shown, &options),
        }
    }

    fn paint(&self, ctx: &Context<Self>) {
        if let Some(view) = &self.view {
            // A GPU that is gone tells so by `on_lost`.
            let _ = view.draw(&self.scene(ctx), host::pixel_ratio());
        }
    }

    fn next_frame(&mut self, ctx: &Context<Self>) {
        if !std::mem::replace(&mut self.awaited, true) {
            let link = ctx.link().clone();
            host::next_frame(move || link.send_message(Message::Frame));
        }
    }

    fn attach(&mut self, ctx: &Context<Self>) {
        let Some(canvas) = self.node.cast::<HtmlCanvasElement>() else { return };
        let (number, link) = (self.canvas, ctx.link().clone());
        self.given = Some(number);
        spawn_local(async move {
            let attached = match link::load().await {
                Ok(renderer) => renderer.attach(&canvas).await,
                Err(error) => Err(error),
            };
            link.send_message(Message::Attached(number, attached));
        });
    }

    fn observe(&mut self, ctx: &Context<Self>) {
        let link = ctx.link().clone();
        let resized = Closure::<dyn FnMut()>::new(move || link.send_message(Message::Resized));
        let observer = ResizeObserver::new(resized.as_ref().unchecked_ref());
        if let (Ok(observer), Some(canvas)) = (observer, self.node.cast::<HtmlCanvasElement>()) {
            observer.observe(&canvas);
            self.observer = Some(Observer { observer, _resized: resized });
        }
    }
}

/// Whether the way is one that can be walked in a step: anything further is a jump.
fn one_step(before: &State, after: &State) -> bool {
    let (a, b) = (&before.agent, &after.agent);
    before.rooms == after.rooms && a.x.abs_diff(b.x) + a.y.abs_diff(b.y) <= 1
}
