#pragma once

#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "tests/support/models/sheet_model.h"
#include "ui/capi/penpose.h"

namespace penpose::tests {

/// The bent sheet as arrays that a caller of the C library has.
struct SheetArrays {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::vector<std::uint32_t>> vertices;
  std::vector<std::vector<float>> deltas;
  std::vector<penpose_shape> shapes;
  penpose_arrays arrays{};

  SheetArrays() {
    const document::Model model = sheet_model();
    for (const auto& p : model.mesh->positions()) positions.insert(positions.end(), {p.x, p.y, p.z});
    for (const auto& t : model.mesh->triangles()) triangles.insert(triangles.end(), t.begin(), t.end());
    for (const rig::BlendShape& shape : model.shapes->shapes()) {
      vertices.push_back(shape.vertices);
      auto& list = deltas.emplace_back();
      for (const auto& d : shape.deltas) list.insert(list.end(), {d.x, d.y, d.z});
    }
    shapes = {{"lift", 0, 1, vertices[0].size(), vertices[0].data(), deltas[0].data()},
              {"lean", -1, 1, vertices[1].size(), vertices[1].data(), deltas[1].data()}};
    arrays.vertex_count = positions.size() / 3;
    arrays.positions = positions.data();
    arrays.triangle_count = triangles.size() / 3;
    arrays.triangles = triangles.data();
    arrays.shape_count = shapes.size();
    arrays.shapes = shapes.data();
  }
  SheetArrays(const SheetArrays&) = delete;
  SheetArrays& operator=(const SheetArrays&) = delete;
};

/// An open C library with a sheet in it.
class CDesk {
 public:
  CDesk() {
    EXPECT_EQ(penpose_open(&open, &error), PENPOSE_OK) << error.message;
    EXPECT_EQ(penpose_character_from_arrays(open, &sheet_arrays.arrays, &sheet, &error), PENPOSE_OK) << error.message;
    view.eye[2] = 6;
    view.up[1] = 1;
    view.vertical_fov_degrees = 30;
    view.width = view.height = 1000;
  }
  ~CDesk() { penpose_close(&open); }
  CDesk(const CDesk&) = delete;
  CDesk& operator=(const CDesk&) = delete;

  SheetArrays sheet_arrays;
  penpose_library* open = nullptr;
  penpose_handle sheet = 0;
  penpose_error error{};
  penpose_view view{};

  [[nodiscard]] std::string state(penpose_handle of) {
    char out[33] = {};
    EXPECT_EQ(penpose_state(open, of, out, &error), PENPOSE_OK) << error.message;
    return out;
  }
  [[nodiscard]] std::string state() { return state(sheet); }
  [[nodiscard]] std::vector<double> pose(penpose_handle of) {
    penpose_counts counts{};
    EXPECT_EQ(penpose_count(open, of, &counts, &error), PENPOSE_OK) << error.message;
    std::vector<double> values(counts.parameters);
    EXPECT_EQ(penpose_get_pose(open, of, values.data(), values.size(), &error), PENPOSE_OK) << error.message;
    return values;
  }
  [[nodiscard]] std::vector<double> pose() { return pose(sheet); }

  /// px of a line of the sheet from place to place (-1..1), as the view shows it at rest.
  [[nodiscard]] std::vector<double> line(double x0, double y0, double x1, double y1) {
    std::vector<double> xyz;
    for (int i = 0; i <= 20; ++i) {
      const double x = x0 + (x1 - x0) * i / 20;
      const double y = y0 + (y1 - y0) * i / 20;
      xyz.insert(xyz.end(), {x, y, 0.4 * (1.0 - 0.5 * (x * x + y * y))});
    }
    std::vector<double> px(2 * xyz.size() / 3);
    EXPECT_EQ(penpose_project(&view, xyz.data(), xyz.size() / 3, px.data(), &error), PENPOSE_OK) << error.message;
    return px;
  }
  [[nodiscard]] std::uint32_t draw(const std::vector<double>& px, std::int32_t role = PENPOSE_REFERENCE) {
    std::uint32_t curve = 0;
    EXPECT_EQ(penpose_curve_from_stroke(open, sheet, &view, px.data(), px.size() / 2, role, &curve, &error), PENPOSE_OK)
        << error.message;
    return curve;
  }
  /// A curve of vertices 180 to 194, which `lift` moves, and a target where `lift` brings it.
  [[nodiscard]] std::uint32_t place_lift(double lift) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 180; v < 195; ++v) vertices.push_back(v);
    std::uint32_t curve = 0;
    EXPECT_EQ(
        penpose_curve_from_vertices(open, sheet, vertices.data(), vertices.size(), PENPOSE_REFERENCE, &curve, &error),
        PENPOSE_OK)
        << error.message;
    const double values[] = {lift, 0};
    std::vector<double> all(sheet_arrays.positions.size());
    EXPECT_EQ(penpose_evaluate(open, sheet, values, 2, all.data(), all.size() / 3, &error), PENPOSE_OK);
    EXPECT_EQ(penpose_target_points(open, sheet, curve, &all[3 * 180], 15, &error), PENPOSE_OK) << error.message;
    return curve;
  }
};

/// The strokes of a deformer "up": owns the lines that a penpose_sketch points to.
struct CSketch {
  std::vector<double> general, specific, reference, target;  ///< px, x and y in turn

  /// Valid as long as the lines.
  [[nodiscard]] penpose_sketch on(const CDesk& desk) const {
    penpose_sketch sketch{};
    sketch.name = "up";
    sketch.view = desk.view;
    sketch.general = general.data();
    sketch.general_count = general.size() / 2;
    sketch.specific = specific.data();
    sketch.specific_count = specific.size() / 2;
    sketch.reference = reference.data();
    sketch.reference_count = reference.size() / 2;
    sketch.target = target.data();
    sketch.target_count = target.size() / 2;
    sketch.maximum = 1;
    return sketch;
  }
};

}  // namespace penpose::tests
