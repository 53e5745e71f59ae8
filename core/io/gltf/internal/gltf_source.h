#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/document/model.h"
#include "core/document/source_file.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// Where what was read stands in the file.
struct GltfOrigins {
  std::vector<document::SourceFile::Part> parts;
  std::vector<std::int32_t> joint_of_node;
  std::vector<std::size_t> animations;  ///< numbers in the file, in the order of the model
};

/// Call it while the shapes are those of the file alone.
[[nodiscard]] GltfOrigins origins_of(const GltfMeshes& meshes, const GltfShapes& shapes);

/// Puts animations in the order that the extras give. Those that are not named there stay behind, in their order.
void put_in_order(const RootExtras& root, std::vector<document::Animation>& animations, std::vector<std::size_t>& from);

/// Reads files beside a model and keeps them.
class ReadBeside {
 public:
  explicit ReadBeside(const FileResolver& resolve) : resolve_(resolve) {}
  /// Empty where there is nothing to read with. Lives as long as this.
  [[nodiscard]] FileResolver resolver();
  [[nodiscard]] std::map<std::string, std::vector<std::uint8_t>>& files() { return files_; }

 private:
  const FileResolver& resolve_;
  std::map<std::string, std::vector<std::uint8_t>> files_;
};

/// The file that a model was read from, with the pictures that lie beside it; one that is not there stays a name.
/// Precondition: the document has its file (GltfDocument::file).
[[nodiscard]] std::shared_ptr<const document::SourceFile> keep_source(ReadBeside& beside, const GltfDocument& document,
                                                                      GltfOrigins origins,
                                                                      const document::Model& model);

}  // namespace penpose::io
