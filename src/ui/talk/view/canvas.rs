//! The world's picture, moving: drawn by the renderer once it has come, as SVG until then and where there is no GPU, it
//! was lost or it is slow; a renderer without a GPU draws the first picture and SVG whatever changes. A step glides from
//! cell to cell; a jump, or a person who prefers less motion, does not.
//! Nothing is built or drawn while nothing changes. A pointer is told in cells.
use super::observer::Observer;
use super::pace::Pace;
use crate::domain::State;
use crate::render::link::{self, LinkError, View};
use crate::render::{Extent, Fit, Motion, Options, Scene};
use crate::ui::page::grammar::room_at;
use crate::ui::page::place::one_step;
use crate::ui::page::view::{host, sketch};
use crate::ui::talk::room::point::{Point, PointKind};
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, HtmlCanvasElement, PointerEvent};
use yew::{AttrValue, Callback, Component, Context, Html, NodeRef, Properties, classes, html};

/// A step glides for this share of the time that it lasts.
const GLIDE: f64 = 0.9;

/// So many canvases are tried before the page stays with SVG.
const CANVASES: u32 = 2;

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    /// What is shown.
    pub(super) shown: State,
    /// How.
    pub(super) options: Options,
    pub(super) reduced_motion: bool,
    /// Whether steps follow each other.
    pub(super) playing: bool,
    /// Milliseconds from one step to the next.
    pub(super) step_ms: u32,
    /// What the picture is, in words.
    pub(super) label: AttrValue,
    /// Whether things can be dragged: a finger then draws instead of scrolling the page.
    #[prop_or_default]
    pub(super) interactive: bool,
    /// What lies over the picture, in its units.
    #[prop_or_default]
    pub(super) labels: Html,
    /// Told what a pointer does.
    #[prop_or_default]
    pub(super) on_point: Callback<Point>,
}

pub(super) enum Message {
    Attached(u32, Result<View, LinkError>),
    Lost(u32),
    Frame,
    Resized,
    Pointer(PointKind, PointerEvent),
}

/// The stage's picture.
#[derive(Default)]
pub(super) struct Canvas {
    stage: NodeRef,
    node: NodeRef,
    /// Which canvas this is: a lost one is replaced by a fresh one.
    canvas: u32,
    /// Which canvas the renderer was last given.
    given: Option<u32>,
    view: Option<View>,
    motion: Option<(Motion, f64)>,
    /// The pointer that is held down.
    held: Option<i32>,
    /// The cell that a pointer was last over.
    over: Option<(i32, i32)>,
    /// Whether a frame has been asked for.
    awaited: bool,
    /// Whether it is to be drawn.
    due: bool,
    pace: Pace,
    observer: Option<Observer>,
}

impl Component for Canvas {
    type Message = Message;
    type Properties = Props;

    fn create(_ctx: &Context<Self>) -> Canvas {
        Canvas::default()
    }

