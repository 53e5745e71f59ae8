#include "ui/app/controls/restriction.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace penpose::app {
namespace {

using Names = std::vector<std::string>;

constexpr std::size_t k_most_made = 32;

Names sorted(Names names) {
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

/// Names of one ascending list that are not in another one.
Names less(const Names& names, const Names& taken) {
  Names out;
  std::set_difference(names.begin(), names.end(), taken.begin(), taken.end(), std::back_inserter(out));
  return out;
}

/// Names that are in both of two ascending lists.
Names common(const Names& a, const Names& b) {
  Names out;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

Names all_controls(const document::Document& document) {
  Names names;
  for (const rig::Parameter& parameter : document.model->rig->parameters()) names.push_back(parameter.name);
  return sorted(std::move(names));
}

}  // namespace

const Restriction::Made* Restriction::on() const {
  const Made* best = nullptr;
  double most = 0.5;
  for (const Made& one : made_) {
    const std::size_t held = common(one.locked, editing_.document().locked).size();
    const double share = static_cast<double>(held) / static_cast<double>(one.locked.size());
    // The newest of those that fit alike.
    if (share < most || held == 0) continue;
    most = share;
    best = &one;
  }
  return best;
}

Names Restriction::own_locks() const {
  const Made* now = on();
  return now != nullptr ? less(editing_.document().locked, now->locked) : editing_.document().locked;
}

std::string Restriction::words() const {
  if (const Made* now = on()) return now->words;
  const document::Document& document = editing_.document();
  const std::size_t all = document.model->rig->parameters().size();
  if (2 * document.locked.size() <= all) return {};
  const std::size_t left = all - document.locked.size();
  return "Only " + std::to_string(left) + (left == 1 ? " control" : " controls");
}

bool Restriction::is_only(const Names& names) const {
  return on() != nullptr &&
         less(all_controls(editing_.document()), editing_.document().locked) == less(sorted(names), own_locks());
}

void Restriction::hold(const Names& names, const std::string& words) {
  const Names own = own_locks();
  const Names locked = less(sorted(names), own);
  const Names now = less(editing_.document().locked, own);
  const Names lock = less(locked, now);
  const Names free = less(now, locked);
  if (lock.empty() && free.empty()) return;
  editing_.shown().preview(std::nullopt);
  if (!lock.empty() && !editing_.perform(document::LockParameters{lock, true})) return;
  const document::LockParameters freed{free, false};
  if (!free.empty() && !(lock.empty() ? editing_.perform(freed) : editing_.perform_with(freed))) return;
  if (locked.empty()) return;
  if (made_.size() == k_most_made) made_.erase(made_.begin());
  made_.push_back({words, locked});
}

void Restriction::only(const Names& names, const std::string& words) {
  const Names all = all_controls(editing_.document());
  const Names chosen = common(all, sorted(names));
  if (less(chosen, own_locks()).empty())
    return notices_.tell(chosen.empty() ? "There are no such controls: select some in the sheet, or draw a line first"
                                        : "All of these are locked: free one first");
  if (chosen == all) return lift();
  hold(less(all, chosen), "Only " + words);
}

void Restriction::without(const Names& names, const std::string& words) {
  const Names all = all_controls(editing_.document());
  const Names chosen = common(all, sorted(names));
  if (chosen.empty())
    return notices_.tell("There are no such controls: select some in the sheet, or draw a line first");
  if (chosen == all) return notices_.tell("These are all controls: nothing would move any more");
  hold(chosen, "Not " + words);
}

void Restriction::lift() {
  const Made* now = on();
  const Names names = now != nullptr ? common(now->locked, editing_.document().locked) : editing_.document().locked;
  if (names.empty()) return notices_.tell("All controls may move already");
  editing_.perform(document::LockParameters{names, false});
}

}  // namespace penpose::app
