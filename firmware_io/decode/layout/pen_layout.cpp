#include "firmware_io/decode/layout/pen_layout.h"

#include <algorithm>

#include "firmware_io/decode/layout/pen_axes.h"
#include "firmware_io/decode/wacom/wacom_usages.h"

namespace penpose::decode {
namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::Usage;

constexpr Usage k_digitizer_undefined = hid::usage(hid::k_page_digitizer, 0);
constexpr Usage k_microsoft_undefined = 0xff000000;

/// More controls than any pen has; a field that claims more is an opaque block.
constexpr std::uint32_t k_most_controls = 64;

bool is_standard_pen_field(const ReportDescriptor& descriptor, const Field& field) {
  const Usage application = descriptor.enclosing(field, hid::k_collection_application);
  if (application == hid::k_touch_screen || application == hid::k_touch_pad) return false;
  if (descriptor.is_inside(field, hid::k_finger)) return false;
  return application == hid::k_pen || application == hid::k_digitizer || descriptor.is_inside(field, hid::k_stylus) ||
         descriptor.is_inside(field, hid::k_puck) || descriptor.is_inside(field, hid::k_pen);
}

struct RoleOfUsage {
  Usage usage;
  PenRole role;
};
constexpr RoleOfUsage k_role_of_usage[] = {
    // HID Usage Tables 1.5, sections 4 and 16.
    {hid::k_x, PenRole::x},
    {hid::k_y, PenRole::y},
    {hid::k_z, PenRole::height_down},
    {hid::k_tip_pressure, PenRole::pressure},
    {hid::k_in_range, PenRole::in_range},
    {hid::k_invert, PenRole::invert},
    {hid::k_x_tilt, PenRole::tilt_x},
    {hid::k_y_tilt, PenRole::tilt_y},
    {hid::k_twist, PenRole::twist},
    {hid::k_tip_switch, PenRole::tip},
    {hid::k_eraser, PenRole::eraser},
    {hid::k_barrel_switch, PenRole::barrel},
    {hid::k_secondary_barrel_switch, PenRole::barrel2},
    {hid::k_transducer_serial, PenRole::serial},
    // The second button of Huion's pens since 2024, and of older pens of others.
    {hid::k_secondary_tip_switch, PenRole::barrel2},
    {hid::k_tablet_pick, PenRole::barrel2},
    // Of Wacom alone.
    {k_wacom_sense, PenRole::sense},
    {k_wacom_serial_high, PenRole::serial_high},
    {k_wacom_barrel3, PenRole::barrel3},
    {k_wacom_tool_type, PenRole::tool_type},
    {k_wacom_distance, PenRole::distance},
    {k_wacom_report_valid, PenRole::report_valid},
    {k_wacom_finger_wheel, PenRole::wheel}};

std::optional<PenRole> role_of(Usage usage) {
  for (const RoleOfUsage& one : k_role_of_usage) {
    if (one.usage == usage) return one.role;
  }
  return std::nullopt;
}

bool has_role(const PenReport& report, PenRole role) {
  return std::any_of(report.controls.begin(), report.controls.end(),
                     [role](const PenControl& control) { return control.role == role; });
}

class PenFinder {
 public:
  PenFinder(const ReportDescriptor& descriptor, Dialect dialect) : descriptor_(descriptor), dialect_(dialect) {
    layout_.has_report_ids = descriptor.has_report_ids;
    layout_.report_of_id.fill(-1);
  }

  std::optional<PenLayout> run();

 private:
  [[nodiscard]] bool carries_contacts(std::uint8_t id) const;
  [[nodiscard]] Usage corrected(const Field& field, std::uint32_t index) const;
  void find_aes_serials();
  bool add_long_serial(PenReport& report, const Field& field);
  void add_field(PenReport& report, std::size_t index);
  void add_control(PenReport& report, const Field& field, std::uint32_t index, PenRole role);

