#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "firmware_io/hid/internal/descriptor_item.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::hid {
namespace {

/// wLength of a HID request is 16 bits, so no report can be longer.
constexpr std::uint64_t k_longest_report_bits = 8ull * 65535;
constexpr std::size_t k_longest_descriptor = 65536;

/// A number whose sign depends on a number declared elsewhere, so both readings are kept.
struct Number {
  std::int64_t as_signed = 0;
  std::int64_t as_unsigned = 0;
};

struct Globals {
  std::uint16_t usage_page = 0;
  Number logical_minimum, logical_maximum, physical_minimum, physical_maximum;
  std::int32_t unit_exponent = 0;
  std::uint32_t unit = 0;
  std::uint32_t report_size = 0;
  std::uint32_t report_count = 0;
  std::uint8_t report_id = 0;
};

/// A usage before the main item that gives it its page.
struct PendingUsage {
  std::uint32_t minimum = 0;
  std::uint32_t maximum = 0;
  bool extended = false;
  bool alternative = false;
};

struct Locals {
  std::vector<PendingUsage> usages;
  std::optional<Item> usage_minimum, usage_maximum;
  std::vector<IndexRange> designators, strings;
  std::optional<Item> designator_minimum, designator_maximum, string_minimum, string_maximum;
  std::optional<std::size_t> open_delimiter;  ///< its offset
  std::size_t usages_in_delimiter = 0;
};

class Parser {
 public:
  Parser(base::Bytes bytes, Strictness strictness) : reader_(bytes), strictness_(strictness) {}

  base::Result<ReportDescriptor> run();

 private:
  using Problem = std::optional<base::Error>;

  static bool is_signed_range(const Number& minimum) { return minimum.as_signed < 0; }

  Problem handle(const Item& item);
  Problem handle_main(const Item& item);
  Problem handle_global(const Item& item);
  Problem handle_local(const Item& item);
  Problem handle_delimiter(const Item& item);
  Problem add_usage(const PendingUsage& usage);
  Problem pair_usage_range(const Item& item);
  Problem pair_index_range(std::optional<Item>& minimum, std::optional<Item>& maximum, const char* name,
                           std::vector<IndexRange>& into);
  Problem finish_locals(const Item& item);
  Problem open_collection(const Item& item);
  Problem add_field(const Item& item, ReportType type);
  std::vector<UsageRange> usages_with_page() const;
  std::int32_t innermost() const { return open_.empty() ? -1 : open_.back(); }

