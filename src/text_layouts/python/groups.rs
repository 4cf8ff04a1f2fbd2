//! The groups of keys of a program: what one control node gets.

use ruff_python_ast::Stmt;

use super::fault::Fault;
use super::keys::{Channel, Keys};
use super::walk::{Dictionary, Node, Walk};

/// The keys of one control node.
pub(super) struct Group {
    /// What it is assigned to, with the names of functions and classes that it is in; may be empty.
    pub(super) path: String,
    /// Where it begins.
    pub(super) at: usize,
    /// The keys, or why they are not known.
    pub(super) keys: Result<Keys, Fault>,
}

/// The groups of a module, in the order of the text.
///
/// A call that takes dictionaries makes a group of them. Of other dictionaries, those of one scope make a group, until one comes of a channel
/// that the group has.
pub(super) fn groups(source: &str, module: &[Stmt]) -> Vec<Group> {
    let Walk { dictionaries, nodes, .. } = Walk::through(source, module);
    let mut taken: Vec<[Option<usize>; 3]> = Vec::new();
    let mut groups = Vec::new();
    for node in &nodes {
        // The same keys may be given to several nodes.
        if node.fault.is_some() || !taken.contains(&node.dictionaries) {
            taken.push(node.dictionaries);
            groups.push(of_node(source, node, &dictionaries));
        }
    }
    let mut loose: Vec<&Dictionary> = dictionaries.iter().filter(|dictionary| dictionary.is_loose).collect();
    loose.sort_by_key(|dictionary| dictionary.place.start());
    let has_sure = loose.iter().any(|dictionary| dictionary.is_sure());
    // Numbers by numbers may be anything in a program, but not where there is nothing else.
    let is_alone = !has_sure && nodes.is_empty() && module.iter().all(is_plain);
    loose.retain(|dictionary| dictionary.is_sure() || (is_alone && dictionary.may_be_keys()));
    groups.extend(of_loose(source, &loose));
    groups.retain(|group| group.keys.as_ref().map_or(true, |keys| !keys.are_empty()));
    groups.sort_by_key(|group| group.at);
    groups
}

fn is_plain(statement: &Stmt) -> bool {
    matches!(statement, Stmt::Assign(_) | Stmt::Expr(_) | Stmt::Import(_) | Stmt::ImportFrom(_))
}

fn of_node(source: &str, node: &Node, dictionaries: &[Dictionary]) -> Group {
    let with_channels = node.dictionaries.iter().zip(Channel::ALL);
    let given: Vec<(Channel, &Dictionary)> =
        with_channels.filter_map(|(index, channel)| Some((channel, &dictionaries[(*index)?]))).collect();
    let keys = match &node.fault {
        Some(fault) => Err(fault.clone()),
        None => keys_of(source, &given),
    };
    let first = given.iter().map(|(_, dictionary)| dictionary.place.start()).min().unwrap_or(node.place.start());
    Group { path: node.path.clone(), at: first.to_usize(), keys }
}

fn of_loose(source: &str, loose: &[&Dictionary]) -> Vec<Group> {
    let mut gathered: Vec<Vec<(Channel, &Dictionary)>> = Vec::new();
    for &dictionary in loose {
        // There is nothing in an empty dictionary. What is wrong with other values is said as of translations.
        if dictionary.keys.as_ref().is_ok_and(Vec::is_empty) {
            continue;
        }
        let channel = dictionary.channel.unwrap_or(Channel::Translation);
        let is_alike = |group: &&mut Vec<(Channel, &Dictionary)>| {
            let (_, first) = group[0];
            first.scope == dictionary.scope && first.hint.rest == dictionary.hint.rest
        };
        match gathered.iter_mut().rev().find(is_alike) {
            Some(group) if group.iter().all(|(held, _)| *held != channel) => group.push((channel, dictionary)),
            _ => gathered.push(vec![(channel, dictionary)]),
        }
    }
    let group = |group: &Vec<(Channel, &Dictionary)>| {
        let (_, first) = group[0];
        Group { path: first.path.clone(), at: first.place.start().to_usize(), keys: keys_of(source, group) }
    };
    gathered.iter().map(group).collect()
}

fn keys_of(source: &str, dictionaries: &[(Channel, &Dictionary)]) -> Result<Keys, Fault> {
    let mut keys = Keys::default();
    for (channel, dictionary) in dictionaries {
        keys.add(source, *channel, dictionary.keys.as_ref().map_err(Clone::clone)?)?;
        keys.met.quaternions |= dictionary.met.quaternions;
        keys.met.euler_angles |= dictionary.met.euler_angles;
    }
    Ok(keys)
}