  const ReportDescriptor& descriptor_;
  Dialect dialect_;
  PenLayout layout_;
  std::vector<std::size_t> aes_fields_;  ///< first of three fields that hold tool type, serial and its upper part
};

/// Whether a report is that of a touch device, which numbers its contacts.
bool PenFinder::carries_contacts(std::uint8_t id) const {
  return std::any_of(descriptor_.fields.begin(), descriptor_.fields.end(), [&](const Field& field) {
    if (field.type != hid::ReportType::input || field.report_id != id || !field.is_variable()) return false;
    return std::any_of(field.usages.begin(), field.usages.end(), [](const hid::UsageRange& range) {
      return range.minimum <= hid::k_contact_id && hid::k_contact_id <= range.maximum;
    });
  });
}

/// Pens from before the second barrel switch had a usage number declare an undefined one between Invert and In Range.
Usage PenFinder::corrected(const Field& field, std::uint32_t index) const {
  const Usage usage = field.usage_of(index);
  if (dialect_ == Dialect::standard || usage != k_digitizer_undefined || index < 4) return standard_usage(usage);
  const bool matches = field.usage_of(index - 4) == hid::k_tip_switch &&
                       field.usage_of(index - 3) == hid::k_barrel_switch &&
                       field.usage_of(index - 2) == hid::k_eraser && field.usage_of(index - 1) == hid::k_invert &&
                       field.usage_of(index + 1) == hid::k_in_range;
  return matches ? hid::k_secondary_barrel_switch : usage;
}

/// Wacom's electrostatic pens describe their serial number with usages of their own in three fields of 16, 32 and 8
/// bits, with logical ranges that do not fit.
void PenFinder::find_aes_serials() {
  const auto is = [](const Field& field, Usage usage, std::uint32_t size) {
    return field.bit_size == size && field.usage_of(0) == usage;
  };
  const auto& fields = descriptor_.fields;
  std::vector<std::size_t> inputs;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].type == hid::ReportType::input && !fields[i].is_constant()) inputs.push_back(i);
  }
  for (std::size_t i = 0; i + 2 < inputs.size(); ++i) {
    const Field& first = fields[inputs[i]];
    const Field& second = fields[inputs[i + 1]];
    const Field& third = fields[inputs[i + 2]];
    if (first.report_id != second.report_id || first.report_id != third.report_id) continue;
    if (is(first, k_fingers_serial, 16) && is(second, hid::k_transducer_serial, 32) &&
        is(third, k_microsoft_undefined, 8)) {
      aes_fields_.push_back(inputs[i]);
      aes_fields_.push_back(inputs[i + 1]);
      aes_fields_.push_back(inputs[i + 2]);
      layout_.aes = true;
    }
  }
}

void PenFinder::add_control(PenReport& report, const Field& field, std::uint32_t index, PenRole role) {
  PenControl control;
  control.role = role;
  control.is_signed = field.is_signed();
  control.null_state = (field.flags & hid::k_flag_null_state) != 0;
  control.bit_offset = field.bit_offset + index * field.bit_size;
  control.bit_size = field.bit_size;
  control.minimum = field.logical_minimum;
  control.maximum = field.logical_maximum;
  control.collection = field.collection;
  report.needed = std::max(report.needed, (control.bit_offset + control.bit_size + 7) / 8);
  report.controls.push_back(control);
  report.has_sense = report.has_sense || role == PenRole::sense;
  report.has_serial = report.has_serial || role == PenRole::serial;
  report.has_twist = report.has_twist || role == PenRole::twist;
}

/// Serial numbers of the Universal Stylus Initiative have 64 bits, in one field. Whether the field was one of those.
bool PenFinder::add_long_serial(PenReport& report, const Field& field) {
  if (field.bit_size <= 32 || field.bit_size > 64 || field.usage_of(0) != hid::k_transducer_serial) return false;
  Field part = field;
  part.flags &= ~hid::k_flag_null_state;
  part.logical_minimum = 0;
  for (const PenRole role : {PenRole::serial, PenRole::serial_high}) {
    part.bit_size = std::min(32u, static_cast<std::uint32_t>(field.bit_offset + field.bit_size - part.bit_offset));
    part.logical_maximum = (std::int64_t{1} << part.bit_size) - 1;
    add_control(report, part, 0, role);
    part.bit_offset += 32;
    if (dialect_ == Dialect::wacom) break;  // its Serial Hi is a field of its own
  }
  return true;
}

