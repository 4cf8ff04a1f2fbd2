//! Walks through a program in the order in which it runs, as far as that is known, and notes its dictionaries and its groups of keys.
//! Functions are walked through after what is around them.

use std::collections::{HashSet, VecDeque};

use ruff_python_ast::statement_visitor::{StatementVisitor, walk_stmt as walk_statement};
use ruff_python_ast::visitor::{Visitor, walk_expr, walk_stmt};
use ruff_python_ast::{Expr, ExprContext, Keyword, Stmt, StmtFunctionDef};
use ruff_text_size::{Ranged, TextRange};

use super::dictionary::{Entries, channel_by, elements_of, is_called};
use super::evaluate::{Evaluator, Met};
use super::fault::Fault;
use super::functions::Term;
use super::keys::{Channel, Key};
use super::names::{Hint, dotted_name};
use super::scopes::{Bound, Scopes};
use crate::text_layouts::error::TextProblem;
use crate::words::texts;

/// The most keys that a dictionary can have, so that memory is bounded.
const MOST_KEYS: usize = 20_000;

/// A dictionary of a program.
pub(super) struct Dictionary {
    /// Where it stands.
    pub(super) place: TextRange,
    /// Its name with those of the functions and classes that it is in; empty without one.
    pub(super) path: String,
    /// What its name says.
    pub(super) hint: Hint,
    /// The scope that it is in.
    pub(super) scope: usize,
    /// The channel that it has if no call tells.
    pub(super) channel: Option<Channel>,
    /// Whether it is made of calls that make values of keys.
    pub(super) is_of_calls: bool,
    /// Whether it is a list of pairs.
    is_list: bool,
    /// Whether it had no keys where it was made.
    was_empty: bool,
    /// Whether it may be a group, or part of one, without a call.
    pub(super) is_loose: bool,
    /// Its keys, or why they are not known.
    pub(super) keys: Result<Vec<Key>, Fault>,
    /// What was met in it.
    pub(super) met: Met,
    /// The statements that it stands among.
    block: usize,
}

impl Dictionary {
    /// Whether these are keys, and not other numbers by numbers, as far as the name and the values tell.
    pub(super) fn is_sure(&self) -> bool {
        let is_named = self.hint.channel.is_some() && self.keys.is_ok() && !self.is_list;
        self.hint.is_of_keys || self.is_of_calls || is_named
    }

    /// Whether these may be keys.
    pub(super) fn may_be_keys(&self) -> bool {
        !self.is_list && !self.was_empty
    }
}

/// A call that takes keys.
pub(super) struct Node {
    /// The name that it is assigned to, with those of functions and classes.
    pub(super) path: String,
    /// Where the call stands.
    pub(super) place: TextRange,
    /// The dictionary of each channel.
    pub(super) dictionaries: [Option<usize>; Channel::ALL.len()],
    /// The argument that is not known.
    pub(super) fault: Option<Fault>,
}

/// A walk through a program.
pub(super) struct Walk<'a> {
    pub(super) source: &'a str,
    pub(super) scopes: Scopes,
    /// All dictionaries so far.
    pub(super) dictionaries: Vec<Dictionary>,
    /// All calls that take keys so far.
    pub(super) nodes: Vec<Node>,
    /// The name that is being assigned.
    pub(super) target: String,
    /// The statements that are being walked through: those of an `if` or of a loop may run or not.
    block: usize,
    blocks: usize,
    later: VecDeque<(usize, &'a StmtFunctionDef)>,
}

impl<'a> Walk<'a> {
    /// Walks through a module.
    pub(super) fn through(source: &'a str, module: &'a [Stmt]) -> Self {
        let mut global = GlobalNames::default();
        global.visit_body(module);
        let mut walk = Self {
            source,
            scopes: Scopes::new(global.0),
            dictionaries: Vec::new(),
            nodes: Vec::new(),
            target: String::new(),
            block: 0,
            blocks: 0,
            later: VecDeque::new(),
        };
        walk.visit_body(module);
        while let Some((parent, function)) = walk.later.pop_front() {
            walk.scopes.enter(parent, function.name.as_str(), false);
            for parameter in &*function.parameters {
                walk.scopes.bind(parameter.name().to_string(), Bound::Parameter);
            }
            walk.blocks += 1;
            walk.block = walk.blocks;
            walk.visit_body(&function.body);
        }
        walk
    }

