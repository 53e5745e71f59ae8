#pragma once

#include "ui/render/gl/vertex_array.h"

namespace penpose::render {

/// One triangle that covers the viewport, of the current context: for programs of k_screen_vertex, whose only attribute
/// is `corner`.
class ScreenFill {
 public:
  explicit ScreenFill(const GlDialect& dialect);
  ~ScreenFill();
  ScreenFill(const ScreenFill&) = delete;
  ScreenFill& operator=(const ScreenFill&) = delete;

  /// With the program in use.
  void draw() const;

 private:
  VertexArray array_;
  unsigned corners_ = 0;
};

}  // namespace penpose::render
