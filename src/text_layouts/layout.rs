//! The layouts, their names and descriptions.

/// A layout of keyframes as text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// `N M`, then a row `tx ty tz qw qx qy qz` for each node of each keyframe, one row per line.
    Header,
    /// Like the first, with two lines for each node: translation and quaternion.
    HeaderTwoLines,
    /// Like the first, with all rows of a keyframe on one line.
    HeaderKeyframeALine,
    /// Like the first, with the quaternion before the translation.
    HeaderQuaternionFirst,
    /// Rows without the header.
    Rows,
    /// A line `frame [0]`, `frame [1]` and on before each keyframe's rows.
    Frames,
    /// A line `end` after each keyframe's rows.
    End,
    /// CSV with the header `frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz`.
    Csv,
    /// `tx,ty,tz;qw,qx,qy,qz` separated by spaces, a keyframe a line.
    Pairs,
    /// `tx,ty,tz,qw,qx,qy,qz;` without end.
    Endless,
    /// Column-major 4x4 matrices, a comma after each number, a keyframe a line; only read.
    Matrices,
}

impl Layout {
    /// The layouts that can be written.
    pub const WRITTEN: [Self; 10] = [
        Self::Header,
        Self::HeaderTwoLines,
        Self::HeaderKeyframeALine,
        Self::HeaderQuaternionFirst,
        Self::Rows,
        Self::Frames,
        Self::End,
        Self::Csv,
        Self::Pairs,
        Self::Endless,
    ];

    /// The name on the command line and in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Header => "header",
            Self::HeaderTwoLines => "header-two-lines",
            Self::HeaderKeyframeALine => "header-keyframe-a-line",
            Self::HeaderQuaternionFirst => "header-quaternion-first",
            Self::Rows => "rows",
            Self::Frames => "frames",
            Self::End => "end",
            Self::Csv => "csv",
            Self::Pairs => "pairs",
            Self::Endless => "endless",
            Self::Matrices => "matrices",
        }
    }

    /// A short description.
    #[must_use]
    pub const fn description(self) -> &'static str {
        match self {
            Self::Header => "\"N M\", then tx ty tz qw qx qy qz, a node a line",
            Self::HeaderTwoLines => "\"N M\", then a line of translation and a line of quaternion for each node",
            Self::HeaderKeyframeALine => "\"N M\", then a keyframe a line",
            Self::HeaderQuaternionFirst => "\"N M\", then qw qx qy qz tx ty tz, a node a line",
            Self::Rows => "tx ty tz qw qx qy qz, a node a line, no header",
            Self::Frames => "a line \"frame [0]\", \"frame [1]\", … before each keyframe's rows",
            Self::End => "a line \"end\" after each keyframe's rows",
            Self::Csv => "frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz",
            Self::Pairs => "tx,ty,tz;qw,qx,qy,qz separated by spaces, a keyframe a line",
            Self::Endless => "tx,ty,tz,qw,qx,qy,qz; and on, all in one line",
            Self::Matrices => "column-major 4x4 matrices, a comma after each number, a keyframe a line",
        }
    }

    /// Whether it can represent an empty list.
    #[must_use]
    pub const fn can_be_empty(self) -> bool {
        matches!(
            self,
            Self::Header | Self::HeaderTwoLines | Self::HeaderKeyframeALine | Self::HeaderQuaternionFirst | Self::Csv
        )
    }

    /// The writable layout with this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::WRITTEN.into_iter().find(|layout| layout.name() == name)
    }
}

/// The order of the seven numbers of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldOrder {
    /// tx ty tz qw qx qy qz.
    TranslationFirst,
    /// qw qx qy qz tx ty tz.
    QuaternionFirst,
}

impl FieldOrder {
    /// Both orders.
    pub const ALL: [Self; 2] = [Self::TranslationFirst, Self::QuaternionFirst];

    /// Its name: `translation-first` or `quaternion-first`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::TranslationFirst => "translation-first",
            Self::QuaternionFirst => "quaternion-first",
        }
    }

    /// The order with this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|order| order.name() == name)
    }

    pub(super) const fn words(self) -> &'static str {
        match self {
            Self::TranslationFirst => "translation first",
            Self::QuaternionFirst => "quaternion first",
        }
    }
}
