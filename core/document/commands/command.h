#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/document/commands/list/arc_commands.h"
#include "core/document/commands/list/correction_commands.h"
#include "core/document/commands/list/deformer_commands.h"
#include "core/document/commands/list/face/feature_commands.h"
#include "core/document/commands/list/face_commands.h"
#include "core/document/commands/list/parameter_commands.h"
#include "core/document/commands/list/placed_commands.h"
#include "core/document/commands/list/posing_commands.h"
#include "core/document/commands/list/sound_commands.h"
#include "core/document/commands/list/target_commands.h"
#include "core/document/commands/list/time/bookmark_commands.h"
#include "core/document/commands/list/time/clip_commands.h"
#include "core/document/commands/list/time_commands.h"
#include "core/document/commands/list/view/camera_commands.h"
#include "core/document/commands/list/view/reference_commands.h"

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

/// The types of all commands. No value of this type is made: its members would be compiled wherever a command is used.
using CommandTypes =
    JoinedLists<ParameterCommands, PosingCommands, PlacedCommands, DeformerCommands, TargetCommands, CorrectionCommands,
                TimeCommands, FaceCommands, ArcCommands, SoundCommands, ClipCommands, FeatureCommands, BookmarkCommands,
                CameraCommands, ReferenceCommands>::Type;

template <typename One, typename Types = CommandTypes>
inline constexpr std::size_t k_index_of = static_cast<std::size_t>(-1);
template <typename One, typename... Each>
inline constexpr std::size_t k_index_of<One, std::variant<Each...>> = [] {
  constexpr bool k_same[] = {std::is_same_v<One, Each>...};
  std::size_t i = 0;
  while (i < sizeof...(Each) && !k_same[i]) ++i;
  return i;
}();

template <typename One>
concept OneCommand = k_index_of<One> < std::variant_size_v<CommandTypes>;

/// A value of one of CommandTypes. What copies, compares and frees it is compiled once, in command.cpp;
/// command_visit.h has the visit.
class Command {
 public:
  template <OneCommand One>
  Command(One one)  // NOLINT(google-explicit-constructor): a command is given where one is asked for
      : index_(k_index_of<One>), held_(new One(std::move(one))) {}
  Command(const Command& other);
  Command(Command&& other) noexcept;
  Command& operator=(Command other) noexcept;
  ~Command();

  /// The place of its type in CommandTypes.
  [[nodiscard]] std::size_t index() const { return index_; }
  /// Its members, where it is of this type; else null.
  template <OneCommand One>
  [[nodiscard]] One* get_if() {
    return index_ == k_index_of<One> ? static_cast<One*>(held_) : nullptr;
  }
  template <OneCommand One>
  [[nodiscard]] const One* get_if() const {
    return index_ == k_index_of<One> ? static_cast<const One*>(held_) : nullptr;
  }
  template <OneCommand One>
  [[nodiscard]] bool holds() const {
    return index_ == k_index_of<One>;
  }

  friend bool operator==(const Command& a, const Command& b);

 private:
  std::size_t index_;
  void* held_;  ///< owned; null in what was moved from
};

/// What the command is called.
[[nodiscard]] const Called& called(const Command& command);
[[nodiscard]] inline std::string_view name_of(const Command& command) { return called(command).name; }

}  // namespace penpose::document
