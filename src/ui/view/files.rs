//! Files: choosing and dropping them. What they are is decided in `ui::files`.

use crate::ui::files::Fault;
use crate::ui::{Action, files};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Event, File, FileList, HtmlInputElement};
use yew::{Callback, Html, TargetCast, html};

/// A file to choose: the label is the button, the input itself is unseen but takes the focus.
pub(super) fn open_file(
    id: &'static str,
    label: &'static str,
    accept: &'static str,
    hint: Option<&str>,
    act: &Callback<Action>,
) -> Html {
    let act = act.clone();
    let chosen = Callback::from(move |event: Event| {
        let Some(input) = event.target_dyn_into::<HtmlInputElement>() else { return };
        read_all(input.files(), &act);
        // The same file can then be chosen again after it was mended.
        input.set_value("");
    });
    html! {
        <p class="open-file">
            <input class="unseen" type="file" {id} data-testid={id}
                {accept} onchange={chosen} />
            <label class="plain" for={id}>{ label }</label>
            if let Some(hint) = hint { <span class="dim">{ hint }</span> }
        </p>
    }
}

/// Reads the first of the files given and tells the page.
pub(super) fn read_all(files: Option<FileList>, act: &Callback<Action>) {
    let Some(file) = files.and_then(|list| list.get(0)) else { return };
    let act = act.clone();
    spawn_local(async move {
        let name = file.name();
        act.emit(match read(&file).await {
            Ok(text) => Action::FileRead { name, text },
            Err(fault) => Action::FileRefused(name, fault),
        });
    });
}

async fn read(file: &File) -> Result<String, Fault> {
    files::admit(file.size())?;
    let buffer = JsFuture::from(file.array_buffer()).await.map_err(|_| Fault::Unreadable)?;
    files::decode(js_sys::Uint8Array::new(&buffer).to_vec())
}
