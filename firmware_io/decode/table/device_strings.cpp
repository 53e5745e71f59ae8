#include "firmware_io/decode/table/device_strings.h"

#include "core/base/numbers.h"

namespace penpose::decode {

std::vector<TabletIdentifier::StringCheck> read_device_strings(const JsonPlace& place) {
  std::vector<TabletIdentifier::StringCheck> strings;
  for (const auto& [index, check] : place.members()) {
    const auto number = base::parse_uint(index);
    if (!number || *number > 255) check.fail("is not under the index of a string", "write 1 to 255");
    auto pattern = TextPattern::parse(check.text(1024));
    if (!pattern) {
      check.fail(pattern.error().what, pattern.error().remedy);
      break;
    }
    strings.push_back({static_cast<std::uint8_t>(number.value_or(0)), std::move(pattern).value()});
  }
  return strings;
}

}  // namespace penpose::decode
