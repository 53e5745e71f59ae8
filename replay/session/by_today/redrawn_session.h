#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::replay {

/// How a step of a session came out when it was drawn again.
enum class CameOut : std::uint8_t {
  equal,         ///< the document is what was recorded after the step
  differently,   ///< it is another
  not_drawn,     ///< the step changes nothing today, or cannot be expressed, and changed something then
  not_compared,  ///< the session has no state after it
};

struct RedrawnStep {
  std::uint64_t line = 0;  ///< of the session, from 1: where the stroke ended, or the command
  std::string what;        ///< "stroke", the name of a command, "undo" or "redo"
  std::size_t stroke = 0;  ///< its number among the steps that are strokes, from 1; 0: it is none
  CameOut came_out = CameOut::not_compared;
  std::vector<std::string_view> parts = {};  ///< that differ (document::k_state_parts)
  std::vector<std::string_view> since = {};  ///< of these, those that did not differ after the step before
  std::string reason = {};                   ///< why it changes nothing today, where it may have then
};

/// A session that was drawn again with today's reading.
struct RedrawnSession {
  std::uint32_t edition = 0;  ///< that it was recorded under
  bool other_model = false;   ///< what it was drawn on was in another state then
  std::size_t strokes = 0;    ///< steps that are strokes
  std::array<std::size_t, 4> counts{};
  std::vector<RedrawnStep> steps;  ///< in order, the first k_most_redrawn
  [[nodiscard]] std::size_t count(CameOut how) const { return counts[static_cast<std::size_t>(how)]; }
};
inline constexpr std::size_t k_most_redrawn = 100'000;

/// "equal", "different", "not drawn", "not compared".
[[nodiscard]] std::string_view name_of(CameOut how);
/// "stroke 3 (line 120): parameters and curves differ", for people; empty for a step that came out as recorded.
[[nodiscard]] std::string text_of(const RedrawnStep& step);
/// "drawn in edition 3, read by edition 7: of 30 steps 12 came out as recorded, 17 differently, 1 could not be drawn",
/// for people.
[[nodiscard]] std::string summary_of(const RedrawnSession& redrawn);

}  // namespace penpose::replay
