//! Pictures in a page of a headless browser, drawn with WebGL 2 and read back: against golden images, and
//! against the palette to the bit.
//!
//! When a picture was changed on purpose: `tests/browser/golden.sh` draws the golden images anew; look at them
//! before they are committed.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used, reason = "a failing test panics")]

use groundling::domain::{Direction, Plan, State, generate, text};
use groundling::render::gpu::{Backend, Gpu, GpuError, read_back};
use groundling::render::{
    Arrow, Floor, Ghost, Ground, Options, Rgba, Scene, Theme, Thing, link, spread,
};
use js_sys::{Function, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::HtmlCanvasElement;

wasm_bindgen_test_configure!(run_in_browser);

const ROOMS: &str = include_str!("../data/golden/rooms.json");
const LIGHT: &[u8] = include_bytes!("../data/golden/rooms-light.png");
const DARK: &[u8] = include_bytes!("../data/golden/rooms-dark.png");
const HOME: &str = include_str!("../data/golden/home.txt");
const PLAN_LIGHT: &[u8] = include_bytes!("../data/golden/plan-light.png");
const PLAN_DARK: &[u8] = include_bytes!("../data/golden/plan-dark.png");
const POINT_LIGHT: &[u8] = include_bytes!("../data/golden/point-light.png");
const POINT_DARK: &[u8] = include_bytes!("../data/golden/point-dark.png");
const HAND_LIGHT: &[u8] = include_bytes!("../data/golden/hand-light.png");
const HAND_DARK: &[u8] = include_bytes!("../data/golden/hand-dark.png");

/// Pixels a cell in the golden images.
const SCALE: u32 = 32;

fn scene(theme: Theme) -> Scene {
    let state = State::read(ROOMS).unwrap();
    let highlight = vec![(10, 2), (11, 2), (12, 2)];
    Scene::of(
        &state,
        &Options { theme, highlight, letters: theme == Theme::Dark, ..Options::default() },
    )
}

/// A world with what every free cell is worth on the way to `goal`, and the way there.
fn planned(state: &State, goal: &[(i32, i32)], theme: Theme) -> Options {
    let floor = Floor::of(state);
    let free = |(x, y): (i32, i32)| match floor.at(x, y) {
        Ground::Wall | Ground::Outside => false,
        Ground::Room(_) | Ground::Door(_) => state.objects.iter().all(|o| (o.x, o.y) != (x, y)),
    };
    let sides = |(x, y): (i32, i32)| {
        [
            (Direction::North, (x, y + 1)),
            (Direction::South, (x, y - 1)),
            (Direction::East, (x + 1, y)),
            (Direction::West, (x - 1, y)),
        ]
    };
    let mut found: Vec<((i32, i32), i32, Option<Arrow>)> =
        goal.iter().map(|cell| (*cell, 0, None)).collect();
    let mut next = 0;
    while let Some((cell, far, _)) = found.get(next).copied() {
        next += 1;
        for (side, from) in sides(cell) {
            if free(from) && !found.iter().any(|(known, ..)| *known == from) {
                found.push((from, far + 1, Some(Arrow::Step(side.opposite()))));
            }
        }
    }
    let worth = |((x, y), far, _): &((i32, i32), i32, _)| (*x, *y, 0.99f64.powi(*far));
    Options {
        theme,
        values: spread(&found.iter().map(worth).collect::<Vec<_>>()).cells,
        arrows: found.iter().filter_map(|((x, y), _, arrow)| Some((*x, *y, (*arrow)?))).collect(),
        goal: goal.to_vec(),
        ..Options::default()
    }
}

fn home() -> State {
    text::read_legal(HOME).unwrap()
}

/// Where to go, and how.
fn plan(theme: Theme) -> Scene {
    let options = planned(&home(), &[(10, 7), (11, 7), (11, 6)], theme);
    Scene::of(&home(), &options)
}

/// A room and a thing pointed out beside goal cells, and every kind of arrow.
fn pointing(theme: Theme) -> Scene {
    let state = home();
    let red = state.rooms[0].bounds;
    let inside = (red.left + 1..red.right)
        .flat_map(|x| (red.bottom + 1..red.top).map(move |y| (x, y)))
        .filter(|cell| *cell != (red.left + 1, red.bottom + 1));
    let highlight = inside.chain([(10, 6), (8, 7)]).collect();
    let arrows = ["north", "west", "forward", "turn_left", "turn_right", "pull"];
    let arrows =
        (1..).zip(arrows).map(|(x, name)| (x, 2, Arrow::of_action(name, Direction::East).unwrap()));
    let goal = vec![(2, 3), (3, 3), (4, 3), (3, 1), (8, 7)];
    let options = Options {
        theme,
        highlight,
        goal,
        arrows: arrows.collect(),
        letters: true,
        ..Options::default()
    };
    Scene::of(&state, &options)
}

/// The keyboard's cell, and a chair in a person's hand over a place where it may not stand.
fn hand(theme: Theme) -> Scene {
    let ghost = Ghost { what: Thing::Object(0), at: [8.2, 4.9], target: (8, 5), allowed: false };
    let cursor = Some((11, 3));
    let options =
        Options { theme, cursor, ghost: Some(ghost), letters: true, ..Options::default() };
    Scene::of(&home(), &options)
}

fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().unwrap().document().unwrap();
    document.create_element("canvas").unwrap().dyn_into().unwrap()
}

