#pragma once

#include <string>

#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// What came of the last stroke, in one line: what moved and by how much, what is left of the way and which controls
/// can go no further. Empty: there is nothing to say.
[[nodiscard]] std::string outcome_of(EditingSession& editing);

}  // namespace penpose::app
