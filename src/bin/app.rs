//! The page: mounts the view on the static skeleton. Empty natively.

fn main() {
    #[cfg(target_arch = "wasm32")]
    groundling::ui::view::mount();
}