/// Draws a scene at `scale` pixels a cell and reads it back: width and pixels.
async fn drawn(scene: &Scene, scale: u32) -> (HtmlCanvasElement, Vec<u8>) {
    let canvas = canvas();
    let mut gpu = Gpu::on(Backend::WebGl2, canvas.clone()).await.unwrap();
    let (w, h) = (scene.extent.columns * scale, scene.extent.rows * scale);
    gpu.draw(&scene.floats(), w, h).unwrap();
    let pixels = read_back(&canvas).unwrap();
    assert_eq!(pixels.len() as u32, w * h * 4);
    (canvas, pixels)
}

/// The pixels of a PNG with eight bits a component.
fn decoded(png: &[u8]) -> Vec<u8> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgba, png::BitDepth::Eight));
    pixels
}

/// Fails, with the picture drawn as a data address, when it differs from the golden image by more than what
/// another machine's smoothing may do: one pixel in two hundred by more than a tenth.
async fn is_golden(name: &str, golden: &[u8], scene: &Scene) {
    let (canvas, pixels) = drawn(scene, SCALE).await;
    let golden = if golden.is_empty() { Vec::new() } else { decoded(golden) };
    let differs = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 25);
    let different = pixels.chunks(4).zip(golden.chunks(4)).filter(|pair| differs(*pair)).count();
    let same = pixels.len() == golden.len() && different * 200 <= pixels.len() / 4;
    assert!(same, "{different} pixels differ\ngolden {name} {}", canvas.to_data_url().unwrap());
}

#[wasm_bindgen_test]
async fn rooms_by_day() {
    is_golden("rooms-light.png", LIGHT, &scene(Theme::Light)).await;
}

#[wasm_bindgen_test]
async fn rooms_by_night() {
    is_golden("rooms-dark.png", DARK, &scene(Theme::Dark)).await;
}

#[wasm_bindgen_test]
async fn a_plan_by_day() {
    is_golden("plan-light.png", PLAN_LIGHT, &plan(Theme::Light)).await;
}

#[wasm_bindgen_test]
async fn a_plan_by_night() {
    is_golden("plan-dark.png", PLAN_DARK, &plan(Theme::Dark)).await;
}

#[wasm_bindgen_test]
async fn pointing_by_day() {
    is_golden("point-light.png", POINT_LIGHT, &pointing(Theme::Light)).await;
}

#[wasm_bindgen_test]
async fn pointing_by_night() {
    is_golden("point-dark.png", POINT_DARK, &pointing(Theme::Dark)).await;
}

#[wasm_bindgen_test]
async fn a_hand_by_day() {
    is_golden("hand-light.png", HAND_LIGHT, &hand(Theme::Light)).await;
}

#[wasm_bindgen_test]
async fn a_hand_by_night() {
    is_golden("hand-dark.png", HAND_DARK, &hand(Theme::Dark)).await;
}

