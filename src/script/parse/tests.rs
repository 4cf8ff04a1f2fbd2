//! Scripts and what becomes of their lines.

use super::*;
use crate::editor::ViewCommand;
use crate::editor::commands::radians;
use crate::scene::{DEFAULT_SCENE, built_in_scene, scene_from_json};

fn parsed(text: &str) -> Result<Vec<Line>, Vec<ScriptError>> {
    parse(text.as_bytes(), &built_in_scene(DEFAULT_SCENE).unwrap())
}

#[track_caller]
fn check_problem(line: &str, sentence: &str) {
    let problems = parsed(&format!("undo\n{line}\n")).expect_err(line);
    assert_eq!(problems.len(), 1);
    assert_eq!(problems[0].to_string(), format!("line 2: {sentence}"));
}

#[test]
fn comments_blanks_and_line_ends() {
    let lines = parsed("\u{feff}# a comment\r\n\r\n  key   n  # more\r\n\tundo\nredo#x\n   ").unwrap();
    let texts: Vec<(usize, &str)> = lines.iter().map(|line| (line.number, line.text.as_str())).collect();
    assert_eq!(texts, [(3, "key   n"), (4, "undo"), (5, "redo")]);
}

#[test]
fn what_cannot_be_understood() {
    check_problem("jump 3", "\"jump\" is not a command; `inbetween help script` lists them");
    check_problem("roate z 3", "\"roate\" is not a command; did you mean rotate? `inbetween help script` lists them");
    check_problem("select robot3", "node \"robot3\" is not in the scene \"two-robots\"");
    check_problem("select", "expected `select PATH`, found `select`");
    check_problem("rotate z", "expected `rotate AXIS DEGREES`, found `rotate z`");
    check_problem("rotate w 3", "\"w\" is not an axis; expected x, y or z");
    check_problem("rotate x nan", "\"nan\" is not a finite number");
    check_problem("rotate x 1e999", "\"1e999\" is not a finite number");
    check_problem("translate 1 2", "expected `translate X Y Z`, found `translate 1 2`");
    check_problem("translate 1 2 3 4", "expected `translate X Y Z`, found `translate 1 2 3 4`");
    check_problem("translate 1 2 1e39", "\"1e39\" is not a finite number");
    check_problem("key", "expected `key K`, found `key`");
    check_problem("key n n", "expected `key K`, found `key n n`");
    check_problem("key q", "\"q\" is not a hotkey");
    check_problem("key f12", "\"f12\" is not a hotkey");
    check_problem("wait 5", "\"5\" is not a time; expected as in 500ms or 2s, 0 to 1e6 seconds");
    check_problem("wait -1s", "\"-1s\" is not a time; expected as in 500ms or 2s, 0 to 1e6 seconds");
    check_problem("wait infs", "\"infs\" is not a time; expected as in 500ms or 2s, 0 to 1e6 seconds");
    check_problem("wait s", "\"s\" is not a time; expected as in 500ms or 2s, 0 to 1e6 seconds");
    check_problem("wait 5 ms", "expected `wait TIME`, found `wait 5 ms`");
    check_problem("undo it", "expected `undo`, found `undo it`");
    check_problem("redo 2", "expected `redo`, found `redo 2`");
    check_problem("screenshot", "expected `screenshot [--overlays] PATH`, found `screenshot`");
    check_problem("do Fly", "\"Fly\" is not in the list of commands");
    check_problem("do", "expected `do NAME`, found `do`");
    check_problem("go x", "\"x\" is not a keyframe; expected a whole number from 0");
    check_problem("go -1", "\"-1\" is not a keyframe; expected a whole number from 0");
    check_problem("go", "expected `go KEYFRAME`, found `go`");
    check_problem("select-keyframes", "expected `select-keyframes KEYFRAME…|none`, found `select-keyframes`");
    check_problem("select-keyframes 1 4-2", "\"4-2\" is not a range of keyframes; expected as in 3-6");
    check_problem("select-keyframes 0-99999999", "\"0-99999999\" is not a range of keyframes; expected as in 3-6");
    check_problem("move", "expected `move PLACE`, found `move`");
    check_problem("cut 3", "expected `cut`, found `cut 3`");
    check_problem("duration 1 0", "\"0\" is not a duration; expected a number from 0.001 to 1000");
    check_problem("duration 1 nan", "\"nan\" is not a duration; expected a number from 0.001 to 1000");
    check_problem(
        "duration 1 2 ripple",
        "expected `duration KEYFRAME STEPS [ripple-free]`, found `duration 1 2 ripple`",
    );
    check_problem("rename", "expected `rename KEYFRAME [NAME]`, found `rename`");
    check_problem("set-translation 1 2 3", "expected `set-translation X Y Z PATH`, found `set-translation 1 2 3`");
    check_problem("set-translation 1 2 3 robot3", "node \"robot3\" is not in the scene \"two-robots\"");
    check_problem("reach robot1/left_elbow 1 2 3", "\"robot1/left_elbow\" is not a finite number");
    check_problem("set-rotation 1 2 3 inf robot1", "\"inf\" is not a finite number");
    check_problem("set-keyframe-rotation z 0 0 0 1 robot1", "\"z\" is not a keyframe; expected a whole number from 0");
    check_problem("drag left", "expected `drag begin|end|cancel|move X Y Z|turn AXIS DEGREES`, found `drag left`");
    check_problem("interpolation cubic", "\"cubic\" is not an interpolation; expected linear or catmull-rom");
    check_problem("ms 99", "\"99\" is not a number of milliseconds; expected a whole number from 100 to 10000");
    check_problem("scrub now", "\"now\" is not a finite number");
    check_problem("step 1.5", "\"1.5\" is not a step in ticks; expected a whole number from -216000 to 216000");
    check_problem("mode twice", "\"twice\" is not a mode of playing; expected once, loop or ping-pong");
    check_problem("range 1", "expected `range FIRST LAST|all`, found `range 1`");
    check_problem("speed 9", "\"9\" is not a speed in percent; expected a whole number from 10 to 1000");
    check_problem("auto-key yes", "\"yes\" is not a state; expected on or off");
    check_problem("ghosts 21", "\"21\" is not a number of ghosts; expected a whole number from 0 to 20");
    check_problem("eye ground", "node \"ground\" is not an eye of the scene; expected sky, robot1 or robot2");
}