    fn changed(&mut self, ctx: &Context<Self>, old: &Props) -> bool {
        let new = ctx.props();
        let differs = (&new.shown, &new.options) != (&old.shown, &old.options);
        if differs && self.view.as_ref().is_some_and(View::is_software) {
            self.draw_plainly();
        }
        if old.shown != new.shown {
            let motion = Motion::between(&old.shown, &new.shown);
            // What a hand has put down is there already.
            let walked = old.options.ghost.is_none() && one_step(&old.shown, &new.shown);
            let glides = !new.reduced_motion && self.canvas < CANVASES;
            self.due = true;
            self.motion = (walked && glides).then(|| (motion, host::now()));
            self.next_frame(ctx);
        }
        // Whom to tell is asked when there is something to tell.
        let Props { shown, options, label, interactive, labels, .. } = new;
        (shown, options, label, interactive, labels)
            != (&old.shown, &old.options, &old.label, &old.interactive, &old.labels)
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
                if self.view.is_some() && self.pace.frame() {
                    self.draw_plainly();
                    return true;
                }
                let glide_ms = glide_ms(ctx);
                let over = |(_, begun): &(Motion, f64)| host::now() - begun >= glide_ms;
                let ended = self.motion.take_if(|motion| over(motion)).is_some();
                let due = std::mem::take(&mut self.due) || self.motion.is_some();
                if self.motion.is_some() {
                    self.next_frame(ctx);
                }
                if self.view.is_some() && !ended {
                    if due {
                        self.paint(ctx);
                    }
                    return false;
                }
                due || ended
            }
            Message::Resized => {
                self.paint(ctx);
                false
            }
            Message::Pointer(kind, event) => {
                self.point(ctx, kind, &event);
                false
            }
        }
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        let Props { shown, label, interactive, labels, .. } = ctx.props();
        let backend = self.view.as_ref().map_or_else(|| "svg".to_owned(), View::backend);
        let drawn = self.view.is_some();
        let pointer =
            |kind| ctx.link().callback(move |event: PointerEvent| Message::Pointer(kind, event));
        html! {
            <div ref={self.stage.clone()} class={classes!("stage", interactive.then_some("interactive"))}
                onpointerdown={pointer(PointKind::Down)} onpointermove={pointer(PointKind::Move)}
                onpointerup={pointer(PointKind::Up)} onpointerleave={pointer(PointKind::Leave)}
                onpointercancel={pointer(PointKind::Leave)}
                data-testid="stage" data-backend={backend}
                data-still={self.motion.is_none().to_string()}
                data-robot-x={shown.agent.x.to_string()} data-robot-y={shown.agent.y.to_string()}
                data-robot-room={room_at(shown, (shown.agent.x, shown.agent.y)).map_or("", |color| color.name())}>
                if self.canvas < CANVASES {
                    <canvas key={self.canvas} ref={self.node.clone()} aria-hidden="true" />
                }
                <svg class="picture" role="img" aria-label={label.clone()}
                    viewBox={sketch::view_box(&Extent::of(shown))}>
                    if !drawn { { sketch::quads(&self.scene(ctx)) } }
                    { labels.clone() }
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
        let Props { shown, options, .. } = ctx.props();
        match &self.motion {
            Some((motion, begun)) => {
                motion.scene_at(((host::now() - begun) / glide_ms(ctx)) as f32, options)
            }
            None => Scene::of(shown, options),
        }
    }

    /// Tells what a pointer does, and holds on to one that drags beyond the picture's edge.
    fn point(&mut self, ctx: &Context<Self>, kind: PointKind, event: &PointerEvent) {
        let Props { shown, on_point, .. } = ctx.props();
        let Some(stage) = self.stage.cast::<Element>() else { return };
        let ours = |held: Option<i32>| held.is_none_or(|id| id == event.pointer_id());
        if !ours(self.held) || kind == PointKind::Down && event.button() != 0 {
            return;
        }
        let rect = stage.get_bounding_client_rect();
        let fit = Fit::new(Extent::of(shown), rect.width() as f32, rect.height() as f32);
        let x = (f64::from(event.client_x()) - rect.left()) as f32;
        let y = (f64::from(event.client_y()) - rect.top()) as f32;
        let cell = fit.cell(x, y);
        match kind {
            PointKind::Down => {
                self.held = Some(event.pointer_id());
                // A pointer that is gone already needs no holding.
                let _ = stage.set_pointer_capture(event.pointer_id());
            }
            PointKind::Move if self.held.is_none() && self.over == Some(cell) => return,
            PointKind::Up | PointKind::Leave => self.held = None,
            PointKind::Move => {}
        }
        self.over = (kind != PointKind::Leave).then_some(cell);
        let [x, y] = fit.point(x, y);
        on_point.emit(Point { kind, x, y, cell });
    }

    fn paint(&mut self, ctx: &Context<Self>) {
        if let Some(view) = &self.view {
            // A GPU that is gone tells so by `on_lost`.
            let _ = view.draw(&self.scene(ctx), host::pixel_ratio());
            if ctx.props().playing {
                self.pace.drawn();
                self.next_frame(ctx);
            }
        }
    }

    /// From now on the page draws by itself, and steps jump.
    fn draw_plainly(&mut self) {
        if let Some(view) = self.view.take() {
            view.detach();
        }
        (self.observer, self.motion, self.canvas) = (None, None, CANVASES);
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
        let canvas = self.node.cast::<HtmlCanvasElement>();
        self.observer = canvas
            .and_then(|canvas| Observer::of(&canvas, move || link.send_message(Message::Resized)));
    }
}

/// How long a step glides.
fn glide_ms(ctx: &Context<Canvas>) -> f64 {
    f64::from(ctx.props().step_ms.max(1)) * GLIDE
}
