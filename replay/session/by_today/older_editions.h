#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/document/document_hash.h"

// What sessions of older editions say otherwise than today's. All differences are rows of the tables in the source:
// a row names the last edition that it is true of. An edition's other lines are today's lines, and members that it did
// not know yet are at their defaults.

namespace penpose::replay {

/// What a command of an older edition is today.
struct Today {
  std::vector<document::Command> commands;     ///< in this order; none: nothing is to be done now
  std::optional<document::KeyKind> keys = {};  ///< all keys are of this kind from now on
  std::optional<base::Error> refused = {};     ///< what it was refused for then; today's command would not be
};

/// The command "NAME MEMBER=VALUE ..." of a session of that edition; nothing where today's form reads it. `now` is what
/// it is done to. Errors: a member of another form.
[[nodiscard]] base::Result<std::optional<Today>> today_of(std::uint32_t edition, std::string_view command,
                                                          const document::Document& now);

/// The kind that all keys of a session of that edition have until it says another; nothing where each has its own.
[[nodiscard]] std::optional<document::KeyKind> one_kind_of(std::uint32_t edition);

/// The command that gives all keys that kind; nothing where they have it.
[[nodiscard]] std::optional<document::Command> with_one_kind(const document::Timeline& timeline,
                                                             document::KeyKind kind);

/// The forms in which sessions of that edition wrote down states: later programs of an edition may say more.
[[nodiscard]] std::span<const document::HashForm> hash_forms_of(std::uint32_t edition);

}  // namespace penpose::replay
