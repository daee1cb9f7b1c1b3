//! The browser around the page: its elements, what the person prefers, and the crash panel, which is plain HTML
//! that the boot script fills, so that it works when the program itself is gone.

use crate::render::Theme;
use crate::ui::page::preferences::Preferences;
use std::sync::Once;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{AddEventListenerOptions, CustomEvent, CustomEventInit, Element, MediaQueryList};
use web_sys::{HtmlElement, Response, ScrollIntoViewOptions, ScrollLogicalPosition, Url};
use yew::{BaseComponent, Callback};

/// The event that the boot script shows the crash panel on; its detail is the message.
const CRASHED: &str = "groundling:crashed";

const REDUCED_MOTION: &str = "(prefers-reduced-motion: reduce)";
const DARK: &str = "(prefers-color-scheme: dark)";

/// An element by its id.
pub(crate) fn element(id: &str) -> Option<Element> {
    web_sys::window()?.document()?.get_element_by_id(id)
}

/// Mounts a page's root component in `#app`, in place of the skeleton.
pub(crate) fn mount<Root: BaseComponent<Properties = ()>>() {
    report_panics();
    let Some(place) = element("app") else {
        report("The page has no element #app.");
        return;
    };
    place.set_inner_html("");
    yew::Renderer::<Root>::with_root(place).render();
}

/// The address of a file beside the page.
pub(crate) fn beside(name: &str) -> Result<Url, JsValue> {
    let window = web_sys::window().ok_or("no window")?;
    let base = window.document().ok_or("no document")?.base_uri()?.ok_or("no base address")?;
    Url::new_with_base(name, &base)
}

/// The text of a file beside the page.
pub(crate) async fn text(name: &str) -> Result<String, JsValue> {
    let window = web_sys::window().ok_or("no window")?;
    let response = JsFuture::from(window.fetch_with_str(&beside(name)?.href())).await?;
    let response: Response = response.dyn_into()?;
    if !response.ok() {
        return Err(JsValue::from_str(&format!("status {}", response.status())));
    }
    let text = JsFuture::from(response.text()?).await?;
    text.as_string().ok_or_else(|| JsValue::from_str("no text"))
}

/// Scrolls an element into view as little as need be.
pub(crate) fn reveal(id: &str) {
    let options = ScrollIntoViewOptions::new();
    options.set_block(ScrollLogicalPosition::Nearest);
    if let Some(element) = element(id) {
        element.scroll_into_view_with_scroll_into_view_options(&options);
    }
}

/// Gives an element the keyboard's focus, and scrolls it into view as little as need be.
pub(crate) fn focus(id: &str) {
    reveal(id);
    if let Some(Ok(element)) = element(id).map(|element| element.dyn_into::<HtmlElement>()) {
        // What cannot take the focus has at least been scrolled to.
        let _ = element.focus();
    }
}

/// The language that the person's browser asks for.
pub(crate) fn language() -> String {
    web_sys::window().and_then(|w| w.navigator().language()).unwrap_or_default()
}

/// Tells the browser, and with it screen readers, which language the page is in now.
pub(crate) fn set_language(code: &str) {
    let root = web_sys::window().and_then(|w| w.document()).and_then(|d| d.document_element());
    if let Some(root) = root {
        let _ = root.set_attribute("lang", code);
    }
}

/// Copies a text; whether the browser allowed it.
pub(crate) async fn copy(text: &str) -> bool {
    let Some(window) = web_sys::window() else { return false };
    // Only secure pages have a clipboard.
    let clipboard = js_sys::Reflect::get(&window.navigator(), &JsValue::from_str("clipboard"));
    if clipboard.is_ok_and(|found| found.is_undefined()) {
        return false;
    }
    JsFuture::from(window.navigator().clipboard().write_text(text)).await.is_ok()
}

/// Goes to a view, by what names it in the address: the browser can go back from it.
pub(crate) fn go(view: &str) {
    if let Some(window) = web_sys::window() {
        // An address that cannot be changed leaves one where one is.
        let _ = window.location().set_hash(view);
    }
}

