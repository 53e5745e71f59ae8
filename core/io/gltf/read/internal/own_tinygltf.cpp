// Neither pictures nor files are read by it; where its JSON comes from is said below.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
// It would take memory that ran out for text that is no JSON.
#define TINYGLTF_NOEXCEPTION
#define TINYGLTF_IMPLEMENTATION

#include "core/base/json/json_value.h"

namespace json_of_penpose {
using json = penpose::json::Json;
}  // namespace json_of_penpose
#define nlohmann json_of_penpose

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
