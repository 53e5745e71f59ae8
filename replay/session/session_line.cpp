#include "replay/session/session_line.h"

#include "core/base/edition.h"
#include "core/base/members.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/shown_text.h"
#include "core/document/commands/command_text.h"
#include "core/document/commands/text_members.h"

namespace penpose::replay {
namespace {

using document::take_piece;

constexpr std::string_view k_mark = "penpose";
constexpr std::size_t k_longest_name = 60;

struct HashMember {
  std::string path;
  static auto members(auto& self) { return base::named("path", self.path); }
};
struct LightMembers {
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  static auto members(auto& self) { return base::named("left", self.left, "right", self.right); }
};
struct ProgramMember {
  std::string program;
  static auto members(auto& self) { return base::named("program", self.program); }
};

std::string hex8(std::uint32_t value) {
  std::string out;
  base::append_hex(out, value, 8);
  return out;
}

std::string text_of(const SessionBegins& line) {
  std::string out = "session edition=" + std::to_string(base::k_edition);
  document::append_members(out, ProgramMember{line.program});
  return out;
}
std::string text_of(const ModelNamed& line) {
  std::string out = "model " + line.hash.hex();
  document::append_members(out, HashMember{line.path});
  return out;
}
std::string text_of(const ViewChanged& line) { return "view " + document::to_text(line.view); }
std::string text_of(const ToolChosen& line) {
  const std::string members = drawing::to_text(line.tool);
  return members.empty() ? "tool" : "tool " + members;
}
std::string text_of(const TabletSet& line) {
  std::string out = "tablet " + std::to_string(line.device);
  document::append_members(out, line.setting);
  return out;
}
std::string text_of(const TabletGone& line) { return "gone " + std::to_string(line.device); }
std::string text_of(const LightsSeen& line) {
  std::string out = "lights " + std::to_string(line.device);
  document::append_members(
      out, LightMembers{static_cast<std::uint32_t>(line.lights[0]), static_cast<std::uint32_t>(line.lights[1])});
  return out;
}
std::string text_of(const PenPlace& line) { return line.on_canvas ? "canvas" : "panel"; }
std::string text_of(const Performed& line) { return "do " + document::to_text(line.command); }
std::string text_of(const Undone&) { return "undo"; }
std::string text_of(const Redone&) { return "redo"; }
std::string text_of(const StateReached& line) {
  std::string out = "state " + line.state.whole.hex();
  for (std::size_t i = 0; i < document::k_state_parts.size(); ++i) {
    out += ' ';
    out += document::k_state_parts[i];
    out += '=' + hex8(line.state.parts[i]);
  }
  return out;
}

base::Error malformed(std::string_view what) {
  return {"the line \"" + std::string(what.substr(0, 40)) + "\" of the session has another form", "",
          "record the session again or remove the line"};
}

std::optional<int> read_device(std::string_view text) {
  const auto number = base::parse_uint(text);
  if (!number || *number > 9999) return std::nullopt;
  return static_cast<int>(*number);
}

/// Whether a comment is a line of penpose's own; what it says is left.
bool take_mark(std::string_view& comment) {
  if (!comment.starts_with("# ")) return false;
  comment.remove_prefix(2);
  return take_piece(comment, ' ') == k_mark;
}

using Line = base::Result<std::optional<SessionLine>>;

Line parsed(SessionLine line) { return std::optional(std::move(line)); }

Line parse_state(std::string_view text) {
  StateReached line;
  const auto hash = base::parse_hash(take_piece(text, ' '));
  if (!hash) return malformed("state");
  line.state.whole = *hash;
  for (std::size_t i = 0; i < document::k_state_parts.size(); ++i) {
    std::string_view piece = take_piece(text, ' ');
    const std::string_view name = take_piece(piece, '=');
    const auto value = base::parse_uint(piece, 16);
    if (name != document::k_state_parts[i] || piece.size() != 8 || piece[0] == '+' || !value) return malformed("state");
    line.state.parts[i] = static_cast<std::uint32_t>(*value);
  }
  return parsed(line);
}

/// The edition is 0 where none is said.
SessionOrigin parse_origin(std::string_view text) {
  std::string_view edition = take_piece(text, ' ');
  const bool named = take_piece(edition, '=') == "edition";
  auto members = document::parse_members<ProgramMember>(text);
  return {named ? document::TextForm<std::uint32_t>::read(edition).value_or(0) : 0,
          members ? std::move(members->program) : std::string()};
}

base::Error another_edition(const SessionOrigin& origin) {
  const std::string program =
      origin.program.empty() ? "a program without a name" : base::shown_line(origin.program, k_longest_name);
  std::string what = "the session was recorded by " + program + " under another edition of drawing";
  if (origin.edition == 0) return {what + ", which it does not say", "", "replay it with that program"};
  what += ": " + std::to_string(origin.edition) + ", this program's is " + std::to_string(base::k_edition);
  if (origin.edition > base::k_edition) return {what, "", "take a program as new as that one"};
  return {what, "", "draw it again with today's reading: replay --by-today, or open it in the window"};
}

Line parse_header(std::string_view text) {
  const SessionOrigin origin = parse_origin(text);
  if (origin.edition != base::k_edition) return another_edition(origin);
  static_cast<void>(take_piece(text, ' '));
  auto members = document::parse_members<ProgramMember>(text);
  if (!members) return members.error();
  return parsed(SessionBegins{std::move(members->program)});
}

Line parse_model(std::string_view text) {
  const auto hash = base::parse_hash(take_piece(text, ' '));
  if (!hash) return malformed("model");
  auto members = document::parse_members<HashMember>(text);
  if (!members) return members.error();
  return parsed(ModelNamed{*hash, std::move(members->path)});
}

Line parse_tablet(std::string_view text) {
  const auto device = read_device(take_piece(text, ' '));
  if (!device) return malformed("tablet");
  auto setting = document::parse_members<TabletSetting>(text);
  if (!setting) return setting.error();
  return parsed(TabletSet{*device, std::move(setting).value()});
}

Line parse_lights(std::string_view text) {
  const auto device = read_device(take_piece(text, ' '));
  if (!device) return malformed("lights");
  const auto members = document::parse_members<LightMembers>(text);
  if (!members) return members.error();
  constexpr std::uint32_t k_most = 3;
  if (members->left > k_most || members->right > k_most) return malformed("lights");
  return parsed(
      LightsSeen{*device, {static_cast<std::int8_t>(members->left), static_cast<std::int8_t>(members->right)}});
}

Line parse_what(std::string_view what, std::string_view text) {
  if (what == "session") return parse_header(text);
  if (what == "model") return parse_model(text);
  if (what == "state") return parse_state(text);
  if (what == "tablet") return parse_tablet(text);
  if (what == "lights") return parse_lights(text);
  if (what == "view") {
    const auto view = document::parse_view(text);
    if (!view) return view.error();
    return parsed(ViewChanged{*view});
  }
  if (what == "tool") {
    auto tool = drawing::parse_tool(text);
    if (!tool) return tool.error();
    return parsed(ToolChosen{std::move(tool).value()});
  }
  if (what == "do") {
    auto command = document::parse_command(text);
    if (!command) return command.error();
    return parsed(Performed{std::move(command).value()});
  }
  if (what == "gone") {
    const auto device = read_device(text);
    if (device) return parsed(TabletGone{*device});
  }
  if (text.empty()) {
    if (what == "undo") return parsed(Undone{});
    if (what == "redo") return parsed(Redone{});
    if (what == "canvas" || what == "panel") return parsed(PenPlace{what == "canvas"});
  }
  return malformed(what);
}

}  // namespace

std::string to_text(const SessionLine& line) {
  return std::string(k_mark) + ' ' + std::visit([](const auto& one) { return text_of(one); }, line);
}

base::Result<std::optional<SessionLine>> parse_session_line(std::string_view comment) {
  if (!take_mark(comment)) return std::optional<SessionLine>();
  const std::string_view what = take_piece(comment, ' ');
  return parse_what(what, comment);
}

std::optional<SessionOrigin> session_origin(std::string_view comment) {
  if (!take_mark(comment) || take_piece(comment, ' ') != "session") return std::nullopt;
  SessionOrigin origin = parse_origin(comment);
  if (origin.edition == 0) return std::nullopt;
  return origin;
}

}  // namespace penpose::replay
