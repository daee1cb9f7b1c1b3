//! The keeper's module: the store of what the page keeps, which the page imports once it is to be seen
//! (`ui::page::view::keeper`), and the texts that sessions, lessons and worlds go out and come in as
//! (`ui::page::view::forms`). Its exports are all there is of it. A fault is thrown as its name, any other error in words.

#[cfg(target_arch = "wasm32")]
mod exports {
    #![expect(unreachable_pub, reason = "reached from JavaScript")]

    use groundling::domain::State as World;
    use groundling::ui::kept::view::list;
    use groundling::ui::page::keep::fault::Fault;
    use groundling::ui::page::language::Language;
    use groundling::ui::page::view::claim;
    use groundling::ui::page::view::store::{Content, Store};
    use groundling::ui::talk::share::session::Session;
    use groundling::ui::talk::teach::learn;
    use js_sys::{Array, Function, Uint8Array};
    use std::rc::Rc;
    use wasm_bindgen::JsValue;
    use wasm_bindgen::prelude::wasm_bindgen;
    use web_sys::HtmlElement;

    /// The store, open.
    #[wasm_bindgen]
    pub struct Keeper(Rc<Store>);

    /// Opens the store of this name; `told` is called with the name of a fault that comes later.
    #[wasm_bindgen]
    pub async fn open(name: String, told: Function) -> Result<Keeper, JsValue> {
        let (blocked, gone) = (teller(&told, Fault::Older), teller(&told, Fault::Newer));
        let store = Store::open(&name, blocked, gone).await.map_err(thrown)?;
        Ok(Keeper(Rc::new(store)))
    }

    /// Claims a name for this tab; `told` is called when another tab takes it.
    #[wasm_bindgen]
    pub async fn claim(name: String, steal: bool, told: Function) -> bool {
        claim::claim(&name, steal, teller(&told, Fault::Elsewhere)).await
    }

    #[wasm_bindgen]
    impl Keeper {
        /// Keeps a text.
        pub async fn write(&self, kind: String, name: String, text: String) -> Result<(), JsValue> {
            self.0.write(&kind, &name, Content::Text(&text)).await.map_err(thrown)
        }

        /// A text, and whether its newest copy was damaged; nothing when it is not kept.
        pub async fn read(&self, kind: String, name: String) -> Result<JsValue, JsValue> {
            let found = self.0.read(&kind, &name).await.map_err(thrown)?;
            Ok(found.map_or(JsValue::NULL, |(text, damaged)| {
                let text = String::from_utf8_lossy(&text).into_owned();
                Array::of2(&text.into(), &damaged.into()).into()
            }))
        }

        /// Keeps bytes.
        pub async fn write_bytes(
            &self,
            kind: String,
            name: String,
            bytes: Vec<u8>,
        ) -> Result<(), JsValue> {
            self.0.write(&kind, &name, Content::Bytes(&bytes)).await.map_err(thrown)
        }

        /// What is kept as bytes, otherwise as `read`.
        pub async fn read_bytes(&self, kind: String, name: String) -> Result<JsValue, JsValue> {
            let found = self.0.read(&kind, &name).await.map_err(thrown)?;
            Ok(found.map_or(JsValue::NULL, |(bytes, damaged)| {
                Array::of2(&Uint8Array::from(&*bytes), &damaged.into()).into()
            }))
        }

        /// What is kept, the latest first, as JSON.
        pub async fn list(&self) -> Result<String, JsValue> {
            let items = self.0.list().await.map_err(thrown)?;
            // Strings and numbers only: JSON can hold them all.
            Ok(serde_json::to_string(&items).unwrap_or_default())
        }

        /// Deletes what is kept under a kind and a name.
        pub async fn delete(&self, kind: String, name: String) -> Result<(), JsValue> {
            self.0.delete(&kind, &name).await.map_err(thrown)
        }

        /// Draws the list of what is kept into an element, in the language of this code.
        pub async fn show(&self, into: HtmlElement, language: String) -> Result<(), JsValue> {
            let language = Language::of(&language).unwrap_or_default();
            list::show(self.0.clone(), into, language).await.map_err(thrown)
        }
    }

    /// A session, checked and packed, from its text.
    #[wasm_bindgen]
    pub fn read_session(text: &str) -> Result<Vec<u8>, String> {
        Session::read(text).map(|session| session.pack()).map_err(|error| error.to_string())
    }

    /// The text of a session that is packed.
    #[wasm_bindgen]
    pub fn write_session(packed: &[u8]) -> String {
        Session::unpack(packed).map(|session| session.write()).unwrap_or_default()
    }

    /// The corpus of lessons that are packed.
    #[wasm_bindgen]
    pub fn write_lessons(packed: &[u8]) -> String {
        learn::corpus(packed)
    }

    /// A world, checked and packed, from JSON.
    #[wasm_bindgen]
    pub fn read_world(text: &str) -> Result<Vec<u8>, String> {
        let world = World::read(text).map_err(|error| format!("it is no world: {error}"))?;
        postcard::to_allocvec(&world).map_err(|error| error.to_string())
    }

    fn teller(told: &Function, fault: Fault) -> impl FnOnce() + Clone + 'static {
        let told = told.clone();
        move || {
            // The page listens as long as it lives.
            let _ = told.call1(&JsValue::NULL, &fault.name().into());
        }
    }

    fn thrown(fault: Fault) -> JsValue {
        fault.name().into()
    }
}

fn main() {}
