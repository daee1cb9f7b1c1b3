//! Which part of the Talk page does what a person wants, an arm an action; and what changes here when something
//! changed for all pages.

use super::action::Action;
use super::command::say::say;
use super::command::state::Command;
use super::command::{ask, study};
use super::demo::run;
use super::demo::state::Demo;
use super::past::recall;
use super::room::{hand, moved, worlds};
use super::share::exchange;
use super::share::state::Sharing;
use super::state::State;
use super::teach::{learn, unlike};
use super::watch::{ahead, play, values};
use super::why::mend;
use super::words::Text;
use crate::ui::page::effect::Effect;
use crate::ui::page::model;
use crate::ui::page::shared::Shared;
use crate::worker::protocol::Program;

/// Does what a person wants.
pub fn update(state: &mut State, shared: &mut Shared, action: Action) {
    if matches!(
        action,
        Action::Ask
            | Action::AskExample(_)
            | Action::Choose(_)
            | Action::SetRules(_)
            | Action::Help(_)
    ) {
        state.resume.is_quiet = false;
    }
    if matches!(action, Action::Typed(_) | Action::Ask | Action::AskExample(_) | Action::Open(_)) {
        // Whoever says something, in whatever way, has the page.
        state.demo = Demo::Over;
    }
    if matches!(action, Action::Ask | Action::AskExample(_)) {
        // What a person says is not said over again by a session that was opened before and waited for its words.
        (state.resume.command, state.resume.form) = (None, None);
    }
    if !matches!(
        action,
        Action::Touched
            | Action::TogglePlay
            | Action::Seek(_)
            | Action::SetSpeed(_)
            | Action::ToggleLayer(_)
            | Action::Link(_)
            | Action::Preview(_)
            | Action::Point(_)
            | Action::Copy(_)
    ) {
        ahead::end(shared);
    }
    match action {
        Action::Demo => run::want(state, shared),
        Action::Touched => run::end(state, shared),
        Action::Typed(command) => ask::typed(state, shared, &command),
        Action::Ask => say(state, shared),
        Action::AskExample(command) => {
            state.command.input = command;
            // What was pressed may be gone when there is an answer.
            shared.want(Effect::FocusOnDesk("command"));
            say(state, shared);
        }
        Action::Recall(back) => recall::recall(state, shared, back),
        Action::GoOn(place) => recall::go_on(state, shared, place),
        Action::Choose(reading) => ask::choose(state, shared, reading),
        Action::Remember => learn::remember(state, shared),
        Action::Link(link) => state.command.link = link,
        Action::Preview(reading) => state.command.preview = reading,
        Action::AllReadings => state.command.all_readings = true,
        Action::Deepen(depth) => {
            shared.depth = depth;
            deepened(state, shared);
        }
        Action::ChooseNode(node) => (state.command.node, state.command.steps) = (Some(node), 0),
        Action::Reduce(steps) => state.command.steps = steps,
        Action::SetRules(rules) if rules == shared.document.rules => {}
        Action::SetRules(rules) => ask::set_rules(state, shared, rules),
        Action::Help(help) => mend::mend(state, shared, help),
        Action::FetchModel => model::fetch(shared),
        Action::Copy(text) => shared.want(Effect::Copy(text)),

        Action::TogglePlay => play::toggle(state, shared),
        Action::Seek(step) => play::seek(state, shared, step),
        Action::SetSpeed(speed) => play::set_speed(state, shared, speed),
        Action::ToggleLayer(layer) => values::toggle_layer(state, shared, layer),
        Action::TryMany => values::try_many(state, shared),
        Action::StopPlanning => shared.cancel(Program::Talker),

        Action::SetMode(mode) => hand::set_mode(state, shared, mode),
        Action::Take(tool) => hand::take(state, tool),
        Action::SetLook(look) => state.room.look = look,
        Action::SetPaint(color) => state.room.paint = color,
        Action::Point(point) => hand::point(state, shared, point),
        Action::Mean(meant) => moved::mean(state, shared, meant),
        Action::Press(key) => hand::press(state, shared, key),
        Action::PickWorld(choice) => worlds::pick(state, shared, choice),
        Action::ResetWorld => worlds::reset(state, shared),
        Action::SetBlueprint(blueprint) => state.room.blueprint = blueprint,
        Action::SetSeed(seed) => state.room.seed = seed,
        Action::DrawWorld => worlds::draw(state, shared),
        Action::ToggleText => worlds::toggle_text(state, shared),
        Action::TypedText(text) => state.room.text = Some(text),
        Action::ApplyText => worlds::apply_text(state, shared),
        Action::WorldRead(world) => worlds::was_read(state, shared, world),

        Action::TypedLesson(words) => learn::typed(state, &words),
        Action::Teach => learn::teach(state, shared),
        Action::TeachFit(place) => learn::mean(state, shared, place),
        Action::ClearDraft => learn::clear_draft(state, shared),
        Action::Unlike(which) => unlike::unlike(state, shared, which),
        Action::Unteach(place) => learn::unteach(state, shared, place),
        Action::SaveLessons => learn::save(shared),

        Action::Share => exchange::share(shared),
        Action::Shared(made) => exchange::made(state, shared, made),
        Action::SaveSession => exchange::save(shared),
        Action::Unsaved(why) => exchange::unsaved(state, shared, &why),
        Action::Open(text) => exchange::opened(state, shared, text),
        Action::CloseShare => state.sharing = Sharing::default(),
    }
}

/// The person looks deeper, or less deep.
pub fn deepened(state: &State, shared: &mut Shared) {
    values::look(state, shared);
    study::study(state, shared);
}

/// The document was undone or redone: what hangs on the one before is forgotten, and the words say what was done.
pub fn travelled(state: &mut State, shared: &mut Shared, words: &str) {
    state.watch.forget();
    state.room.let_go();
    learn::look(state, shared);
    let said = shared.document.said.as_ref().map(|said| said.answer.command.clone());
    state.command = Command { input: said.unwrap_or_default(), ..Command::default() };
    study::study(state, shared);
    let robot = Text::of(shared.language).phrases.robot(state.shown(shared));
    shared.say(format!("{words} {robot}"));
}
