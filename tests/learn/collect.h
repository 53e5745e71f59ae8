#pragma once

#include <map>
#include <vector>

#include "tests/judges/cases/gestures.h"
#include "tests/judges/cases/known_faces.h"
#include "tests/judges/rigs/rig.h"
#include "tests/learn/fit.h"

namespace penpose::learn {

/// Poses whose controls were once a reading of a case, by the case's name: they stay rivals in later rounds.
using KnownReadings = std::map<std::string, std::vector<rig::Pose>>;

/// What is asked of a model.
struct Asked {
  std::string name;
  const document::Model& model;
  std::vector<judges::Gesture> gestures;
  std::vector<judges::KnownFace> faces;
};
/// Readings of all these cases by these weights, judged. `known` receives the readings.
[[nodiscard]] std::vector<LearnCase> collect(const Asked& asked, const inference::Weights& weights,
                                             KnownReadings& known);

/// The same of a rig: gestures, and whole faces of known poses.
[[nodiscard]] std::vector<LearnCase> collect(const judges::Rig& rig, const inference::Weights& weights,
                                             KnownReadings& known);

}  // namespace penpose::learn
