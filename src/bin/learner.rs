//! The page's learner, in a dedicated worker. Empty natively.

fn main() {
    #[cfg(target_arch = "wasm32")]
    groundling::worker::agent::listen::<groundling::worker::Learner>();
}
