#include "core/io/tracks/values/bare_values.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/arkit/arkit_names.h"

namespace penpose::io {

std::vector<std::string> usual_names(std::size_t count) {
  if (count != 51 && count != 52 && count != 55 && count != 61) return {};
  std::vector<std::string> names;
  for (const std::string_view name : k_arkit_shapes) {
    // Live Link Face has right before left here, Apple has not.
    const bool right = name == "JawRight" || name == "MouthRight";
    const bool left = name == "JawLeft" || name == "MouthLeft";
    std::string own(name);
    if (right) own.replace(own.size() - 5, 5, "Left");
    if (left) own.replace(own.size() - 4, 4, "Right");
    own[0] = base::lower(own[0]);
    if (own == "tongueOut" && count == 51) continue;
    names.push_back(std::move(own));
  }
  if (count == 55) names.insert(names.end(), {"headRoll", "leftEyeRoll", "rightEyeRoll"});
  if (count == 61) names.insert(names.end(), k_arkit_turns.begin(), k_arkit_turns.end());
  return names;
}

std::string usual_names_note(std::size_t count) {
  const char* more = count == 51   ? ", without tongueOut"
                     : count == 55 ? ", and headRoll, leftEyeRoll and rightEyeRoll, as Azure sends them"
                     : count == 61 ? ", and the turns of the head and the eyes"
                                   : "";
  return "its " + std::to_string(count) +
         " numbers a frame have no names: they are taken as ARKit's shapes in Apple's order" + more;
}

std::size_t first_numbers(std::string_view json) {
  constexpr std::size_t k_beginning = 1 << 16;
  json = json.substr(0, k_beginning);
  for (std::size_t open = json.find('['); open != std::string_view::npos; open = json.find('[', open + 1)) {
    const std::size_t close = json.find_first_of("[]{}\"", open + 1);
    if (close == std::string_view::npos || json[close] != ']') continue;
    const std::string_view list = json.substr(open + 1, close - open - 1);
    if (list.find_first_of("0123456789") == std::string_view::npos) continue;
    return 1 + static_cast<std::size_t>(std::count(list.begin(), list.end(), ','));
  }
  return 0;
}

BareTable bare_table(std::string_view text) {
  constexpr std::size_t k_looked_at = 50;
  auto table = CsvReader::open_bare(text.substr(0, std::size_t{1} << 17U), {});
  if (!table) return {};
  std::vector<std::string_view> cells;
  std::size_t count = 0, rows = 0;
  std::optional<double> before;
  bool grows = true;
  while (rows < k_looked_at && table->next(cells)) {
    // The sampled text may end in the middle of a row.
    if (rows > 0 && cells.size() != count) break;
    count = cells.size();
    for (const std::string_view cell : cells) {
      if (!table->number(cell) && !is_hole(cell)) return {};
    }
    const auto first = table->number(cells[0]);
    grows = grows && first && (!before || *first > *before);
    before = first;
    ++rows;
  }
  const bool plain = !usual_names(count).empty();
  const bool with_time = count > 0 && !usual_names(count - 1).empty();
  if (with_time && (!plain || (rows > 2 && grows))) return {true, count - 1};
  return {false, plain ? count : 0};
}

bool is_hole(std::string_view cell) {
  constexpr std::array<std::string_view, 6> k_holes{"", "none", "null", "na", "n/a", "-"};
  const std::string_view bare = base::trim(cell);
  return std::any_of(k_holes.begin(), k_holes.end(),
                     [&](std::string_view one) { return base::same_but_case(one, bare); });
}

}  // namespace penpose::io
