//! The engine that has stopped: what happened, and a new one.

use crate::ui::page::engine::{Engine, Health};
use crate::ui::page::language::Language;
use crate::ui::page::words::Text;
use crate::worker::protocol::Program;
use yew::{Callback, Html, html};

/// The engine that has stopped: what happened, and a new one.
pub(crate) fn stopped(language: Language, engine: &Engine, again: &Callback<Program>) -> Html {
    let text = Text::of(language);
    let program = engine.program();
    let Health::Stopped(why) = &engine.health else { return Html::default() };
    html! {
        <section class="notice bad engine" role="alert" data-testid="engine-stopped">
            <h2>{ text.engine_stopped }</h2>
            <p>{ text.engine_kept }</p>
            <pre tabindex="0" data-testid="engine-report">{ why }</pre>
            <button type="button" class="primary" data-testid="restart-engine"
                onclick={again.reform(move |_| program)}>
                { text.engine_restart }</button>
        </section>
    }
}
