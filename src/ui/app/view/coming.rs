//! What stands where the workbench will, until it has come; and if it does not.
use crate::ui::app::action::{Action, View};
use crate::ui::app::state::{Bench, State};
use crate::ui::app::words::Text;
use crate::ui::page::view::sends::sends;
use yew::{Callback, Html, html};

/// The place of the workbench; nothing once it is there itself.
pub(super) fn coming(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.shared.language);
    match &state.bench {
        Bench::Here => Html::default(),
        Bench::Lost(why) => html! {
            <main>
                <section class="notice bad" role="alert" data-testid="no-workbench">
                    <p>{ (text.no_workbench)(why) }</p>
                    <button type="button" class="primary" data-testid="load-workbench"
                        onclick={sends(act, Action::Go(View::Train))}>{ text.try_again }</button>
                </section>
            </main>
        },
        Bench::Absent | Bench::Coming => html! {
            <main aria-busy="true" data-testid="workbench-comes">
                <section class="card"><p role="status">{ text.workbench_comes }</p><div class="line tall blank" /></section>
            </main>
        },
    }
}
