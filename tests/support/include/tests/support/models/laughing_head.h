#pragma once

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "core/character/character.h"
#include "core/character/demo_head.h"
#include "core/geometry/camera.h"

namespace penpose::tests {

[[nodiscard]] inline character::Character demo_character() {
  return character::Character(document::make_document(character::make_demo_head().value()));
}

/// A drawing of the built-in head that laughs: the curves that its model names, as a view shows them.
struct LaughingHead {
  static constexpr double k_jaw = 0.5, k_corner = 0.8;
  static inline const std::vector<document::NamedValue> k_values = {
      {"jaw", k_jaw}, {"mouth_corner_L", k_corner}, {"mouth_corner_R", k_corner}};

  document::View view;
  std::vector<std::string> names;  ///< of the curve of each line
  std::vector<std::vector<geometry::PxPoint>> lines;

  /// `laughs`: or is at rest.
  explicit LaughingHead(double yaw_degrees = 0, bool laughs = true) {
    character::Character head = demo_character();
    view = head.view_from(yaw_degrees);
    if (laughs) {
      EXPECT_TRUE(head.perform(document::SetParameters{k_values}));
    }
    const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
    for (const document::NamedCurve& curve : head.document().model->curves) {
      if (curve.points.size() < 2) continue;
      names.push_back(curve.name);
      auto& line = lines.emplace_back();
      for (const auto& p : document::positions_of(head.document(), curve.points))
        line.push_back(camera.project(p).value());
    }
  }

  /// How many of the lines were taken for what they are.
  [[nodiscard]] std::size_t right(const std::vector<std::string>& taken) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < names.size() && i < taken.size(); ++i) count += taken[i] == names[i] ? 1U : 0U;
    return count;
  }
};

}  // namespace penpose::tests
