#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/document/look.h"

namespace penpose::render {

/// The pictures of models as textures of the current context. A picture is unpacked when it is first drawn, and kept
/// while models that have it are drawn, also when their shapes change.
class Textures {
 public:
  Textures() = default;
  ~Textures();
  Textures(Textures&& other) noexcept;
  Textures& operator=(Textures&& other) noexcept;

  /// Has the pictures that the look's surfaces use, and no others. Two are unpacked at a time, so that memory is little
  /// above that of the textures.
  void keep(const document::Look& look, const std::vector<bool>& surface_is_used);
  void clear();
  /// Binds a picture to texture unit 0 as it is to be used. False: it cannot be read.
  bool bind(const document::Look& look, const document::TextureUse& use) const;
  /// Pictures that could not be read and why, one line each; each is told once.
  [[nodiscard]] std::vector<std::string> take_notes();

 private:
  using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

  std::map<Bytes, unsigned> names_;  ///< 0: cannot be read
  std::vector<std::string> notes_;
};

}  // namespace penpose::render