#[wasm_bindgen_test]
async fn colours_are_the_palettes_at_any_scale() {
    let bytes = |Rgba(c): Rgba| c.map(|c| (c * 255.0).round() as u8);
    for theme in [Theme::Light, Theme::Dark] {
        let scene = scene(theme);
        for scale in [7, 20, 33, 64] {
            let (canvas, pixels) = drawn(&scene, scale).await;
            // The middle of a cell, by column and by row from the north.
            let at = |column: u32, row: u32| {
                let (x, y) = (column * scale + scale / 2, row * scale + scale / 2);
                let start = ((y * canvas.width() + x) * 4) as usize;
                <[u8; 4]>::try_from(&pixels[start..start + 4]).unwrap()
            };
            assert_eq!(at(0, 3), bytes(theme.wall()), "wall, {theme:?} at {scale}");
            let blue = theme.floor(groundling::domain::Color::Blue);
            assert_eq!(at(11, 7), bytes(blue), "floor, {theme:?} at {scale}");
            assert_eq!(&pixels[..4], bytes(theme.backdrop()), "backdrop, {theme:?} at {scale}");
        }
    }
}

#[wasm_bindgen_test]
async fn everything_is_one_draw_call() {
    let state = generate(&Plan { side: (32, 32), objects: (20, 20) }, 1);
    let goal = [(state.agent.x, state.agent.y)];
    let highlight = state.objects.iter().map(|o| (o.x, o.y)).collect();
    let ghost = Ghost { what: Thing::Robot, at: [3.3, 3.3], target: (3, 3), allowed: true };
    let (ghost, cursor) = (Some(ghost), Some((4, 4)));
    let options = planned(&state, &goal, Theme::Light);
    let scene = Scene::of(&state, &Options { highlight, ghost, cursor, letters: true, ..options });
    // Every way to draw counts itself.
    let count = Function::new_no_args(
        "globalThis.draws = 0; const all = WebGL2RenderingContext.prototype;
        for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
            const draw = all[name];
            all[name] = function (...rest) { globalThis.draws += 1; return draw.apply(this, rest); };
        }",
    );
    count.call0(&JsValue::NULL).unwrap();
    let canvas = canvas();
    let mut gpu = Gpu::on(Backend::WebGl2, canvas).await.unwrap();
    for drawn in 1..=3 {
        gpu.draw(&scene.floats(), 640, 640).unwrap();
        let draws = Reflect::get(&js_sys::global(), &"draws".into()).unwrap();
        assert_eq!(draws.as_f64(), Some(f64::from(drawn)), "{} quads", scene.quads.len());
    }
}

#[wasm_bindgen_test]
async fn a_lost_context_is_told() {
    let canvas = canvas();
    let mut gpu = Gpu::on(Backend::WebGl2, canvas.clone()).await.unwrap();
    let floats = scene(Theme::Light).floats();
    gpu.draw(&floats, 40, 30).unwrap();
    assert!(matches!(gpu.draw(&floats[..9], 40, 30), Err(GpuError::NotAScene(9))));
    let context: JsValue = canvas.get_context("webgl2").unwrap().unwrap().into();
    let call = |this: &JsValue, name: &str, argument: &JsValue| {
        let function = Reflect::get(this, &name.into()).unwrap().dyn_into::<Function>().unwrap();
        function.call1(this, argument).unwrap()
    };
    let extension = call(&context, "getExtension", &"WEBGL_lose_context".into());
    call(&extension, "loseContext", &JsValue::UNDEFINED);
    let reason = JsFuture::from(gpu.lost()).await.unwrap();
    assert!(reason.as_string().unwrap().contains("context"));
    assert!(matches!(gpu.draw(&floats, 40, 30), Err(GpuError::Lost(_))));
}

#[wasm_bindgen_test]
async fn whatever_is_there_draws() {
    let canvas = canvas();
    let mut gpu = Gpu::attach(canvas.clone()).await.unwrap();
    let scene = scene(Theme::Light);
    gpu.draw(&scene.floats(), 800, 600).unwrap();
    let Rgba(backdrop) = scene.backdrop;
    let wanted = backdrop.map(|c| (c * 255.0).round() as u8);
    assert_eq!(read_back(&canvas).unwrap().get(..4), Some(wanted.as_slice()));
}

#[wasm_bindgen_test]
async fn a_module_that_does_not_come_is_an_error_in_words() {
    // The test's page has no renderer beside it.
    let Err(error) = link::load().await else { panic!("there is no such file") };
    assert!(error.to_string().starts_with("the picture's program could not be loaded: "));
}
