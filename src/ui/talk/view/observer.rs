//! Watches an element's size.
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{Element, ResizeObserver};

/// Watches an element's size, as long as it lives.
pub(super) struct Observer {
    observer: ResizeObserver,
    _resized: Closure<dyn FnMut()>,
}

impl Observer {
    /// Calls back whenever the element's size changes; nothing where the browser cannot tell.
    pub(super) fn of(element: &Element, resized: impl Fn() + 'static) -> Option<Observer> {
        let resized: Closure<dyn FnMut()> = Closure::new(resized);
        let observer = ResizeObserver::new(resized.as_ref().unchecked_ref()).ok()?;
        observer.observe(element);
        Some(Observer { observer, _resized: resized })
    }
}

impl Drop for Observer {
    fn drop(&mut self) {
        self.observer.disconnect();
    }
}
