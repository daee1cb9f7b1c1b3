//! The link to a rosbridge: a browser's WebSocket to the address that a person typed, and to no other.

use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, WebSocket};

/// Something that happens to a link.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// It is open.
    Opened,
    /// A text came over it; one of bytes, which nobody asked for, is empty.
    Heard(String),
    /// It is closed, or never opened.
    Closed,
}

/// A link; it closes when this is dropped, and says nothing any more.
pub struct Link {
    socket: WebSocket,
    _event: Closure<dyn FnMut(web_sys::Event)>,
    _message: Closure<dyn FnMut(MessageEvent)>,
}

impl Link {
    /// Opens a link; what happens to it goes to `told`.
    ///
    /// # Errors
    /// When the browser takes the address for none, or for one that it may not open.
    pub fn open(address: &str, told: impl Fn(News) + Clone + 'static) -> Result<Link, JsValue> {
        let socket = WebSocket::new(address)?;
        let tell = told.clone();
        let event: Closure<dyn FnMut(web_sys::Event)> =
            Closure::new(move |event: web_sys::Event| {
                tell(if event.type_() == "open" { News::Opened } else { News::Closed });
            });
        let message: Closure<dyn FnMut(MessageEvent)> = Closure::new(move |event: MessageEvent| {
            told(News::Heard(event.data().as_string().unwrap_or_default()));
        });
        socket.set_onopen(Some(event.as_ref().unchecked_ref()));
        // An error is always followed by this.
        socket.set_onclose(Some(event.as_ref().unchecked_ref()));
        socket.set_onmessage(Some(message.as_ref().unchecked_ref()));
        Ok(Link { socket, _event: event, _message: message })
    }

    /// Sends a text now; nothing is kept where the link is not open.
    pub fn send(&self, text: &str) {
        if self.socket.ready_state() == WebSocket::OPEN {
            // A link that has closed meanwhile says so itself.
            let _ = self.socket.send_with_str(text);
        }
    }

    /// Bytes that were sent and have not left.
    pub fn backlog(&self) -> u32 {
        self.socket.buffered_amount()
    }
}

impl Drop for Link {
    fn drop(&mut self) {
        self.socket.set_onopen(None);
        self.socket.set_onclose(None);
        self.socket.set_onmessage(None);
        // What is closed already is closed.
        let _ = self.socket.close();
    }
}
