#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "firmware_io/decode/layout/layout_reader.h"
#include "firmware_io/decode/sample/pen_decoder.h"

namespace penpose::decode {

/// The vendor protocols that the program knows, by name.
[[nodiscard]] const ProtocolMap& known_protocols();

/// Their names, sorted.
[[nodiscard]] std::span<const std::string> protocol_names();

/// A fresh decoder of that protocol, or null when the name is unknown.
[[nodiscard]] std::unique_ptr<PenDecoder> make_protocol_decoder(std::string_view name);

}  // namespace penpose::decode
