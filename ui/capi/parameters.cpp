#include <algorithm>
#include <cmath>

#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

std::size_t parameter_named(const character::Character& one, std::string_view name) {
  const auto found = rig::find_parameter(one.parameters(), name);
  if (!found)
    fail(PENPOSE_REFUSED, {"the character has no parameter \"" + std::string(name) + "\"", "name",
                           "ask for those that there are (penpose_parameter)"});
  return *found;
}

/// The pose that a caller gives; none: the character's own.
std::span<const double> pose_or_own(const character::Character& one, const double* values, std::size_t count) {
  if (values == nullptr && count == 0) return one.pose();
  const auto given = array(values, count, "values");
  if (given.size() != one.parameters().size()) {
    fail_argument(std::to_string(count) + " values for " + std::to_string(one.parameters().size()) + " parameters",
                  "value_count", "give one value a parameter");
  }
  if (!std::all_of(given.begin(), given.end(), [](double value) { return std::isfinite(value); }))
    fail_argument("a value that is not finite", "values", "give numbers");
  return given;
}

void check_vertices(const character::Character& one, std::size_t vertices) {
  if (vertices == one.vertex_count()) return;
  fail_argument("room for " + std::to_string(vertices) + " vertices of " + std::to_string(one.vertex_count()),
                "vertices", "give room for exactly as many as there are");
}

}  // namespace

int32_t penpose_parameter(penpose_library* library, penpose_handle character, size_t parameter, char* name,
                          size_t capacity, size_t* length, double range[3], penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    if (parameter >= one.parameters().size()) {
      fail_argument("there are " + std::to_string(one.parameters().size()) + " parameters", "parameter",
                    "give a number below");
    }
    const rig::Parameter& found = one.parameters()[parameter];
    if (length != nullptr) *length = found.name.size();
    if (range != nullptr) {
      range[0] = found.minimum;
      range[1] = found.rest;
      range[2] = found.maximum;
    }
    const auto room = array(name, capacity, "name");
    if (room.empty()) return;
    if (room.size() <= found.name.size()) {
      fail(PENPOSE_TOO_SMALL,
           {"the name has " + std::to_string(found.name.size()) + " bytes", "capacity", "give room for it and a 0"});
    }
    std::copy_n(found.name.c_str(), found.name.size() + 1, room.begin());
  });
}

int32_t penpose_find_parameter(penpose_library* library, penpose_handle character, const char* name, size_t* parameter,
                               penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    needed(parameter, "parameter") = parameter_named(one, text(name, "name"));
  });
}

int32_t penpose_get_pose(penpose_library* library, penpose_handle character, double* values, size_t count,
                         penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    if (count != one.pose().size()) {
      fail_argument(std::to_string(count) + " values for " + std::to_string(one.pose().size()) + " parameters", "count",
                    "give room for one value a parameter");
    }
    std::copy(one.pose().begin(), one.pose().end(), array(values, count, "values").begin());
  });
}

int32_t penpose_set_pose(penpose_library* library, penpose_handle character, const double* values, size_t count,
                         penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.set_pose(array(values, count, "values")));
  });
}

int32_t penpose_set_parameter(penpose_library* library, penpose_handle character, const char* name, double value,
                              penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.perform(document::SetParameters{{{std::string(text(name, "name")), value}}}));
  });
}

int32_t penpose_reset(penpose_library* library, penpose_handle character, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.perform(document::ResetParameters{}));
  });
}

int32_t penpose_lock(penpose_library* library, penpose_handle character, const char* name, int32_t locked,
                     penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    if (locked != 0 && locked != 1) fail_argument("neither 0 nor 1", "locked", "give 1 to lock, 0 to free");
    done(one.perform(document::LockParameters{{std::string(text(name, "name"))}, locked == 1}));
  });
}

int32_t penpose_evaluate(penpose_library* library, penpose_handle character, const double* values, size_t value_count,
                         double* xyz, size_t vertices, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    const auto pose = pose_or_own(one, values, value_count);
    check_vertices(one, vertices);
    const auto out = array(xyz, 3 * vertices, "xyz");
    // A point is three numbers and nothing else: they are written where the caller wants them.
    static_assert(sizeof(geometry::ModelPoint) == 3 * sizeof(double));
    one.evaluate(pose, {reinterpret_cast<geometry::ModelPoint*>(out.data()), vertices});
  });
}

int32_t penpose_evaluate_float(penpose_library* library, penpose_handle character, const double* values,
                               size_t value_count, float* xyz, size_t vertices, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    const auto pose = pose_or_own(one, values, value_count);
    check_vertices(one, vertices);
    const auto out = array(xyz, 3 * vertices, "xyz");
    std::vector<geometry::ModelPoint> positions(vertices);
    one.evaluate(pose, positions);
    for (std::size_t v = 0; v < vertices; ++v) {
      for (int axis = 0; axis < 3; ++axis) out[3 * v + axis] = static_cast<float>(positions[v][axis]);
    }
  });
}