  base::ByteReader reader_;
  Strictness strictness_;
  ReportDescriptor result_;
  Globals globals_;
  std::vector<Globals> stack_;
  Locals locals_;
  std::vector<std::int32_t> open_;
};

base::Result<ReportDescriptor> Parser::run() {
  if (reader_.remaining() > k_longest_descriptor) return illegal(k_longest_descriptor, "longer than 65536 bytes");
  for (;;) {
    auto item = next_item(reader_);
    if (!item) return item.error();
    if (!item->has_value()) break;
    if (auto problem = handle(**item)) return *problem;
  }
  const std::size_t end = reader_.offset();
  if (locals_.open_delimiter) return illegal(*locals_.open_delimiter, "a delimiter is never closed");
  if (!open_.empty()) return illegal(end, std::to_string(open_.size()) + " collection(s) still open at the end");
  if (result_.has_report_ids) {
    for (Field& field : result_.fields) field.bit_offset += 8;
  }
  return std::move(result_);
}

Parser::Problem Parser::handle(const Item& item) {
  if (item.type == ItemType::main) return handle_main(item);
  if (item.type == ItemType::global) return handle_global(item);
  if (item.type == ItemType::local) return handle_local(item);
  if (strictness_ == Strictness::tolerant) return std::nullopt;
  return illegal(item.offset, "item of a reserved type");
}

Parser::Problem Parser::handle_main(const Item& item) {
  if (auto problem = finish_locals(item)) return problem;
  Problem problem;
  switch (item.tag) {
    case 0x8:
      problem = add_field(item, ReportType::input);
      break;
    case 0x9:
      problem = add_field(item, ReportType::output);
      break;
    case 0xb:
      problem = add_field(item, ReportType::feature);
      break;
    case 0xa:
      problem = open_collection(item);
      break;
    case 0xc:
      if (open_.empty()) return illegal(item.offset, "End Collection without a collection");
      open_.pop_back();
      break;
    default:
      if (strictness_ == Strictness::exact) problem = illegal(item.offset, "reserved main item");
  }
  locals_ = {};
  return problem;
}

Parser::Problem Parser::handle_global(const Item& item) {
  const Number number{item.as_signed(), item.data};
  switch (item.tag) {
    case 0x0:
      if (item.data > 0xffff) return illegal(item.offset, "Usage Page above 65535");
      globals_.usage_page = static_cast<std::uint16_t>(item.data);
      break;
    case 0x1:
      globals_.logical_minimum = number;
      break;
    case 0x2:
      globals_.logical_maximum = number;
      break;
    case 0x3:
      globals_.physical_minimum = number;
      break;
    case 0x4:
      globals_.physical_maximum = number;
      break;
    case 0x5: {
      // The exponent is a nibble in two's complement; descriptors that write -1 as a whole byte are common.
      const std::int32_t raw = item.as_signed();
      globals_.unit_exponent = raw >= 8 && raw <= 15 ? raw - 16 : raw;
      if (globals_.unit_exponent < -128 || globals_.unit_exponent > 127) {
        return illegal(item.offset, "Unit Exponent out of range");
      }
      break;
    }
    case 0x6:
      globals_.unit = item.data;
      break;
    case 0x7:
      globals_.report_size = item.data;
      break;
    case 0x8:
      if (item.data == 0 || item.data > 255) return illegal(item.offset, "Report ID out of 1..255");
      globals_.report_id = static_cast<std::uint8_t>(item.data);
      result_.has_report_ids = true;
      break;
    case 0x9:
      globals_.report_count = item.data;
      break;
    case 0xa:
      if (item.size != 0) return illegal(item.offset, "Push carries data");
      stack_.push_back(globals_);
      break;
    case 0xb:
      if (item.size != 0) return illegal(item.offset, "Pop carries data");
      if (stack_.empty()) return illegal(item.offset, "Pop without Push");
      globals_ = stack_.back();
      stack_.pop_back();
      break;
    default:
      if (strictness_ == Strictness::exact) return illegal(item.offset, "reserved global item");
  }
  return std::nullopt;
}

Parser::Problem Parser::handle_local(const Item& item) {
  switch (item.tag) {
    case 0x0:
      return add_usage({item.data, item.data, item.size == 4, false});
    case 0x1:
    case 0x2: {
      auto& slot = item.tag == 1 ? locals_.usage_minimum : locals_.usage_maximum;
      if (slot && strictness_ == Strictness::exact) {
        return illegal(item.offset, item.tag == 1 ? "second Usage Minimum" : "second Usage Maximum");
      }
      slot = item;
      return locals_.usage_minimum && locals_.usage_maximum ? pair_usage_range(item) : std::nullopt;
    }
    case 0x3:
      locals_.designators.push_back({item.data, item.data});
      return std::nullopt;
    case 0x4:
      locals_.designator_minimum = item;
      return pair_index_range(locals_.designator_minimum, locals_.designator_maximum, "Designator",
                              locals_.designators);
    case 0x5:
      locals_.designator_maximum = item;
      return pair_index_range(locals_.designator_minimum, locals_.designator_maximum, "Designator",
                              locals_.designators);
    case 0x7:
      locals_.strings.push_back({item.data, item.data});
      return std::nullopt;
    case 0x8:
      locals_.string_minimum = item;
      return pair_index_range(locals_.string_minimum, locals_.string_maximum, "String", locals_.strings);
    case 0x9:
      locals_.string_maximum = item;
      return pair_index_range(locals_.string_minimum, locals_.string_maximum, "String", locals_.strings);
    case 0xa:
      return handle_delimiter(item);
    default:
      break;
  }
  if (strictness_ == Strictness::tolerant) return std::nullopt;
  return illegal(item.offset, "reserved local item");
}

Parser::Problem Parser::handle_delimiter(const Item& item) {
  if (item.data == 1) {
    if (locals_.open_delimiter) return illegal(item.offset, "a delimiter opens within another");
    locals_.open_delimiter = item.offset;
    locals_.usages_in_delimiter = 0;
    return std::nullopt;
  }
  if (item.data != 0) return illegal(item.offset, "Delimiter is neither open (1) nor close (0)");
  if (!locals_.open_delimiter) return illegal(item.offset, "a delimiter closes that was never opened");
  locals_.open_delimiter.reset();
  return std::nullopt;
}

Parser::Problem Parser::add_usage(const PendingUsage& usage) {
  PendingUsage added = usage;
  // Of a delimited set the first usage is the preferred one; the others are alternatives for the same control.
  if (locals_.open_delimiter) added.alternative = locals_.usages_in_delimiter++ > 0;
  locals_.usages.push_back(added);
  return std::nullopt;
}

Parser::Problem Parser::pair_usage_range(const Item& item) {
  const Item minimum = *locals_.usage_minimum;
  const Item maximum = *locals_.usage_maximum;
  locals_.usage_minimum.reset();
  locals_.usage_maximum.reset();
  const bool extended = minimum.size == 4 || maximum.size == 4;
  std::uint32_t low = minimum.data;
  std::uint32_t high = maximum.data;
  if (extended && minimum.size != 4) low |= high & 0xffff0000u;
  if (extended && maximum.size != 4) high |= low & 0xffff0000u;
  if (low > high) return illegal(item.offset, "Usage Minimum above Usage Maximum");
  if (page_of(low) != page_of(high)) return illegal(item.offset, "a usage range crosses usage pages");
  return add_usage({low, high, extended, false});
}

Parser::Problem Parser::pair_index_range(std::optional<Item>& minimum, std::optional<Item>& maximum, const char* name,
                                         std::vector<IndexRange>& into) {
  if (!minimum || !maximum) return std::nullopt;
  const IndexRange range{minimum->data, maximum->data};
  const std::size_t offset = std::max(minimum->offset, maximum->offset);
  minimum.reset();
  maximum.reset();
  if (range.minimum > range.maximum) {
    return illegal(offset, std::string(name) + " Minimum above " + name + " Maximum");
  }
  into.push_back(range);
  return std::nullopt;
}

Parser::Problem Parser::finish_locals(const Item& item) {
  if (locals_.open_delimiter) return illegal(item.offset, "a main item within a delimiter");
  if (strictness_ == Strictness::tolerant) return std::nullopt;
  for (const auto* half : {&locals_.usage_minimum, &locals_.usage_maximum, &locals_.designator_minimum,
                           &locals_.designator_maximum, &locals_.string_minimum, &locals_.string_maximum}) {
    if (half->has_value()) return illegal((*half)->offset, "a range has only one end");
  }
  return std::nullopt;
}

std::vector<UsageRange> Parser::usages_with_page() const {
  std::vector<UsageRange> usages;
  usages.reserve(locals_.usages.size());
  for (const PendingUsage& pending : locals_.usages) {
    // A usage without a page takes the page in force at the main item (6.2.2.8).
    const std::uint32_t page = pending.extended ? 0 : static_cast<std::uint32_t>(globals_.usage_page) << 16;
    usages.push_back({page | pending.minimum, page | pending.maximum, pending.alternative});
  }
  return usages;
}

Parser::Problem Parser::open_collection(const Item& item) {
  if (item.data > 0xff) return illegal(item.offset, "Collection kind above 255");
  Collection collection;
  collection.kind = static_cast<std::uint8_t>(item.data);
  const auto usages = usages_with_page();
  collection.usage = usages.empty() ? 0 : usages.front().minimum;
  collection.parent = innermost();
  open_.push_back(static_cast<std::int32_t>(result_.collections.size()));
  result_.collections.push_back(collection);
  return std::nullopt;
}

Parser::Problem Parser::add_field(const Item& item, ReportType type) {
  Field field;
  field.type = type;
  field.report_id = globals_.report_id;
  field.flags = item.data;
  field.bit_size = globals_.report_size;
  field.count = globals_.report_count;
  field.unit = globals_.unit;
  field.unit_exponent = globals_.unit_exponent;
  field.collection = innermost();
  field.usages = usages_with_page();
  field.designators = std::move(locals_.designators);
  field.strings = std::move(locals_.strings);

  const bool logical_signed = is_signed_range(globals_.logical_minimum);
  field.logical_minimum = globals_.logical_minimum.as_signed;
  field.logical_maximum = logical_signed ? globals_.logical_maximum.as_signed : globals_.logical_maximum.as_unsigned;
  if (field.logical_minimum > field.logical_maximum) {
    return illegal(item.offset, "Logical Minimum above Logical Maximum");
  }
  const bool physical_signed = is_signed_range(globals_.physical_minimum);
  field.physical_minimum = globals_.physical_minimum.as_signed;
  field.physical_maximum =
      physical_signed ? globals_.physical_maximum.as_signed : globals_.physical_maximum.as_unsigned;
  if (field.physical_minimum == 0 && field.physical_maximum == 0) {
    field.physical_minimum = field.logical_minimum;
    field.physical_maximum = field.logical_maximum;
  }

  std::uint32_t& bits = result_.report_bits[static_cast<std::size_t>(type)][field.report_id];
  const std::uint64_t end = bits + std::uint64_t{field.bit_size} * field.count;
  if (end > k_longest_report_bits) return illegal(item.offset, "a report longer than 65535 bytes");
  field.bit_offset = bits;
  bits = static_cast<std::uint32_t>(end);
  result_.fields.push_back(std::move(field));
  return std::nullopt;
}

}  // namespace

base::Result<ReportDescriptor> parse_report_descriptor(base::Bytes descriptor, Strictness strictness) {
  return Parser(descriptor, strictness).run();
}

}  // namespace penpose::hid
