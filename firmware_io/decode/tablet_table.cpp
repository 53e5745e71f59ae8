#include "firmware_io/decode/tablet_table.h"

#include "firmware_io/decode/embedded_files.h"
#include "firmware_io/decode/layout_decoder.h"
#include "firmware_io/decode/tablet_reader.h"

namespace penpose::decode {
namespace {

/// How well an identifier fits: `met` conditions hold, `open` ones could not be looked at. Nothing: something
/// contradicts.
struct Fit {
  int met = 0;
  int open = 0;
};

class Matcher {
 public:
  template <typename Wanted, typename Known, typename Same>
  void condition(const std::optional<Wanted>& wanted, const std::optional<Known>& known, const Same& same) {
    if (!wanted) return;
    if (!known) {
      ++fit_.open;
    } else if (same(*wanted, *known)) {
      fit_.met += 2;
    } else {
      contradicted_ = true;
    }
  }
  void add(int met, int open) {
    fit_.met += met;
    fit_.open += open;
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
  if (identifier.input_report_length && device.input_report_length == identifier.input_report_length) match.add(1, 0);
  for (const auto& check : identifier.strings) {
    const auto known = device.strings.find(check.index);
    if (known == device.strings.end()) {
      // The name of a device is made of its strings, so a hit in it counts a little and a miss nothing.
      match.add(check.pattern.found_in(device.name) ? 1 : 0, 1);
    } else if (check.pattern.found_in(known->second)) {
      match.add(2, 0);
    } else {
      match.contradict();
    }
  }
  return match.fit();
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
  std::optional<TabletMatch> best;
  Fit best_fit;
  bool contested = false;
  const auto look = [&](const Tablet& tablet, const TabletIdentifier& identifier, bool is_pad) {
    const auto found = fit(identifier, device);
    if (!found) return;
    const bool as_good = best && found->met == best_fit.met && found->open == best_fit.open;
    if (best && (found->met < best_fit.met || (found->met == best_fit.met && found->open >= best_fit.open))) {
      contested = contested || (as_good && best->tablet != &tablet);
      return;
    }
    best = TabletMatch{&tablet, &identifier, is_pad, false};
    best_fit = *found;
    contested = false;
  };
  for (const auto& tablet : tablets_) {
    for (const auto& identifier : tablet.identifiers) look(tablet, identifier, false);
  }
  for (const auto& tablet : tablets_) {
    for (const auto& identifier : tablet.pads) look(tablet, identifier, true);
  }
  if (best) best->certain = best_fit.open == 0 && !contested;
  return best;
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
