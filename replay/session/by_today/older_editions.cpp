#include "replay/session/by_today/older_editions.h"

#include <algorithm>
#include <array>

#include "core/base/edition.h"
#include "core/base/members.h"
#include "core/document/commands/text_members.h"
#include "core/document/time/timeline_editing.h"

namespace penpose::replay {
namespace {

using document::Document;
using document::KeyKind;

/// Commands that went, with their members as they were.
struct DeleteKey : document::AtTime {};
struct MoveKey {
  double from_s = 0;
  double to_s = 0;
  static auto members(auto& self) { return base::named("from_s", self.from_s, "to_s", self.to_s); }
};
struct SetKeyInterpolation {
  KeyKind interpolation = KeyKind::smooth;
  static auto members(auto& self) { return base::named("interpolation", self.interpolation); }
};

base::Result<Today> today(const DeleteKey& command, const Document&) {
  return Today{{document::DeleteKeys{{{command.time_s}, {}}}}};
}

/// A whole key went to a free moment. The moment must come out to the bit: where adding the difference does not give
/// it, everything is drawn together around it.
base::Result<Today> today(const MoveKey& command, const Document& now) {
  if (command.from_s != command.to_s && document::key_at(*now.timeline, command.to_s))
    return Today{{}, {}, base::Error{"another key is at that moment", "to_s", "delete it first"}};
  document::MoveKeys moved{{{command.from_s}, {}}};
  moved.by_s = command.to_s - command.from_s;
  if (command.from_s + moved.by_s != command.to_s) {
    constexpr double k_to_nothing = 1e-300;
    moved.by_s = 0;
    moved.about_s = command.to_s;
    moved.scale = k_to_nothing;
  }
  return Today{{moved}};
}

base::Result<Today> today(const SetKeyInterpolation& command, const Document& now) {
  if (command.interpolation != KeyKind::linear && command.interpolation != KeyKind::smooth)
    return base::Error{"the value has another form", "interpolation", "write linear or smooth"};
  Today out{{}, command.interpolation};
  if (auto changed = with_one_kind(*now.timeline, command.interpolation)) out.commands.push_back(*std::move(changed));
  return out;
}

template <typename Command>
base::Result<Today> read(std::string_view members, const Document& now) {
  const auto command = document::parse_members<Command>(members);
  if (!command) return command.error();
  return today(*command, now);
}

struct CommandRow {
  std::uint32_t until;
  std::string_view name;
  base::Result<Today> (*read)(std::string_view members, const Document& now);
};
constexpr std::array<CommandRow, 3> k_commands{{
    {4, "delete_key", read<DeleteKey>},                      // delete_keys: keys of single controls
    {4, "move_key", read<MoveKey>},                          // move_keys
    {4, "set_key_interpolation", read<SetKeyInterpolation>}  // set_key_kind: each key has a kind of its own
}};

/// Timelines of one kind for all keys.
struct KindRow {
  std::uint32_t until;
  KeyKind kind;
};
constexpr std::array<KindRow, 1> k_kinds{{{4, KeyKind::smooth}}};

constexpr std::array<document::HashForm, 1> k_one_kind{{{KeyKind::smooth, false}}};
constexpr std::array<document::HashForm, 1> k_no_moments{{{std::nullopt, false}}};
constexpr std::array<document::HashForm, 2> k_either{{{std::nullopt, false}, {}}};
constexpr std::array<document::HashForm, 1> k_today{{{}}};
struct FormRow {
  std::uint32_t until;
  std::span<const document::HashForm> forms;
};
constexpr std::array<FormRow, 4> k_forms{
    {{4, k_one_kind}, {5, k_no_moments}, {6, k_either}, {base::k_edition, k_today}}};

/// The first row that is true of an edition; null: it is as today.
template <typename Rows>
auto row_of(const Rows& rows, std::uint32_t edition) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return edition <= row.until; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

base::Result<std::optional<Today>> today_of(std::uint32_t edition, std::string_view command, const Document& now) {
  const std::string_view name = document::take_piece(command, ' ');
  for (const CommandRow& row : k_commands) {
    if (row.name != name || edition > row.until) continue;
    auto read = row.read(command, now);
    if (!read) return read.error();
    return std::optional(std::move(read).value());
  }
  return std::optional<Today>();
}

std::optional<KeyKind> one_kind_of(std::uint32_t edition) {
  const KindRow* row = row_of(k_kinds, edition);
  return row == nullptr ? std::nullopt : std::optional(row->kind);
}

std::optional<document::Command> with_one_kind(const document::Timeline& timeline, KeyKind kind) {
  document::SetKeyKind command;
  command.kind = kind;
  for (const document::PoseKey& key : timeline.keys) {
    if (key.controls.usual() && kind == KeyKind::smooth) continue;
    const auto is_of_kind = [&](std::size_t p) { return !key.controls.has(p) || key.controls[p].kind == kind; };
    bool fits = true;
    for (std::size_t p = 0; fits && p < key.pose.size(); ++p) fits = is_of_kind(p);
    if (!fits) command.times_s.push_back(key.time_s);
  }
  if (command.times_s.empty()) return std::nullopt;
  return command;
}

std::span<const document::HashForm> hash_forms_of(std::uint32_t edition) { return row_of(k_forms, edition)->forms; }

}  // namespace penpose::replay
