//! The whole page: the guide's lines, examples as buttons.

use crate::domain::State as World;
use crate::ui::help::guide::{Line, lines};
use crate::ui::help::state::State;
use crate::ui::page::view::notice::notice;
use yew::{Callback, Html, html};

/// The guide for a world; an example that is pressed goes to `say`.
pub(crate) fn help(state: &State, world: &World, say: &Callback<String>) -> Html {
    let (text, wrong) = match &state.text {
        Some(Ok(text)) => (&**text, None),
        Some(Err(why)) => ("", Some(&**why)),
        None => ("", None),
    };
    let all = lines(text, world);
    let rows = all.chunk_by(|a, b| kind(a) == kind(b) && kind(a) > 0);
    html! {
        <main class="columns single">
            <section class="card guide" data-testid="guide" aria-busy={state.text.is_none().to_string()}>
                { notice(wrong, "guide-notice") }
                { for rows.map(|row| match row {
                    [Line::Head(1, words)] => html! { <h2>{ words }</h2> },
                    [Line::Head(_, words)] => html! { <h3>{ words }</h3> },
                    [Line::Text(words)] => html! { <p>{ words }</p> },
                    [Line::Say(_), ..] => html! { <p class="chips" lang="en">{ for row.iter().map(|line| example(line, say)) }</p> },
                    _ => html! { <dl class="keys">{ for row.iter().map(key) }</dl> },
                }) }
            </section>
        </main>
    }
}

/// What lines stand together: examples, and keys.
const fn kind(line: &Line) -> u8 {
    match line {
        Line::Say(_) => 1,
        Line::Key(..) => 2,
        _ => 0,
    }
}

fn example(line: &Line, say: &Callback<String>) -> Html {
    let Line::Say(words) = line else { return Html::default() };
    let said = words.clone();
    html! {
        <button type="button" class="chip" data-testid="example"
            onclick={say.reform(move |_| said.clone())}>{ words }</button>
    }
}

fn key(line: &Line) -> Html {
    let Line::Key(key, does) = line else { return Html::default() };
    html! { <><dt><kbd>{ key }</kbd></dt><dd>{ does }</dd></> }
}
