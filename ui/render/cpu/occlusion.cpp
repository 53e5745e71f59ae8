#include "ui/render/cpu/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "ui/render/cpu/mixing.h"
#include "ui/render/light/crease_radius.h"

namespace penpose::render {
namespace {

/// Light that bounces out of a crease is warm, and never quite gone: what the picture is multiplied by.
struct Dimming {
  std::array<std::array<float, 3>, 1025> by_open;
  Dimming() {
    for (std::size_t i = 0; i < by_open.size(); ++i) {
      const float open = static_cast<float>(i) / static_cast<float>(by_open.size() - 1);
      const auto red = static_cast<float>(base::pow(static_cast<double>(open), 0.82));
      by_open[i] = {mixed(0.14F, 1.0F, red), mixed(0.07F, 1.0F, open), mixed(0.06F, 1.0F, open)};
    }
  }
};

}  // namespace

Occlusion::Occlusion(const Raster& raster, std::span<const float> inverse_depths)
    : raster_(raster),
      inverse_(inverse_depths),
      far_(1.0F / (raster.view.depth_to_z.x + raster.view.depth_to_z.y)),
      radius_(crease_radius(raster.view)),
      open_(inverse_depths.size(), 255) {
  for (int i = 0; i < k_samples; ++i) {
    const double t = (i + 0.5) / k_samples;
    const double angle = t * 2 * base::k_pi * 7;
    places_[static_cast<std::size_t>(i)] = glm::vec2(base::cos(angle) * t, base::sin(angle) * t);
  }
}

float Occlusion::inverse_at(int x, int y) const {
  const int column = std::clamp(x, 0, raster_.size.width - 1);
  const int row = std::clamp(y, 0, raster_.size.height - 1);
  return inverse_[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster_.size.width) +
                  static_cast<std::size_t>(column)];
}

float Occlusion::depth_at(int x, int y) const {
  const float inverse = inverse_at(x, y);
  return inverse > 0 ? 1.0F / inverse : far_;
}

glm::vec3 Occlusion::point(float place_x, float place_y, float depth) const {
  return {(place_x * 2.0F - 1.0F) * raster_.view.image_plane.x * depth,
          (1.0F - place_y * 2.0F) * raster_.view.image_plane.y * depth, -depth};
}

float Occlusion::open_at(int x, int y) const {
  const auto width = static_cast<float>(raster_.size.width);
  const auto height = static_cast<float>(raster_.size.height);
  const float place_x = (static_cast<float>(x) + 0.5F) / width;
  const float place_y = (static_cast<float>(y) + 0.5F) / height;
  const glm::vec3 p = point(place_x, place_y, depth_at(x, y));
  const auto beside = [&](int dx, int dy) {
    return point(place_x + static_cast<float>(dx) / width, place_y + static_cast<float>(dy) / height,
                 depth_at(x + dx, y + dy));
  };
  const glm::vec3 right = beside(1, 0) - p;
  const glm::vec3 left = p - beside(-1, 0);
  const glm::vec3 up = beside(0, -1) - p;
  const glm::vec3 down = p - beside(0, 1);
  const glm::vec3 along_x = std::abs(right.z) < std::abs(left.z) ? right : left;
  const glm::vec3 along_y = std::abs(up.z) < std::abs(down.z) ? up : down;
  const glm::vec3 normal = glm::cross(along_x, along_y);
  const float size2 = glm::dot(normal, normal);
  if (!(size2 > 0)) return 1.0F;
  const glm::vec3 n = normal * (1.0F / std::sqrt(size2));
  const float reach = radius_ / (-p.z * raster_.view.image_plane.y) * 0.5F;
  // Rows count from the foot where the noise was made for.
  const float noise = fraction(52.9829189F * fraction((static_cast<float>(x) + 0.5F) * 0.06711056F +
                                                      (height - static_cast<float>(y) - 0.5F) * 0.00583715F));
  const double turn = static_cast<double>(noise) * 2 * base::k_pi;
  const auto cosine = static_cast<float>(base::cos(turn));
  const auto sine = static_cast<float>(base::sin(turn));
  float sum = 0;
  for (const glm::vec2& place : places_) {
    const float at_x = place_x + (place.x * cosine - place.y * sine) * height / width * reach;
    const float at_y = place_y - (place.x * sine + place.y * cosine) * reach;
    if (at_x < 0.0F || at_y < 0.0F || at_x > 1.0F || at_y > 1.0F) continue;
    const float inverse = inverse_at(static_cast<int>(at_x * width), static_cast<int>(at_y * height));
    if (!(inverse > 0)) continue;
    const glm::vec3 d = point(at_x, at_y, 1.0F / inverse) - p;
    const float dd = glm::dot(d, d);
    const float close = std::max(1.0F - dd / (radius_ * radius_), 0.0F);
    sum += close * std::max(glm::dot(d, n) - 0.012F * radius_, 0.0F) / (dd + 0.0004F * radius_ * radius_) * radius_;
  }
  return std::clamp(1.08F - 0.75F * sum / static_cast<float>(k_samples), 0.0F, 1.0F);
}

void Occlusion::measure_row(int y) {
  const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.size.width);
  for (int x = 0; x < raster_.size.width; ++x) {
    const std::size_t i = row + static_cast<std::size_t>(x);
    if (inverse_[i] > 0) open_[i] = static_cast<std::uint8_t>(open_at(x, y) * 255.0F + 0.5F);
  }
}

void Occlusion::darken_row(int y, Image& picture) const {
  static const Dimming dimming;
  const int width = raster_.size.width;
  for (int x = 0; x < width; ++x) {
    const float z = depth_at(x, y);
    float sum = 0;
    float weights = 0;
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const int column = std::clamp(x + dx, 0, width - 1);
        const int row = std::clamp(y + dy, 0, raster_.size.height - 1);
        const float w = std::max(1.0F - std::abs(depth_at(column, row) - z) / (0.25F * radius_), 0.0F) + 0.0001F;
        sum += w * static_cast<float>(open_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                            static_cast<std::size_t>(column)]);
        weights += w;
      }
    }
    const float open = sum / weights * (1.0F / 255.0F);
    if (open >= 1.0F) continue;
    const auto& dim = dimming.by_open[static_cast<std::size_t>(open * 1024.0F + 0.5F)];
    std::uint8_t* const out = px_of(picture, x, y);
    for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(static_cast<float>(out[c]) * dim[c] + 0.5F);
  }
}

}  // namespace penpose::render
