#include "firmware_io/decode/wacom/hand/wacom_generic_touch_decoder.h"

#include <algorithm>
#include <utility>

#include "firmware_io/decode/wacom/wacom_usages.h"

namespace penpose::decode {
namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::Usage;

/// Room for fingers where the tablet has to be asked for it, which a decoder cannot.
constexpr unsigned k_generic_contacts = 16;

FingerRole touch_role_of(Usage usage) {
  constexpr std::pair<Usage, FingerRole> k_roles[] = {{hid::k_x, FingerRole::x},
                                                      {hid::k_y, FingerRole::y},
                                                      {hid::k_contact_id, FingerRole::id},
                                                      {hid::k_tip_switch, FingerRole::tip},
                                                      {hid::k_confidence, FingerRole::confidence},
                                                      {k_fingers_valid, FingerRole::valid}};
  for (const auto& [known, role] : k_roles) {
    if (known == usage) return role;
  }
  return FingerRole::other;
}

/// Usages of which the last that a report has tells that all was said of a finger.
bool may_end_finger(Usage usage) {
  switch (usage) {
    case hid::k_x:
    case hid::k_y:
    case hid::k_contact_width:
    case hid::k_contact_height:
    case hid::k_contact_id:
    case hid::k_in_range:
    case hid::k_invert:
    case hid::k_tip_switch:
      return true;
    default:
      return false;
  }
}

bool touch_has_usage(const Field& field, Usage wanted) {
  for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field.usage_count(), k_most_controls_of_field); ++i) {
    if (standard_usage(field.usage_of(i)) == wanted) return true;
  }
  return false;
}

void note_axis(TouchAxes& axes, Usage usage, const Field& field) {
  Axis& axis = usage == hid::k_x ? axes.x : axes.y;
  if (axis.present || (usage != hid::k_x && usage != hid::k_y)) return;
  axis = {static_cast<std::int32_t>(field.logical_minimum), static_cast<std::int32_t>(field.logical_maximum),
          hid::units_per_mm(field), true};
}

/// All fields of one report, in order, of which some are of fingers.
std::optional<FingerReport> read_report(const ReportDescriptor& descriptor, const std::vector<const Field*>& fields,
                                        TouchAxes& axes) {
  FingerReport report;
  Usage last = 0;
  for (const Field* field : fields) {
    for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field->count, k_most_controls_of_field); ++i) {
      const Usage usage = standard_usage(field->usage_of(i));
      if (may_end_finger(usage)) last = usage;
      if (usage == hid::k_contact_count) report.count = DescribedControl(*field, i);
    }
  }
  std::int32_t group = -1;
  for (const Field* field : fields) {
    const bool finger = field->is_variable() && field->bit_size > 0 && field->bit_size <= 32 &&
                        is_wacom_finger(descriptor, *field) && !is_wacom_pad(descriptor, *field) &&
                        !is_wacom_pen(descriptor, *field);
    if (!finger) continue;
    if (group != field->collection && !report.controls.empty()) report.controls.back().ends_group = true;
    group = field->collection;
    for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field->count, k_most_controls_of_field); ++i) {
      const Usage usage = standard_usage(field->usage_of(i));
      FingerControl control;
      control.role = touch_role_of(usage);
      control.ends_finger = usage == last && i + 1 == field->count;
      control.place = DescribedControl(*field, i);
      // Some sensors leave one bit's range for a number of more.
      if (control.role == FingerRole::id && control.place.maximum - control.place.minimum < k_generic_contacts)
        control.place.maximum = 255;
      if (control.ends_finger) ++report.fingers;
      note_axis(axes, usage, *field);
      report.controls.push_back(control);
    }
  }
  if (report.controls.empty() || report.fingers == 0) return std::nullopt;
  report.controls.back().ends_group = true;
  report.id = fields.front()->report_id;
  report.length = descriptor.report_length(hid::ReportType::input, report.id);
  return report;
}

}  // namespace

