//! The sources of the library and the program, parsed: which paths a file names, with imports resolved.
//!
//! Unit tests are left out: items under `#[cfg(test)]`, and the files of modules that are declared so.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::Visit;

/// One file of `src/`, without its unit tests.
pub struct Source {
    /// Its path below `src/`, with `/` between the names.
    pub name: String,
    /// Every path that its code names, resolved: `std::fs::read`, `crate::scene::SceneGraph`.
    pub paths: BTreeSet<String>,
    /// How often the code names each path that it calls.
    pub calls: BTreeMap<String, usize>,
    /// The names of the methods that it calls.
    pub methods: BTreeSet<String>,
    /// The macros that it calls, and the last name of their path.
    pub macros: BTreeSet<String>,
    /// Its statics: name, whether `mut`, and the paths in the type.
    pub statics: Vec<(String, bool, BTreeSet<String>)>,
}

impl Source {
    /// The module of the top level that it belongs to; `main` and `lib` for the two files that belong to none.
    pub fn room(&self) -> &str {
        self.name.split('/').next().unwrap_or_default().trim_end_matches(".rs")
    }

    /// The top-level modules of the crate that its code names.
    pub fn rooms_named(&self) -> BTreeSet<&str> {
        self.paths.iter().filter_map(|path| path.strip_prefix("crate::")?.split("::").next()).collect()
    }

    /// Whether its code names something of this path: the path itself, or what is below it.
    pub fn names(&self, path: &str) -> bool {
        self.paths
            .iter()
            .any(|found| found.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with("::")))
    }

    /// Whether a name of a path of its code is this one, wherever it stands.
    pub fn names_part(&self, part: &str) -> bool {
        self.paths.iter().any(|path| path.split("::").any(|name| name == part))
    }
}

/// The names and texts of all files of `src/`, unit tests included.
pub fn files() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    walk(&root, &mut files);
    files.sort();
    assert!(files.len() > 20);
    let named = |path: PathBuf| {
        let name = path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
        (name, fs::read_to_string(&path).expect("sources are text"))
    };
    files.into_iter().map(named).collect()
}

/// All files of `src/` that are not unit tests, parsed once for all rules.
pub fn sources() -> &'static [Source] {
    static SOURCES: LazyLock<Vec<Source>> = LazyLock::new(parsed);
    &SOURCES
}

fn parsed() -> Vec<Source> {
    let parsed: Vec<(String, String, syn::File)> = files()
        .into_iter()
        .map(|(name, text)| {
            let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("src/{name}: {error}"));
            (name, text, file)
        })
        .collect();
    let tests: BTreeSet<String> = parsed.iter().flat_map(|(name, _, file)| test_modules(name, file)).collect();
    let is_test =
        |name: &str| tests.iter().any(|test| name == format!("{test}.rs") || name.starts_with(&format!("{test}/")));
    let sources = parsed.into_iter().filter(|(name, ..)| !is_test(name));
    sources.map(|(name, _, file)| source(name, &file)).collect()
}

fn walk(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("src is a folder") {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            walk(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// What a file of `src/` with this name holds.
pub fn source(name: String, file: &syn::File) -> Source {
    let module = module_of(&name);
    let mut imports = Imports { module: module.clone(), all: BTreeMap::new(), paths: BTreeSet::new() };
    imports.visit_file(file);
    let mut code = Code {
        module,
        imports: imports.all,
        source: Source {
            name,
            paths: imports.paths,
            calls: BTreeMap::new(),
            methods: BTreeSet::new(),
            macros: BTreeSet::new(),
            statics: Vec::new(),
        },
    };
    code.visit_file(file);
    code.source
}

/// The names of the modules in which a file's code stands: none for `lib.rs` and `main.rs`.
fn module_of(name: &str) -> Vec<String> {
    let names = name.trim_end_matches(".rs");
    if matches!(names, "lib" | "main") { Vec::new() } else { names.split('/').map(str::to_owned).collect() }
}

/// The files, without `.rs`, of the modules that a file declares under `#[cfg(test)]`.
fn test_modules(name: &str, file: &syn::File) -> Vec<String> {
    let folder = module_of(name);
    let declared = file.items.iter().filter_map(|item| match item {
        syn::Item::Mod(module) if module.content.is_none() && is_test(&module.attrs) => Some(module.ident.to_string()),
        _ => None,
    });
    declared.map(|module| [folder.as_slice(), &[module]].concat().join("/")).collect()
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let syn::Meta::List(list) = &attribute.meta else { return false };
        list.path.is_ident("cfg") && list.tokens.to_string() == "test"
    })
}

/// The path that names in a module mean, from the crate's root or from another crate's name.
fn absolute(names: &[String], module: &[String]) -> Vec<String> {
    let mut names = names.iter().map(String::as_str).peekable();
    let mut base: Option<Vec<String>> = None;
    while let Some(&name) = names.peek() {
        match (name, &mut base) {
            ("crate" | "inbetween", None) => base = Some(Vec::new()),
            ("self", None) => base = Some(module.to_vec()),
            ("super", None) => base = Some(module[..module.len().saturating_sub(1)].to_vec()),
            ("super", Some(base)) => drop(base.pop()),
            _ => break,
        }
        names.next();
    }
    let rest = names.map(str::to_owned);
    match base {
        Some(base) => std::iter::once("crate".to_owned()).chain(base).chain(rest).collect(),
        None => rest.collect(),
    }
}

/// What a file's `use` items bring into it, by the names that they give it.
struct Imports {
    module: Vec<String>,
    all: BTreeMap<String, Vec<String>>,
    paths: BTreeSet<String>,
}

impl Imports {
    fn tree(&mut self, tree: &syn::UseTree, before: &[String]) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        let (names, alias) = match tree {
            syn::UseTree::Path(path) => return self.tree(&path.tree, &with(&path.ident)),
            syn::UseTree::Group(group) => {
                return group.items.iter().for_each(|tree| self.tree(tree, before));
            }
            syn::UseTree::Name(name) if name.ident == "self" => (before.to_vec(), before.last().cloned()),
            syn::UseTree::Name(name) => (with(&name.ident), Some(name.ident.to_string())),
            syn::UseTree::Rename(rename) if rename.ident == "self" => {
                (before.to_vec(), Some(rename.rename.to_string()))
            }
            syn::UseTree::Rename(rename) => (with(&rename.ident), Some(rename.rename.to_string())),
            syn::UseTree::Glob(_) => (before.to_vec(), None),
        };
        let path = absolute(&names, &self.module);
        self.paths.insert(path.join("::"));
        if let Some(alias) = alias {
            self.all.insert(alias, path);
        }
    }
}