void PenFinder::add_field(PenReport& report, std::size_t index) {
  const Field& field = descriptor_.fields[index];
  const auto aes = std::find(aes_fields_.begin(), aes_fields_.end(), index);
  if (aes != aes_fields_.end()) {
    constexpr std::array<PenRole, 3> k_roles{PenRole::tool_type, PenRole::serial, PenRole::serial_high};
    add_control(report, field, 0, k_roles[static_cast<std::size_t>(aes - aes_fields_.begin()) % 3]);
    PenControl& added = report.controls.back();
    added.is_signed = false;
    added.minimum = 0;
    added.maximum = (std::int64_t{1} << field.bit_size) - 1;
    return;
  }
  if (add_long_serial(report, field)) return;
  if (field.bit_size == 0 || field.bit_size > 32 || field.usages.empty()) return;
  for (std::uint32_t i = 0; i < std::min(field.count, k_most_controls); ++i) {
    const auto role = role_of(dialect_ == Dialect::wacom ? corrected(field, i) : field.usage_of(i));
    if (!role) continue;
    // A usage that stands twice in a standard report belongs to its first control; Wacom repeats whole frames.
    if (dialect_ == Dialect::standard && has_role(report, *role)) continue;
    add_control(report, field, i, *role);
    note_axis(report.axes, *role, field);
    if (descriptor_.is_inside(field, hid::k_puck)) report.is_puck = true;
  }
}

std::optional<PenLayout> PenFinder::run() {
  if (dialect_ == Dialect::wacom) find_aes_serials();
  std::array<bool, 256> seen{};
  for (std::size_t i = 0; i < descriptor_.fields.size(); ++i) {
    const Field& field = descriptor_.fields[i];
    if (field.type != hid::ReportType::input || !field.is_variable() || field.is_constant()) continue;
    const bool pen = dialect_ == Dialect::wacom ? is_wacom_pen(descriptor_, field) && !is_wacom_pad(descriptor_, field)
                                                : is_standard_pen_field(descriptor_, field);
    if (!pen) continue;
    if (!seen[field.report_id]) {
      seen[field.report_id] = true;
      // Some pens number their contacts as fingers do (Goodix).
      const bool named_pen = descriptor_.enclosing(field, hid::k_collection_application) == hid::k_pen;
      if (dialect_ == Dialect::standard && !named_pen && carries_contacts(field.report_id)) continue;
      layout_.report_of_id[field.report_id] = static_cast<std::int16_t>(layout_.reports.size());
      PenReport report;
      report.id = field.report_id;
      report.length = descriptor_.report_length(hid::ReportType::input, field.report_id);
      layout_.reports.push_back(report);
    }
    const std::int16_t index = layout_.report_of_id[field.report_id];
    if (index >= 0) add_field(layout_.reports[static_cast<std::size_t>(index)], i);
  }
  bool found = false;
  for (PenReport& report : layout_.reports) {
    report.has_tip = has_role(report, PenRole::tip);
    report.has_invert = has_role(report, PenRole::invert);
    report.has_proximity = has_role(report, PenRole::in_range) || has_role(report, PenRole::sense);
    // As Linux's wacom driver has it (WACOM_QUIRK_PEN_BUTTON3).
    report.both_are_third =
        !layout_.aes && has_role(report, PenRole::serial_high) && !has_role(report, PenRole::barrel3);
    const bool is_pen = has_role(report, PenRole::x) && has_role(report, PenRole::y) &&
                        (report.has_tip || report.has_proximity || has_role(report, PenRole::pressure));
    if (is_pen) {
      found = true;
    } else {
      layout_.report_of_id[report.id] = -1;
    }
  }
  if (!found) return std::nullopt;
  unite_axes(layout_);
  return std::move(layout_);
}

}  // namespace

std::optional<PenLayout> find_pens(const ReportDescriptor& descriptor, Dialect dialect) {
  return PenFinder(descriptor, dialect).run();
}

std::int64_t PenControl::rescaled(std::int64_t value) const {
  const std::int64_t span = maximum - minimum;
  const std::int64_t way = std::clamp<std::int64_t>(value - minimum, 0, span);
  return to_minimum + (2 * way * (to_maximum - to_minimum) + span) / (2 * span);
}

}  // namespace penpose::decode
