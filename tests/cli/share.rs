//! `inbetween share`: the page with an animation in it.

use crate::grade::course;
use crate::report::hand_in;
use crate::sandbox::Sandbox;

const WALK: &str = include_str!("../../assets/animations/walk.json");

/// A sandbox with files that stand for the page's.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    write_page(&sandbox);
    sandbox
}

fn write_page(sandbox: &Sandbox) {
    sandbox.write("page/index.html", "<body>\n<!-- shown -->\n</body>");
    sandbox.write("page/inbetween_bg.wasm", "the program");
    sandbox.write("page/snippets/page.js", "the script");
}

#[test]
fn a_page_shows_an_animation_beside_another_and_names_nobody() {
    let sandbox = sandbox();
    sandbox.write("kim-123.json", WALK);
    let line = ["share", "kim-123.json", "--compare", "kim-123.json", "--page", "page", "-o", "out"];
    let said = sandbox.run(&line).succeeds();
    assert!(said.contains("the page is in out"), "{said}");
    let index = sandbox.read("out/index.html");
    let shown = r#"<script>shown = {"compare":"reference.json","file":"animation.json"};</script>"#;
    assert!(index.contains(shown), "{index}");
    assert_eq!((sandbox.read("out/animation.json"), sandbox.read("out/reference.json")), (WALK.into(), WALK.into()));
    assert_eq!(sandbox.read("out/snippets/page.js"), "the script");
    assert_eq!(std::fs::read_dir(sandbox.path("out")).unwrap().count(), 5);
    // Again, over what was shared before.
    sandbox.run(&line).succeeds();
    assert_eq!(sandbox.read("out/index.html"), index);
}

#[test]
fn a_scene_that_is_not_the_usual_one_goes_along() {
    let sandbox = sandbox();
    let orbits = include_str!("../../assets/scenes/orbits.json");
    sandbox.write("mine.json", orbits);
    sandbox.write("script.txt", "key n\nkey n\nkey n\nkey n\nkey w\n");
    sandbox.run(&["script", "script.txt", "--scene", "mine.json", "--keyframes", "a.json"]).succeeds();
    sandbox.run(&["share", "a.json", "--scene", "mine.json", "--page", "page", "-o", "out"]).succeeds();
    assert!(sandbox.read("out/index.html").contains(r#""scene":"scene.json""#));
    assert_eq!(sandbox.json("out/scene.json")["name"], "orbits");
}

#[test]
fn nothing_of_others_is_overwritten_and_a_missing_page_is_said() {
    let sandbox = sandbox();
    sandbox.write("walk.json", WALK);
    sandbox.write("full/index.html", "mine");
    let said = sandbox.run(&["share", "walk.json", "--page", "page", "-o", "full"]);
    assert_eq!((said.status, &*said.stderr), (1, "full: this folder has other files in it\n"));
    assert_eq!(sandbox.read("full/index.html"), "mine");
    let said = sandbox.run(&["share", "walk.json", "--page", "full", "-o", "out"]);
    assert!(said.status == 1 && said.stderr.starts_with("full: the page's files are not in this folder"), "{said:?}");
    assert!(!sandbox.path("out").exists());
}

/// A submission as Moodle names it.
const ENTRY: &str = "Ada Lovelace_48101_assignsubmission_file_";

/// A page, and a submission whose files are called after the student.
fn course_with_page() -> Sandbox {
    let (sandbox, made) = course();
    hand_in(&sandbox, ENTRY, &made, "nan-when-equal");
    let folder = sandbox.path("all").join(ENTRY);
    for file in std::fs::read_dir(&folder).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        std::fs::rename(folder.join(&name), folder.join(format!("ada_l {name}"))).unwrap();
    }
    std::fs::rename(folder, sandbox.path(ENTRY)).unwrap();
    write_page(&sandbox);
    sandbox
}

#[test]
fn a_report_goes_along_without_names_and_with_points_only_where_asked() {
    let sandbox = course_with_page();
    let line = ["share", ENTRY, "--page", "page", "-o", "out"];
    let reported = [&line[..], &["--report", "rubric.json", "--json"]].concat();
    let said: serde_json::Value = serde_json::from_str(&sandbox.run(&reported).succeeds()).unwrap();
    assert_eq!(said["files"], serde_json::json!({"file": "animation.json", "report": "report.html"}));
    let hidden = sandbox.read("out/report.html");
    sandbox.run(&[&reported[..], &["--with-marks"]].concat()).succeeds();
    let shown = sandbox.read("out/report.html");
    for report in [&hidden, &shown] {
        let text = report.split("background-image").next().unwrap().split("</style>").nth(1).unwrap();
        for name in ["ada_l", "lovelace", "48101", "assignsubmission"] {
            assert!(!text.to_lowercase().contains(name), "{name}: {text}");
        }
        for part in [
            "The submission",
            "nan-when-equal",
            "file 1",
            "keyframe count",
            "<figcaption>Linear, as file ",
            "aria-label=",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
    let is_points = |report: &str| report.contains("<td class=\"n ") || report.contains("<h2><span>");
    assert_eq!((is_points(&hidden), is_points(&shown)), (false, true));
    let index = sandbox.read("out/index.html");
    assert!(index.contains("<nav><a href=\"report.html\" target=\"_blank\">Report</a></nav>"), "{index}");
    // The animation is that of the submission. What is shared without a report later has none.
    std::fs::copy(sandbox.path("out/animation.json"), sandbox.path("one.json")).unwrap();
    sandbox.run(&["share", "one.json", "--page", "page", "-o", "out"]).succeeds();
    assert!(!sandbox.path("out/report.html").exists());
    assert!(!sandbox.read("out/index.html").contains("report.html"));
    sandbox.run(&[&line[..], &["--with-marks"]].concat()).misuses();
}

#[test]
fn a_submission_that_cannot_be_shown_says_why() {
    let sandbox = course_with_page();
    sandbox.write("empty.txt", "nothing");
    let said = sandbox.run(&["share", "empty.txt", "--report", "rubric.json", "--page", "page", "-o", "out"]);
    assert!(said.status == 1 && said.stderr.starts_with("empty.txt: "), "{said:?}");
    assert!(!sandbox.path("out").exists());
}

#[test]
fn what_is_shared_is_never_written_over() {
    let sandbox = sandbox();
    sandbox.write("walk.json", WALK);
    sandbox.run(&["share", "walk.json", "--compare", "walk.json", "--page", "page", "-o", "out"]).succeeds();
    // Without --compare it would be removed.
    sandbox.run(&["share", "out/reference.json", "--page", "page", "-o", "out"]).misuses();
    assert_eq!(sandbox.read("out/reference.json"), WALK);
}
