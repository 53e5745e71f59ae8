#include "ui/render/cpu/ground_rows.h"

#include <algorithm>
#include <cmath>

#include "ui/render/cpu/mixing.h"
#include "ui/render/light/baked_light.h"

namespace penpose::render {
namespace {

/// Of a place on the square, -1..1 each way, between the middles of px.
float ground_shade_at(const BakedLight& light, float x, float z) {
  constexpr int k_last = BakedLight::k_ground_px - 1;
  const float column = (x * 0.5F + 0.5F) * static_cast<float>(BakedLight::k_ground_px) - 0.5F;
  const float row = (z * 0.5F + 0.5F) * static_cast<float>(BakedLight::k_ground_px) - 0.5F;
  const int left = static_cast<int>(std::floor(column));
  const int top = static_cast<int>(std::floor(row));
  const float right = column - static_cast<float>(left);
  const float lower = row - static_cast<float>(top);
  const auto read = [&](int at_x, int at_y) {
    return static_cast<float>(light.ground_shade[static_cast<std::size_t>(
        std::clamp(at_y, 0, k_last) * BakedLight::k_ground_px + std::clamp(at_x, 0, k_last))]);
  };
  return mixed(mixed(read(left, top), read(left + 1, top), right),
               mixed(read(left, top + 1), read(left + 1, top + 1), right), lower) *
         (1.0F / 255.0F);
}

}  // namespace

void draw_ground(const BakedLight& light, const View& view, Image& backdrop) {
  const auto seen = view_of_ground(light, view, {backdrop.width, backdrop.height});
  if (!seen) return;
  const glm::mat4& m = view.to_view;
  for (int y = seen->top; y < seen->bottom; ++y) {
    const float up =
        (1.0F - 2.0F * (static_cast<float>(y) + 0.5F) / static_cast<float>(backdrop.height)) * view.image_plane.y;
    for (int x = seen->left; x < seen->right; ++x) {
      const float across =
          (2.0F * (static_cast<float>(x) + 0.5F) / static_cast<float>(backdrop.width) - 1.0F) * view.image_plane.x;
      // The ray in the world: a product with the turned-back view.
      const float down = m[1][0] * across + m[1][1] * up - m[1][2];
      if (down >= -0.0001F) continue;
      const float far = -seen->eye.y / down;
      const float at_x = seen->eye.x + far * (m[0][0] * across + m[0][1] * up - m[0][2]);
      const float at_z = seen->eye.z + far * (m[2][0] * across + m[2][1] * up - m[2][2]);
      if (std::abs(at_x) >= 1.0F || std::abs(at_z) >= 1.0F) continue;
      const float open = 1.0F - k_ground_opacity * ground_shade_at(light, at_x, at_z);
      std::uint8_t* const out = px_of(backdrop, x, y);
      for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(static_cast<float>(out[c]) * open + 0.5F);
    }
  }
}

}  // namespace penpose::render
