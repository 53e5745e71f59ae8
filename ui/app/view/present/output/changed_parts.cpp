#include "ui/app/view/present/output/changed_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace penpose::app {
namespace {

using render::Image;
using render::PxRect;

/// Px of a side of what is compared at once.
constexpr int k_block = 16;
/// A driver takes so many at once for certain; more are put into one.
constexpr std::size_t k_most_parts = 16;

bool same(const Image& before, const Image& now, const PxRect& block) {
  const auto bytes = static_cast<std::size_t>(block.right - block.left) * 4;
  for (int y = block.top; y < block.bottom; ++y) {
    if (std::memcmp(before.at(block.left, y), now.at(block.left, y), bytes) != 0) return false;
  }
  return true;
}

/// Lengthens a rectangle that ends where this one begins, or adds it.
void add_below(std::vector<PxRect>& parts, const PxRect& run) {
  for (PxRect& part : parts) {
    if (part.bottom == run.top && part.left == run.left && part.right == run.right) {
      part.bottom = run.bottom;
      return;
    }
  }
  parts.push_back(run);
}

}  // namespace

std::vector<PxRect> changed_parts(const Image& before, const Image& now) {
  const PxRect all{0, 0, now.width, now.height};
  if (before.width != now.width || before.height != now.height) return {all};
  std::vector<PxRect> parts;
  PxRect around{now.width, now.height, 0, 0};
  for (int top = 0; top < now.height; top += k_block) {
    const int bottom = std::min(now.height, top + k_block);
    // Ends with one column that is outside and the same.
    PxRect run{0, top, 0, bottom};
    for (int left = 0; left <= now.width + k_block; left += k_block) {
      const PxRect block{left, top, std::min(now.width, left + k_block), bottom};
      if (left < now.width && !same(before, now, block)) {
        if (run.empty()) run.left = left;
        run.right = block.right;
      } else if (!run.empty()) {
        add_below(parts, run);
        around = {std::min(around.left, run.left), std::min(around.top, top), std::max(around.right, run.right),
                  bottom};
        run = {0, top, 0, bottom};
      }
    }
  }
  if (parts.size() > k_most_parts) return {around};
  return parts;
}

}  // namespace penpose::app
