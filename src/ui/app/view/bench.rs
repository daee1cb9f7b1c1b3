//! The page's side of the workbench: imports the module `workbench.js`, whose view stands beside the page's own, brings
//! it files, and keeps it told of what it shows of the page.
use crate::ui::app::action::{Action, View};
use crate::ui::app::state::{Bench, State};
use crate::ui::page::document::{Model, Origin};
use crate::ui::page::language::Language;
use crate::ui::page::news::News;
use crate::ui::page::view::host;
use crate::ui::page::view::module::import;
use js_sys::{Array, Promise};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::prelude::{Closure, wasm_bindgen};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Element, File, HtmlLinkElement};
use yew::Callback;

/// The element of the page that it draws in, outside the page's own: each listens to its own events alone.
const PLACE: &str = "workbench";

#[wasm_bindgen]
extern "C" {
    /// The module's exports.
    type Module;
    #[wasm_bindgen(method, structural)]
    fn open(this: &Module, place: &Element, tell: &JsValue) -> Workbench;

    /// The workbench, open.
    #[derive(Clone)]
    type Workbench;
    #[wasm_bindgen(method, structural)]
    fn speak(this: &Workbench, language: &str);
    #[wasm_bindgen(method, structural)]
    fn show(this: &Workbench, shown: bool);
    #[wasm_bindgen(method, structural)]
    fn bring(this: &Workbench, files: &Array);
    #[wasm_bindgen(method, structural)]
    fn notice(this: &Workbench, words: Option<&str>);
    #[wasm_bindgen(method, structural)]
    fn model(
        this: &Workbench,
        text: &str,
        origin: &str,
        corpus: &str,
        examples: usize,
        valid: usize,
        entries: usize,
    );
}

/// The workbench as the page has it.
pub(super) struct Link {
    act: Callback<Action>,
    open: Rc<RefCell<Option<Workbench>>>,
    tries: u32,
    /// Files that wait for it.
    files: Array,
    told: Told,
}

/// What it was told last.
#[derive(Default)]
struct Told {
    language: Option<Language>,
    shown: bool,
    model: Option<Model>,
    notice: Option<String>,
}

impl Link {
    /// What it tells goes to `act`.
    pub(super) fn new(act: Callback<Action>) -> Link {
        Link { act, open: Rc::default(), tries: 0, files: Array::new(), told: Told::default() }
    }

    /// Has it fetched and opened.
    pub(super) fn load(&mut self) {
        let (act, open, again) = (self.act.clone(), self.open.clone(), self.tries);
        self.tries += 1;
        spawn_local(async move {
            let told = teller(act.reform(Action::Bench));
            let came = fetched(again, &told).await.map(|workbench| {
                *open.borrow_mut() = Some(workbench);
            });
            act.emit(Action::Loaded(came.map_err(|error| host::words(&error))));
        });
    }

    /// Brings it files, as soon as it is there.
    pub(super) fn bring(&mut self, files: Vec<File>) {
        for file in files {
            self.files.push(&file);
        }
    }

    /// Tells it what has changed.
    pub(super) fn keep_up(&mut self, State { shared, view, bench, .. }: &State) {
        let open = self.open.borrow();
        let (Some(workbench), Bench::Here) = (&*open, bench) else { return };
        let told = &mut self.told;
        if told.language != Some(shared.language) {
            told.language = Some(shared.language);
            workbench.speak(shared.language.code());
        }
        if told.model != shared.document.model {
            told.model = shared.document.model.clone();
            if let Some(Model { report, origin }) = &told.model {
                let (origin, corpus) = match origin {
                    Origin::Shipped => ("shipped", ""),
                    Origin::Trained(corpus) => ("trained", corpus.as_str()),
                    Origin::File => ("file", ""),
                };
                let (examples, valid, entries) = (report.examples, report.valid, report.entries);
                workbench.model(&report.model, origin, corpus, examples, valid, entries);
            }
        }
        if told.notice != shared.model_notice {
            told.notice = shared.model_notice.clone();
            workbench.notice(told.notice.as_deref());
        }
        let shown = *view == View::Train;
        if std::mem::replace(&mut told.shown, shown) != shown {
            workbench.show(shown);
        }
        if self.files.length() > 0 {
            workbench.bring(&std::mem::take(&mut self.files));
        }
    }
}

/// What it calls with its news.
fn teller(told: Callback<News>) -> JsValue {
    let teller =
        Closure::<dyn FnMut(String, String, String)>::new(move |kind: String, text, corpus| {
            if let Some(news) = News::of(&kind, text, corpus) {
                told.emit(news);
            }
        });
    teller.into_js_value()
}

async fn fetched(again: u32, tell: &JsValue) -> Result<Workbench, JsValue> {
    let place = host::element(PLACE).ok_or("no place for it")?;
    // Its looks come first, so that it is not seen without them.
    JsFuture::from(styled()?).await.map_err(|_| "its looks did not come")?;
    let module: Module = import("workbench.js", again).await?.unchecked_into();
    Ok(module.open(&place, tell))
}

/// Links its style sheet; settles when it has come, or has not.
fn styled() -> Result<Promise, JsValue> {
    let document = web_sys::window().and_then(|w| w.document()).ok_or("no document")?;
    let link: HtmlLinkElement = document.create_element("link")?.unchecked_into();
    link.set_rel("stylesheet");
    link.set_href(&host::beside("workbench.css")?.href());
    let settled = Promise::new(&mut |came, lost| {
        link.set_onload(Some(&came));
        link.set_onerror(Some(&lost));
    });
    document.head().ok_or("no head")?.append_child(&link)?;
    Ok(settled)
}
