//! Calls that take keys: of `KeyFrameControlNode`, of `TransformKeyFrames`, of classes named like them, and of the class above one.

use ruff_python_ast::visitor::Visitor as _;
use ruff_python_ast::{Expr, ExprCall};
use ruff_text_size::Ranged as _;

use super::dictionary::{Entries, elements_of};
use super::fault::Fault;
use super::keys::Channel;
use super::names::{Hint, dotted_name, last_name};
use super::scopes::Bound;
use super::walk::{Node, Walk};

/// What an argument is.
enum Argument {
    /// The dictionary of this number.
    Dictionary(usize),
    /// What the function around it was given, or something of another module.
    PassedOn,
    /// No keys.
    None,
    /// Something that is known only when the program runs.
    Unknown,
}

impl<'a> Walk<'a> {
    /// Takes in a call. Returns whether nothing more is to be looked at in it.
    pub(super) fn call(&mut self, call: &'a ExprCall) -> bool {
        if let Expr::Attribute(method) = &*call.func {
            let pair = match &*call.arguments.args {
                [pair] if method.attr.as_str() == "append" => elements_of(pair),
                _ => None,
            };
            match (method.attr.as_str(), pair) {
                ("append", Some([time, value])) => self.change(&method.value, Some((time, value)), call.range()),
                (
                    "append" | "update" | "pop" | "popitem" | "clear" | "setdefault" | "extend" | "insert" | "remove",
                    _,
                ) => {
                    self.change(&method.value, None, call.range());
                }
                _ => {}
            }
        }
        let name = last_name(&call.func).unwrap_or_default().to_lowercase();
        // `KeyFrames` takes the keys of one channel.
        let is_node = (name.contains("keyframe") && name != "keyframes") || name.contains("controlnode");
        if is_node || (is_of_class_above(&call.func) && self.takes_keys(call)) {
            self.node(call, is_node)
        } else {
            false
        }
    }

    /// Whether any argument is for sure a dictionary of keys.
    fn takes_keys(&self, call: &'a ExprCall) -> bool {
        let named = call.arguments.keywords.iter().map(|keyword| &keyword.value);
        let are_keys = |argument: &'a Expr| match (Entries::of(argument), self.bound(argument)) {
            (Some(entries), _) => entries.is_of_calls(),
            (None, Bound::Dictionary(index)) => self.dictionaries[index].is_sure(),
            (None, _) => false,
        };
        call.arguments.args.iter().chain(named).any(are_keys)
    }

    fn node(&mut self, call: &'a ExprCall, is_node: bool) -> bool {
        let is_self = |argument: &Expr| dotted_name(argument).as_deref() == Some("self");
        let placed = call.arguments.args.iter().filter(|argument| !is_self(argument));
        let placed = placed.zip(Channel::ALL).map(|(argument, channel)| (argument, channel, ""));
        let named = call.arguments.keywords.iter().filter_map(|keyword| {
            let name = keyword.arg.as_ref()?.as_str();
            Some((&keyword.value, Hint::new(name).channel?, name))
        });
        let mut node = Node {
            path: self.scopes.path_of(&self.target),
            place: call.range(),
            dictionaries: Default::default(),
            fault: None,
        };
        let (mut is_known, mut is_unknown) = (false, false);
        let arguments: Vec<_> = placed.chain(named).collect();
        for &(argument, channel, name) in &arguments {
            match self.argument(argument, name) {
                Argument::Dictionary(index) => {
                    node.dictionaries[channel as usize] = Some(index);
                    is_known = true;
                }
                Argument::None => {}
                kind @ (Argument::PassedOn | Argument::Unknown) => {
                    is_unknown |= matches!(kind, Argument::Unknown);
                    node.fault.get_or_insert_with(|| Fault::unknown(self.source, argument));
                }
            }
        }
        // A class that passes on what it was given is no group.
        let is_group = is_known || (is_node && is_unknown);
        if !is_group {
            return false;
        }
        for index in node.dictionaries.into_iter().flatten() {
            self.dictionaries[index].is_loose = false;
        }
        self.nodes.push(node);
        self.visit_expr(&call.func);
        let is_taken = |value: &Expr| arguments.iter().any(|&(argument, ..)| std::ptr::eq(argument, value));
        for argument in &call.arguments.args {
            if !is_taken(argument) {
                self.visit_expr(argument);
            }
        }
        for keyword in &call.arguments.keywords {
            if !is_taken(&keyword.value) {
                self.visit_keyword(keyword);
            }
        }
        true
    }

    fn argument(&mut self, argument: &'a Expr, name: &str) -> Argument {
        if let Some(entries) = Entries::of(argument) {
            return Argument::Dictionary(self.dictionary(argument, entries, name, Hint::default(), false));
        }
        match argument {
            Expr::NoneLiteral(_) => Argument::None,
            Expr::Starred(_) => Argument::PassedOn,
            Expr::Name(_) | Expr::Attribute(_) => {
                match dotted_name(argument).and_then(|name| self.scopes.look_up(&name)) {
                    Some(Bound::Dictionary(index)) => Argument::Dictionary(index),
                    Some(Bound::Unknown) => Argument::Unknown,
                    _ => Argument::PassedOn,
                }
            }
            // `KeyFrames({0: 1})`
            Expr::Call(call) => match &*call.arguments.args {
                [keys, ..] if last_name(&call.func).is_some_and(|name| name.to_lowercase().contains("keyframes")) => {
                    self.argument(keys, name)
                }
                _ => Argument::Unknown,
            },
            _ => Argument::Unknown,
        }
    }
}

/// Whether it is `super().__init__`, or that of a class.
fn is_of_class_above(function: &Expr) -> bool {
    matches!(function, Expr::Attribute(attribute) if attribute.attr.as_str() == "__init__")
}
