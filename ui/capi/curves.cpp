#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

bool is_constraint(std::int32_t role) {
  return meaning_of<bool>(role, {{PENPOSE_REFERENCE, false}, {PENPOSE_CONSTRAINT, true}}, "role",
                          "give PENPOSE_REFERENCE or PENPOSE_CONSTRAINT");
}

void place(character::Character& one, std::span<const mesh::MeshPoint> points, bool constraint, std::uint32_t& curve) {
  curve = taken(constraint ? one.place_constraint(points) : one.place_reference(points)).value;
}

character::Preset preset_of(std::int32_t preset) {
  using character::Preset;
  return meaning_of<Preset>(preset,
                            {{PENPOSE_PRESET_DEFAULT, Preset::meant},
                             {PENPOSE_PRESET_EXACT, Preset::exact},
                             {PENPOSE_PRESET_PAPER, Preset::paper}},
                            "preset", "give one of PENPOSE_PRESET_...");
}

}  // namespace

int32_t penpose_curve_from_vertices(penpose_library* library, penpose_handle character, const uint32_t* vertices,
                                    size_t count, int32_t role, uint32_t* curve, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    needed(curve, "curve");
    const bool constraint = is_constraint(role);
    place(one, taken(one.points_at(array(vertices, count, "vertices"))), constraint, *curve);
  });
}

int32_t penpose_curve_from_points(penpose_library* library, penpose_handle character, const penpose_mesh_point* points,
                                  size_t count, int32_t role, uint32_t* curve, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    needed(curve, "curve");
    const bool constraint = is_constraint(role);
    std::vector<mesh::MeshPoint> on_mesh;
    for (const penpose_mesh_point& point : array(points, count, "points"))
      on_mesh.push_back({point.triangle, {point.shares[0], point.shares[1], point.shares[2]}});
    place(one, on_mesh, constraint, *curve);
  });
}

int32_t penpose_curve_from_stroke(penpose_library* library, penpose_handle character, const penpose_view* view,
                                  const double* px, size_t count, int32_t role, uint32_t* curve, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    needed(curve, "curve");
    const bool constraint = is_constraint(role);
    const auto seen = view_of(needed(view, "view"));
    const auto line = line_of(px, count, "px");
    *curve = taken(constraint ? one.draw_constraint(seen, line) : one.draw_reference(seen, line)).value;
  });
}

int32_t penpose_curve_named(penpose_library* library, penpose_handle character, const char* name, int32_t role,
                            uint32_t* curve, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    needed(curve, "curve");
    const bool constraint = is_constraint(role);
    place(one, taken(one.points_of(text(name, "name"))), constraint, *curve);
  });
}

int32_t penpose_curve_positions(penpose_library* library, penpose_handle character, uint32_t curve, double* xyz,
                                size_t room, size_t* count, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    const auto positions = taken(one.positions_of({curve}));
    needed(count, "count") = positions.size();
    if (xyz == nullptr && room == 0) return;
    if (room < positions.size()) {
      fail(PENPOSE_TOO_SMALL, {"the curve has " + std::to_string(positions.size()) + " points", "room", "give more"});
    }
    double* out = array(xyz, 3 * positions.size(), "xyz").data();
    for (const geometry::ModelPoint& p : positions) {
      for (int axis = 0; axis < 3; ++axis) *out++ = p[axis];
    }
  });
}

int32_t penpose_curve_points(penpose_library* library, penpose_handle character, uint32_t curve,
                             penpose_mesh_point* points, size_t room, size_t* count, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    std::vector<penpose_mesh_point> out;
    for (const mesh::MeshPoint& point : taken(one.points_of(document::CurveId{curve})))
      out.push_back({point.triangle, {point.barycentric[0], point.barycentric[1], point.barycentric[2]}});
    write_list<penpose_mesh_point>(out, points, room, count, "points");
  });
}

int32_t penpose_curve_distances(penpose_library* library, penpose_handle character, uint32_t curve, double* distances,
                                size_t room, size_t* count, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    write_list<double>(taken(one.distances_of({curve})), distances, room, count, "distances");
  });
}

int32_t penpose_curve_delete(penpose_library* library, penpose_handle character, uint32_t curve, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.perform(document::DeleteCurve{{curve}}));
  });
}

int32_t penpose_curves_clear(penpose_library* library, penpose_handle character, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.perform(document::ClearCurves{}));
  });
}

int32_t penpose_target_points(penpose_library* library, penpose_handle character, uint32_t curve, const double* xyz,
                              size_t count, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.place_target({curve}, points_of(xyz, count, "xyz")));
  });
}

int32_t penpose_target_stroke(penpose_library* library, penpose_handle character, uint32_t curve,
                              const penpose_view* view, const double* px, const double* pressure, size_t count,
                              penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    const auto pressed = array(pressure, pressure == nullptr ? 0 : count, "pressure");
    done(one.draw_target({curve}, view_of(needed(view, "view")), line_of(px, count, "px"), pressed));
  });
}

int32_t penpose_solve(penpose_library* library, penpose_handle character, int32_t preset, penpose_error* error) {
  return call_character(library, character, error,
                        [&](character::Character& one, CharacterObject&) { done(one.solve(preset_of(preset))); });
}

int32_t penpose_live_begin(penpose_library* library, penpose_handle character, uint32_t curve, const penpose_view* view,
                           penpose_handle* live, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    needed(live, "live");
    give<LiveObject>(*library, *live, taken(character::LiveTarget::begin(one, {curve}, view_of(needed(view, "view")))));
  });
}

int32_t penpose_live_follow(penpose_library* library, penpose_handle live, const double* px, size_t count,
                            double* values, size_t value_count, int32_t* moved, penpose_error* error) {
  return call_with<LiveObject>(library, live, error, [&](LiveObject& object) {
    if (value_count != object.live.pose().size()) {
      fail_argument(
          "room for " + std::to_string(value_count) + " values of " + std::to_string(object.live.pose().size()),
          "value_count", "give room for one value a parameter");
    }
    const auto out = array(values, value_count, "values");
    const auto line = line_of(px, count, "px");
    for (const geometry::PxPoint& p : line) {
      const bool is_near = p.x >= -1e6 && p.x <= 1e6 && p.y >= -1e6 && p.y <= 1e6;
      if (!is_near) fail_argument("a place that is not finite or farther out than a million px", "px", "give px");
    }
    const bool solved = object.live.follow(line);
    if (moved != nullptr) *moved = solved ? 1 : 0;
    std::copy(object.live.pose().begin(), object.live.pose().end(), out.begin());
  });
}
