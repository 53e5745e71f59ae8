#pragma once

namespace penpose::app {

class EditingSession;
class Notices;

/// What is drawn of the face is the face at rest as this hand draws it; where nothing is drawn, that is forgotten. Says
/// which.
void keep_neutral(EditingSession& editing, Notices& notices);

}  // namespace penpose::app
