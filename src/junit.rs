//! Results as JUnit XML, which CI services read: suites of cases, of which each is passed, failed or could not be run.

use std::fmt::Write as _;

use crate::markup::escaped;

/// A suite: results that belong together.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Suite {
    /// What the suite is called.
    pub name: String,
    /// Its results, in order.
    pub cases: Vec<Case>,
}

/// One result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// What was tested.
    pub name: String,
    /// The group that services list it under: a folder, a student.
    pub class_name: String,
    /// The file that it is about, if there is one.
    pub file: Option<String>,
    /// How it ended.
    pub outcome: Outcome,
    /// Names and values that JUnit has no place for, such as points.
    pub properties: Vec<(String, String)>,
}

/// How a case ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// As it should be.
    Passed,
    /// Not as it should be. The text says why, and its first line is shown in lists.
    Failed(String),
    /// It could not be found out.
    Errored(String),
}

impl Suite {
    /// How many cases failed and how many could not be run.
    fn counts(&self) -> [usize; 2] {
        let count = |is: fn(&Outcome) -> bool| self.cases.iter().filter(|case| is(&case.outcome)).count();
        [
            count(|outcome| matches!(outcome, Outcome::Failed(_))),
            count(|outcome| matches!(outcome, Outcome::Errored(_))),
        ]
    }
}

/// The suites as a document, UTF-8.
#[must_use]
pub fn xml(suites: &[Suite]) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites");
    let all = suites.iter().map(Suite::counts).fold([0, 0], |sum, counts| [sum[0] + counts[0], sum[1] + counts[1]]);
    push_counts(&mut text, suites.iter().map(|suite| suite.cases.len()).sum(), all);
    for suite in suites {
        let _ = write!(text, "  <testsuite name=\"{}\"", escaped(&suite.name));
        push_counts(&mut text, suite.cases.len(), suite.counts());
        for case in &suite.cases {
            push_case(&mut text, case);
        }
        text.push_str("  </testsuite>\n");
    }
    text.push_str("</testsuites>\n");
    text
}

fn push_counts(text: &mut String, tests: usize, [failures, errors]: [usize; 2]) {
    let _ = writeln!(text, " tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"0\">");
}

fn push_case(text: &mut String, case: &Case) {
    let _ = write!(text, "    <testcase name=\"{}\" classname=\"{}\"", escaped(&case.name), escaped(&case.class_name));
    if let Some(file) = &case.file {
        let _ = write!(text, " file=\"{}\"", escaped(file));
    }
    let reason = match &case.outcome {
        Outcome::Passed => None,
        Outcome::Failed(reason) => Some(("failure", reason)),
        Outcome::Errored(reason) => Some(("error", reason)),
    };
    if reason.is_none() && case.properties.is_empty() {
        text.push_str("/>\n");
        return;
    }
    text.push_str(">\n");
    if !case.properties.is_empty() {
        text.push_str("      <properties>\n");
        for (name, value) in &case.properties {
            let _ = writeln!(text, "        <property name=\"{}\" value=\"{}\"/>", escaped(name), escaped(value));
        }
        text.push_str("      </properties>\n");
    }
    if let Some((element, reason)) = reason {
        let first = reason.lines().next().unwrap_or_default();
        let lines: Vec<String> = reason.lines().map(escaped).collect();
        let _ = writeln!(
            text,
            "      <{element} message=\"{}\" type=\"{element}\">{}</{element}>",
            escaped(first),
            lines.join("\n")
        );
    }
    text.push_str("    </testcase>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(name: &str, outcome: Outcome, properties: &[(&str, &str)]) -> Case {
        let properties = properties.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        Case { name: name.to_owned(), class_name: "pictures".to_owned(), file: None, outcome, properties }
    }

    #[test]
    fn a_document_counts_and_escapes() {
        let failed = Outcome::Failed("beyond <0.06>\nand \"more\"".to_owned());
        let cases = vec![
            case("rest", Outcome::Passed, &[]),
            case("a & b", failed, &[("points", "2.5")]),
            Case { file: Some("list.json".to_owned()), ..case("gone", Outcome::Errored("no file".to_owned()), &[]) },
        ];
        assert_eq!(
            xml(&[Suite { name: "verify".to_owned(), cases }, Suite::default()]),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <testsuites tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\">\n\
             \x20 <testsuite name=\"verify\" tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\">\n\
             \x20   <testcase name=\"rest\" classname=\"pictures\"/>\n\
             \x20   <testcase name=\"a &amp; b\" classname=\"pictures\">\n\
             \x20     <properties>\n\
             \x20       <property name=\"points\" value=\"2.5\"/>\n\
             \x20     </properties>\n\
             \x20     <failure message=\"beyond &lt;0.06&gt;\" type=\"failure\">beyond &lt;0.06&gt;\nand &quot;more&quot;</failure>\n\
             \x20   </testcase>\n\
             \x20   <testcase name=\"gone\" classname=\"pictures\" file=\"list.json\">\n\
             \x20     <error message=\"no file\" type=\"error\">no file</error>\n\
             \x20   </testcase>\n\
             \x20 </testsuite>\n\
             \x20 <testsuite name=\"\" tests=\"0\" failures=\"0\" errors=\"0\" skipped=\"0\">\n\
             \x20 </testsuite>\n\
             </testsuites>\n"
        );
    }
}
