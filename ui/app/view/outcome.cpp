#include "ui/app/view/outcome.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/drawing/editor.h"
#include "ui/app/session/reading_offer.h"

namespace penpose::app {
namespace {

constexpr std::size_t k_named = 3;

std::string why_nothing_moved(EditingSession& editing) {
  const bool restricted = !editing.document().locked.empty();
  if (editing.last_stroke().left_px() < 0) {
    if (const auto& face = editing.document().face; face && !face->lines.empty() && face->lines.back().feature.empty())
      return "the line is not recognised: touch its name to say what it is";
    return restricted ? "no control that may move brings the face nearer to the line: free the others in the panel"
                      : "the face already is near the line, or no control brings it nearer";
  }
  if (editing.last_stroke().within_hand(editing.document(), editing.editor().view().viewport))
    return "the curve already is where the line was drawn";
  const std::vector<std::string> others = words_of_readings(editing.document(), editing.words());
  if (!others.empty()) return "the nearest would be " + others.front();
  return !restricted ? "no control of this model moves the curve towards the line"
                     : "no unlocked control moves the curve towards the line: unlock some in the panel";
}

std::string number(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// "smile, left at its limit"; several: "jaw opens; smile, left at their limits".
std::string at_limits(EditingSession& editing, const std::vector<Movement>& movements) {
  std::string names;
  std::size_t count = 0;
  for (const Movement& one : movements) {
    if (!one.at_limit) continue;
    if (++count <= k_named) names += (count > 1 ? "; " : "") + editing.words_of(one.name);
  }
  if (count == 0) return {};
  if (count > k_named) names += " and " + std::to_string(count - k_named) + " more";
  return names + (count > 1 ? " at their limits" : " at its limit");
}

std::string moved_text(EditingSession& editing, const std::vector<Movement>& movements) {
  std::string text = "Moved ";
  for (std::size_t i = 0; i < std::min(k_named, movements.size()); ++i) {
    text += (i == 0 ? "" : "; ") + editing.words_of(movements[i].name) + " " + number("%+.2f", movements[i].by);
  }
  if (movements.size() > k_named) text += " and " + std::to_string(movements.size() - k_named) + " more";
  return text;
}

}  // namespace

std::string outcome_of(EditingSession& editing) {
  if (const std::string said = editing.last_stroke().text(); !said.empty()) return said;
  const auto& movements = editing.last_stroke().movements();
  const auto& face = editing.document().face;
  const LastStroke& last = editing.last_stroke();
  const bool nothing_moved = movements.empty() && (last.is_newest() || (face && last.is_fresh()));
  const bool drawn = !editing.document().curves.empty() || face;
  if ((movements.empty() && !nothing_moved) || !drawn ||
      editing.editor().tool().kind == drawing::ToolKind::articulate) {
    return {};
  }
  if (nothing_moved) return "Nothing moved: " + why_nothing_moved(editing);
  // What is left comes first: it is what one acts on.
  std::string text;
  if (const double left = editing.last_stroke().left_px(); left >= 0) text = number("%.1f px left", left);
  if (const std::string limits = at_limits(editing, movements); !limits.empty())
    text += (text.empty() ? "" : ", ") + limits;
  return text + (text.empty() ? "" : "   |   ") + moved_text(editing, movements);
}

}  // namespace penpose::app
