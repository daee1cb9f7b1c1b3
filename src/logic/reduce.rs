//! Normal forms by hereditary substitution (Watkins et al. 2003): putting normal terms together gives a normal
//! term at once, so no redex is ever stored. Application and composition are memoised on ids.

use super::term::{LogicError, Node, TermId, Terms};
use super::ty::{TRUTH, TyId, Type};

/// Substitution steps that one application may take: outside text can ask for towers of them.
const MAX_STEPS: u32 = 200_000;

impl Terms {
    /// The η-long form of a constant.
    ///
    /// # Errors
    /// A variadic constant has none.
    pub fn constant_term(&mut self, name: &str, ty: TyId) -> Result<TermId, LogicError> {
        let constant = self.constant(name, ty);
        let head = self.raw_constant(constant);
        self.eta_expand(head)
    }

    /// The η-long form of a variable by de Bruijn index.
    ///
    /// # Errors
    /// A variable cannot be variadic.
    pub fn variable(&mut self, index: u32, ty: TyId) -> Result<TermId, LogicError> {
        if self.types.has_variadic(ty) {
            return Err(LogicError::BareVariadic);
        }
        let head = self.raw_variable(index, ty);
        self.eta_expand(head)
    }

    /// `function` applied to `argument`, in normal form. Memoised.
    ///
    /// # Errors
    /// When the types do not fit or the normal form is too large.
    pub fn apply(&mut self, function: TermId, argument: TermId) -> Result<TermId, LogicError> {
        if let Some(&known) = self.applied.get(&(function, argument)) {
            return known;
        }
        let result = self.beta(function, argument, &mut MAX_STEPS.clone());
        self.applied.insert((function, argument), result);
        result
    }

    /// `λx. f(g(x))`, in normal form. Memoised.
    ///
    /// # Errors
    /// When the types do not fit or the normal form is too large.
    pub fn compose(&mut self, f: TermId, g: TermId) -> Result<TermId, LogicError> {
        if let Some(&known) = self.composed.get(&(f, g)) {
            return known;
        }
        let result = self.compose_once(f, g);
        self.composed.insert((f, g), result);
        result
    }

    /// A variadic constant applied to two or more arguments (`and`, `or`, `all` and `any`: to any number).
    ///
    /// # Errors
    /// When an argument has another type, or there are too few.
    pub fn apply_variadic(
        &mut self,
        name: &str,
        ty: TyId,
        args: &[TermId],
    ) -> Result<TermId, LogicError> {
        let Type::Variadic(each, _) = self.types.get(ty) else {
            return Err(LogicError::NotAFunction);
        };
        if args.iter().any(|&arg| self.ty(arg) != each) {
            return Err(LogicError::TypeMismatch);
        }
        let constant = self.constant(name, ty);
        let head = self.raw_constant(constant);
        self.saturate(head, args.to_vec())
    }

    /// The conjunction of truth values.
    ///
    /// # Errors
    /// When one is no truth value or the result is too large.
    pub fn conjoin(&mut self, args: &[TermId]) -> Result<TermId, LogicError> {
        let ty = self.types.intern(Type::Variadic(TRUTH, TRUTH));
        self.apply_variadic("and", ty, args)
    }

    /// A head as [`super::Node::Apply`] holds it with other arguments of the same types, in canonical form.
    ///
    /// # Errors
    /// When the head takes no such arguments or the result is too large.
    pub fn apply_head(&mut self, head: TermId, args: &[TermId]) -> Result<TermId, LogicError> {
        self.saturate(head, args.to_vec())
    }

    fn compose_once(&mut self, f: TermId, g: TermId) -> Result<TermId, LogicError> {
        let Node::Lambda { parameter, body } = self.node(g) else {
            return Err(LogicError::NotAFunction);
        };
        let mut steps = MAX_STEPS;
        let f = self.shift(f, 1, 0, &mut steps)?;
        let inner = self.beta(f, body, &mut steps)?;
        self.lambda(parameter, inner)
    }

    fn beta(&mut self, f: TermId, x: TermId, steps: &mut u32) -> Result<TermId, LogicError> {
        let Node::Lambda { parameter, body } = self.node(f) else {
            return Err(LogicError::NotAFunction);
        };
        if self.ty(x) != parameter {
            return Err(LogicError::TypeMismatch);
        }
        self.substitute(body, 0, x, steps)
    }

    /// `term` with `argument` for variable `depth` and the variables beyond it one lower.
    fn substitute(
        &mut self,
        term: TermId,
        depth: u32,
        argument: TermId,
        steps: &mut u32,
    ) -> Result<TermId, LogicError> {
        if self.free(term) <= depth {
            return Ok(term);
        }
        *steps = steps.checked_sub(1).ok_or(LogicError::TooLarge)?;
        match self.node(term) {
            Node::Constant(_) => Ok(term),
            Node::Variable(index) if index == depth => self.shift(argument, depth, 0, steps),
            Node::Variable(index) => Ok(self.raw_variable(index - 1, self.ty(term))),
            Node::Lambda { parameter, body } => {
                let body = self.substitute(body, depth + 1, argument, steps)?;
                self.lambda(parameter, body)
            }
            Node::Apply { head, args } => {
                let mut args = args.to_vec();
                for arg in &mut args {
                    *arg = self.substitute(*arg, depth, argument, steps)?;
                }
                if self.node(head) == Node::Variable(depth) {
                    let mut result = self.shift(argument, depth, 0, steps)?;
                    for arg in args {
                        result = self.beta(result, arg, steps)?;
                    }
                    Ok(result)
                } else {
                    let head = self.substitute(head, depth, argument, steps)?;
                    self.saturate(head, args)
                }
            }
        }
    }

