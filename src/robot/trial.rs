//! Whether a base stops by itself when no velocity comes any more, which alone helps against a lost link: it is turned a
//! little, then left without a word, and its heading watched. Pure; times in milliseconds, angles in radians.

use super::geometry::{Pose, Twist, wrap};

/// How it is turned, and for how long.
const TURNING: Twist = Twist { linear: 0.0, angular: 0.5 };
const TURNED: f64 = 1000.0;
/// How long it may go on turning.
const MOST: f64 = 2500.0;
/// Two stretches of its heading are held against each other, each so long.
const STRETCH: f64 = 300.0;
/// So far it may turn from one to the next when it stands: a third of what it would turn.
const STANDS: f64 = 0.05;
/// So far it must have turned at all.
const MOVED: f64 = 0.15;

/// A trial at work.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trial {
    phase: Phase,
    /// Times and headings, each counted on from the one before.
    headings: Vec<(f64, f64)>,
    began: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Phase {
    /// For the key to be held.
    #[default]
    Waiting,
    /// It is turned, since then.
    Turning(f64),
    /// It is left alone, since then.
    Silent(f64),
}

/// What a trial comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It stands after so many milliseconds.
    Stops(u32),
    /// It was not seen to.
    Untried(Untried),
}

/// Why a base was not seen to stop by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Untried {
    /// It goes on turning.
    GoesOn,
    /// It did not turn in the first place.
    Still,
    /// The key was let go.
    LetGo,
}

impl Trial {
    /// Whether it waits for the key.
    pub fn is_waiting(&self) -> bool {
        self.phase == Phase::Waiting
    }

    /// The key is held: it begins.
    pub fn begin(&mut self, now: f64) {
        self.phase = Phase::Turning(now);
        self.began = now;
    }

    /// A pose came in.
    pub fn saw(&mut self, pose: Pose, now: f64) {
        let last = self.headings.last().map_or(pose.heading, |&(_, heading)| heading);
        self.headings.push((now, last + wrap(pose.heading - last)));
    }

    /// The velocity to be sent by now, if any is.
    pub fn twist(&mut self, now: f64) -> Option<Twist> {
        match self.phase {
            Phase::Turning(since) if now - since < TURNED => Some(TURNING),
            Phase::Turning(_) => {
                self.phase = Phase::Silent(now);
                None
            }
            _ => None,
        }
    }

    /// What it comes to, once that is known.
    pub fn verdict(&self, now: f64) -> Option<Verdict> {
        let Phase::Silent(since) = self.phase else { return None };
        let alone = now - since;
        let (last, earlier) =
            (self.mean(now - STRETCH, now), self.mean(now - 2.0 * STRETCH, now - STRETCH));
        let stands = last.zip(earlier).is_some_and(|(a, b)| (a - b).abs() < STANDS);
        if alone >= 2.0 * STRETCH && stands {
            // What comes in at first was seen before it began to turn.
            let first = self.mean(self.began, self.began + STRETCH / 2.0);
            let has_moved = last.zip(first).is_some_and(|(a, b)| (a - b).abs() > MOVED);
            return Some(if has_moved {
                Verdict::Stops((alone - STRETCH) as u32)
            } else {
                Verdict::Untried(Untried::Still)
            });
        }
        (alone > MOST).then_some(Verdict::Untried(Untried::GoesOn))
    }

    fn mean(&self, from: f64, to: f64) -> Option<f64> {
        let within = self.headings.iter().filter(|(at, _)| (from..=to).contains(at));
        let (sum, n) = within.fold((0.0, 0.0), |(sum, n), (_, heading)| (sum + heading, n + 1.0));
        (n > 0.0).then_some(sum / n)
    }
}
