//! The workbench's module: what the page imports when its Train page is opened first (`ui::app::view::bench`). Its
//! exports are all there is of it.

#[cfg(target_arch = "wasm32")]
mod exports {
    #![expect(unreachable_pub, reason = "reached from JavaScript")]

    use groundling::ui::page::document::{Model, Origin};
    use groundling::ui::page::language::Language;
    use groundling::ui::train::Action;
    use groundling::ui::train::view::{Handle, mount};
    use groundling::worker::protocol::TrainReport;
    use js_sys::{Array, Function};
    use std::rc::Rc;
    use wasm_bindgen::JsCast;
    use wasm_bindgen::prelude::wasm_bindgen;
    use web_sys::{Element, File};

    /// The workbench, open.
    #[wasm_bindgen]
    pub struct Workbench(Handle);

    /// Opens it in an element; `tell` is called with its news.
    #[wasm_bindgen]
    pub fn open(place: Element, tell: Function) -> Workbench {
        Workbench(mount(place, tell))
    }

    #[wasm_bindgen]
    impl Workbench {
        /// The page is in the language of this code.
        pub fn speak(&self, language: &str) {
            self.0.act(Action::Speak(Language::of(language).unwrap_or_default()));
        }

        /// It is to be seen, or no more.
        pub fn show(&self, shown: bool) {
            self.0.act(Action::Shown(shown));
        }

        /// Files were dropped on the page.
        pub fn bring(&self, files: &Array) {
            self.0.bring(files.iter().filter_map(|file| file.dyn_into::<File>().ok()).collect());
        }

        /// Why the robot has no model, or not the one that was wanted.
        pub fn notice(&self, words: Option<String>) {
            self.0.act(Action::Notice(words));
        }

        /// The robot uses this model.
        pub fn model(
            &self,
            text: String,
            origin: &str,
            corpus: String,
            examples: usize,
            valid: usize,
            entries: usize,
        ) {
            let origin = match origin {
                "shipped" => Origin::Shipped,
                "trained" => Origin::Trained(corpus),
                _ => Origin::File,
            };
            let report = Rc::new(TrainReport { model: text, examples, valid, entries });
            self.0.act(Action::Uses(Model { report, origin }));
        }
    }
}

fn main() {}
