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

}  // namespace penpose::render
