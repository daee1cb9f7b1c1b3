//! All rules of usage together. Each refuses by itself.

use super::standing::Standing;
use super::{denials, joints, limits, verbs};
use crate::ccg::chart::Lexical;
use crate::ccg::context::Context;

/// Whether words may have a category where they stand, by what stands around them.
pub(in crate::ccg) fn may_mean(context: &Context, item: &Lexical) -> bool {
    let standing = Standing::new(context, item);
    let mut rules =
        [denials::RULES, joints::RULES, limits::RULES, verbs::RULES].into_iter().flatten();
    !rules.any(|is_misused| is_misused(&standing))
}
