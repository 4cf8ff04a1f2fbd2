//! What names stand for at a place of a program.

use std::collections::{HashMap, HashSet};

use super::evaluate::Constant;
use super::functions::Term;

/// What a name stands for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Bound {
    /// A value.
    Term(Term),
    /// The dictionary of this number.
    Dictionary(usize),
    /// What the caller of a function gives.
    Parameter,
    /// Something that is known only when the program runs.
    Unknown,
}

struct Binding {
    value: Bound,
    /// How often the name was assigned.
    count: usize,
}

/// The names of the module, of a class, or of a function.
struct Scope {
    names: HashMap<String, Binding>,
    parent: Option<usize>,
    is_class: bool,
    /// Its name with dots: `Bird.__init__`; empty for the module.
    path: String,
}

/// All scopes of a program, and the current one.
pub(super) struct Scopes {
    all: Vec<Scope>,
    current: usize,
    /// Names that functions assign outside of themselves, at times that are not known.
    global: HashSet<String>,
}

impl Scopes {
    /// The scope of the module.
    pub(super) fn new(global: HashSet<String>) -> Self {
        let module = Scope { names: HashMap::new(), parent: None, is_class: false, path: String::new() };
        Self { all: vec![module], current: 0, global }
    }

    /// The number of the current scope.
    pub(super) fn current(&self) -> usize {
        self.current
    }

    /// Makes a scope in another the current one. It has no names yet.
    pub(super) fn enter(&mut self, parent: usize, name: &str, is_class: bool) {
        let path = match self.all[parent].path.as_str() {
            "" => name.to_owned(),
            above => format!("{above}.{name}"),
        };
        self.all.push(Scope { names: HashMap::new(), parent: Some(parent), is_class, path });
        self.current = self.all.len() - 1;
    }

    /// Makes another scope the current one.
    pub(super) fn return_to(&mut self, scope: usize) {
        self.current = scope;
    }

    /// The name, with dots, of something in the current scope.
    pub(super) fn path_of(&self, name: &str) -> String {
        match (self.all[self.current].path.as_str(), name) {
            ("", name) => name.to_owned(),
            (path, "") => path.to_owned(),
            (path, name) => format!("{path}.{name}"),
        }
    }

    /// Assigns a name in the current scope.
    pub(super) fn bind(&mut self, name: String, value: Bound) {
        let binding = self.all[self.current].names.entry(name).or_insert(Binding { value, count: 0 });
        binding.value = value;
        binding.count += 1;
    }

    /// What a name stands for in the current scope; `None` if the program does not assign it.
    pub(super) fn look_up(&self, name: &str) -> Option<Bound> {
        let mut scope = &self.all[self.current];
        if let Some(binding) = scope.names.get(name) {
            return Some(if self.is_global(name) { Bound::Unknown } else { binding.value });
        }
        while let Some(parent) = scope.parent {
            scope = &self.all[parent];
            // The body of a function does not see the names of the class.
            if let Some(binding) = scope.names.get(name).filter(|_| !scope.is_class) {
                // It runs later, when a name that is assigned twice may stand for either.
                let is_known = binding.count == 1 && !self.is_global(name);
                return Some(if is_known { binding.value } else { Bound::Unknown });
            }
        }
        None
    }

    /// The value of a name with dots as a constant.
    pub(super) fn constant(&self, name: &str) -> Constant {
        match self.look_up(name) {
            Some(Bound::Term(term)) => Constant::Known(term),
            Some(_) => Constant::Unknown,
            None => match name.split_once('.') {
                Some((root, _)) if self.look_up(root).is_some() => Constant::Unknown,
                _ => Constant::Foreign,
            },
        }
    }

    fn is_global(&self, name: &str) -> bool {
        !self.global.is_empty() && self.global.contains(name)
    }
}
