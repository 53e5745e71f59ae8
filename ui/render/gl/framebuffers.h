#pragma once

#include <vector>

#include "core/base/result.h"
#include "ui/render/gl/gl_dialect.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// Samples a px of pictures that are not smoothed.
inline constexpr int k_most_samples = 8;

/// What a picture is drawn into, of the current context: a multisampled target for surfaces, the resolved picture with
/// a readable depth, and two textures for the occlusion. Without the modern dialect it has one sample a px, and a depth
/// that cannot be read. Kept while the size stays.
class Framebuffers {
 public:
  explicit Framebuffers(const GlDialect& dialect) : dialect_(dialect) {}
  ~Framebuffers();
  Framebuffers(const Framebuffers&) = delete;
  Framebuffers& operator=(const Framebuffers&) = delete;

  /// Samples a px; each costs its memory, and time on a software renderer. Counts for targets that are made from now
  /// on.
  void set_most_samples(int most) { most_samples_ = most; }
  /// Makes targets of that size where there are none yet. Errors: larger than the driver can.
  base::Status resize(int width, int height);

  /// Draws go to the multisampled target from here on.
  void begin_surfaces() const;
  /// Color and depth are averaged into the picture, where draws go from here on. With one sample a px surfaces are
  /// drawn into the picture itself.
  void resolve() const;
  /// Adds the picture to an average of pictures, with a share of the whole; the first one with 1. Leaves blending on.
  /// `fill` draws a texture over everything.
  template <typename Fill>
  void average(float share, const Fill& fill) {
    begin_average(share);
    fill(picture_color_);
    begin_picture();
  }
  /// The average in place of the picture, where draws go from here on. `fill` draws a texture over everything.
  template <typename Fill>
  void show_average(const Fill& fill) const {
    if (dialect_.modern) return blit_average();
    begin_picture();
    fill(average_texture_);
  }
  /// Draws go to the texture of the raw occlusion (same size as the picture).
  void begin_occlusion();
  /// Back to the picture.
  void begin_picture() const;
  /// A picture without depth test on its depth, so that the depth can be read.
  void begin_picture_without_depth() const;

  [[nodiscard]] unsigned depth_texture() const { return depth_texture_; }
  [[nodiscard]] unsigned occlusion_texture() const { return occlusion_texture_; }
  [[nodiscard]] int samples() const { return samples_; }

  [[nodiscard]] Image read() const;
  /// Copies the picture to another framebuffer (0: the window), its lower left corner at x, y. `fill` as above.
  template <typename Fill>
  void copy_to(unsigned framebuffer, int x, int y, const Fill& fill) const {
    if (dialect_.modern) return blit_to(framebuffer, x, y);
    begin_other(framebuffer, x, y);
    fill(picture_color_);
  }

 private:
  void blit_average() const;
  void blit_to(unsigned framebuffer, int x, int y) const;
  void begin_other(unsigned framebuffer, int x, int y) const;
  void release();
  void begin_average(float share);

  GlDialect dialect_;
  int width_ = 0;
  int height_ = 0;
  int samples_ = 0;
  int most_samples_ = k_most_samples;
  unsigned surface_target_ = 0;
  unsigned surface_color_ = 0;
  unsigned surface_depth_ = 0;
  unsigned picture_target_ = 0;
  unsigned picture_plain_target_ = 0;
  unsigned picture_color_ = 0;
  unsigned depth_texture_ = 0;
  unsigned plain_depth_ = 0;  ///< in place of that texture
  unsigned occlusion_target_ = 0;
  unsigned occlusion_texture_ = 0;
  unsigned average_target_ = 0;
  unsigned average_texture_ = 0;
};

}  // namespace penpose::render