/// Calls back whenever the page is no more to be seen, as long as it lives: it may be closed then.
pub(crate) fn watch_hidden(hidden: &Callback<()>) {
    let Some(document) = web_sys::window().and_then(|w| w.document()) else { return };
    let (hidden, page) = (hidden.clone(), document.clone());
    let changed = Closure::<dyn FnMut()>::new(move || {
        if page.hidden() {
            hidden.emit(());
        }
    });
    // Its own property would have to be named by a feature of the bindings that nothing else here needs.
    let _ = document
        .add_event_listener_with_callback("visibilitychange", changed.as_ref().unchecked_ref());
    changed.forget();
}

/// What a thrown value says, for a person.
pub(crate) fn words(error: &JsValue) -> String {
    let message = error.dyn_ref::<js_sys::Error>().map(|e| String::from(e.message()));
    message.or_else(|| error.as_string()).unwrap_or_else(|| format!("{error:?}"))
}

/// What the person prefers.
pub(crate) fn preferences() -> Preferences {
    let holds = |query| media(query).is_some_and(|m| m.matches());
    let theme = if holds(DARK) { Theme::Dark } else { Theme::Light };
    Preferences { reduced_motion: holds(REDUCED_MOTION), theme }
}

/// Calls back whenever the person comes to prefer something else, as long as the page lives.
pub(crate) fn watch_preferences(changed: &Callback<Preferences>) {
    for list in [REDUCED_MOTION, DARK].into_iter().filter_map(media) {
        let changed = changed.clone();
        let listener = Closure::<dyn FnMut()>::new(move || changed.emit(preferences()));
        list.set_onchange(Some(listener.as_ref().unchecked_ref()));
        listener.forget();
        // A list that nobody holds may be collected, and its listener with it.
        std::mem::forget(list);
    }
}

/// Whether the page is pointed at with a mouse, so that there is a keyboard beside it.
pub(crate) fn is_desk() -> bool {
    media("(pointer: fine)").is_some_and(|m| m.matches())
}

fn media(query: &str) -> Option<MediaQueryList> {
    web_sys::window().and_then(|w| w.match_media(query).ok()).flatten()
}

/// Device pixels a CSS pixel.
pub(crate) fn pixel_ratio() -> f64 {
    web_sys::window().map_or(1.0, |w| w.device_pixel_ratio())
}

/// Milliseconds since the page began.
pub(crate) fn now() -> f64 {
    web_sys::window().and_then(|w| w.performance()).map_or(0.0, |p| p.now())
}

/// Calls back before the next frame is drawn.
pub(crate) fn next_frame(callback: impl FnOnce() + 'static) {
    if let Some(window) = web_sys::window() {
        let callback = Closure::once_into_js(callback);
        // A window that draws no frames shows none.
        let _ = window.request_animation_frame(callback.unchecked_ref());
    }
}

/// Calls back at the first key or touch, or before the first text from elsewhere (dictation, a program that helps).
pub(crate) fn once_touched(touched: Callback<()>) {
    let Some(window) = web_sys::window() else { return };
    let listener: Closure<dyn FnMut()> = Closure::new(move || touched.emit(()));
    let options = AddEventListenerOptions::new();
    options.set_capture(true);
    options.set_once(true);
    for event in ["keydown", "pointerdown", "beforeinput"] {
        let called = listener.as_ref().unchecked_ref();
        // A window that takes no listener is never touched.
        let _ = window.add_event_listener_with_callback_and_add_event_listener_options(
            event, called, &options,
        );
    }
    // The page listens as long as it lives.
    listener.forget();
}

/// Shows a message in the crash panel.
pub(crate) fn report(message: &str) {
    let init = CustomEventInit::new();
    init.set_detail(&JsValue::from_str(message));
    let event = CustomEvent::new_with_event_init_dict(CRASHED, &init);
    if let (Some(window), Ok(event)) = (web_sys::window(), event) {
        // A failure here leaves nobody to tell.
        let _ = window.dispatch_event(&event);
    }
}

/// From now on a panic is shown in words; the first one is the one kept.
fn report_panics() {
    static FIRST: Once = Once::new();
    std::panic::set_hook(Box::new(|info| {
        let message = info.to_string();
        FIRST.call_once(|| report(&message));
    }));
}