#[test]
fn names_may_be_quoted() {
    use crate::editor::{Edit, TimelineEdit};
    use crate::keyframe::KeyframeIndex;
    for (line, text, name) in [
        ("rename 3 the jump # up", "rename 3 the jump", "the jump"),
        ("rename 3 \"Take #2\" # \"up\"", "rename 3 \"Take #2\"", "Take #2"),
        ("rename 3 \"a \\\"b\\\"\"", "rename 3 \"a \\\"b\\\"\"", "a \"b\""),
        ("rename 3", "rename 3", ""),
        ("rename 3 12", "rename 3 12", "12"),
    ] {
        let lines = parsed(line).expect(line);
        let edit = Edit::Timeline(TimelineEdit::RenameKeyframe(KeyframeIndex::new(3), name.to_owned()));
        assert_eq!((lines[0].text.as_str(), &lines[0].action), (text, &Action::Apply(Command::Edit(edit))));
    }
}

#[test]
fn bytes_that_are_no_text_have_a_line_too() {
    let problems = parse(b"undo\nkey \xff\n", &built_in_scene(DEFAULT_SCENE).unwrap()).unwrap_err();
    assert_eq!(problems[0].to_string(), "line 2: not UTF-8");
}

#[test]
fn times() {
    for (word, nanoseconds) in
        [("500ms", 500_000_000), ("2s", 2_000_000_000), ("0.5ms", 500_000), ("1.25s", 1_250_000_000), ("0s", 0)]
    {
        assert_eq!(duration(word), Ok(Duration::from_nanos(nanoseconds)), "{word}");
    }
}

#[test]
fn whole_turns_are_nothing() {
    assert_eq!(radians("720"), Ok(0.0));
    assert_eq!(radians("-90"), Ok(-std::f64::consts::FRAC_PI_2));
}

#[test]
fn every_path_can_be_selected_even_with_blanks_and_number_signs() {
    let scene = scene_from_json(
        r#"{"format": "inbetween.scene", "version": 1, "name": "odd", "eyes": ["a b#1"],
            "nodes": [{"name": "a b#1"}, {"name": "a"}, {"name": "c # d"}]}"#,
    )
    .unwrap();
    for (line, text) in [
        ("select a b#1", "select a b#1"),
        ("select a b#1 # note", "select a b#1"),
        ("select c # d#e", "select c # d"),
        ("select a#1", "select a"),
    ] {
        let lines = parse(line.as_bytes(), &scene).expect(line);
        assert_eq!(lines[0].text, text);
        let rbt = scene.find_rbt(text.strip_prefix("select ").unwrap());
        assert_eq!(lines[0].action, Action::Apply(Command::View(ViewCommand::Choose(rbt))));
    }
}

#[test]
fn lines_about_the_scene_speak_of_it_as_the_lines_before_leave_it() {
    let lines = parsed(
        "put-control robot1\nadd-key scale 1.5 robot1_control\nrename-control spin robot1_control\n\
         set-key rotation 2s 90,0,0 spin\nremove-control spin\nseconds 2.5\n",
    );
    assert_eq!(lines.unwrap().len(), 6);
    let gone = parsed("put-control robot1\nremove-control robot1_control\nadd-key scale 1 robot1_control\n");
    assert_eq!(gone.unwrap_err()[0].to_string(), "line 3: node \"robot1_control\" is not in the scene \"two-robots\"");
    check_problem("add-key scale 1.5 robot1_control", "node \"robot1_control\" is not in the scene \"two-robots\"");
    check_problem("put-control", "expected `put-control PATH`, found `put-control`");
    check_problem("seconds 1 2", "expected `seconds SECONDS`, found `seconds 1 2`");
    check_problem("add-key scale robot1", "expected `add-key CHANNEL SECONDS PATH`, found `add-key scale robot1`");
    check_problem("add-key size 1 robot1", "\"size\" has no keys; expected translation, rotation, scale or colour");
    check_problem("move-key scale 1 x robot1", "\"x\" is not a finite number");
    check_problem("set-key translation 1 1,2 robot1", "\"1,2\" is not a translation; expected x,y,z");
    check_problem("set-key colour 1 red robot1", "\"red\" is not a colour; expected rrggbb");
}
