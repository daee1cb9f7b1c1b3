//! The page's side of the renderer: imports the module `renderer.js` (and with it the GPU's code) when the first
//! picture is wanted and hands it scenes as one `Float32Array` a frame. Needs no more of a content policy than
//! `script-src 'self' 'wasm-unsafe-eval'`: the import is the language's own, of a file beside the page.

use crate::render::Scene;
use js_sys::{Float32Array, Promise};
use wasm_bindgen::prelude::{JsCast, JsValue, wasm_bindgen};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{HtmlCanvasElement, Url};

/// Where the renderer's module lies, relative to the page's base address.
pub const MODULE: &str = "renderer.js";

/// Why there is no picture; the page then shows the grid of cells.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LinkError {
    /// The module did not come: no network, an old browser, a broken site.
    #[error("the picture's program could not be loaded: {0}")]
    Load(String),
    /// The module is there, but this browser gives it no GPU.
    #[error("this browser offers neither WebGPU nor WebGL 2: {0}")]
    NoGpu(String),
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = import)]
    fn import_module(url: &str) -> Promise;

    /// The renderer's exports.
    #[derive(Clone)]
    type Module;
    #[wasm_bindgen(method, structural, catch, js_name = default)]
    fn start(this: &Module) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, structural, catch)]
    fn attach(this: &Module, canvas: &HtmlCanvasElement) -> Result<Promise, JsValue>;

    /// The renderer's hold on one canvas.
    type Picture;
    #[wasm_bindgen(method, structural)]
    fn backend(this: &Picture) -> String;
    #[wasm_bindgen(method, structural)]
    fn is_software(this: &Picture) -> bool;
    #[wasm_bindgen(method, structural, catch)]
    fn draw(this: &Picture, scene: &Float32Array, w: u32, h: u32) -> Result<(), JsValue>;
    #[wasm_bindgen(method, structural)]
    fn lost(this: &Picture) -> Promise;
    #[wasm_bindgen(method, structural)]
    fn free(this: &Picture);
}

/// The renderer's module, loaded; cheap to clone.
#[derive(Clone)]
pub struct Renderer(Module);

/// A canvas that scenes can be drawn on.
pub struct View {
    picture: Picture,
    canvas: HtmlCanvasElement,
}

/// Loads the renderer. The browser keeps the module: a second call costs nothing.
///
/// # Errors
/// [`LinkError::Load`] when the file does not come or does not start.
pub async fn load() -> Result<Renderer, LinkError> {
    let failed = |error: JsValue| LinkError::Load(words(&error));
    let base =
        web_sys::window().and_then(|w| w.document()).and_then(|d| d.base_uri().ok().flatten());
    let base = base.ok_or_else(|| LinkError::Load("there is no page".to_owned()))?;
    let url = Url::new_with_base(MODULE, &base).map_err(failed)?;
    let module = JsFuture::from(import_module(&url.href())).await.map_err(failed)?;
    let module: Module = module.unchecked_into();
    JsFuture::from(module.start().map_err(failed)?).await.map_err(failed)?;
    Ok(Renderer(module))
}

impl Renderer {
    /// Takes a canvas that nothing was drawn on: WebGPU where it proves to work, else WebGL 2.
    ///
    /// # Errors
    /// [`LinkError::NoGpu`] when neither is there; the canvas may then be spent.
    pub async fn attach(&self, canvas: &HtmlCanvasElement) -> Result<View, LinkError> {
        let failed = |error: JsValue| LinkError::NoGpu(words(&error));
        let picture =
            JsFuture::from(self.0.attach(canvas).map_err(failed)?).await.map_err(failed)?;
        Ok(View { picture: picture.unchecked_into(), canvas: canvas.clone() })
    }
}

impl View {
    /// `webgpu` or `webgl2`.
    pub fn backend(&self) -> String {
        self.picture.backend()
    }

    /// Whether there is no GPU behind it: what moves is then better drawn by the page itself.
    pub fn is_software(&self) -> bool {
        self.picture.is_software()
    }

    /// Draws a scene, fitted into the canvas and centred, at `dpr` device pixels a CSS pixel. The canvas's CSS
    /// size must come from the style sheet, since its `width` and `height` are set here to device pixels.
    ///
    /// # Errors
    /// [`LinkError::NoGpu`] when the GPU is gone; [`View::on_lost`] tells it too.
    pub fn draw(&self, scene: &Scene, dpr: f64) -> Result<(), LinkError> {
        let dpr = if dpr.is_finite() { dpr.clamp(0.25, 8.0) } else { 1.0 };
        let pixels = |css: f64| ((css * dpr).round() as u32).max(1);
        let shown = self.canvas.get_bounding_client_rect();
        let (w, h) = (pixels(shown.width()), pixels(shown.height()));
        let floats = Float32Array::from(scene.floats().as_slice());
        self.picture.draw(&floats, w, h).map_err(|error| LinkError::NoGpu(words(&error)))
    }

    /// Calls back once, with the reason, when the GPU takes the canvas away. The canvas is then spent: attach a
    /// fresh one, or show the grid of cells.
    pub fn on_lost(&self, callback: impl FnOnce(String) + 'static) {
        let lost = self.picture.lost();
        spawn_local(async move {
            let reason = JsFuture::from(lost).await.ok().and_then(|reason| reason.as_string());
            if let Some(reason) = reason {
                callback(reason);
            }
        });
    }

    /// Gives the GPU's memory back.
    pub fn detach(self) {
        self.picture.free();
    }
}

/// What a thrown value says, for a person.
fn words(value: &JsValue) -> String {
    let message = value.dyn_ref::<js_sys::Error>().map(|error| String::from(error.message()));
    message.or_else(|| value.as_string()).unwrap_or_else(|| format!("{value:?}"))
}
