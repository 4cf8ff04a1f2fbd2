//! What the report tells about the known mistakes that its class shows, each once.

use std::fmt::Write as _;

use super::super::film::MistakeFilm;
use super::super::finding::{Answer, Finding, SampleFinding};
use super::super::marks::Marks;
use super::super::studio::ReportPicture;
use super::class::links;
use super::sheet::Sheet;
use crate::diagnosis::{Fact, Mistake};
use crate::interpolation::Interpolation;
use crate::markup::escaped;
use crate::text::counted;

/// A known mistake that submissions show.
#[derive(Clone, Debug)]
pub struct ShownMistake {
    /// The mistake.
    pub mistake: &'static Mistake,
    /// The playback in which the first of them shows it.
    pub interpolation: Interpolation,
    /// The indices of the submissions that show it, ascending, at least one.
    pub shown_by: Vec<usize>,
}

/// The known mistakes that samples show, if they are explained.
pub fn named(samples: &SampleFinding) -> Vec<&'static Mistake> {
    let mistakes = explanation(samples).into_iter().flat_map(|best| best.mistakes.iter().copied());
    mistakes.filter(|mistake| !mistake.is_right()).collect()
}

/// What else explains samples that show a mistake.
pub fn also(samples: &SampleFinding) -> impl Iterator<Item = &Answer> {
    let wrong = explanation(samples).filter(|best| !best.is_right());
    let diagnosis = samples.diagnosis.as_ref().ok().filter(|_| wrong.is_some());
    diagnosis.into_iter().flat_map(Finding::also).filter(move |other| {
        // Samples that end early agree with the same without an early end, which says nothing more.
        wrong.is_none_or(|best| !best.mistakes.starts_with(&other.mistakes) && !other.is_right())
    })
}

fn explanation(samples: &SampleFinding) -> Option<&Answer> {
    samples.diagnosis.as_ref().ok().filter(|diagnosis| diagnosis.is_explained()).map(Finding::best)
}

/// The known mistakes of a class, the commonest first.
#[must_use]
pub fn shown(all: &[Marks]) -> Vec<ShownMistake> {
    let mut found: Vec<ShownMistake> = Vec::new();
    for (index, marks) in all.iter().enumerate() {
        for samples in &marks.samples {
            let Some(best) = explanation(samples) else { continue };
            for mistake in named(samples) {
                match found.iter_mut().find(|known| known.mistake == mistake) {
                    Some(known) if known.shown_by.last() == Some(&index) => {}
                    Some(known) => known.shown_by.push(index),
                    None => {
                        found.push(ShownMistake { mistake, interpolation: best.interpolation, shown_by: vec![index] });
                    }
                }
            }
        }
    }
    found.sort_by(|one, other| (other.shown_by.len(), one.mistake.name).cmp(&(one.shown_by.len(), other.mistake.name)));
    found
}

/// A link to the section of a mistake.
pub fn link(mistake: &Mistake) -> String {
    format!("<a href=\"#{0}\">{0}</a>", mistake.name)
}

/// A section for each mistake, with its film where there is one.
pub fn sections<'a>(
    all: &[Marks],
    found: &[ShownMistake],
    films: &'a [Option<MistakeFilm>],
    sheet: &mut Sheet<'a>,
) -> String {
    let mut text = String::from("<div class=\"mistakes\">\n");
    for (number, ShownMistake { mistake, shown_by, .. }) in found.iter().enumerate() {
        let film = films.get(number).and_then(Option::as_ref).map(|film| &film.picture);
        let count = counted(shown_by.len(), "submission");
        text.push_str(&opening(mistake, Some(&count), film, sheet));
        let _ = writeln!(
            text,
            "<dt>Shown by</dt><dd>{}</dd></dl>\n<nav><a href=\"#top\">↑ overview</a></nav></section>",
            links(all, shown_by)
        );
    }
    text.push_str("</div>\n");
    text
}

/// The section of a mistake, open after its last fact.
pub fn opening<'a>(
    mistake: &Mistake,
    count: Option<&str>,
    film: Option<&'a ReportPicture>,
    sheet: &mut Sheet<'a>,
) -> String {
    let count = count.map_or_else(String::new, |count| format!("<span>{count}</span> "));
    let mut text = format!(
        "<section class=\"mistake\" id=\"{0}\"><h2>{count}{0}</h2>\n<p>{1}</p>\n",
        mistake.name,
        escaped(mistake.what)
    );
    if let Some(film) = film {
        text.push_str(&sheet.figure(film));
    }
    text.push_str("<dl>");
    for Fact { title, text: fact, is_code } in mistake.facts() {
        let fact = if is_code { format!("<code>{}</code>", escaped(fact)) } else { escaped(fact) };
        let _ = write!(text, "<dt>{title}</dt><dd>{fact}</dd>");
    }
    text
}
