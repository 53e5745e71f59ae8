#include "ui/render/scene.h"

namespace penpose::render {

Color curve_color(CurveKind kind) {
  switch (kind) {
    case CurveKind::reference:
      return from_srgb(0x2fd24a);
    case CurveKind::target:
      return from_srgb(0x2f7bff);
    case CurveKind::constraint:
      return from_srgb(0xf23a3a);
  }
  return {1, 1, 1, 1};
}

bool same_background(const Background& a, const Background& b) {
  const auto same = [](const Color& c, const Color& d) { return c.r == d.r && c.g == d.g && c.b == d.b && c.a == d.a; };
  return same(a.top, b.top) && same(a.bottom, b.bottom) && a.vignette == b.vignette;
}

}  // namespace penpose::render
