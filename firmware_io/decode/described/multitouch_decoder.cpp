#include "firmware_io/decode/described/multitouch_decoder.h"

#include <algorithm>

namespace penpose::decode {
namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::ReportType;
using hid::Usage;

/// Feature reports with which devices show that they were certified for Windows 8.
constexpr Usage k_certificate = hid::usage(0xff00, 0xc5);
constexpr Usage k_certificate_status = hid::usage(0xff00, 0xc6);

constexpr unsigned k_default_contacts = 10;
constexpr std::int64_t k_most_contacts = 250;

bool is_certified(const ReportDescriptor& descriptor) {
  return std::any_of(descriptor.fields.begin(), descriptor.fields.end(), [](const Field& field) {
    if (field.type != ReportType::feature || field.bit_size != 8 || field.usages.empty()) return false;
    return (field.usage_of(0) == k_certificate && field.count == 256) ||
           (field.usage_of(0) == k_certificate_status && field.count == 1);
  });
}

unsigned most_contacts(const ReportDescriptor& descriptor) {
  unsigned contacts = 0;
  for (const Field& field : descriptor.fields) {
    if (field.type != ReportType::feature) continue;
    for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field.usage_count(), k_most_controls_of_field); ++i) {
      if (field.usage_of(i) == hid::k_contact_max && field.logical_maximum > 0 &&
          field.logical_maximum <= k_most_contacts)
        contacts = static_cast<unsigned>(field.logical_maximum);
    }
  }
  return contacts == 0 ? k_default_contacts : contacts;
}

class Finder {
 public:
  explicit Finder(const ReportDescriptor& descriptor) : descriptor_(descriptor) {}
  std::optional<MultitouchLayout> run();

 private:
  [[nodiscard]] bool has_contacts(std::uint8_t id) const;
  MultitouchApplication& application_of(const Field& field);
  void add(MultitouchApplication& to, const Field& field, std::uint32_t index);
  static void store(MultitouchApplication& to, std::optional<DescribedControl> MultitouchFinger::*where,
                    const Field& field, std::uint32_t index);

  const ReportDescriptor& descriptor_;
  MultitouchLayout layout_;
};

/// Whether a report numbers fingers. Certified devices put each into a collection of its own.
bool Finder::has_contacts(std::uint8_t id) const {
  return std::any_of(descriptor_.fields.begin(), descriptor_.fields.end(), [&](const Field& field) {
    if (field.type != ReportType::input || field.report_id != id || !field.is_variable() || field.usages.empty())
      return false;
    if (layout_.certified && descriptor_.enclosing(field, hid::k_collection_logical) != hid::k_finger) return false;
    for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field.count, k_most_controls_of_field); ++i) {
      if (field.usage_of(i) == hid::k_contact_id) return true;
    }
    return false;
  });
}

MultitouchApplication& Finder::application_of(const Field& field) {
  const Usage usage = descriptor_.enclosing(field, hid::k_collection_application);
  auto found = std::find_if(layout_.applications.begin(), layout_.applications.end(),
                            [&](const MultitouchApplication& one) { return one.usage == usage; });
  if (found == layout_.applications.end()) {
    layout_.applications.emplace_back();
    found = layout_.applications.end() - 1;
    found->usage = usage;
  }
  if (std::find(found->report_ids.begin(), found->report_ids.end(), field.report_id) == found->report_ids.end())
    found->report_ids.push_back(field.report_id);
  return *found;
}

/// A usage that the last finger has already begins the next one.
void Finder::store(MultitouchApplication& to, std::optional<DescribedControl> MultitouchFinger::*where,
                   const Field& field, std::uint32_t index) {
  if (to.fingers.empty()) to.fingers.emplace_back();
  if (to.fingers.back().*where) {
    const MultitouchFinger& last = to.fingers.back();
    if (!last.id || !last.x || !last.y || to.fingers.size() >= k_most_contacts) return;
    to.fingers.emplace_back();
  }
  to.fingers.back().*where = DescribedControl(field, index);
  to.fingers.back().report_id = field.report_id;
}

void Finder::add(MultitouchApplication& to, const Field& field, std::uint32_t index) {
  const Usage usage = field.usage_of(index);
  // The second of two equal coordinates is the middle of the finger rather than where it touches.
  const bool repeated = index > 0 && field.usage_of(index - 1) == usage;
  const auto axis = [&] {
    return Axis{static_cast<std::int32_t>(field.logical_minimum), static_cast<std::int32_t>(field.logical_maximum),
                hid::units_per_mm(field), true};
  };
  switch (usage) {
    case hid::k_x:
      if (repeated) return;
      if (!layout_.axes.x.present) layout_.axes.x = axis();
      return store(to, &MultitouchFinger::x, field, index);
    case hid::k_y:
      if (repeated) return;
      if (!layout_.axes.y.present) layout_.axes.y = axis();
      return store(to, &MultitouchFinger::y, field, index);
    case hid::k_in_range:
      return store(to, &MultitouchFinger::in_range, field, index);
    case hid::k_confidence:
      return store(to, &MultitouchFinger::confidence, field, index);
    case hid::k_tip_switch:
      return store(to, &MultitouchFinger::tip, field, index);
    case hid::k_contact_id:
      return store(to, &MultitouchFinger::id, field, index);
    case hid::k_contact_count:
      to.count = DescribedControl(field, index);
      to.count_report = field.report_id;
      return;
    case hid::k_scan_time:
      to.scan_time = DescribedControl(field, index);
      to.scan_time_report = field.report_id;
      return;
    default:
      return;
  }
}