    /// The value of an expression at this place.
    pub(super) fn term(&self, expression: &Expr, met: &mut Met) -> Result<Term, Fault> {
        let constant = |name: &str| self.scopes.constant(name);
        let mut evaluator = Evaluator { source: self.source, constant, met: *met };
        let term = evaluator.term(expression);
        *met = evaluator.met;
        term
    }

    /// Statements that may run or not, or often.
    fn uncertain(&mut self, body: &'a [Stmt]) {
        let before = self.block;
        self.blocks += 1;
        self.block = self.blocks;
        self.visit_body(body);
        self.block = before;
    }

    /// Forgets the values of all names that a statement assigns.
    fn forget_assigned(&mut self, statement: &'a Stmt) {
        let mut assigned = AssignedNames::default();
        assigned.visit_stmt(statement);
        for name in assigned.0 {
            self.scopes.bind(name, Bound::Unknown);
        }
    }

    fn assign(&mut self, target: &'a Expr, value: &'a Expr) {
        // `keys = {…},` as it is copied from between the arguments of a call.
        let value = match value {
            Expr::Tuple(tuple) if tuple.elts.len() == 1 && Entries::of(&tuple.elts[0]).is_some() => &tuple.elts[0],
            value => value,
        };
        if let (Some(targets), Some(values)) = (elements_of(target), elements_of(value))
            && targets.len() == values.len()
        {
            for (target, value) in targets.iter().zip(values) {
                self.assign(target, value);
            }
            return;
        }
        let Some(name) = dotted_name(target) else {
            self.visit_expr(value);
            self.assign_to_other(target, value);
            return;
        };
        let hint = Hint::new(&name);
        if let Some(index) = self.loose_dictionary(value, &name, hint) {
            self.scopes.bind(name, Bound::Dictionary(index));
            return;
        }
        let outer = std::mem::replace(&mut self.target, name.clone());
        self.visit_expr(value);
        self.target = outer;
        let bound = self.bound(value);
        self.scopes.bind(name, bound);
    }

    /// What an expression stands for.
    pub(super) fn bound(&self, value: &Expr) -> Bound {
        if let Some(name) = dotted_name(value)
            && let Some(bound @ Bound::Dictionary(_)) = self.scopes.look_up(&name)
        {
            return bound;
        }
        self.term(value, &mut Met::default()).map_or(Bound::Unknown, Bound::Term)
    }

    /// Assigns to an element, or to several names.
    fn assign_to_other(&mut self, target: &'a Expr, value: &'a Expr) {
        if let Expr::Subscript(subscript) = target {
            self.change(&subscript.value, Some((&subscript.slice, value)), target.range());
            return;
        }
        let mut assigned = AssignedNames::default();
        assigned.visit_expr(target);
        for name in assigned.0 {
            self.scopes.bind(name, Bound::Unknown);
        }
    }

    /// Takes in that a dictionary, if a name stands for one, gets another key, or is changed in another way.
    pub(super) fn change(&mut self, name: &Expr, pair: Option<(&Expr, &Expr)>, place: TextRange) {
        let Some(Bound::Dictionary(index)) = dotted_name(name).and_then(|name| self.scopes.look_up(&name)) else {
            return;
        };
        let mut met = self.dictionaries[index].met;
        let key = match pair {
            Some((time, value)) if self.dictionaries[index].block == self.block => self.key(time, value, &mut met),
            _ => Err(Fault::unknown(self.source, place)),
        };
        let dictionary = &mut self.dictionaries[index];
        dictionary.met = met;
        dictionary.is_of_calls |= pair.is_some_and(|(_, value)| is_called(value));
        let Ok(keys) = &mut dictionary.keys else { return };
        match key {
            Ok(key) => {
                dictionary.channel = channel_by(&dictionary.hint, Channel::of_term(&keys.first().unwrap_or(&key).term));
                keys.retain(|before| before.seconds != key.seconds);
                if keys.len() == MOST_KEYS {
                    dictionary.keys = Err(Fault::of(place, TextProblem::TooManyKeys { limit: MOST_KEYS }));
                } else {
                    keys.push(key);
                }
            }
            Err(fault) => dictionary.keys = Err(fault),
        }
    }

