//! The first steps.

use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use glam::Vec3;
use inbetween::editor::{Command, Edit, PlaybackCommand, WindowCommand};
use inbetween::pose::RbtIndex;

use crate::{App, click, does, editor, editor_of, harness, harness_of};

const HEADING: &str = "First steps";

/// The sentence of the step at hand.
fn at_hand(harness: &Harness<'_, App>) -> Option<String> {
    let label = |node: egui_kittest::Node<'_>| node.accesskit_node().value().or_else(|| node.accesskit_node().label());
    harness
        .query_all_by_role(egui::accesskit::Role::Label)
        .filter(|node| node.accesskit_node().data().is_selected() == Some(true))
        .find_map(label)
}

fn pose(harness: &mut Harness<'_, App>, x: f32) {
    does(harness, Command::Edit(Edit::SetTranslation(RbtIndex::new(2), Vec3::new(x, 1.0, 0.0))));
}

#[test]
fn each_step_is_done_by_doing_it() {
    let mut harness = harness(editor(0));
    harness.get_by_label(HEADING);
    let create = || Command::Edit(Edit::CreateKeyframe);
    let mut seen = vec![at_hand(&harness).unwrap()];
    pose(&mut harness, 1.0);
    seen.push(at_hand(&harness).unwrap());
    does(&mut harness, create());
    seen.push(at_hand(&harness).unwrap());
    pose(&mut harness, 2.0);
    seen.push(at_hand(&harness).unwrap());
    does(&mut harness, create());
    seen.push(at_hand(&harness).unwrap());
    does(&mut harness, create());
    does(&mut harness, create());
    seen.push(at_hand(&harness).unwrap());
    let begins = ["Pose: ", "Press n: ", "Pose it", "Press n again", "The same twice", "Press y "];
    for (sentence, begin) in seen.iter().zip(begins) {
        assert!(sentence.starts_with(begin), "{seen:?}");
    }
    harness.state_mut().apply(Command::Playback(PlaybackCommand::PlayOrStop));
    harness.step();
    harness.step();
    assert_eq!(at_hand(&harness), None);
    assert!(harness.query_by_label_contains("That is an animation.").is_some());
}

#[test]
fn it_takes_no_key_and_no_focus() {
    let mut harness = harness(editor(0));
    assert!(!harness.state().ui.has_keyboard(&harness.ctx));
    assert!(!harness.state().ui.takes_escape(&harness.ctx));
    for _ in 0..80 {
        harness.key_press(Key::Tab);
        harness.run();
        let focused = harness
            .query_all_by(|node| node.is_focused() && !node.is_hidden())
            .next()
            .and_then(|node| node.accesskit_node().label());
        assert_ne!(focused.as_deref(), Some("Close the first steps"));
    }
}

#[test]
fn it_is_closed_for_good_and_comes_back_by_the_menu() {
    let mut harness = harness(editor(0));
    click(&mut harness, "Close the first steps");
    assert!(harness.query_by_label(HEADING).is_none());
    assert!(!harness.state().settings.tour);
    let mut app = App::new(editor(0));
    app.settings = harness.state().settings.clone();
    app.ui.adopt(&app.settings);
    let mut again = harness_of(app, vec2(1280.0, 800.0));
    assert!(again.query_by_label(HEADING).is_none());
    does(&mut again, Command::Window(WindowCommand::ShowTour));
    again.get_by_label(HEADING);
    assert!(again.state().settings.tour);
}

#[test]
fn a_window_with_keyframes_shows_none() {
    assert!(harness(editor(4)).query_by_label(HEADING).is_none());
}

#[test]
fn a_small_view_shows_the_step_at_hand_alone() {
    let harness = harness_of(App::new(editor(0)), vec2(720.0, 480.0));
    assert!(at_hand(&harness).unwrap().starts_with("Pose: "));
    assert!(harness.query_by_label("Pose it differently.").is_none());
}

#[test]
fn no_robots_are_named_where_there_are_none() {
    for scene in ["cylinder", "orbits"] {
        let harness = harness(editor_of(scene, 0));
        assert!(harness.query_all_by_label_contains("robot").next().is_none(), "{scene}");
    }
    assert!(!include_str!("../../assets/words/en.txt").contains("robot"));
}