std::optional<FingerLayout> find_wacom_fingers(const ReportDescriptor& descriptor) {
  FingerLayout layout;
  layout.has_report_ids = descriptor.has_report_ids;
  const auto fields = fields_by_report(descriptor, hid::ReportType::input);
  for (std::size_t first = 0; first < fields.size();) {
    std::size_t end = first;
    while (end < fields.size() && fields[end]->report_id == fields[first]->report_id) ++end;
    auto report = read_report(
        descriptor,
        {fields.begin() + static_cast<std::ptrdiff_t>(first), fields.begin() + static_cast<std::ptrdiff_t>(end)},
        layout.axes);
    if (report) layout.reports.push_back(std::move(*report));
    first = end;
  }
  if (layout.reports.empty() || !layout.axes.x.present || !layout.axes.y.present) return std::nullopt;
  layout.axes.contacts = 1;
  for (const Field& field : descriptor.fields) {
    if (field.type == hid::ReportType::feature && touch_has_usage(field, hid::k_contact_max))
      layout.axes.contacts = k_generic_contacts;
    const Usage application = descriptor.enclosing(field, hid::k_collection_application);
    if (field.type == hid::ReportType::input && application == hid::k_touch_screen) layout.axes.on_screen = true;
  }
  return layout;
}

WacomGenericTouchDecoder::WacomGenericTouchDecoder(FingerLayout layout, std::shared_ptr<TouchSwitch> gate)
    : TouchDecoder(layout.axes), layout_(std::move(layout)), gate_(std::move(gate)) {
  if (gate_) gate_->has_touch = true;
}

void WacomGenericTouchDecoder::reset() {
  TouchDecoder::reset();
  finger_ = {};
  expected_ = received_ = 0;
  invalid_ = down_ = false;
}

bool WacomGenericTouchDecoder::decode(base::Bytes report) {
  if (report.empty()) return false;
  const std::uint8_t id = layout_.has_report_ids ? report[0] : 0;
  bool ended = false;
  for (const FingerReport& layout : layout_.reports) {
    if (layout.id != id || report.size() < layout.length) continue;
    const bool listens = !muted() || down_;
    if (listens) begin(layout, report);
    for (const FingerControl& control : layout.controls) {
      const std::int64_t value = control.place.value(report);
      if (listens && control.place.holds(value)) apply(control, value);
      if (control.ends_group) ended = end_group() || ended;
    }
  }
  return ended;
}

void WacomGenericTouchDecoder::begin(const FingerReport& layout, base::Bytes report) {
  invalid_ = false;
  finger_.confident = true;
  if (layout.count) {
    const std::int64_t count = layout.count->value(report);
    if (count == 0) return;
    expected_ = static_cast<std::int32_t>(std::clamp<std::int64_t>(count, 0, 255));
  } else {
    expected_ = std::min(static_cast<std::int32_t>(axes_.contacts), layout.fingers);
  }
  received_ = 0;
}

void WacomGenericTouchDecoder::apply(const FingerControl& control, std::int64_t value) {
  if (invalid_) return;
  const auto number = static_cast<std::int32_t>(value);
  switch (control.role) {
    case FingerRole::x:
      finger_.x = number;
      break;
    case FingerRole::y:
      finger_.y = number;
      break;
    case FingerRole::id:
      finger_.id = number;
      break;
    case FingerRole::tip:
      finger_.tip = value != 0;
      break;
    case FingerRole::confidence:
      finger_.confident = value != 0;
      break;
    case FingerRole::valid:
      invalid_ = value == 0;
      return;
    case FingerRole::other:
      break;
  }
  if (control.ends_finger) end_finger();
}

void WacomGenericTouchDecoder::end_finger() {
  bool touches = finger_.tip && finger_.confident;
  if (muted()) {
    if (!down_) return;
    touches = false;
  }
  if (++received_ > expected_) return;
  const auto slot = axes_.contacts > 1 ? slots_.slot_of(finger_.id) : std::optional<std::size_t>(0);
  if (!slot || (axes_.contacts > 1 && !touches && !slots_.is_active(*slot))) return;
  slots_.set(*slot, touches);
  if (touches) slots_.move(*slot, finger_.x, finger_.y);
}

bool WacomGenericTouchDecoder::end_group() {
  if (expected_ == 0 || received_ < expected_) return false;
  slots_.end_frame();
  slots_.publish();
  expected_ = received_ = 0;
  down_ = slots_.any_active();
  return true;
}

}  // namespace penpose::decode
