#pragma once

#include <vector>

#include "core/base/result.h"
#include "ui/render/image.h"

namespace penpose::render {

/// What a picture is drawn into, of the current context: a multisampled target for surfaces, the resolved picture with
/// a readable depth, and two textures for the occlusion. Kept while the size stays.
class Framebuffers {
 public:
  Framebuffers() = default;
  ~Framebuffers();
  Framebuffers(const Framebuffers&) = delete;
  Framebuffers& operator=(const Framebuffers&) = delete;

  /// Counts for targets that are made from now on.
  void set_most_samples(int most) { most_samples_ = most; }
  /// Makes targets of that size where there are none yet. Errors: larger than the driver can.
  base::Status resize(int width, int height);

  /// Draws go to the multisampled target from here on.
  void begin_surfaces() const;
  /// Color and depth are averaged into the picture, where draws go from here on.
  void resolve() const;
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

 private:
  void release();

  int width_ = 0;
  int height_ = 0;
  int samples_ = 0;
  int most_samples_ = 8;
  unsigned surface_target_ = 0;
  unsigned surface_color_ = 0;
  unsigned surface_depth_ = 0;
  unsigned picture_target_ = 0;
  unsigned picture_plain_target_ = 0;
  unsigned picture_color_ = 0;
  unsigned depth_texture_ = 0;
  unsigned occlusion_target_ = 0;
  unsigned occlusion_texture_ = 0;
};

}  // namespace penpose::render
