#pragma once

#include <string_view>
#include <type_traits>
#include <variant>

#include "core/document/commands/articulation_commands.h"
#include "core/document/commands/posing_commands.h"
#include "core/document/commands/time_commands.h"

// The commands: the only way to change a document. Each is a plain struct with its name in files and, in `fields`, the
// names of its members there. The variant `Command` is the one list of them; text form, application and tests are made
// from it.

namespace penpose::document {

using Command = std::variant<SetParameters, ResetParameters, LockParameters, DrawReference, DrawTarget,
                             OversketchTarget, DragTarget, DrawConstraint, Pin, KeepCurve, DeleteCurve, EraseCurves,
                             ClearCurves, SolvePose, SetPressureWeighting, NameCurve, DeleteNamedCurve, BeginDeformer,
                             SketchCurve, CancelDeformer, RedrawCurve, ChangeDeformer, MirrorDeformer, RenameDeformer,
                             DeleteDeformer, MoveDeformer, SetKey, DeleteKey, MoveKey, SetKeyInterpolation, GoToTime,
                             SaveView, DeleteView, SuggestRest, SetHand, BeginCorrection, DeleteCorrection, TakeRegion,
                             DrawBetween, DeleteBetween, PullBetween, PullTarget, PlaceCurve, PlaceTarget, KeyPoses>;

/// The command's name in files.
[[nodiscard]] inline std::string_view name_of(const Command& command) {
  return std::visit([](const auto& one) { return std::decay_t<decltype(one)>::k_name; }, command);
}

}  // namespace penpose::document
