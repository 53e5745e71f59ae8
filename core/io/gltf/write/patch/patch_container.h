#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/document/source_file.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/internal/gltf_builder.h"
#include "core/io/gltf/write/patch_gltf.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// Gives the files that were beside a model when it was read.
[[nodiscard]] FileResolver resolver_of(const document::SourceFile& source);

/// Where the buffers of a file that was read go, and where new bytes follow them. All that is given outlives it.
class PatchContainer {
 public:
  PatchContainer(const document::SourceFile& source, const GltfDocument& document, GltfContainer container,
                 std::string stem);

  /// The document, its views already where the buffers are put.
  [[nodiscard]] const json::Json& document() const { return json_; }
  /// The buffer that new bytes lie in, and their first place there.
  [[nodiscard]] std::size_t buffer() const { return buffer_; }
  [[nodiscard]] std::size_t start() const { return start_; }
  /// What lies in that buffer already, where it is of one piece.
  [[nodiscard]] base::Bytes known() const { return pieces_.size() == 1 ? pieces_.front() : base::Bytes(); }

  /// The file, and what belongs beside it. Without a change it is the one that was read, where that is of this kind.
  /// Errors: of pack_glb.
  [[nodiscard]] base::Result<std::vector<std::uint8_t>> finish(GltfBuilder& builder, bool changed,
                                                               std::map<std::string, std::vector<std::uint8_t>>& files);

 private:
  void gather();
  void take_pictures(GltfBuilder& builder) const;
  [[nodiscard]] std::string free_name() const;

  const document::SourceFile& source_;
  const GltfDocument& from_;
  GltfContainer container_;
  std::string stem_;
  json::Json json_;
  std::vector<base::Bytes> pieces_;  ///< of the buffer, behind which new bytes are
  bool in_binary_ = false;           ///< the file that was read is a .glb with a buffer of its own
  std::size_t length_ = 0;           ///< of the pieces
  std::size_t buffer_ = 0;
  std::size_t start_ = 0;
};

}  // namespace penpose::io
