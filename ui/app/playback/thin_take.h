#pragma once

#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/intent/model/control_fields.h"

namespace penpose::app {

/// How far a control's curve may be off on the screen, px.
inline constexpr double k_take_px = 0.5;

/// A take with the few keys that it needs: with what the timeline has, no vertex of the model is off at any frame by
/// more than k_take_px of the view. Its first and last moment stay. `all`: the take frame by frame. Precondition: the
/// fields are those of the document's rig.
[[nodiscard]] document::KeyPoses thinned(const document::Document& document, const document::KeyPoses& all,
                                         const intent::ControlFields& fields, const document::View& view);

}  // namespace penpose::app
