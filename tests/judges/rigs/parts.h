#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "tests/judges/rigs/rig.h"

namespace penpose::judges {

/// A displacement of each vertex.
using Field = std::vector<geometry::ModelVector>;

/// A head at rest and what muscles do to it, each at its most. Rigs are made of sums of these. Words, with _L or _R for
/// a side (+x is _L):
///   mouth   smile_, frown_, stretch_, dimple_, press_, upper_up_, lower_down_, cheek_, puff_, pucker, funnel,
///   roll_upper,
///           roll_lower, shrug_upper, shrug_lower, mouth_L, mouth_R (all of it aside)
///   jaw     jaw_open, jaw_L, jaw_R, jaw_forward, lips_close (of an open jaw)
///   brows   brow_inner_up_, brow_outer_up_, brow_down_        nose  sneer_
///   eyes    blink_, wide_, squint_, look_up_, look_down_, look_left_, look_right_
struct Parts {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<FaceLine> lines;
  std::map<std::string, Field> fields;
  std::vector<double> jaw_share;                           ///< of each vertex: how much of it goes with the jaw
  std::map<std::string, std::vector<std::uint32_t>> eyes;  ///< vertices of the balls: "L", "R"; a creature has none
  double mouth = 0;                                        ///< half its width, model units
  std::size_t skin = 0;  ///< vertices from here on are pieces that go along with the others; 0: there are none

  [[nodiscard]] std::span<const geometry::ModelPoint> rest() const { return mesh->positions(); }
  [[nodiscard]] const std::vector<std::uint32_t>& line(std::string_view name) const;
  [[nodiscard]] const Field& field(const std::string& name) const;
};

/// The built-in head, with the controls that the program brings along and others that are made here.
[[nodiscard]] const Parts& head_parts();

/// A head of a few hundred vertices with a muzzle, made of a grid. `columns` and `rows` of vertices.
[[nodiscard]] Parts creature_parts(std::uint32_t columns = 19, std::uint32_t rows = 24);

/// The same muscles on a face of another shape: `where` moves places smoothly, and displacements follow.
[[nodiscard]] Parts reshaped(const Parts& parts,
                             const std::function<geometry::ModelPoint(const geometry::ModelPoint&)>& where);

/// Toon proportions: eyes one and a half times as large, a low and small mouth, a short chin.
[[nodiscard]] geometry::ModelPoint toon(const geometry::ModelPoint& p);
/// Another person: longer, narrower, a little crooked.
[[nodiscard]] geometry::ModelPoint other_person(const geometry::ModelPoint& p);
/// A broad face with a wide mouth.
[[nodiscard]] geometry::ModelPoint broad_person(const geometry::ModelPoint& p);

}  // namespace penpose::judges
