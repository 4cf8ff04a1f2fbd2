//! Merging: two windows share one settings file, and neither takes back what the other has set.

use std::collections::BTreeMap;

use super::{MOST_RECENT_FILES, Settings};

impl Settings {
    /// These settings on top of those that are in the file now: a field that was not changed since `base` is the file's. Of hotkeys and
    /// panel sizes, each entry is a field of its own. Of recent files, each stays that neither side has removed.
    #[must_use]
    pub fn merged(&self, base: &Self, file: Self) -> Self {
        let Settings {
            keys,
            theme,
            language,
            scale_percent,
            recent: _,
            panels,
            journal,
            reload,
            window,
            tour,
            gizmo_axes,
            snap,
            recorded_eye,
            reduce_motion,
            inset_while_playing,
            refine_at_rest,
        } = self;
        Self {
            keys: merged_map(keys, &base.keys, file.keys),
            theme: changed(theme, &base.theme, file.theme),
            language: changed(language, &base.language, file.language),
            scale_percent: changed(scale_percent, &base.scale_percent, file.scale_percent),
            recent: self.merged_recent(base, file.recent),
            panels: merged_map(panels, &base.panels, file.panels),
            journal: changed(journal, &base.journal, file.journal),
            reload: changed(reload, &base.reload, file.reload),
            window: changed(window, &base.window, file.window),
            tour: changed(tour, &base.tour, file.tour),
            gizmo_axes: changed(gizmo_axes, &base.gizmo_axes, file.gizmo_axes),
            snap: changed(snap, &base.snap, file.snap),
            recorded_eye: changed(recorded_eye, &base.recorded_eye, file.recorded_eye),
            reduce_motion: changed(reduce_motion, &base.reduce_motion, file.reduce_motion),
            inset_while_playing: changed(inset_while_playing, &base.inset_while_playing, file.inset_while_playing),
            refine_at_rest: changed(refine_at_rest, &base.refine_at_rest, file.refine_at_rest),
        }
    }

    /// The file that was used last here comes first, then the others in the order of the settings file, then those that only this
    /// window has used.
    fn merged_recent(&self, base: &Self, file: Vec<std::path::PathBuf>) -> Vec<std::path::PathBuf> {
        if self.recent == base.recent {
            return file;
        }
        let is_removed = |path: &std::path::PathBuf| base.recent.contains(path) && !self.recent.contains(path);
        let others = file.into_iter().filter(|path| !is_removed(path));
        let own = self.recent.iter().filter(|path| !base.recent.contains(path)).cloned();
        let mut merged = Vec::new();
        for path in self.recent.first().cloned().into_iter().chain(others).chain(own) {
            if !merged.contains(&path) {
                merged.push(path);
            }
        }
        merged.truncate(MOST_RECENT_FILES);
        merged
    }
}

fn changed<T: Clone + PartialEq>(own: &T, base: &T, file: T) -> T {
    if own == base { file } else { own.clone() }
}

fn merged_map<V: Clone + PartialEq>(
    own: &BTreeMap<String, V>,
    base: &BTreeMap<String, V>,
    file: BTreeMap<String, V>,
) -> BTreeMap<String, V> {
    let mut merged = file;
    merged.retain(|key, _| own.contains_key(key) || !base.contains_key(key));
    merged.extend(
        own.iter()
            .filter(|(key, value)| base.get(*key) != Some(value))
            .map(|(key, value)| (key.clone(), value.clone())),
    );
    merged
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::*;
    use crate::settings::{ThemeChoice, WindowPlace};

    fn place(width: f32) -> WindowPlace {
        WindowPlace::new([width, 600.0], None)
    }

    fn settings(change: impl FnOnce(&mut Settings)) -> Settings {
        let mut settings = Settings::default();
        settings.keys.insert("undo".to_owned(), vec!["F1".to_owned()]);
        settings.recent = vec![PathBuf::from("b"), PathBuf::from("a")];
        change(&mut settings);
        settings
    }

    #[test]
    fn only_what_was_changed_here_replaces_what_is_in_the_file() {
        let base = settings(|_| ());
        let own = settings(|own| {
            own.theme = ThemeChoice::Dark;
            own.panels.insert("side".to_owned(), 300.0);
            own.keys.clear();
            own.window = Some(place(900.0));
        });
        let file = settings(|file| {
            file.scale_percent = 150;
            file.journal = false;
            file.reload = true;
            file.window = Some(place(800.0));
            file.tour = false;
            file.recorded_eye = true;
            file.reduce_motion = true;
            file.inset_while_playing = true;
            file.refine_at_rest = false;
            file.panels.insert("timeline".to_owned(), 200.0);
            file.keys.insert("redo".to_owned(), vec!["F2".to_owned()]);
        });
        let expected = settings(|expected| {
            expected.theme = ThemeChoice::Dark;
            expected.scale_percent = 150;
            expected.journal = false;
            expected.reload = true;
            expected.window = Some(place(900.0));
            expected.tour = false;
            expected.recorded_eye = true;
            expected.reduce_motion = true;
            expected.inset_while_playing = true;
            expected.refine_at_rest = false;
            expected.panels = BTreeMap::from([("side".to_owned(), 300.0), ("timeline".to_owned(), 200.0)]);
            expected.keys = BTreeMap::from([("redo".to_owned(), vec!["F2".to_owned()])]);
        });
        assert_eq!(own.merged(&base, file), expected);
    }

    #[track_caller]
    fn check_recent(own: impl FnOnce(&mut Settings), file: &[&str], expected: &[&str]) {
        let base = settings(|_| ());
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        let file = settings(|settings| settings.recent = paths(file));
        assert_eq!(settings(own).merged(&base, file).recent, paths(expected));
    }

    #[test]
    fn recent_files_of_both_windows_stay() {
        check_recent(|_| (), &["c", "b", "a"], &["c", "b", "a"]);
        check_recent(|own| own.used(Path::new("d")), &["c", "b", "a"], &["d", "c", "b", "a"]);
        check_recent(|own| own.used(Path::new("a")), &["c", "b", "a"], &["a", "c", "b"]);
        check_recent(|own| own.recent.clear(), &["c", "b", "a"], &["c"]);
    }
}
