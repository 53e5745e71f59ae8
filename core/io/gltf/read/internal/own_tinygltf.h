#pragma once

// Hidden in core/io. tinygltf as it is compiled here, from Debian's header, with Json for its JSON
// (own_tinygltf.cpp): its shared library frees JSON in a way that ends the program where memory runs out. It has a
// namespace of its own, so that a program may link both.

#include <string>

#define tinygltf tinygltf_of_penpose
#include <tiny_gltf.h>

namespace penpose::io {

/// Reads the structure of a glTF document, without what other files hold. Errors: false.
[[nodiscard]] bool parse_structure(const std::string& text, tinygltf::Model& model);

}  // namespace penpose::io
