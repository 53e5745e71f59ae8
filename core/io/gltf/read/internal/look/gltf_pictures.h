#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/document/look.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// Px of the largest picture that is shown: 8192 x 8192.
inline constexpr std::uint64_t k_most_picture_px = std::uint64_t{1} << 26;

/// The pictures of a file as its surfaces ask for them. Each is taken once, as it is, not unpacked; those that lie in a
/// file that is kept (GltfDocument::file) stay there.
class GltfPictures {
 public:
  /// All must outlive it.
  GltfPictures(const GltfDocument& document, const FileResolver& resolve, document::Look& look)
      : document_(document), resolve_(resolve), look_(look) {}

  /// The number in Look::images of an image of the file; nothing where it cannot be drawn, which Look::undrawn tells.
  std::optional<std::size_t> find(std::size_t index);

  /// Notes that something cannot be drawn, and why.
  std::nullopt_t refuse(const std::string& name, const std::string& why);

 private:
  [[nodiscard]] base::Result<document::KeptBytes> bytes_of(const json::Json& image) const;
  std::optional<std::size_t> take(const json::Json& image, std::size_t index);

  const GltfDocument& document_;
  const FileResolver& resolve_;
  document::Look& look_;
  std::vector<std::size_t> known_;
  std::uint64_t held_ = 0;
};

}  // namespace penpose::io
