#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::io {

/// A picture that a file holds or names.
struct GltfTexture {
  std::string name;  ///< of the image, or its file; may be empty
  std::string type;  ///< "image/png" or what the file says; may be empty
};

/// What a glTF file holds beside the shape that a model is read from.
struct GltfContents {
  std::vector<GltfTexture> textures;        ///< images, in the file's order
  std::vector<std::string> passed_through;  ///< what stays in the file as it is: "KHR_lights_punctual", "2 cameras"
  std::vector<std::string> not_understood;  ///< extensions that penpose does not know
  bool is_project = false;                  ///< it opens as the document that this edition saved, and not as a model
  bool is_older_project = false;            ///< it opens as what today makes of a document that an older edition saved
};

/// Reads the JSON of a .gltf or .glb alone. Empty for anything else, and where the JSON cannot be read.
[[nodiscard]] GltfContents gltf_contents(base::Bytes bytes);

}  // namespace penpose::io
