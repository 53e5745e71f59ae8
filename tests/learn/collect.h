#pragma once

#include <map>
#include <vector>

#include "tests/judges/rigs/rig.h"
#include "tests/learn/fit.h"

namespace penpose::learn {

/// Poses whose controls were once a reading of a case, by the case's name: they stay rivals in later rounds.
using KnownReadings = std::map<std::string, std::vector<rig::Pose>>;

/// Readings of all cases of a rig by these weights, judged: gestures, and whole faces of known poses. `known` receives
/// the readings.
[[nodiscard]] std::vector<LearnCase> collect(const judges::Rig& rig, const inference::Weights& weights,
                                             KnownReadings& known);

}  // namespace penpose::learn
