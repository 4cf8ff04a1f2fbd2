//! `inbetween share`: the page with an animation in it.

use super::sandbox::Sandbox;

const WALK: &str = include_str!("../../assets/animations/walk.json");

/// A sandbox with files that stand for the page's.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("page/index.html", "<body>\n<!-- shown -->\n</body>");
    sandbox.write("page/inbetween_bg.wasm", "the program");
    sandbox.write("page/snippets/page.js", "the script");
    sandbox
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
