#include "firmware_io/decode/table/tablet_table.h"

#include <algorithm>
#include <set>

#include "core/base/text/joined.h"
#include "core/base/text/letters.h"
#include "firmware_io/decode/layout/layout_decoder.h"
#include "firmware_io/decode/table/embedded_files.h"
#include "firmware_io/decode/table/tablet_reader.h"

namespace penpose::decode {
namespace {

/// How well an identifier fits. The score weighs conditions that hold, strings most, against those that could not be
/// looked at, so that a tablet which asks for nothing goes before one that asks for something unknown.
struct Fit {
  int score = 0;
  int open = 0;       ///< conditions that could not be looked at
  bool told = false;  ///< a string or the device's name says which tablet it is
};
constexpr int k_met = 2;
constexpr int k_met_exactly = 1;
constexpr int k_met_string = 4;
constexpr int k_met_in_name = 3;
constexpr int k_open = -2;

class Matcher {
 public:
  template <typename Wanted, typename Known, typename Same>
  void condition(const std::optional<Wanted>& wanted, const std::optional<Known>& known, const Same& same) {
    if (!wanted) return;
    if (!known) {
      leave_open();
    } else if (same(*wanted, *known)) {
      add(k_met);
    } else {
      contradicted_ = true;
    }
  }
  void add(int score) { fit_.score += score; }
  void tell(int score) {
    add(score);
    fit_.told = true;
  }
  void leave_open() {
    // How many more conditions are unknown says nothing about which tablet it is.
    if (fit_.open++ == 0) fit_.score += k_open;
  }
  void contradict() { contradicted_ = true; }
  [[nodiscard]] std::optional<Fit> fit() const { return contradicted_ ? std::nullopt : std::optional<Fit>(fit_); }

