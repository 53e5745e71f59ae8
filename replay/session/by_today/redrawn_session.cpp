#include "replay/session/by_today/redrawn_session.h"

#include "core/base/edition.h"

namespace penpose::replay {
namespace {

constexpr std::array<std::string_view, 4> k_names{"equal", "different", "not drawn", "not compared"};

std::string joined(const std::vector<std::string_view>& parts) {
  std::string out;
  for (const std::string_view part : parts) {
    if (!out.empty()) out += ", ";
    out += part;
  }
  return out;
}

}  // namespace

std::string_view name_of(CameOut how) { return k_names[static_cast<std::size_t>(how)]; }

std::string text_of(const RedrawnStep& step) {
  if (step.came_out == CameOut::equal) return {};
  std::string out = step.what;
  if (step.stroke > 0) out += ' ' + std::to_string(step.stroke);
  out += " (line " + std::to_string(step.line) + "): ";
  if (step.came_out == CameOut::not_drawn) return out + "could not be drawn: " + step.reason;
  if (step.came_out == CameOut::not_compared) {
    if (!step.reason.empty()) out += "changes nothing today (" + step.reason + "); ";
    return out + "the session has no state after it to compare with";
  }
  if (step.parts.empty()) return out + "the hash as a whole differs";
  out += "different in " + joined(step.parts);
  if (step.since.empty()) return out + ", as before it";
  if (step.since != step.parts) out += "; newly in " + joined(step.since);
  return out;
}

std::string summary_of(const RedrawnSession& redrawn) {
  std::size_t all = 0;
  for (const std::size_t count : redrawn.counts) all += count;
  std::string out = "drawn in edition " + std::to_string(redrawn.edition) + ", read by edition " +
                    std::to_string(base::k_edition) + ": of " + std::to_string(all) +
                    (all == 1 ? " step " : " steps ") + std::to_string(redrawn.count(CameOut::equal)) +
                    " came out as recorded, " + std::to_string(redrawn.count(CameOut::differently)) + " differently, " +
                    std::to_string(redrawn.count(CameOut::not_drawn)) + " could not be drawn";
  if (const std::size_t unknown = redrawn.count(CameOut::not_compared); unknown > 0)
    out += ", " + std::to_string(unknown) + " cannot be compared";
  return out;
}

}  // namespace penpose::replay
