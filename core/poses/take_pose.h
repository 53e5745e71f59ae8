#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/document/named_value.h"
#include "core/poses/face_measure.h"

namespace penpose::poses {

/// How a pose is taken to a rig.
enum class Way : std::uint8_t {
  names,    ///< values of controls of the same names, or of those that programs agree on
  effects,  ///< by what controls do: features go as far as those of the pose
  lines,    ///< by the lines that it was drawn with
};
/// "names", "effects", "lines".
[[nodiscard]] std::string_view name_of(Way way);
[[nodiscard]] std::optional<Way> way_named(std::string_view name);

struct TakeOptions {
  FacePart part = FacePart::all;
  std::optional<Way> way = {};  ///< that one alone; none: the first that fits
};

/// A pose for another rig.
struct TakenPose {
  Way way = Way::names;
  std::vector<document::NamedValue> values;  ///< controls of the rig, within their ranges; what is not named stays
  std::vector<std::string> missing;          ///< controls of the pose that nothing stands for
  std::vector<std::string> clamped;          ///< controls of the rig whose value was out of range
  /// What is left of the moves of features, as a share of all that the pose asks for; none: nothing is measured.
  std::optional<double> left = {};
};

/// The pose for a rig: by names where all of its controls are there and the features then go about as they should; else
/// by what controls do; else by its lines; else by the names that there are. `face`: of the model, null where it has no
/// features. The same on every machine. Errors: the rig has nothing for the pose, or nothing for the asked way.
[[nodiscard]] base::Result<TakenPose> take_pose(const KeptPose& pose, const document::Model& model,
                                                const FaceMeasure* face, const TakeOptions& options);

/// The pose on top of another one.
[[nodiscard]] rig::Pose with_values(const rig::Rig& rig, rig::Pose pose,
                                    const std::vector<document::NamedValue>& values);

/// What is said of it: by what, and what could not be taken. One line.
[[nodiscard]] std::string words_of(const KeptPose& pose, const TakenPose& taken);

}  // namespace penpose::poses
