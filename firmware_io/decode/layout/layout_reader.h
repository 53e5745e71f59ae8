#pragma once

#include <map>
#include <memory>
#include <string>

#include "firmware_io/decode/layout/layout.h"
#include "firmware_io/decode/table/json_place.h"

namespace penpose::decode {

using ProtocolMap = std::map<std::string, std::shared_ptr<const Protocol>, std::less<>>;

/// Reads the members `layouts`, `rule_lists` and `protocols` of a tablet file (their form is in tablets/README.md).
/// Errors go to the error of `file`; the result is then meaningless.
[[nodiscard]] ProtocolMap read_protocols(const JsonPlace& file);

}  // namespace penpose::decode
