//! Tasks over time as clauses mean them: a clause is a *continuation* `<p,p>`, which makes of what must hold afterwards what
//! must hold now. So "then" is composition, and a whole sentence is its clauses' continuation of `done`.

use super::term::{LogicError, TermId, Terms};
use super::ty::{RUN, TRUTH, Type};

impl Terms {
    /// `λk. all(always(φ), f(k))`: the clause `f` with something that holds all along.
    ///
    /// # Errors
    /// When the types are others or the result is too large.
    pub fn bounded(&mut self, holds: TermId, clause: TermId) -> Result<TermId, LogicError> {
        let onwards = self.types.function(TRUTH, RUN);
        let always = self.constant_term("always", onwards)?;
        let after = self.variable(0, RUN)?;
        let parts = [self.apply(always, holds)?, self.apply(clause, after)?];
        let all = self.types.intern(Type::Variadic(RUN, RUN));
        let body = self.apply_variadic("all", all, &parts)?;
        self.lambda(RUN, body)
    }

    /// What a sentence asks for whose clauses mean this: of a continuation the task that ends there, of anything else
    /// itself.
    pub fn ended(&mut self, meaning: TermId) -> TermId {
        let done = self.connectives.done;
        if self.types.get(self.ty(meaning)) == Type::Function(RUN, RUN) {
            return self.apply(meaning, done).unwrap_or(meaning);
        }
        meaning
    }
}