    /// `term` with every variable from `depth` on raised by `by`.
    fn shift(
        &mut self,
        term: TermId,
        by: u32,
        depth: u32,
        steps: &mut u32,
    ) -> Result<TermId, LogicError> {
        if by == 0 || self.free(term) <= depth {
            return Ok(term);
        }
        *steps = steps.checked_sub(1).ok_or(LogicError::TooLarge)?;
        match self.node(term) {
            Node::Constant(_) => Ok(term),
            Node::Variable(index) => Ok(self.raw_variable(index + by, self.ty(term))),
            Node::Lambda { parameter, body } => {
                let body = self.shift(body, by, depth + 1, steps)?;
                self.lambda(parameter, body)
            }
            Node::Apply { head, args } => {
                let mut args = args.to_vec();
                for arg in &mut args {
                    *arg = self.shift(*arg, by, depth, steps)?;
                }
                let head = self.shift(head, by, depth, steps)?;
                self.saturate(head, args)
            }
        }
    }

    /// `λx… . head(x…)` with each variable η-long in turn; the head itself at a base type.
    fn eta_expand(&mut self, head: TermId) -> Result<TermId, LogicError> {
        let mut parameters = Vec::new();
        let mut ty = self.ty(head);
        loop {
            match self.types.get(ty) {
                Type::Function(from, to) => {
                    parameters.push(from);
                    ty = to;
                }
                Type::Variadic(..) => return Err(LogicError::BareVariadic),
                Type::Entity | Type::Truth | Type::Number | Type::Run => break,
            }
        }
        if parameters.is_empty() {
            return Ok(head);
        }
        let count = parameters.len() as u32;
        let head = self.shift(head, count, 0, &mut MAX_STEPS.clone())?;
        let mut args = Vec::with_capacity(parameters.len());
        for (place, &parameter) in (1..).zip(&parameters) {
            args.push(self.variable(count - place, parameter)?);
        }
        let mut term = self.saturate(head, args)?;
        for &parameter in parameters.iter().rev() {
            term = self.lambda(parameter, term)?;
        }
        Ok(term)
    }

    /// A head with all its arguments, in canonical form. The types are known to fit.
    fn saturate(&mut self, head: TermId, args: Vec<TermId>) -> Result<TermId, LogicError> {
        let ty = self.ty(head);
        let Type::Variadic(_, to) = self.types.get(ty) else {
            let mut result = ty;
            for _ in &args {
                match self.types.get(result) {
                    Type::Function(_, to) => result = to,
                    _ => return Err(LogicError::NotAFunction),
                }
            }
            return self.plain(head, &args, result);
        };
        let constant = match self.node(head) {
            Node::Constant(constant) => constant,
            _ => return Err(LogicError::BareVariadic),
        };
        let known = self.connectives;
        let (unit, absorber) = match constant {
            and if and == known.and => (known.truth, known.falsity),
            or if or == known.or => (known.falsity, known.truth),
            all if all == known.all => (known.done, known.failed),
            any if any == known.any => (known.failed, known.done),
            _ if args.len() < 2 => return Err(LogicError::TooFewArguments),
            _ => {
                let mut args = args;
                self.sort(&mut args);
                return self.raw_apply(head, &args, to);
            }
        };
        let mut flat = Vec::with_capacity(args.len());
        for arg in args {
            match self.node(arg) {
                Node::Apply { head: inner, args } if inner == head => flat.extend_from_slice(args),
                _ if arg == unit => {}
                _ if arg == absorber => return Ok(absorber),
                _ => flat.push(arg),
            }
        }
        self.sort(&mut flat);
        flat.dedup();
        match flat[..] {
            [] => Ok(unit),
            [only] => Ok(only),
            _ => self.raw_apply(head, &flat, to),
        }
    }

    /// An ordinary application. `not(not(x))` is `x`; what always holds, or never, of runs is said by one term:
    /// `always(true)` is `done`; `always(false)`, `until(c, false, k)` and `until(c, x, failed)` are `failed`.
    fn plain(&mut self, head: TermId, args: &[TermId], ty: TyId) -> Result<TermId, LogicError> {
        let known = self.connectives;
        let Node::Constant(constant) = self.node(head) else {
            return self.raw_apply(head, args, ty);
        };
        match *args {
            [inner] if constant == known.not => {
                if let Node::Apply { head: second, args: &[innermost] } = self.node(inner)
                    && second == head
                {
                    return Ok(innermost);
                }
            }
            [inner] if constant == known.always => {
                if inner == known.truth {
                    return Ok(known.done);
                }
                if inner == known.falsity {
                    return Ok(known.failed);
                }
            }
            [_, reached, after]
                if constant == known.until
                    && (reached == known.falsity || after == known.failed) =>
            {
                return Ok(known.failed);
            }
            _ => {}
        }
        self.raw_apply(head, args, ty)
    }
}
