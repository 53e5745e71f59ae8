#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/document/look.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// The pictures of models as textures of the current context. A picture is unpacked when it is first drawn, and kept
/// while models that have it are drawn, also when their shapes change.
class Textures {
 public:
  Textures() = default;
  ~Textures();
  Textures(Textures&& other) noexcept;
  Textures& operator=(Textures&& other) noexcept;

  /// Has the pictures that the batches use, and no others. Two are unpacked at a time, so that memory is little above
  /// that of the textures. A side has 2048 px at most, and all together 9.6 million: where they would have more,
  /// sides are halved, the largest first and those of what moves last.
  void keep(const document::Look& look, std::span<const LookBatch> batches);
  void clear();
  /// Binds a picture to texture unit 0 as it is to be used. False: it cannot be read.
  bool bind(const document::Look& look, const document::TextureUse& use) const;
  /// Pictures that could not be unpacked, "NAME (why)" as Look::undrawn; each is told once.
  [[nodiscard]] std::vector<std::string> take_undrawn();

 private:
  struct Texture {
    document::KeptBytes bytes;  ///< kept, so that no other picture lies at their place
    unsigned name = 0;          ///< 0: cannot be read
    int most_px = 0;            ///< a side was made no longer than this
  };
  std::map<const std::uint8_t*, Texture> names_;  ///< by where their bytes begin
  std::vector<std::string> undrawn_;
};

}  // namespace penpose::render
