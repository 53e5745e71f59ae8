#pragma once

#include <span>

#include "core/document/time/timeline.h"
#include "ui/app/action.h"

namespace penpose::app {

/// A kind of keys, as it is chosen.
struct KeyKindInfo {
  document::KeyKind kind;
  const char* name;
  const char* tip;
};
/// Those that a key can have, the usual one first.
[[nodiscard]] std::span<const KeyKindInfo> key_kinds();

/// Actions of keys, of the timeline and of what is played.
[[nodiscard]] std::span<const ActionInfo> time_actions();

}  // namespace penpose::app
