#pragma once

#include <string_view>
#include <type_traits>
#include <variant>

#include "core/document/commands/list/arc_commands.h"
#include "core/document/commands/list/correction_commands.h"
#include "core/document/commands/list/deformer_commands.h"
#include "core/document/commands/list/face_commands.h"
#include "core/document/commands/list/parameter_commands.h"
#include "core/document/commands/list/placed_commands.h"
#include "core/document/commands/list/posing_commands.h"
#include "core/document/commands/list/sound_commands.h"
#include "core/document/commands/list/target_commands.h"
#include "core/document/commands/list/time/clip_commands.h"
#include "core/document/commands/list/time_commands.h"

// The commands: the only way to change a document. Each is a plain struct that says what it is called and, in
// `members`, what its members are called in files, with a function `run` that makes the changed document. A header of
// `list` holds those of one subject and names them at its end; text form, application and tests are made from these
// lists.

namespace penpose::document {

template <typename... Lists>
struct JoinedLists;
template <typename... Each>
struct JoinedLists<std::variant<Each...>> {
  using Type = std::variant<Each...>;
};
template <typename... Some, typename... More, typename... Lists>
struct JoinedLists<std::variant<Some...>, std::variant<More...>, Lists...>
    : JoinedLists<std::variant<Some..., More...>, Lists...> {};

using Command =
    JoinedLists<ParameterCommands, PosingCommands, PlacedCommands, DeformerCommands, TargetCommands, CorrectionCommands,
                TimeCommands, FaceCommands, ArcCommands, SoundCommands, ClipCommands>::Type;

/// What the command is called.
[[nodiscard]] inline const Called& called(const Command& command) {
  return std::visit([](const auto& one) -> const Called& { return std::decay_t<decltype(one)>::k_called; }, command);
}
[[nodiscard]] inline std::string_view name_of(const Command& command) { return called(command).name; }

}  // namespace penpose::document