    fn key(&self, time: &Expr, value: &Expr, met: &mut Met) -> Result<Key, Fault> {
        let seconds = match self.term(time, met)? {
            // Normalises -0.0 to 0.0 so that equal values give equal bytes.
            Term::Number(seconds) => seconds + 0.0,
            _ => return Err(Fault::unexpected(self.source, time, texts::TEXT_EXPECTED_SECONDS)),
        };
        let term = self.term(value, met)?;
        Ok(Key { seconds, term, places: [time.range(), value.range()] })
    }

    /// Notes an expression as a dictionary that no call takes, if it can be one of keys.
    fn loose_dictionary(&mut self, expression: &'a Expr, name: &str, hint: Hint) -> Option<usize> {
        let entries = Entries::of(expression)?;
        let is_empty = entries.pairs.is_empty() && entries.other.is_none();
        if !is_empty {
            let first = entries.pairs.first().map(|(time, value)| self.key(time, value, &mut Met::default()).is_ok());
            let is_of_keys = match first {
                None => hint.channel.is_some(),
                Some(_) if entries.are_of_others() => false,
                Some(is_known) => is_known || entries.is_of_calls() || hint.channel.is_some(),
            };
            let is_named = hint.is_of_keys || hint.channel.is_some();
            if !is_of_keys || (entries.is_list && !entries.is_of_calls() && !is_named) {
                return None;
            }
        }
        Some(self.dictionary(expression, entries, name, hint, true))
    }

    /// Notes a dictionary.
    pub(super) fn dictionary(
        &mut self,
        expression: &Expr,
        entries: Entries<'a>,
        name: &str,
        hint: Hint,
        is_loose: bool,
    ) -> usize {
        let mut met = Met::default();
        let keys: Result<Vec<Key>, Fault> = match entries.other {
            _ if entries.pairs.len() > MOST_KEYS => {
                Err(Fault::of(entries.pairs[MOST_KEYS].0, TextProblem::TooManyKeys { limit: MOST_KEYS }))
            }
            Some(other) => Err(Fault::unknown(self.source, other)),
            None => entries.pairs.iter().map(|(time, value)| self.key(time, value, &mut met)).collect(),
        };
        let by_value = match &keys {
            Ok(keys) => keys.first().and_then(|key| Channel::of_term(&key.term)),
            Err(_) => entries.called_channel(),
        };
        self.dictionaries.push(Dictionary {
            place: expression.range(),
            path: self.scopes.path_of(name),
            channel: channel_by(&hint, by_value),
            hint,
            scope: self.scopes.current(),
            is_of_calls: entries.is_of_calls(),
            is_list: entries.is_list,
            was_empty: entries.pairs.is_empty(),
            is_loose,
            keys,
            met,
            block: self.block,
        });
        self.dictionaries.len() - 1
    }
}

