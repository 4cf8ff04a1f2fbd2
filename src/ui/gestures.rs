//! What the mouse does, for the help: one row for each gesture. Who adds a gesture adds its row.

use crate::words::{Phrase, texts};

/// Where a gesture is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Over the scene.
    Scene,
    /// In the timeline.
    Timeline,
    /// In the right panel and at the edges of panels.
    Panels,
}

impl Place {
    /// All of them, in the order of the help.
    pub const ALL: [Self; 3] = [Self::Scene, Self::Timeline, Self::Panels];

    /// Its heading.
    pub const fn heading(self) -> Phrase {
        match self {
            Self::Scene => texts::MOUSE_OVER_THE_SCENE,
            Self::Timeline => texts::MOUSE_IN_THE_TIMELINE,
            Self::Panels => texts::MOUSE_IN_THE_PANELS,
        }
    }
}

/// One of them.
#[derive(Clone, Copy, Debug)]
pub struct Gesture {
    /// Where it is made.
    pub place: Place,
    /// How it is made, as in "Left drag".
    pub how: Phrase,
    /// What it does.
    pub does: Phrase,
}

const fn row(place: Place, how: Phrase, does: Phrase) -> Gesture {
    Gesture { place, how, does }
}

/// All of them, in the order of the help.
pub const GESTURES: &[Gesture] = &[
    row(Place::Scene, texts::LEFT_DRAG, texts::TURN_BY_THE_ARCBALL),
    row(Place::Scene, texts::HANDLE_DRAG, texts::TURN_OR_MOVE_BY_ITS_AXIS),
    row(Place::Scene, texts::AXIS_OR_DIGIT_IN_DRAG, texts::LOCK_THE_AXIS_TYPE_THE_NUMBER),
    row(Place::Scene, texts::RIGHT_DRAG, texts::MOVE_IN_THE_VIEWS_PLANE),
    row(Place::Scene, texts::LEFT_DRAG_ON_NOTHING, texts::LOOK_AROUND),
    row(Place::Scene, texts::MIDDLE_DRAG, texts::LOOK_AROUND),
    row(Place::Scene, texts::LEFT_RIGHT_DRAG, texts::MOVE_ALONG_THE_VIEW),
    row(Place::Scene, texts::SPACE_LEFT_DRAG, texts::MOVE_ALONG_THE_VIEW),
    row(Place::Scene, texts::WHEEL, texts::NEARER_OR_FARTHER),
    row(Place::Scene, texts::CLICK, texts::CHOOSE_A_PART),
    row(Place::Scene, texts::DRAG_A_DOT, texts::MOVE_THE_NODE_IN_THAT_KEYFRAME),
    row(Place::Scene, texts::DRAG_A_BALL, texts::REACH_WITH_THAT_HAND_OR_FOOT),
    row(Place::Scene, texts::WHEEL_IN_THAT_DRAG, texts::TURN_THE_ELBOW_OR_KNEE_AROUND),
    row(Place::Timeline, texts::DRAG_ON_THE_RULER, texts::SHOW_THE_POSE_AT_THAT_TIME),
    row(Place::Timeline, texts::CLICK_A_DIAMOND, texts::SELECT_THE_KEYFRAME_SHIFT_AND_CTRL),
    row(Place::Timeline, texts::DRAG_ON_NOTHING, texts::SELECT_WHAT_IS_IN_THE_BOX),
    row(Place::Timeline, texts::DRAG_DIAMONDS, texts::MOVE_THE_SELECTED_KEYFRAMES),
    row(Place::Timeline, texts::DRAG_AN_INTERVALS_END, texts::CHANGE_THE_INTERVALS_DURATION),
    row(Place::Timeline, texts::DOUBLE_CLICK, texts::RENAME_A_KEYFRAME_OR_ADD_A_KEY),
    row(Place::Timeline, texts::RIGHT_CLICK, texts::NAMES_DURATIONS_AND_EASINGS),
    row(Place::Timeline, texts::WHEEL, texts::PAN_WITH_CTRL_ZOOM),
    row(Place::Panels, texts::DRAG_A_NUMBER, texts::CHANGE_IT_A_CLICK_LETS_TYPE_IT),
    row(Place::Panels, texts::DRAG_AN_EDGE, texts::RESIZE_THE_PANEL),
    row(Place::Panels, texts::DOUBLE_CLICK_AN_EDGE, texts::GIVE_THE_PANEL_ITS_USUAL_SIZE),
];