impl<'ast> Visit<'ast> for Imports {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if !is_test(attributes(item)) {
            syn::visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        self.module.push(module.ident.to_string());
        syn::visit::visit_item_mod(self, module);
        self.module.pop();
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.tree(&item.tree, &[]);
    }
}

fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    match item {
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Enum(item) => &item.attrs,
        syn::Item::ExternCrate(item) => &item.attrs,
        syn::Item::Fn(item) => &item.attrs,
        syn::Item::Impl(item) => &item.attrs,
        syn::Item::Macro(item) => &item.attrs,
        syn::Item::Mod(item) => &item.attrs,
        syn::Item::Static(item) => &item.attrs,
        syn::Item::Struct(item) => &item.attrs,
        syn::Item::Trait(item) => &item.attrs,
        syn::Item::Type(item) => &item.attrs,
        syn::Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// What the code of a file names.
struct Code {
    module: Vec<String>,
    imports: BTreeMap<String, Vec<String>>,
    source: Source,
}

impl Code {
    /// The path that names mean where they stand: an imported first name is replaced by what it was imported from.
    fn resolved(&self, names: &[String]) -> String {
        match names.split_first().and_then(|(first, rest)| Some((self.imports.get(first)?, rest))) {
            Some((imported, rest)) => [imported.as_slice(), rest].concat().join("::"),
            None => absolute(names, &self.module).join("::"),
        }
    }

    /// The paths and methods in what a macro is given, which the parser leaves as tokens: names with `::` between them, and names after
    /// a dot.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut names: Vec<String> = Vec::new();
        let mut colons = 0;
        let mut is_after_dot = false;
        for token in tokens {
            let follows_dot =
                std::mem::replace(&mut is_after_dot, matches!(&token, TokenTree::Punct(sign) if sign.as_char() == '.'));
            match token {
                TokenTree::Ident(name) if follows_dot => {
                    self.source.methods.insert(name.to_string());
                }
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.end_names(&mut names);
                    }
                    names.push(name.to_string());
                    colons = 0;
                }
                TokenTree::Punct(sign) if sign.as_char() == ':' => colons += 1,
                TokenTree::Group(group) => {
                    self.end_names(&mut names);
                    colons = 0;
                    self.tokens(group.stream());
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => {
                    self.end_names(&mut names);
                    colons = 0;
                }
            }
        }
        self.end_names(&mut names);
    }

    fn end_names(&mut self, names: &mut Vec<String>) {
        if !names.is_empty() {
            let path = self.resolved(names);
            *self.source.calls.entry(path.clone()).or_default() += 1;
            self.source.paths.insert(path);
            names.clear();
        }
    }
}

fn names_of(path: &syn::Path) -> Vec<String> {
    path.segments.iter().map(|segment| segment.ident.to_string()).collect()
}

impl<'ast> Visit<'ast> for Code {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if !is_test(attributes(item)) {
            syn::visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        self.module.push(module.ident.to_string());
        syn::visit::visit_item_mod(self, module);
        self.module.pop();
    }

    fn visit_item_static(&mut self, item: &'ast syn::ItemStatic) {
        let mut of_type = Code { module: self.module.clone(), imports: self.imports.clone(), source: empty() };
        of_type.visit_type(&item.ty);
        let is_mutable = !matches!(item.mutability, syn::StaticMutability::None);
        self.source.statics.push((item.ident.to_string(), is_mutable, of_type.source.paths));
        syn::visit::visit_item_static(self, item);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let path_named = self.resolved(&names_of(path));
        self.source.paths.insert(path_named);
        syn::visit::visit_path(self, path);
    }

    fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
        if let syn::Expr::Path(called) = &*call.func {
            let path = self.resolved(&names_of(&called.path));
            *self.source.calls.entry(path).or_default() += 1;
        }
        syn::visit::visit_expr_call(self, call);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        self.source.methods.insert(call.method.to_string());
        syn::visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        if let Some(name) = names_of(&called.path).last() {
            self.source.macros.insert(name.clone());
        }
        self.tokens(called.tokens.clone());
        syn::visit::visit_macro(self, called);
    }
}

fn empty() -> Source {
    Source {
        name: String::new(),
        paths: BTreeSet::new(),
        calls: BTreeMap::new(),
        methods: BTreeSet::new(),
        macros: BTreeSet::new(),
        statics: Vec::new(),
    }
}
