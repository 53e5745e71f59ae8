#include "core/articulation/region/kept_surface.h"

namespace penpose::articulation {

base::Result<KeptSurface> KeptSurface::make(const Surface& surface, const Canvas& canvas) {
  using Held = base::Result<std::shared_ptr<const HeldSurface>>;
  auto held = of_surface(surface, Held(nullptr), [&](const auto& one) { return one.held(canvas); });
  if (!held) return held.error();
  return KeptSurface(std::move(held).value());
}

}  // namespace penpose::articulation