impl<'a> Visitor<'a> for Walk<'a> {
    fn visit_stmt(&mut self, statement: &'a Stmt) {
        match statement {
            Stmt::FunctionDef(function) => {
                for decorator in &function.decorator_list {
                    self.visit_decorator(decorator);
                }
                self.visit_parameters(&function.parameters);
                self.scopes.bind(function.name.to_string(), Bound::Unknown);
                self.later.push_back((self.scopes.current(), function));
            }
            Stmt::ClassDef(class) => {
                if let Some(arguments) = &class.arguments {
                    self.visit_arguments(arguments);
                }
                let outer = self.scopes.current();
                self.scopes.enter(outer, class.name.as_str(), true);
                self.visit_body(&class.body);
                self.scopes.return_to(outer);
                self.scopes.bind(class.name.to_string(), Bound::Unknown);
            }
            Stmt::Assign(assignment) => {
                let Some((first, others)) = assignment.targets.split_first() else { return };
                self.assign(first, &assignment.value);
                for target in others {
                    let bound = dotted_name(first).and_then(|name| self.scopes.look_up(&name));
                    match dotted_name(target) {
                        Some(name) => self.scopes.bind(name, bound.unwrap_or(Bound::Unknown)),
                        None => self.assign_to_other(target, &assignment.value),
                    }
                }
            }
            Stmt::AnnAssign(assignment) => {
                if let Some(value) = &assignment.value {
                    self.assign(&assignment.target, value);
                }
            }
            Stmt::AugAssign(assignment) => {
                self.visit_expr(&assignment.value);
                if let Expr::Subscript(subscript) = &*assignment.target {
                    self.change(&subscript.value, None, assignment.range());
                } else {
                    self.change(&assignment.target, None, assignment.range());
                    self.forget_assigned(statement);
                }
            }
            Stmt::Delete(deletion) => {
                for target in &deletion.targets {
                    if let Expr::Subscript(subscript) = target {
                        self.change(&subscript.value, None, deletion.range());
                    } else if let Some(name) = dotted_name(target) {
                        self.scopes.bind(name, Bound::Unknown);
                    }
                }
            }
            Stmt::For(repeated) => {
                self.visit_expr(&repeated.iter);
                self.forget_assigned(statement);
                self.uncertain(&repeated.body);
                self.uncertain(&repeated.orelse);
                self.forget_assigned(statement);
            }
            Stmt::While(repeated) => {
                self.forget_assigned(statement);
                self.visit_expr(&repeated.test);
                self.uncertain(&repeated.body);
                self.uncertain(&repeated.orelse);
                self.forget_assigned(statement);
            }
            Stmt::If(choice) => {
                self.visit_expr(&choice.test);
                self.uncertain(&choice.body);
                for clause in &choice.elif_else_clauses {
                    if let Some(test) = &clause.test {
                        self.visit_expr(test);
                    }
                    self.uncertain(&clause.body);
                }
                self.forget_assigned(statement);
            }
            Stmt::Try(attempt) => {
                self.uncertain(&attempt.body);
                for handler in &attempt.handlers {
                    if let Some(handler) = handler.as_except_handler() {
                        self.uncertain(&handler.body);
                    }
                }
                self.uncertain(&attempt.orelse);
                self.uncertain(&attempt.finalbody);
                self.forget_assigned(statement);
            }
            Stmt::Match(choice) => {
                self.visit_expr(&choice.subject);
                self.forget_assigned(statement);
                for case in &choice.cases {
                    self.uncertain(&case.body);
                }
                self.forget_assigned(statement);
            }
            _ => walk_stmt(self, statement),
        }
    }

    fn visit_keyword(&mut self, keyword: &'a Keyword) {
        let name = keyword.arg.as_ref().map(ToString::to_string).unwrap_or_default();
        let outer = std::mem::replace(&mut self.target, name);
        self.visit_expr(&keyword.value);
        self.target = outer;
    }

    fn visit_expr(&mut self, expression: &'a Expr) {
        match expression {
            Expr::Call(call) if self.call(call) => return,
            Expr::Name(name) if name.ctx == ExprContext::Store => {
                self.scopes.bind(name.id.to_string(), Bound::Unknown);
            }
            Expr::Lambda(lambda) => {
                for parameter in lambda.parameters.iter().flat_map(|parameters| &**parameters) {
                    self.scopes.bind(parameter.name().to_string(), Bound::Unknown);
                }
            }
            Expr::ListComp(_) | Expr::SetComp(_) | Expr::DictComp(_) | Expr::Generator(_) => {
                let mut assigned = AssignedNames::default();
                assigned.visit_expr(expression);
                for name in assigned.0 {
                    self.scopes.bind(name, Bound::Unknown);
                }
            }
            _ => {}
        }
        let name = std::mem::take(&mut self.target);
        if self.loose_dictionary(expression, &name, Hint::new(&name)).is_none() {
            self.target.clone_from(&name);
            walk_expr(self, expression);
        }
        self.target = name;
    }
}

/// The names that are assigned somewhere in a statement.
#[derive(Default)]
struct AssignedNames(Vec<String>);

impl<'a> Visitor<'a> for AssignedNames {
    fn visit_expr(&mut self, expression: &'a Expr) {
        let is_assigned = match expression {
            Expr::Name(name) => name.ctx == ExprContext::Store,
            Expr::Attribute(attribute) => attribute.ctx == ExprContext::Store,
            _ => false,
        };
        if is_assigned && let Some(name) = dotted_name(expression) {
            self.0.push(name);
        }
        walk_expr(self, expression);
    }
}

/// The names that functions assign outside of themselves.
#[derive(Default)]
struct GlobalNames(HashSet<String>);

impl<'a> StatementVisitor<'a> for GlobalNames {
    fn visit_stmt(&mut self, statement: &'a Stmt) {
        match statement {
            Stmt::Global(names) => self.0.extend(names.names.iter().map(ToString::to_string)),
            Stmt::Nonlocal(names) => self.0.extend(names.names.iter().map(ToString::to_string)),
            _ => walk_statement(self, statement),
        }
    }
}
