#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/rig/rig.h"

namespace penpose::io {

/// The member "project" of a file as today's projects have it (project_json.h):
///
/// - "interpolation" of a timeline, "linear" or "smooth", which projects up to edition 4 have in place of kinds of
///   keys, becomes the kind of all its keys;
/// - where controls of the file stay blend shapes, poses and keys come into the order of the model's parameters.
///   `of_file`: the names of the file's parameters in its order; empty: they are the model's. A parameter that the file
///   has no value of is at rest.
///
/// What has another form stays as it is, for the reader to refuse.
[[nodiscard]] json::Json todays_project(const json::Json& project, const std::vector<std::string>& of_file,
                                        std::span<const rig::Parameter> parameters);

}  // namespace penpose::io
