//! The renderer's module: what the page imports when it wants its first picture (`render::link`). Its exports are
//! all there is of it; they stand here and not in the library, so that no other program links the GPU.

#[cfg(target_arch = "wasm32")]
mod exports {
    #![expect(unreachable_pub, reason = "reached from JavaScript")]

    use groundling::render::gpu::Gpu;
    use js_sys::Promise;
    use wasm_bindgen::prelude::{JsError, wasm_bindgen};
    use web_sys::HtmlCanvasElement;

    /// The renderer's hold on one canvas.
    #[wasm_bindgen]
    pub struct Picture(Gpu);

    /// Takes a fresh canvas; rejects when there is no GPU.
    #[wasm_bindgen]
    pub async fn attach(canvas: HtmlCanvasElement) -> Result<Picture, JsError> {
        Ok(Picture(Gpu::attach(canvas).await?))
    }

    #[wasm_bindgen]
    impl Picture {
        /// `webgpu` or `webgl2`.
        pub fn backend(&self) -> String {
            self.0.backend().name().to_owned()
        }

        /// Whether the processor does a GPU's work.
        pub fn is_software(&self) -> bool {
            self.0.is_software()
        }

        /// Draws a scene's numbers on a canvas of `width` by `height` device pixels.
        pub fn draw(&mut self, scene: &[f32], width: u32, height: u32) -> Result<(), JsError> {
            Ok(self.0.draw(scene, width, height)?)
        }

        /// Resolves with a reason when the GPU takes the canvas away, with null when this is freed before.
        pub fn lost(&self) -> Promise {
            self.0.lost()
        }
    }
}

fn main() {}
