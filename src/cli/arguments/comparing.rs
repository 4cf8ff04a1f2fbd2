//! Arguments of pictures that compare interpolations.

use clap::Args;

use crate::export::{Comparison, ExportError, Size, check_comparison};
use crate::film::{COMPARED_AT_MOST, ComparedAs, ComparedLayout};
use crate::keyframe::Blend;
use crate::text::listed;

/// Arguments of pictures that compare interpolations.
#[derive(Debug, Args)]
pub struct ComparingArguments {
    /// Show each moment by 2 to 4 interpolations, with their names and the angular speed below: linear, catmull-rom, nlerp (blended
    /// quaternions), matrix (blended matrices), file (what FILE says). --size is that of the whole picture.
    #[arg(long, value_name = "NAME,NAME…", requires = "file", conflicts_with_all = ["keyframe", "id", "interpolation"], value_parser = names)]
    pub compare: Option<ComparedNames>,
    /// How: side-by-side, or ghosts of the others over the first [default: side-by-side].
    #[arg(long, value_name = "side-by-side|ghosts", requires = "compare", value_parser = compared_as)]
    pub compare_as: Option<ComparedAs>,
    /// The path of the node whose angular speed is shown [default: the one that turns fastest].
    #[arg(long, value_name = "NODE", requires = "compare")]
    pub compare_node: Option<String>,
}

/// What is compared, each by the name that was typed; `None` is what the file says.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedNames(Vec<(String, Option<Blend>)>);

/// The size of each view where no size is given.
const VIEW: [u32; 2] = [320, 240];
/// The size of the view that has ghosts.
const VIEW_OF_GHOSTS: [u32; 2] = [640, 480];
/// The size of each view in a contact sheet.
const VIEW_IN_SHEET: [u32; 2] = [160, 120];

impl ComparingArguments {
    /// How what is compared is shown.
    pub fn how(&self) -> ComparedAs {
        self.compare_as.unwrap_or_default()
    }

    /// The layout of pictures of a size, or of the usual one; `None` if nothing is compared.
    ///
    /// # Errors
    /// [`ExportError`]: the size is too small.
    pub fn layout(&self, size: Option<Size>, is_sheet: bool) -> Result<Option<ComparedLayout>, ExportError> {
        let Some(ComparedNames(names)) = &self.compare else { return Ok(None) };
        let count = names.len() as u32;
        let view = match self.how() {
            _ if is_sheet => VIEW_IN_SHEET,
            ComparedAs::SideBySide => VIEW,
            ComparedAs::Ghosts => VIEW_OF_GHOSTS,
        };
        let usual = Size::of(ComparedLayout::size_of_views(self.how(), count, view));
        check_comparison(self.how(), count, size.unwrap_or(usual)).map(Some)
    }

    /// What is compared, in a layout.
    pub fn comparison(&self, layout: Option<ComparedLayout>) -> Option<Comparison<'_>> {
        let ComparedNames(blends) = self.compare.as_ref()?;
        Some(Comparison { blends, layout: layout?, node: self.compare_node.as_deref() })
    }
}

/// The name of what the file says.
const OF_FILE: &str = "file";

fn names(text: &str) -> Result<ComparedNames, String> {
    let known: Vec<&str> = Blend::ALL.iter().map(|blend| blend.name()).chain([OF_FILE]).collect();
    let named = |name: &str| match Blend::from_name(name) {
        None if name != OF_FILE => Err(format!("{name:?} is none of {}", known.join(", "))),
        blend => Ok((name.to_owned(), blend)),
    };
    let names = text.split(',').map(|name| named(name.trim())).collect::<Result<Vec<_>, _>>()?;
    if let Some((_, (twice, _))) = names.iter().enumerate().find(|(place, name)| names[..*place].contains(name)) {
        return Err(format!("{twice} is there twice"));
    }
    if !(2..=COMPARED_AT_MOST).contains(&names.len()) {
        return Err(format!("expected 2 to {COMPARED_AT_MOST} of {} between commas", listed(&known, "and")));
    }
    Ok(ComparedNames(names))
}

fn compared_as(text: &str) -> Result<ComparedAs, String> {
    let named = ComparedAs::NAMED.into_iter().find(|(name, _)| *name == text);
    named
        .map(|(_, how)| how)
        .ok_or_else(|| format!("expected {}", ComparedAs::NAMED.map(|(name, _)| name).join(" or ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_kept_as_they_were_typed() {
        let ComparedNames(read) = names("linear, matrices,file").unwrap();
        let labels: Vec<&str> = read.iter().map(|(label, _)| label.as_str()).collect();
        assert_eq!(labels, ["linear", "matrices", "file"]);
        assert_eq!(read[1].1, Some(Blend::Matrices));
        assert_eq!(read[2].1, None);
    }

    #[test]
    fn what_cannot_be_compared_is_said() {
        for (text, said) in [
            ("linear,cubic", "\"cubic\" is none of linear, catmull-rom, nlerp, matrix, file"),
            ("linear,", "\"\" is none of linear, catmull-rom, nlerp, matrix, file"),
            ("linear", "expected 2 to 4 of linear, catmull-rom, nlerp, matrix and file between commas"),
            (
                "linear,catmull-rom,nlerp,matrix,file",
                "expected 2 to 4 of linear, catmull-rom, nlerp, matrix and file between commas",
            ),
            ("nlerp,linear,nlerp", "nlerp is there twice"),
        ] {
            assert_eq!(names(text), Err(said.to_owned()), "{text}");
        }
    }
}
