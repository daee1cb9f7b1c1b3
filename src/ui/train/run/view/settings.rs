//! The settings of the next run; the paper's unless a person says otherwise.

use super::press::press;
use crate::ui::page::view::fields::{choice, number, tick};
use crate::ui::page::view::files::open_file;
use crate::ui::train::run::action::{Action, Number, Setting};
use crate::ui::train::run::state::State;
use crate::ui::train::run::words::Text;
use crate::worker::protocol::{FeatureKind, Lexicon, SeedLexicon};
use yew::{Callback, Html, html};

/// The settings; those of a run at work stay as they were when it began.
pub(super) fn settings(state: &State, text: &Text, act: &Callback<Action>) -> Html {
    let set = act.reform(Action::Set);
    let numbers = Number::ALL.into_iter().map(|(which, least, most)| {
        let step = if which == Number::Margin { 0.1 } else { 1.0 };
        let id = format!("setting-{which:?}").to_ascii_lowercase();
        let value = [state.number(which), least, most, step];
        let change = set.reform(move |value| Setting::Number(which, value));
        number(id.into(), (text.number)(which).into(), value, false, change)
    });
    // In the order of their words; the person's own is the last.
    let here = |lexicon| Some(Lexicon::Here(lexicon));
    let mut lexicons = vec![None, here(SeedLexicon::Demonstration), here(SeedLexicon::Domain)];
    let mut names = text.lexicons.map(str::to_owned).to_vec();
    if let Some((name, own)) = &state.own {
        lexicons.push(Some(Lexicon::Own(own.clone())));
        names.push(name.clone());
    }
    let chosen = lexicons.iter().position(|one| *one == state.lexicon).unwrap_or(0);
    let choose =
        set.reform(move |place: usize| Setting::Lexicon(lexicons.get(place).cloned().flatten()));
    let kinds = FeatureKind::ALL.into_iter().map(|(name, kind)| {
        let is_out = state.settings.without.contains(&kind);
        let change = set.reform(move |out| Setting::Without(kind, out));
        tick(format!("without-{name}").into(), (text.kind)(kind).into(), is_out, false, change)
    });
    let is_paper = state.is_paper();
    html! {
        <section class="card" aria-labelledby="settings-title">
            <div class="card-head">
                <h2 id="settings-title">{ text.settings }</h2>
                if is_paper {
                    <span class="dim">{ text.are_paper }</span>
                } else {
                    { press("quiet", "paper", text.paper, false, act, Action::Paper) }
                }
            </div>
            <div class="settings">{ for numbers }</div>
            <div class="fields">
                { choice("setting-lexicon".into(), text.lexicon.into(), &names, chosen, choose) }
                { open_file("lexicon-file", text.own_lexicon, ".txt,.lex", None, &act.reform(Action::OwnLexicon)) }
                { tick("setting-idioms".into(), text.idioms.into(), state.settings.idioms, false, set.reform(Setting::Idioms)) }
            </div>
            <fieldset class="kinds"><legend>{ text.without }</legend>{ for kinds }</fieldset>
        </section>
    }
}