std::optional<MultitouchLayout> Finder::run() {
  layout_.has_report_ids = descriptor_.has_report_ids;
  layout_.certified = is_certified(descriptor_);
  layout_.axes.contacts = most_contacts(descriptor_);
  for (const Field* field : fields_by_report(descriptor_, ReportType::input)) {
    if (field->is_constant() || field->bit_size == 0 || field->bit_size > 32 || !has_contacts(field->report_id))
      continue;
    const std::uint8_t id = field->report_id;
    layout_.report_length[id] = descriptor_.report_length(ReportType::input, id);
    MultitouchApplication& application = application_of(*field);
    if (application.usage == hid::k_touch_screen) layout_.axes.on_screen = true;
    for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field->count, k_most_controls_of_field); ++i)
      add(application, *field, i);
  }
  std::erase_if(layout_.applications, [](const MultitouchApplication& one) { return one.fingers.empty(); });
  if (layout_.applications.empty() || !layout_.axes.x.present || !layout_.axes.y.present) return std::nullopt;
  return std::move(layout_);
}

}  // namespace

std::optional<MultitouchLayout> find_multitouch(const ReportDescriptor& descriptor) { return Finder(descriptor).run(); }

MultitouchDecoder::MultitouchDecoder(MultitouchLayout layout)
    : TouchDecoder(layout.axes),
      layout_(std::move(layout)),
      states_(layout_.applications.size()),
      palms_(layout_.axes.contacts) {
  for (std::size_t i = 0; i < states_.size(); ++i) states_[i].fingers.resize(layout_.applications[i].fingers.size());
}

void MultitouchDecoder::reset() {
  TouchDecoder::reset();
  std::fill(palms_.begin(), palms_.end(), false);
  for (State& state : states_) {
    const std::size_t fingers = state.fingers.size();
    state = {};
    state.fingers.resize(fingers);
  }
}

bool MultitouchDecoder::decode(base::Bytes report) {
  if (report.empty()) return false;
  const std::uint8_t id = layout_.has_report_ids ? report[0] : 0;
  if (layout_.report_length[id] == 0 || report.size() < layout_.report_length[id]) return false;
  bool ended = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const MultitouchApplication& application = layout_.applications[i];
    const auto& ids = application.report_ids;
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) continue;
    read(application, states_[i], id, report);
    ended = decode_application(application, states_[i]) || ended;
  }
  return ended;
}

void MultitouchDecoder::read(const MultitouchApplication& layout, State& state, std::uint8_t id,
                             base::Bytes report) const {
  if (layout.count && layout.count_report == id) state.count = layout.count->value(report);
  if (layout.scan_time && layout.scan_time_report == id) state.scan_time = layout.scan_time->value(report);
  for (std::size_t i = 0; i < layout.fingers.size(); ++i) {
    const MultitouchFinger& from = layout.fingers[i];
    if (from.report_id != id) continue;
    ReportedFinger& to = state.fingers[i];
    const auto number = [&](const std::optional<DescribedControl>& control, std::int32_t& into) {
      if (control) into = static_cast<std::int32_t>(control->value(report));
    };
    const auto flag = [&](const std::optional<DescribedControl>& control, bool& into) {
      if (control) into = (control->value(report) & 0xff) != 0;
    };
    number(from.id, to.id);
    number(from.x, to.x);
    number(from.y, to.y);
    flag(from.tip, to.tip);
    flag(from.in_range, to.in_range);
    flag(from.confidence, to.confident);
  }
}

bool MultitouchDecoder::decode_application(const MultitouchApplication& layout, State& state) {
  if (layout.count) {
    // Reports that carry a frame on say 0; so does a first one that brings no finger, but at another time.
    const bool new_time = layout_.certified && state.received == 0 && state.last_scan_time != state.scan_time;
    if (state.count >= 0 && (new_time || state.count != 0)) state.expected = state.count;
  }
  state.last_scan_time = state.scan_time;
  for (const ReportedFinger& finger : state.fingers) {
    if (take(layout, state, finger)) ++state.received;
  }
  if (state.received < state.expected) return false;
  slots_.end_frame();
  slots_.publish();
  bool lifted = false;
  for (std::size_t i = 0; i < palms_.size(); ++i) {
    if (!palms_[i]) continue;
    palms_[i] = false;
    slots_.set(i, false);
    lifted = true;
  }
  if (lifted) {
    slots_.end_frame();
    slots_.publish();
  }
  state.received = 0;
  return true;
}

bool MultitouchDecoder::take(const MultitouchApplication& layout, const State& state, const ReportedFinger& finger) {
  // Where reports have room for one finger only, or are not counted, it is believed always.
  const bool counted = layout.count.has_value() && layout.fingers.size() > 1;
  if (counted && state.received >= state.expected) return false;
  const auto slot = slots_.slot_of(finger.id);
  if (!slot) return true;
  if (layout_.certified && slots_.is_active(*slot) && slots_.is_used(*slot)) return false;
  bool active = finger.tip || (layout_.certified && finger.in_range);
  const bool palm = layout_.certified && !finger.confident &&
                    (layout.usage == hid::k_touch_screen || layout.usage == hid::k_touch_pad);
  if (palm && !active && slots_.is_active(*slot)) {
    active = true;
    palms_[*slot] = true;
  }
  slots_.set(*slot, active);
  if (active) slots_.move(*slot, finger.x, finger.y);
  return true;
}

}  // namespace penpose::decode
