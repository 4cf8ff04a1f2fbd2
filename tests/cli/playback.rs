use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

/// Imports a file of so many keyframes and runs a script; gives the trace after the import and the state.
#[track_caller]
fn play(keyframes: usize, script: &str) -> (Vec<Value>, Value) {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(keyframes).to_string());
    let mut trace = sandbox.trace(&format!("key i\n{script}"));
    trace.remove(0);
    (trace, sandbox.json("state.json"))
}

#[track_caller]
fn assert_head_at(state: &Value, x: f64) {
    let found = state["pose"][HEAD]["translation"][0].as_f64().unwrap();
    assert!((found - x).abs() < 1e-6, "the head is at {found}, expected {x}");
}

fn states(trace: &[Value], field: &str) -> Vec<Value> {
    trace.iter().map(|line| line[field].clone()).collect()
}

#[test]
fn key_time_goes_by_whole_ticks() {
    let (trace, state) = play(6, "key y\nwait 16ms\nwait 1ms\nwait 483ms\nwait 0.5s\n");
    assert_eq!(states(&trace, "key_time"), [json!(0.0), json!(0.0), json!(50.0 / 6000.0), json!(0.25), json!(0.5)]);
    assert_head_at(&state, 1.5);
}

#[test]
fn the_end_is_one_tick_exactly() {
    let (trace, state) = play(4, "key y\nwait 1999.999ms\nwait 0.001ms\n");
    assert_eq!(states(&trace, "playing"), [json!(true), json!(true), json!(false)]);
    assert_eq!(trace[1]["key_time"], json!(119.0 * 50.0 / 6000.0));
    assert_eq!((&trace[2]["key_time"], &trace[2]["current"]), (&Value::Null, &json!(2)));
    assert_eq!(trace[2]["message"], json!("Played to the end."));
    assert_head_at(&state, 2.0);
    let (trace, _) = play(6, "key y\nwait 3600s\nwait 1s\n");
    assert_eq!(states(&trace, "message")[1..], [json!("Played to the end."), json!("")]);
    assert_eq!(trace[2]["current"], json!(4));
}

#[test]
fn what_was_waited_for_before_playing_does_not_count() {
    let (trace, _) = play(4, "wait 10ms\nkey y\nwait 10ms\nwait 7ms\n");
    assert_eq!(states(&trace[2..], "key_time"), [json!(0.0), json!(50.0 / 6000.0)]);
}

#[test]
fn stopping_ends_where_the_end_is() {
    let (trace, state) = play(6, "key y\nwait 500ms\nkey y\n");
    assert_eq!((&trace[2]["playing"], &trace[2]["current"]), (&json!(false), &json!(4)));
    assert_head_at(&state, 4.0);
}

#[test]
fn pausing_keeps_the_current_keyframe_and_captures_the_in_between() {
    let (trace, state) = play(6, "key y\nwait 500ms\nkey shift+p\nwait 5s\nkey n\n");
    assert_eq!(states(&trace, "playing")[2..], [json!(false), json!(false), json!(false)]);
    assert_eq!(states(&trace, "key_time")[2..], [Value::Null, Value::Null, Value::Null]);
    assert_eq!(states(&trace, "current"), [json!(0), json!(0), json!(0), json!(0), json!(1)]);
    assert_head_at(&state, 1.25);
    let (trace, state) = play(6, "key y\nwait 500ms\nkey shift+p\nwait 5s\nkey shift+p\nwait 500ms\n");
    assert_eq!(trace[5]["key_time"], json!(0.5));
    assert_head_at(&state, 1.5);
}

#[test]
fn what_is_refused_while_playing_leaves_it_running() {
    let refused = [
        "key u",
        "key n",
        "key d",
        "key <",
        "key >",
        "key i",
        "key r",
        "key space",
        "key c",
        "key ctrl+z",
        "key ctrl+y",
        "undo",
        "redo",
        "rotate x 10",
        "translate 1 0 0",
    ];
    for line in refused {
        let (trace, state) = play(6, &format!("select robot1/head\nkey y\nwait 1s\n{line}\nwait 500ms\n"));
        let message = trace[3]["message"].as_str().unwrap();
        assert!(message.starts_with("Cannot ") && message.contains(" while playing."), "{line}: {message}");
        assert_eq!((&trace[3]["playing"], &trace[3]["key_time"]), (&json!(true), &json!(0.5)), "{line}");
        assert_eq!((&trace[4]["keyframes"], &trace[4]["key_time"]), (&json!(6), &json!(0.75)), "{line}");
        assert_head_at(&state, 1.75);
    }
}

#[test]
fn everything_else_works_while_playing() {
    for line in ["key w", "key t", "key v", "key p", "key a", "key h", "key f11", "key +", "key -", "select sky"] {
        let (trace, _) = play(6, &format!("key y\nwait 1s\n{line}\n"));
        let message = trace[2]["message"].as_str().unwrap();
        assert!(!message.contains("while playing"), "{line}: {message}");
        assert_eq!((&trace[2]["playing"], &trace[2]["key_time"]), (&json!(true), &json!(0.5)), "{line}");
    }
}

#[test]
fn another_pace_goes_on_from_the_key_time_reached() {
    let faster = "key +\n".repeat(10);
    let (trace, _) = play(6, &format!("key y\nwait 1s\n{faster}wait 500ms\n"));
    assert_eq!(trace[11]["key_time"], json!(0.5));
    assert_eq!(trace[11]["ms_between_keyframes"], json!(1000));
    assert_eq!(trace[12]["key_time"], json!(1.0));
}

#[test]
fn undo_brings_back_posing_that_the_end_overwrote() {
    let (trace, state) = play(4, "select robot1/head\ntranslate 7 0 0\nkey y\nwait 3s\nundo\n");
    assert_eq!(trace[3]["current"], json!(2));
    assert_eq!(trace[4]["current"], json!(0));
    assert_head_at(&state, 7.0);
}

#[test]
fn a_script_shows_what_sample_says() {
    for (key, interpolation) in [("", "linear"), ("key t\n", "catmull-rom")] {
        let sandbox = Sandbox::new();
        sandbox.trace(
            "select robot1/head\nkey n\nrotate x 50\ntranslate 1 0 0\nkey n\nrotate y 70\nkey n\nrotate z -120\n\
             translate 0 1 2\nkey n\nrotate x 30\nkey n\nkey w\n",
        );
        sandbox.trace(&format!("key i\n{key}key y\nwait 2700ms\n"));
        let state = sandbox.json("state.json");
        let at = state["key_time"].to_string();
        let arguments = ["sample", "animation.json", "--at", &at, "--interpolation", interpolation];
        let sampled: Value = serde_json::from_str(&sandbox.run(&arguments).succeeds()).unwrap();
        assert_eq!(sampled["frames"][0]["pose"], state["pose"]);
        assert_eq!(sampled["nodes"], state["nodes"]);
    }
}
