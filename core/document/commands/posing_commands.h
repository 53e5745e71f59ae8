#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve/bend.h"
#include "core/document/commands/named_value.h"
#include "core/document/drawing/pose_curve.h"
#include "core/mesh/mesh_point.h"

// Commands of parameters and of the curves that pose (command.h).

namespace penpose::document {

/// How curves are solved: for what was meant (core/intent), for the lowest sum of distances, or for that by the single
/// simplex of 2006.
enum class Preset : std::uint8_t { meant, exact, paper };

/// Sets parameters. Errors: no such parameter, a value out of range.
struct SetParameters {
  static constexpr std::string_view k_name = "set_parameters";
  std::vector<NamedValue> values;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("values", self.values);
  }
  friend bool operator==(const SetParameters&, const SetParameters&) = default;
};

/// Puts parameters at rest; all of them when no name is given.
struct ResetParameters {
  static constexpr std::string_view k_name = "reset_parameters";
  std::vector<std::string> names;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("names", self.names);
  }
  friend bool operator==(const ResetParameters&, const ResetParameters&) = default;
};

/// Locks parameters against the solver, or frees them.
struct LockParameters {
  static constexpr std::string_view k_name = "lock_parameters";
  std::vector<std::string> names;
  bool locked = true;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("names", self.names);
    visit("locked", self.locked);
  }
  friend bool operator==(const LockParameters&, const LockParameters&) = default;
};

/// Moves what is not held to where the keyed poses say that it belongs (core/prior). What is locked is held too.
/// Errors: no such parameter, nothing held, a strength out of 0..1, fewer than two different keys, held parameters that
/// no key moves.
struct SuggestRest {
  static constexpr std::string_view k_name = "suggest_rest";
  std::vector<std::string> held;
  double strength = 1;  ///< 0..1: how much of the way
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("held", self.held);
    visit("strength", self.strength);
  }
  friend bool operator==(const SuggestRest&, const SuggestRest&) = default;
};

// Posing.

/// Draws a reference curve on the posed surface.
struct DrawReference {
  static constexpr std::string_view k_name = "draw_reference";
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const DrawReference&, const DrawReference&) = default;
};

/// Draws (again) where a reference should go, and solves.
struct DrawTarget {
  static constexpr std::string_view k_name = "draw_target";
  CurveId curve;
  View view;
  std::vector<PxPoint> line;
  std::vector<double> pressure;  ///< 0..1, one a point of the line; empty: all 1
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
    visit("view", self.view);
    visit("line", self.line);
    visit("pressure", self.pressure);
  }
  friend bool operator==(const DrawTarget&, const DrawTarget&) = default;
};

/// Replaces the part of a target that a stroke runs along, and solves.
struct OversketchTarget {
  static constexpr std::string_view k_name = "oversketch_target";
  CurveId curve;
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const OversketchTarget&, const OversketchTarget&) = default;
};

/// Moves a target by px of its own view, and solves.
struct DragTarget {
  static constexpr std::string_view k_name = "drag_target";
  CurveId curve;
  PxPoint by;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
    visit("by", self.by);
  }
  friend bool operator==(const DragTarget&, const DragTarget&) = default;
};

/// Pulls a target at a place: what is near it along the line follows, less the farther (curve/bend.h); what does not
/// follow stays to the bit. Then solves.
struct PullTarget {
  static constexpr std::string_view k_name = "pull_target";
  CurveId curve;
  View view;
  PxPoint at;  ///< where it is held
  PxPoint by;
  double reach = curve::k_usual_reach;  ///< share of the line's length to either side; 0: the whole line
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
    visit("view", self.view);
    visit("at", self.at);
    visit("by", self.by);
    visit("reach", self.reach);
  }
  friend bool operator==(const PullTarget&, const PullTarget&) = default;
};

/// Draws a curve that should stay where it is now.
struct DrawConstraint {
  static constexpr std::string_view k_name = "draw_constraint";
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const DrawConstraint&, const DrawConstraint&) = default;
};

/// Pins one point of the surface where it is now.
struct Pin {
  static constexpr std::string_view k_name = "pin";
  View view;
  PxPoint at;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("view", self.view);
    visit("at", self.at);
  }
  friend bool operator==(const Pin&, const Pin&) = default;
};

/// Turns a reference into a constraint where its points are now.
struct KeepCurve {
  static constexpr std::string_view k_name = "keep_curve";
  CurveId curve;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
  }
  friend bool operator==(const KeepCurve&, const KeepCurve&) = default;
};

struct DeleteCurve {
  static constexpr std::string_view k_name = "delete_curve";
  CurveId curve;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
  }
  friend bool operator==(const DeleteCurve&, const DeleteCurve&) = default;
};

/// Deletes every curve that is seen under a stroke.
struct EraseCurves {
  static constexpr std::string_view k_name = "erase_curves";
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const EraseCurves&, const EraseCurves&) = default;
};

/// Deletes all curves of the posing tool; the pose stays.
struct ClearCurves {
  static constexpr std::string_view k_name = "clear_curves";
  template <typename Self>
  static void fields(Self&, auto&&) {}
  friend bool operator==(const ClearCurves&, const ClearCurves&) = default;
};

/// Solves the curves that are there, from the pose as it is.
struct SolvePose {
  static constexpr std::string_view k_name = "solve_pose";
  Preset preset = Preset::meant;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("preset", self.preset);
  }
  friend bool operator==(const SolvePose&, const SolvePose&) = default;
};

struct SetPressureWeighting {
  static constexpr std::string_view k_name = "set_pressure_weighting";
  bool on = false;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("on", self.on);
  }
  friend bool operator==(const SetPressureWeighting&, const SetPressureWeighting&) = default;
};

/// How unsteady the artist's hand is, as a multiple of a usual one: what drawn lines are doubted by.
struct SetHand {
  static constexpr std::string_view k_name = "set_hand";
  double unsteadiness = 1;  ///< 0.25..4
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("unsteadiness", self.unsteadiness);
  }
  friend bool operator==(const SetHand&, const SetHand&) = default;
};

/// Adds a curve of points that are known and not drawn, as other programs give them. Errors: no points, one that is not
/// on the mesh.
struct PlaceCurve {
  static constexpr std::string_view k_name = "place_curve";
  std::vector<mesh::MeshPoint> points;
  bool constraint = false;  ///< stays where it is now; else a reference
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("points", self.points);
    visit("constraint", self.constraint);
  }
  friend bool operator==(const PlaceCurve&, const PlaceCurve&) = default;
};

/// Says where each point of a reference should go, and solves nothing yet. Errors: no such reference, another number of
/// points, a point beyond what numbers in files can say.
struct PlaceTarget {
  static constexpr std::string_view k_name = "place_target";
  CurveId curve;
  std::vector<geometry::ModelPoint> points;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
    visit("points", self.points);
  }
  friend bool operator==(const PlaceTarget&, const PlaceTarget&) = default;
};

/// Gives the points of a drawn curve a name in the model, as maps of tracked curves use it.
struct NameCurve {
  static constexpr std::string_view k_name = "name_curve";
  CurveId curve;
  std::string name;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("curve", self.curve);
    visit("name", self.name);
  }
  friend bool operator==(const NameCurve&, const NameCurve&) = default;
};

struct DeleteNamedCurve {
  static constexpr std::string_view k_name = "delete_named_curve";
  std::string name;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
  }
  friend bool operator==(const DeleteNamedCurve&, const DeleteNamedCurve&) = default;
};

}  // namespace penpose::document
