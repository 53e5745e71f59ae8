#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/geometry/space.h"
#include "core/poses/face_part.h"

namespace penpose::poses {

using geometry::ModelVector;

/// The number of the form of files of poses; others are refused by it.
inline constexpr int k_pose_format = 1;
/// Places on a feature curve, evenly along it, at which a pose is measured.
inline constexpr std::size_t k_places = 9;

/// How far the places of a feature go from rest, in units of that feature (FaceMeasure), x to the face's own left, y
/// up, z to the front.
struct FeatureMoves {
  std::string feature;
  std::vector<ModelVector> moves;  ///< k_places
  friend bool operator==(const FeatureMoves&, const FeatureMoves&) = default;
};

/// A control that is away from rest, and what it does alone: how far it moves features in the mean.
struct KeptValue {
  std::string control;
  double value = 0;
  std::vector<std::pair<std::string, ModelVector>> does = {};  ///< by feature; empty: nothing that is measured
  friend bool operator==(const KeptValue&, const KeptValue&) = default;
};

/// A line that the pose was drawn with: places of a feature and how far the line asks them to go.
struct KeptLine {
  std::string feature;
  ModelVector from{0, 0, 1};       ///< direction to the eye that saw it, of length one
  std::vector<double> at;          ///< where along the feature, 0..1 of its length, as it runs in the file's rig
  std::vector<ModelVector> moves;  ///< one each, in units of the feature
  friend bool operator==(const KeptLine&, const KeptLine&) = default;
};

/// A pose that stands for itself, so that it can be taken to another rig.
struct KeptPose {
  std::string name;
  std::string model;                                  ///< what the rig was called
  std::vector<std::string> controls;                  ///< of the rig, all of them
  std::vector<KeptValue> values;                      ///< those away from rest
  std::vector<FeatureMoves> moves;                    ///< all of them together, without what turns the whole head
  std::vector<KeptLine> lines;                        ///< empty: it was not drawn
  std::array<std::vector<std::uint8_t>, 4> pictures;  ///< PNG files, by FacePart; empty: none
  friend bool operator==(const KeptPose&, const KeptPose&) = default;
};

/// Reads what write_kept_pose wrote, or somebody by hand: "penpose_pose", "name" and "values" alone are needed. Errors
/// (place: JSON pointer): no pose, another format, members of another type, too many or too large.
[[nodiscard]] base::Result<KeptPose> read_kept_pose(base::Bytes bytes);

/// The JSON of a pose (docs/formats.md), which reads back as the same but for numbers, which have six places.
[[nodiscard]] std::string write_kept_pose(const KeptPose& pose);

/// A name that a pose may have: 1 to 100 characters without those that steer a terminal.
[[nodiscard]] bool is_pose_name(const std::string& name);

}  // namespace penpose::poses
