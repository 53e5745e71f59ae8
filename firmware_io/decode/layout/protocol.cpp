#include "firmware_io/decode/layout/protocol.h"

#include <vector>

#include "firmware_io/decode/layout/layout_decoder.h"
#include "firmware_io/decode/table/embedded_files.h"

namespace penpose::decode {
namespace {

ProtocolMap read_embedded_layouts() {
  const auto tree = parse_json(embedded_protocols());
  if (!tree) return {};
  base::Error error;
  auto protocols = read_protocols(JsonPlace(*tree, error));
  return error.what.empty() ? protocols : ProtocolMap{};
}

}  // namespace

const ProtocolMap& known_protocols() {
  static const ProtocolMap protocols = read_embedded_layouts();
  return protocols;
}

std::span<const std::string> protocol_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, protocol] : known_protocols()) list.push_back(name);
    return list;
  }();
  return names;
}

std::unique_ptr<PenDecoder> make_protocol_decoder(std::string_view name) {
  const auto found = known_protocols().find(name);
  if (found == known_protocols().end()) return nullptr;
  return std::make_unique<LayoutDecoder>(found->second);
}

}  // namespace penpose::decode
