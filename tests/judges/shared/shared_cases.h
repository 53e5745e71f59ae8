#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tests/judges/measures/judged_sets.h"

namespace penpose::judges {

/// A file of cases as the program reads it, and what it says beyond: what was meant.
struct SharedFile {
  io::CaseFile cases;
  std::vector<nlohmann::json> meant;  ///< one a case, as it is in the file
};

/// Files of the shared data are known to be whole, so that what cannot be read ends the program.
[[nodiscard]] SharedFile read_shared_cases(const std::string& name);
[[nodiscard]] document::Model read_shared_model(const std::string& name);

/// A face with the lines of ict_face_landmarks.json, under their names there, and the poses of these cases.
[[nodiscard]] Rig shared_face(const std::string& name, document::Model model, const SharedFile& file);

/// Cases with `weights`.
[[nodiscard]] std::vector<KnownFace> known_faces_of(const document::Model& model, const SharedFile& file);
/// Cases with `need` and `accept`, regular expressions of whole names.
[[nodiscard]] std::vector<Gesture> gestures_of(const document::Model& model, const SharedFile& file);
/// Controls whose names, a joint's without its angle, one of the patterns matches.
[[nodiscard]] std::vector<std::string> controls_like(const document::Model& model, const std::string& pattern);
/// Cases with `turns` of nodes, by their numbers in the model's file.
[[nodiscard]] std::vector<Limb> limbs_of(const document::Model& model, const SharedFile& file);

}  // namespace penpose::judges
