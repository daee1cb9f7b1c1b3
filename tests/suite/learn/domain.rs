//! The lexicon of the whole domain: with the six sentences as its only training, commands of every kind that it
//! has never seen are put together from what their words mean.

use super::{means, six, train_from};
use groundling::learn::{CLEANUP_LEXICON, Config, seed_model};

#[test]
fn words_of_the_whole_domain_compose() {
    let seed = seed_model(CLEANUP_LEXICON).unwrap();
    let (mut model, last) = train_from(seed, &six(), &Config::default());
    assert_eq!(last.unwrap().so_far.valid, 6);
    for (command, wanted) in [
        ("go to blue room", "in(the agent, the λx. blue(x) ∧ room(x))"),
        (
            "please go to the small green room",
            "in(the agent, argmin(λx. green(x) ∧ room(x), size))",
        ),
        ("stand to the left of the red chair", "left(the agent, the λx. chair(x) ∧ red(x))"),
        (
            "put the yellow chair in the biggest room",
            "in(the λx. chair(x) ∧ yellow(x), argmax(room, size))",
        ),
        (
            "move the basket to the room with the chair",
            "in(the basket, the λx. in(the chair, x) ∧ room(x))",
        ),
        ("go to the robot's room", "in(the agent, the λx. in(the agent, x) ∧ room(x))"),
        (
            "move the chair to the green room and go to the red room",
            "in(the agent, the λx. red(x) ∧ room(x)) ∧ in(the chair, the λx. green(x) ∧ room(x))",
        ),
    ] {
        means(&mut model, command, wanted);
    }
}
