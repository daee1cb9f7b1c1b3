//! The page that asks people, `collect.html`. Empty natively.

fn main() {
    #[cfg(target_arch = "wasm32")]
    groundling::ui::collect::view::mount();
}
