#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ui/render/gl/gl_dialect.h"
#include "ui/render/kept_pictures.h"

namespace penpose::render {

/// The pictures of models as textures of the current context, as KeptPictures has them: all together 9.6 million px.
/// Where there are no textures of sRGB they hold sRGB as it is, and sides that are powers of two.
class Textures {
 public:
  explicit Textures(const GlDialect& dialect) : modern_(dialect.modern) {}
  void keep(const document::Look& look, std::span<const LookBatch> batches);
  void clear() { pictures_.clear(); }
  /// Binds a picture to a texture unit, which stays active, as it is to be used. False: it cannot be read.
  bool bind(const document::Look& look, const document::TextureUse& use, unsigned unit = 0) const;
  [[nodiscard]] std::vector<std::string> take_undrawn() { return pictures_.take_undrawn(); }

 private:
  class Texture {
   public:
    explicit Texture(unsigned name) : name_(name) {}
    ~Texture();
    Texture(Texture&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Texture& operator=(Texture&&) = delete;
    [[nodiscard]] unsigned name() const { return name_; }

   private:
    unsigned name_ = 0;
  };
  bool modern_;
  KeptPictures<Texture> pictures_;
};

}  // namespace penpose::render
