#pragma once

#include <cstddef>
#include <vector>

#include "core/document/model.h"
#include "core/io/gltf/write/glb_targets.h"

namespace penpose::io {

/// The keys of a weights channel as a file has them: weights of all targets, and so many keys more that the targets of
/// baked deformers follow in between.
struct DenseKeys {
  std::vector<float> times_s;             ///< ascending
  std::vector<std::vector<double>> rows;  ///< one a key (cubic splines: in-tangent, value, out-tangent)
  bool straightened = false;              ///< a cubic spline as straight lines, values alone: `spline` has what it was
  struct Spline {
    std::vector<float> times_s;
    std::vector<std::vector<double>> rows;
  } spline;                        ///< the channel's own keys, where it was straightened
  std::vector<std::size_t> added;  ///< which keys the channel does not have itself, ascending
  double error = 0;                ///< farthest that a vertex is off in between, model units
};

/// Programs mix the weights of all targets alike from key to key, but those with the remaining motion of a deformer
/// are not linear in its amount: keys are added half-way until no vertex is off by more than `tolerance` (model units)
/// at any of several times in between, cubic splines drawn as straight lines (Blender's importer has tangents of its
/// own), or until keys lie as close as 1/128 of what lay between them. Where no deformer is baked and the keys of a
/// spline lie on whole frames, those that are added do so too, at most one a frame. Precondition: the channel is of
/// weights and fits the targets. Splines of very many keys stay what they are.
[[nodiscard]] DenseKeys dense_keys(const document::Channel& channel, const GlbTargets& targets, double tolerance);

}  // namespace penpose::io
