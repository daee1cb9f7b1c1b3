//! What the engine says of studies.

use super::files::{hold, review};
use super::state::State;
use super::update::pack;
use super::words::Text;
use crate::ui::page::files::Offered;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Event, Reviewed, Sheet, StudyAsk, StudySaid};

/// Something is being done.
pub fn progressed(state: &mut State, said: &StudySaid) {
    match said {
        StudySaid::Making(done, of) => state.making = Some((*done, *of)),
        StudySaid::Judging(done, of) => state.judging = Some((*done, *of)),
        StudySaid::Bringing(done) => state.in_file = *done,
        _ => {}
    }
}

/// Something that was asked has been answered; a corpus to train on, if that is it.
pub fn answered(
    state: &mut State,
    desk: &mut Desk,
    asked: StudyAsk,
    event: Event,
) -> Option<Offered> {
    let text = Text::of(desk.language);
    match asked {
        StudyAsk::Make { .. } => state.making = None,
        StudyAsk::Judge(_) => state.judging = None,
        StudyAsk::Review(_) => state.bringing = None,
        _ => {}
    }
    if let (StudyAsk::Bring(file), Some((done, _))) = (&asked, &mut state.bringing) {
        *done += file.bytes.len() as u32;
        state.in_file = 0;
    }
    let said = match event {
        Event::Study(said) => said,
        Event::Refused { message } => {
            tell(state, desk, message);
            return None;
        }
        _ => return None,
    };
    let is_kept = matches!(
        asked,
        StudyAsk::Bring(_)
            | StudyAsk::Review(_)
            | StudyAsk::Convert(_)
            | StudyAsk::Judge(_)
            | StudyAsk::Decide(_)
    );
    let was_judge = matches!(asked, StudyAsk::Judge(_));
    if is_kept {
        state.log.push(asked);
    }
    match said {
        StudySaid::Made { study, open } => {
            state.open = open;
            let told = match state.take(&study) {
                Ok(()) => {
                    pack(state, desk);
                    hold(state, desk);
                    (text.made)(state.study.as_ref().map_or(0, |(study, _)| study.items.len()))
                }
                Err(error) => error.to_string(),
            };
            tell(state, desk, told);
        }
        StudySaid::Trials { trials, paths, mapping } => {
            state.survey = Some((trials, paths, mapping));
        }
        StudySaid::Converted { answers, others, unfinished } => {
            let [answers, others, unfinished] = [answers, others, unfinished].map(|n| n as usize);
            state.survey = None;
            tell(state, desk, (text.converted)(answers, others, unfinished));
            review(state, desk);
        }
        StudySaid::Reviewed(review) => {
            state.review = *review;
            (state.from, state.looked_at) = (0, None);
            if was_judge {
                tell(state, desk, (text.judged)(state.review.rows.len()));
            }
        }
        StudySaid::Counted(coverage) => {
            state.review = Reviewed { coverage, ..std::mem::take(&mut state.review) };
        }
        StudySaid::Shown { id, shows } => {
            if let Some((looked_at, pairs)) = &mut state.looked_at
                && *looked_at == id
            {
                // What the engine wrote is read.
                *pairs = serde_json::from_str(&shows).unwrap_or_default();
            }
        }
        StudySaid::Written { what: Sheet::Corpus, file, unfit } => {
            if unfit > 0 {
                tell(state, desk, (text.unfit)(unfit as usize));
            }
            let bytes = std::sync::Arc::unwrap_or_clone(file.bytes);
            return Some(Offered { name: file.name, bytes: Ok(bytes) });
        }
        StudySaid::Written { file, .. } => desk.want(Effect::GiveBack(file)),
        StudySaid::Enough => tell(state, desk, text.enough.to_owned()),
        _ => {}
    }
    None
}

/// Says something, and leaves it in sight.
fn tell(state: &mut State, desk: &mut Desk, words: String) {
    desk.say(words.clone());
    state.notice = Some(words);
}
