#include "core/document/commands/list/reading_commands.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/apply_parts.h"
#include "core/document/drawing/moment.h"
#include "core/inference/weights.h"

namespace penpose::document {
namespace {

/// Remembers that one reading was taken in place of another, from a pose before both. What was chosen the other way
/// round before is forgotten.
void remember(Document& document, const rig::Pose& other, const Moment::Other& taken_one, const rig::Pose& base) {
  const rig::Pose& taken = taken_one.pose;
  const auto parameters = document.model->rig->parameters();
  TakenReading choice;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool by_taken = taken[i] != base[i];
    const bool by_other = other[i] != base[i];
    if (by_taken && !by_other) choice.taken.push_back(parameters[i].name);
    if (by_other && !by_taken) choice.instead_of.push_back(parameters[i].name);
  }
  if (choice.taken.empty() && choice.instead_of.empty()) return;
  std::vector<TakenReading> all = document.taken ? *document.taken : std::vector<TakenReading>();
  const auto between = [&](const TakenReading& one) {
    return (one.taken == choice.taken && one.instead_of == choice.instead_of) ||
           (one.taken == choice.instead_of && one.instead_of == choice.taken);
  };
  std::erase_if(all, between);
  choice.by = std::min(k_most_taught, std::max(0.0, taken_one.above) + inference::learned_weights().taught_margin);
  all.push_back(std::move(choice));
  if (all.size() > k_most_taken) all.erase(all.begin());
  document.taken = std::make_shared<const std::vector<TakenReading>>(std::move(all));
}

}  // namespace

Changed run(const Document& document, const TakeReading& command, Parts&) {
  const std::shared_ptr<const Moment>& now = document.moment;
  if (!is_last_line(document, command.curve))
    return base::Error{"no line was just drawn for that curve", "curve", "draw where it goes again"};
  if (command.which >= now->others.size()) {
    const std::string count = std::to_string(now->others.size());
    return base::Error{"the line has " + count + " other readings", "which", "give a number below " + count};
  }
  Document changed = document;
  changed.pose = pose_of_reading(document, command.which);
  Moment moment = *now;
  Moment::Other& other = moment.others[command.which];
  remember(changed, now->posed, other, now->base);
  std::swap(moment.posed, other.pose);
  std::swap(moment.probability, other.probability);
  other.above = -other.above;
  changed.moment = std::make_shared<const Moment>(std::move(moment));
  return changed;
}

}  // namespace penpose::document
