#pragma once

#include <vector>

#include "core/base/result.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// Samples a px of pictures that are not smoothed.
inline constexpr int k_most_samples = 8;

/// What a picture is drawn into, of the current context: a multisampled target for surfaces, the resolved picture with
/// a readable depth, and two textures for the occlusion. Kept while the size stays.
class Framebuffers {
 public:
  Framebuffers() = default;
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
  /// `fill` draws the texture of the picture over everything.
  template <typename Fill>
  void average(float share, const Fill& fill) {
    begin_average(share);
    fill();
    begin_picture();
  }
  /// The average in place of the picture, where draws go from here on.
  void show_average() const;
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
  /// Copies the picture to another framebuffer (0: the window), its lower left corner at x, y.
  void copy_to(unsigned framebuffer, int x, int y) const;

  [[nodiscard]] unsigned picture_texture() const { return picture_color_; }

 private:
  void release();
  void begin_average(float share);

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
  unsigned occlusion_target_ = 0;
  unsigned occlusion_texture_ = 0;
  unsigned average_target_ = 0;
  unsigned average_texture_ = 0;
};

}  // namespace penpose::render
