#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/time/timeline.h"

namespace penpose::cli {

/// So many key poses are taken at most; an animation that has a key for every frame has more than an artist makes.
inline constexpr std::size_t k_most_keyed_poses = 2000;

/// A model, a project, or a session (by its name, FILE.session), replayed to its end. Errors of reading; a session that
/// holds nothing, or does not replay as it was recorded.
[[nodiscard]] base::Result<document::Document> load_posed(const std::string& path);

/// Every `every`-th key of the document's timeline, or where it has none of the model's first animation. Errors: there
/// is neither; more than k_most_keyed_poses.
[[nodiscard]] base::Result<std::vector<document::PoseKey>> keyed_poses(const document::Document& document,
                                                                       std::size_t every);

/// Keys of another rig as poses of this one, by the names of the parameters and within their ranges; what the other
/// does not have is at rest. Errors: no name is in both.
[[nodiscard]] base::Result<std::vector<document::PoseKey>> carried_over(std::vector<document::PoseKey> keys,
                                                                        std::span<const rig::Parameter> from,
                                                                        std::span<const rig::Parameter> to);

}  // namespace penpose::cli
