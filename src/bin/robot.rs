//! The page that drives a robot, `robot.html`. Empty natively.

fn main() {
    #[cfg(target_arch = "wasm32")]
    groundling::ui::robot::view::mount();
}
