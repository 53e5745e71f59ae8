// Neither pictures nor files are read by it; where its JSON comes from is said below.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
// It would take memory that ran out for text that is no JSON.
#define TINYGLTF_NOEXCEPTION
#define TINYGLTF_IMPLEMENTATION

#include "core/base/json/json_value.h"

// The type that tinygltf, which asks for nlohmann::json, finds first.
namespace {
namespace nlohmann {
using json = penpose::json::Json;
}
}  // namespace

// A text is read for it as any other, whatever the locale says.
template <>
template <>
penpose::json::Json penpose::json::Json::parse<const char*>(const char* first, const char* last, parser_callback_t,
                                                            bool, bool) {
  auto json = penpose::json::parse_json(penpose::base::as_bytes(std::string_view(first, last)));
  return json ? std::move(json).value() : nullptr;
}

#include "core/io/gltf/read/internal/own_tinygltf.h"

namespace penpose::io {

bool parse_structure(const std::string& text, tinygltf::Model& model) {
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({});
  std::string errors;
  std::string warnings;
  return parser.LoadASCIIFromString(&model, &errors, &warnings, text.data(), static_cast<unsigned int>(text.size()), "",
                                    tinygltf::NO_REQUIRE);
}

}  // namespace penpose::io
