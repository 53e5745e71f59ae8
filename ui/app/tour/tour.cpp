#include "ui/app/tour/tour.h"

#include <algorithm>
#include <utility>

#include "replay/session/session_line.h"

namespace penpose::app {
namespace {

constexpr std::string_view k_ours = "# tour ";
constexpr std::string_view k_path = "tour:";

/// The first word of a text, which is taken from it.
std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

std::optional<Action> action_named(std::string_view name) {
  if (name == "play") return Action::play;
  return std::nullopt;
}

base::Error at_line(std::size_t line, std::string what) {
  return {std::move(what), "line " + std::to_string(line), "make the tour anew with tests/tools/make_tours.py"};
}

}  // namespace

base::Result<Tour> read_tour(std::string_view name, std::string_view session) {
  Tour tour;
  tour.name = name;
  std::string said;
  std::size_t number = 0;
  while (!session.empty()) {
    const std::size_t end = std::min(session.find('\n'), session.size());
    std::string_view line = session.substr(0, end);
    session.remove_prefix(std::min(end + 1, session.size()));
    ++number;
    if (line.starts_with(k_ours)) {
      line.remove_prefix(k_ours.size());
      const std::string_view what = take_word(line);
      if (what == "says") {
        said = line;
      } else if (what == "title") {
        tour.title = line;
      } else if (what == "ends") {
        tour.ends = line;
      } else if (what == "press") {
        const auto action = action_named(take_word(line));
        if (!action) return at_line(number, "there is no action of that name");
        tour.steps.push_back({std::string(line), {}, action});
      } else {
        return at_line(number, "a tour has no line of that name");
      }
      continue;
    }
    if (!line.starts_with('#')) continue;
    auto read = replay::parse_session_line(line);
    if (!read) return read.error();
    if (!*read) continue;
    if (const auto* model = std::get_if<replay::ModelNamed>(&**read)) tour.model = model->path;
    const auto* performed = std::get_if<replay::Performed>(&**read);
    if (performed == nullptr) continue;
    if (said.empty()) return at_line(number, "nothing is said of this command");
    tour.steps.push_back({std::exchange(said, {}), performed->command, {}});
  }
  if (tour.model.empty()) return at_line(number, "a tour names no model");
  if (tour.steps.empty()) return at_line(number, "a tour has no steps");
  return tour;
}

std::optional<std::string> tour_of_path(std::string_view path) {
  if (!path.starts_with(k_path)) return std::nullopt;
  return std::string(path.substr(k_path.size()));
}

}  // namespace penpose::app
