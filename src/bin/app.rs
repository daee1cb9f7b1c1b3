//! The page, and the engine that talks: one program, so that what both need is loaded once. In a window it mounts the
//! view on the static skeleton, in a worker it is the engine. Empty natively.

fn main() {
    #[cfg(target_arch = "wasm32")]
    if groundling::ui::app::view::has_page() {
        groundling::ui::app::view::mount();
    } else {
        groundling::worker::agent::listen::<groundling::worker::Talker>();
    }
}
