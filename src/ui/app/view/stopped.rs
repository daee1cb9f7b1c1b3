//! The engine that has stopped: what happened, and a new one.

use crate::ui::app::action::Action;
use crate::ui::page::engine::{Engine, Health};
use crate::ui::page::language::Language;
use crate::ui::page::words::Text;
use yew::{Callback, Html, html};

/// The engine that has stopped: what happened, and a new one.
pub(super) fn stopped(language: Language, engine: &Engine, act: &Callback<Action>) -> Html {
    let text = Text::of(language);
    let program = engine.program();
    let Health::Stopped(why) = &engine.health else { return Html::default() };
    html! {
        <section class="notice bad engine" role="alert" data-testid="engine-stopped">
            <h2>{ text.engine_stopped }</h2>
            <p>{ text.engine_kept }</p>
            <pre tabindex="0" data-testid="engine-report">{ why }</pre>
            <button type="button" class="primary" data-testid="restart-engine"
                onclick={act.reform(move |_| Action::RestartEngine(program))}>
                { text.engine_restart }</button>
        </section>
    }
}
