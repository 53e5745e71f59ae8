#include "firmware_io/event/internal/descriptor_writer.h"

#include <limits>

namespace penpose::event {
namespace {

/// Heads of items without their length (HID 1.11, 6.2.2).
enum Head : std::uint8_t {
  k_input = 0x80,
  k_feature = 0xb0,
  k_collection = 0xa0,
  k_end_collection = 0xc0,
  k_usage = 8
};

/// Tags of global items.
enum Tag : std::size_t {
  k_logical_minimum = 1,
  k_logical_maximum,
  k_physical_minimum,
  k_physical_maximum,
  k_exponent,
  k_unit,
  k_report_size,
  k_report_id,
  k_report_count
};

/// Finer than any tablet, and so coarse that a metre fits into 31 bits.
constexpr int k_least_exponent = -6;

struct Physical {
  std::int64_t span = 0;
  int exponent = 0;
};

/// How far a logical range reaches, in 10^exponent units: exact where a decimal number can be, else as fine as
/// possible.
Physical physical_of(std::int64_t logical_span, std::int64_t per_unit) {
  Physical best;
  std::int64_t scaled = logical_span;
  for (int exponent = 0; exponent >= k_least_exponent; --exponent, scaled *= 10) {
    const std::int64_t span = (scaled + per_unit / 2) / per_unit;
    if (span > std::numeric_limits<std::int32_t>::max()) break;
    best = {span, exponent};
    if (scaled % per_unit == 0) break;
  }
  return best;
}

}  // namespace

void DescriptorWriter::item(std::uint8_t head, std::int64_t value, std::size_t least) {
  std::size_t length = value == 0                            ? 0
                       : value >= -0x80 && value <= 0x7f     ? 1
                       : value >= -0x8000 && value <= 0x7fff ? 2
                                                             : 4;
  length = std::max(length, least);
  bytes_.push_back(static_cast<std::uint8_t>(head | (length == 4 ? 3 : length)));
  for (std::size_t i = 0; i < length; ++i) {
    bytes_.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
  }
}

void DescriptorWriter::global(std::size_t which, std::int64_t value) {
  if (globals_[which] == value) return;
  globals_[which] = value;
  item(static_cast<std::uint8_t>(which << 4 | 4), value, 1);
}

void DescriptorWriter::open(std::uint8_t collection_kind, hid::Usage usage) {
  item(k_usage, usage, 4);
  item(k_collection, collection_kind, 1);
}

void DescriptorWriter::close() { bytes_.push_back(k_end_collection); }

void DescriptorWriter::begin_report(std::uint8_t id) {
  global(k_report_id, id);
  bits_ = 8;
}

void DescriptorWriter::main(std::uint8_t head, const Control& control) {
  Physical physical;
  if (control.unit.per_unit > 0) physical = physical_of(control.maximum - control.minimum, control.unit.per_unit);
  global(k_logical_minimum, control.minimum);
  global(k_logical_maximum, control.maximum);
  global(k_physical_minimum, 0);
  global(k_physical_maximum, physical.span);
  global(k_unit, physical.span > 0 ? control.unit.unit : 0);
  global(k_exponent, physical.exponent & 0xf);
  global(k_report_size, control.bit_size);
  global(k_report_count, 1);
  if (control.usage != 0) item(k_usage, control.usage, 4);
  item(head, control.flags, 1);
}

std::uint32_t DescriptorWriter::input(const Control& control) {
  main(k_input, control);
  const std::uint32_t offset = bits_;
  bits_ += control.bit_size;
  return offset;
}

void DescriptorWriter::feature(const Control& control) { main(k_feature, control); }

void DescriptorWriter::pad() {
  const std::uint32_t left = (8 - bits_ % 8) % 8;
  if (left == 0) return;
  Control filling;
  filling.bit_size = left;
  filling.flags = hid::k_flag_constant | hid::k_flag_variable;
  input(filling);
}

}  // namespace penpose::event
