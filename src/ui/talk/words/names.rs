//! What the things of the Talk page are called: the words of closed sets, from a language's table.

use super::table::{Meant, Text};
use crate::domain::{Size, State as World};
use crate::render::Thing;
use crate::ui::page::world::Name;
use crate::ui::talk::room::edit::Obstacle;
use crate::ui::talk::room::state::{Held, Mode, Tool};
use crate::ui::talk::teach::state::Missing;
use crate::ui::talk::watch::playback::{Playback, Surprise};
use crate::ui::talk::watch::state::Layer;
use crate::ui::talk::why::help::Help;
use crate::worker::protocol::{Claim, Told, What, Word};

impl Text {
    /// What the robot would, could or will do, names between asterisks: "I will go to *the blue room*."
    pub fn intention(&self, would: &str, claim: &Claim) -> String {
        format!("{would} {}.", self.phrases.deed(claim))
    }

    /// A goal as it was understood.
    pub fn understood(&self, claim: &Claim) -> String {
        self.intention(self.it_means, claim).replace('*', "")
    }

    /// What words mean now.
    pub fn told(&self, Told { words, what }: &Told) -> String {
        let sentence;
        let meant = match what {
            What::Nothing => Meant::Nothing,
            What::Like(other) => Meant::Like(other),
            What::Thing(noun) => {
                sentence = format!("{}.", self.phrases.noun(noun));
                Meant::This(&sentence)
            }
            What::Goal(claim) => {
                sentence = self.phrases.sentence(claim);
                Meant::This(&sentence)
            }
            What::Other => Meant::Other,
        };
        (self.told)(words, meant)
    }

    /// A question about so many readings.
    pub const fn which(&self, choices: usize) -> &'static str {
        self.which[if choices == 1 { 0 } else { 1 }]
    }

    /// What is held.
    pub fn holding(&self, world: &World, held: Held) -> String {
        match held {
            Held::Item(Thing::Robot, _) => self.phrases.holds(None),
            Held::Item(Thing::Object(index), _) => self.phrases.holds(world.objects.get(index)),
            Held::Corner(_) => self.phrases.holds_corner(),
        }
    }

    /// The step of a plan that is shown.
    pub fn step(&self, plan: &Playback) -> String {
        match plan.latest() {
            None => (self.plan_of)(plan.steps()),
            Some(action) => (self.step_of)(plan.at(), plan.steps(), action),
        }
    }

    /// What a step did that nobody expected.
    pub const fn surprise(&self, surprise: Surprise) -> &'static str {
        self.surprises[surprise as usize]
    }

    /// What a lesson lacks.
    pub const fn missing(&self, missing: Missing) -> &'static str {
        self.missing[missing as usize]
    }

    /// What stands in the way of a change.
    pub fn obstacle(&self, obstacle: Obstacle) -> &'static str {
        (self.obstacle)(obstacle)
    }

    /// What a button of a message says, about these words of the command.
    pub fn help(&self, help: &Help, words: &[Word]) -> String {
        let helps = &self.help;
        let fixed = match help {
            Help::Say(_, phrase) => return (helps.say)(phrase),
            Help::Show((start, end)) => {
                let own = words.get(*start..*end).unwrap_or_default();
                let own: Vec<&str> = own.iter().map(|word| &*word.text).collect();
                return format!("{} “{}”", helps.show, own.join(" "));
            }
            Help::Add(look) => {
                return (helps.add)(&self.phrases.look(look.color, look.shape, look.size));
            }
            Help::Just(claim) => {
                return format!("{}: {}", helps.just, self.phrases.deed(claim).replace('*', ""));
            }
            Help::Instead(claims, once) => {
                let claims: Vec<String> =
                    claims.iter().map(|one| self.phrases.claim(one)).collect();
                let words = if *once { helps.once } else { helps.without };
                return format!("{words}: {}", self.phrases.list(&claims));
            }
            Help::Teach => helps.teach,
            Help::Edit => helps.edit,
            Help::FreeLandmarks => helps.free_landmarks,
            Help::Pull => helps.pull,
            Help::Unlock => helps.unlock,
            Help::NoChance => helps.no_chance,
            Help::OtherWorld => helps.other_world,
            Help::Guide => helps.guide,
        };
        fixed.to_owned()
    }

    /// What the room is for.
    pub const fn mode_name(&self, mode: Mode) -> &'static str {
        self.modes[mode as usize].0
    }

    /// What can be done in the room then.
    pub const fn mode_help(&self, mode: Mode) -> &'static str {
        self.modes[mode as usize].1
    }

    /// What keys do in the room then.
    pub const fn keys_help(&self, mode: Mode) -> &'static str {
        self.modes[mode as usize].2
    }

    /// A tool's name.
    pub const fn tool_name(&self, tool: Tool) -> &'static str {
        self.tool_names[tool as usize].0
    }

    /// What a tool does.
    pub const fn tool_help(&self, tool: Tool) -> &'static str {
        self.tool_names[tool as usize].1
    }

    /// A world's name.
    pub const fn world_name(&self, name: Name) -> &'static str {
        self.worlds[name as usize]
    }

    /// A layer's name.
    pub const fn layer_name(&self, layer: Layer) -> &'static str {
        self.layer_names[layer as usize]
    }

    /// A size's name.
    pub fn size_name(&self, size: Option<Size>) -> &'static str {
        size.map_or(self.no_size, |size| self.phrases.size(size))
    }

    /// A solver's name, from the command line's.
    pub fn solver_name(&self, name: &str) -> String {
        let known = self.solvers.iter().find(|(short, _)| *short == name);
        known.map_or(name, |(_, long)| long).to_owned()
    }
}