 private:
  Fit fit_;
  bool contradicted_ = false;
};

std::optional<Fit> fit(const TabletIdentifier& identifier, const DeviceIdentity& device) {
  if (identifier.vendor != device.vendor || identifier.product != device.product) return std::nullopt;
  Matcher match;
  const auto equal = [](int wanted, int known) { return wanted == known; };
  // Some systems count a report id byte even where an interface has no numbered reports.
  const auto equal_length = [](int wanted, int known) { return wanted == known || wanted == known + 1; };
  match.condition(identifier.input_report_length, device.input_report_length, equal_length);
  match.condition(identifier.output_report_length, device.output_report_length, equal_length);
  match.condition(identifier.feature_report_length, device.feature_report_length, equal_length);
  match.condition(identifier.interface_number, device.interface_number, equal);
  if (identifier.input_report_length && device.input_report_length == identifier.input_report_length)
    match.add(k_met_exactly);
  for (const auto& check : identifier.strings) {
    const auto known = device.strings.find(check.index);
    if (known == device.strings.end()) {
      // The name of a device is made of its strings, so a hit in it counts and a miss says nothing.
      match.leave_open();
      if (!device.name.empty() && check.pattern.found_in(device.name)) match.tell(k_met_in_name);
    } else if (check.pattern.found_in(known->second)) {
      match.tell(k_met_string);
    } else {
      match.contradict();
    }
  }
  return match.fit();
}

/// An identifier that the device may be.
struct Candidate {
  const Tablet* tablet = nullptr;
  const TabletIdentifier* identifier = nullptr;
  bool is_pad = false;
  Fit fit;
};

/// Whether a device's name holds a tablet's as a word of its own: "Tablet_H640P" holds "H640P" but not "H640".
bool is_named(const std::string& tablet, const std::string& device) {
  const auto in_word = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  if (tablet.size() < 3) return false;
  for (std::size_t at = device.find(tablet); at != std::string::npos; at = device.find(tablet, at + 1)) {
    const std::size_t end = at + tablet.size();
    if ((at == 0 || !in_word(device[at - 1])) && (end == device.size() || !in_word(device[end]))) return true;
  }
  return false;
}

TabletTable read_embedded() {
  auto tablets = read_tablet_file(embedded_tablets());
  return tablets ? std::move(tablets).value() : TabletTable{};
}

Axis axis_to(std::int32_t maximum, double size_mm) {
  return {.minimum = 0, .maximum = maximum, .units_per_mm = size_mm > 0 ? maximum / size_mm : 0, .present = true};
}

}  // namespace

std::optional<TabletMatch> TabletTable::find(const DeviceIdentity& device) const {
  std::vector<Candidate> candidates;
  const auto look = [&](const Tablet& tablet, const TabletIdentifier& identifier, bool is_pad) {
    auto found = fit(identifier, device);
    if (!found) return;
    if (is_named(tablet.name, device.name)) {
      found->score += k_met_in_name;
      found->told = true;
    }
    // Text of other programs names a tablet as its table does.
    if (device.name == tablet.vendor + ' ' + tablet.name) found->score += k_met_string;
    candidates.push_back({&tablet, &identifier, is_pad, *found});
  };
  for (const auto& tablet : tablets_) {
    for (const auto& identifier : tablet.identifiers) look(tablet, identifier, false);
  }
  for (const auto& tablet : tablets_) {
    for (const auto& identifier : tablet.pads) look(tablet, identifier, true);
  }
  if (candidates.empty()) return std::nullopt;
  const auto top = std::max_element(candidates.begin(), candidates.end(),
                                    [](const Candidate& a, const Candidate& b) { return a.fit.score < b.fit.score; });
  const int best_score = top->fit.score;
  std::set<const Tablet*> possible;
  for (const Candidate& one : candidates) {
    if (!top->fit.told || one.fit.score == best_score) possible.insert(one.tablet);
  }
  std::erase_if(candidates, [best_score](const Candidate& one) { return one.fit.score < best_score; });
  // Of tablets that nothing known tells apart, one that is read as most of them are is most likely read right.
  const auto votes = [&](const Candidate& candidate) {
    return std::count_if(candidates.begin(), candidates.end(), [&](const Candidate& other) {
      return other.identifier->protocol == candidate.identifier->protocol;
    });
  };
  const auto best = std::max_element(candidates.begin(), candidates.end(),
                                     [&](const Candidate& a, const Candidate& b) { return votes(a) < votes(b); });
  const bool contested = std::any_of(candidates.begin(), candidates.end(),
                                     [&](const Candidate& other) { return other.tablet != best->tablet; });
  return TabletMatch{best->tablet, best->identifier, best->is_pad, best->fit.open == 0 && !contested,
                     possible.size() - 1};
}

std::string guess_of(const TabletMatch& match, const DeviceIdentity& device) {
  if (match.others == 0) return {};
  std::string text = "one of " + std::to_string(match.others + 1) + " tablets with the ids ";
  base::append_hex(text, device.vendor, 4);
  text += ':';
  base::append_hex(text, device.product, 4);
  return text + ", read as " + match.tablet->vendor + ' ' + match.tablet->name;
}

base::Result<TabletTable> TabletTable::choose(std::string_view name) const {
  const std::string wanted = base::lower_case(name);
  std::vector<const Tablet*> found;
  std::vector<std::string> alike;
  for (const Tablet& tablet : tablets_) {
    const std::string full = tablet.vendor + ' ' + tablet.name;
    const std::string lower = base::lower_case(full);
    if (lower == wanted || base::lower_case(tablet.name) == wanted) found.push_back(&tablet);
    if (!wanted.empty() && lower.find(wanted) != std::string::npos) alike.push_back(full);
  }
  if (found.size() != 1) {
    const bool none = found.empty();
    for (const Tablet* tablet : found) alike.push_back(tablet->vendor + ' ' + tablet->name);
    std::sort(alike.begin(), alike.end());
    alike.erase(std::unique(alike.begin(), alike.end()), alike.end());
    constexpr std::size_t k_most = 6;
    if (alike.size() > k_most) alike.resize(k_most);
    return base::Error{(none ? "no tablet is named \"" : "several tablets are named \"") + std::string(name) + '"', "",
                       alike.empty() ? "`penpose devices --known` lists them" : "one of " + base::joined(alike, ", ")};
  }
  Tablet chosen = *found.front();
  const auto ask_for_ids_alone = [](std::vector<TabletIdentifier>& identifiers) {
    const bool alike_read = std::all_of(identifiers.begin(), identifiers.end(), [&](const TabletIdentifier& one) {
      return one.protocol == identifiers.front().protocol;
    });
    for (TabletIdentifier& one : identifiers) {
      one.strings.clear();
      if (!alike_read) continue;
      one.input_report_length.reset();
      one.output_report_length.reset();
      one.feature_report_length.reset();
    }
  };
  ask_for_ids_alone(chosen.identifiers);
  ask_for_ids_alone(chosen.pads);
  TabletTable table({std::move(chosen)});
  table.is_choice_ = true;
  return table;
}

const Tablet* TabletTable::only_one(const DeviceIdentity& device) const {
  std::vector<const Tablet*> found;
  for (const Tablet& tablet : tablets_) {
    const bool fits = std::any_of(tablet.identifiers.begin(), tablet.identifiers.end(), [&](const auto& identifier) {
      return identifier.vendor == device.vendor && identifier.product == device.product;
    });
    if (fits) found.push_back(&tablet);
  }
  if (found.size() > 1)
    std::erase_if(found, [&](const Tablet* tablet) { return !is_named(tablet->name, device.name); });
  return found.size() == 1 ? found.front() : nullptr;
}

const TabletTable& known_tablets() {
  static const TabletTable table = read_embedded();
  return table;
}

std::optional<TabletMatch> find_tablet(const DeviceIdentity& device, const TabletTable* own) {
  if (own != nullptr) {
    if (const auto match = own->find(device)) return match;
  }
  return known_tablets().find(device);
}

std::unique_ptr<PenDecoder> make_tablet_decoder(const TabletMatch& match) {
  const Tablet& tablet = *match.tablet;
  PenAxes axes;
  axes.x = axis_to(tablet.max_x, tablet.width_mm);
  axes.y = axis_to(tablet.max_y, tablet.height_mm);
  axes.pressure = axis_to(tablet.max_pressure, 0);
  return std::make_unique<LayoutDecoder>(match.identifier->protocol, axes);
}

}  // namespace penpose::decode
