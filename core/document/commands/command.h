// One file above the usual size: it is the one list of commands, which is read as a whole.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/articulation/edit.h"
#include "core/articulation/sketch.h"
#include "core/curve/bend.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/time/timeline.h"
#include "core/mesh/mesh_point.h"

// The commands: the only way to change a document. Each is a plain struct with its name in files and, in `fields`, the
// names of its members there. The variant `Command` is the one list of them; text form, application and tests are made
// from it.

namespace penpose::document {

using curve::PxPoint;

/// How curves are solved: for what was meant (core/intent), for the lowest sum of distances, or for that by the single
/// simplex of 2006.
enum class Preset : std::uint8_t { meant, exact, paper };

/// A parameter and its value.
struct NamedValue {
  std::string name;
  double value = 0;
  friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

// Parameters.

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

// Articulation.

/// Begins a deformer, whose curves are drawn one by one.
struct BeginDeformer {
  static constexpr std::string_view k_name = "begin_deformer";
  std::string name;  ///< empty: "deformer N" with the first free N
  articulation::Mode mode = articulation::Mode::automatic;
  articulation::Surface surface;
  double minimum = 0;
  double maximum = 1;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
    visit("mode", self.mode);
    visit("surface", self.surface);
    visit("minimum", self.minimum);
    visit("maximum", self.maximum);
  }
  friend bool operator==(const BeginDeformer&, const BeginDeformer&) = default;
};

/// Begins a correction of the pose that several controls make together; its curves are drawn on the model so posed, as
/// those of a deformer are at rest. Errors: fewer than two controls or more than eight away from rest, a control that
/// no correction can follow.
struct BeginCorrection {
  static constexpr std::string_view k_name = "begin_correction";
  std::string name;                 ///< empty: "correction N" with the first free N
  std::vector<NamedValue> drivers;  ///< empty: all controls that are away from rest, as they are
  articulation::Mode mode = articulation::Mode::automatic;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
    visit("drivers", self.drivers);
    visit("mode", self.mode);
  }
  friend bool operator==(const BeginCorrection&, const BeginCorrection&) = default;
};

struct DeleteCorrection {
  static constexpr std::string_view k_name = "delete_correction";
  std::string correction;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("correction", self.correction);
  }
  friend bool operator==(const DeleteCorrection&, const DeleteCorrection&) = default;
};

/// What the first lasso of the deformer that was begun takes. Errors: none was begun; what general_region says.
struct TakeRegion {
  static constexpr std::string_view k_name = "take_region";
  std::optional<articulation::Reach> reach = {};
  std::optional<std::uint32_t> piece = {};  ///< of those inside the lasso, the nearest being 0
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("reach", self.reach);
    visit("piece", self.piece);
  }
  friend bool operator==(const TakeRegion&, const TakeRegion&) = default;
};

/// Draws where the feature of a deformer is at a value other than 0 and 1: another target, or that one again. Errors: a
/// value out of its range; those of build_deformer.
struct DrawBetween {
  static constexpr std::string_view k_name = "draw_between";
  std::string deformer;
  double value = 0.5;
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("value", self.value);
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const DrawBetween&, const DrawBetween&) = default;
};

struct DeleteBetween {
  static constexpr std::string_view k_name = "delete_between";
  std::string deformer;
  double value = 0.5;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("value", self.value);
  }
  friend bool operator==(const DeleteBetween&, const DeleteBetween&) = default;
};

/// Pulls a target of a deformer at a place: what is near it along the line follows, less the farther (curve/bend.h).
struct PullBetween {
  static constexpr std::string_view k_name = "pull_between";
  std::string deformer;
  double value = 1;  ///< 1: its own target
  View view;
  PxPoint at;
  PxPoint by;
  double reach = curve::k_usual_reach;  ///< 0: the whole line
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("value", self.value);
    visit("view", self.view);
    visit("at", self.at);
    visit("by", self.by);
    visit("reach", self.reach);
  }
  friend bool operator==(const PullBetween&, const PullBetween&) = default;
};

/// Draws a curve of the deformer that was begun; the target completes it. Errors: no deformer was begun, a curve before
/// its turn, the second region under another camera than the first; with the target those of build_deformer.
struct SketchCurve {
  static constexpr std::string_view k_name = "sketch_curve";
  articulation::CurveRole role = articulation::CurveRole::general;
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("role", self.role);
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const SketchCurve&, const SketchCurve&) = default;
};

struct CancelDeformer {
  static constexpr std::string_view k_name = "cancel_deformer";
  template <typename Self>
  static void fields(Self&, auto&&) {}
  friend bool operator==(const CancelDeformer&, const CancelDeformer&) = default;
};

/// Draws one curve of a deformer again; a reference without points is inferred. The parameter keeps its value.
struct RedrawCurve {
  static constexpr std::string_view k_name = "redraw_curve";
  std::string deformer;
  articulation::CurveRole role = articulation::CurveRole::target;
  View view;
  std::vector<PxPoint> line;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("role", self.role);
    visit("view", self.view);
    visit("line", self.line);
  }
  friend bool operator==(const RedrawCurve&, const RedrawCurve&) = default;
};

/// Changes how a deformer moves, what it slides over, the sheet that its reference lies on, what its first lasso takes,
/// or its range; what is not given stays.
struct ChangeDeformer {
  static constexpr std::string_view k_name = "change_deformer";
  std::string deformer;
  std::optional<articulation::Mode> mode;
  std::optional<articulation::Surface> surface;
  std::optional<double> minimum;
  std::optional<double> maximum;
  std::optional<bool> other_sheet = {};  ///< the drawn reference goes over to the other sheet of the surface, or back
  std::optional<articulation::Reach> reach = {};
  std::optional<std::uint32_t> piece = {};
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("mode", self.mode);
    visit("surface", self.surface);
    visit("minimum", self.minimum);
    visit("maximum", self.maximum);
    visit("other_sheet", self.other_sheet);
    visit("reach", self.reach);
    visit("piece", self.piece);
  }
  friend bool operator==(const ChangeDeformer&, const ChangeDeformer&) = default;
};

/// Adds the same deformer on the model's other side.
struct MirrorDeformer {
  static constexpr std::string_view k_name = "mirror_deformer";
  std::string deformer;
  std::string to = {};  ///< its name; empty: articulation::mirrored_name
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("to", self.to);
  }
  friend bool operator==(const MirrorDeformer&, const MirrorDeformer&) = default;
};

struct RenameDeformer {
  static constexpr std::string_view k_name = "rename_deformer";
  std::string deformer;
  std::string to;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("to", self.to);
  }
  friend bool operator==(const RenameDeformer&, const RenameDeformer&) = default;
};

struct DeleteDeformer {
  static constexpr std::string_view k_name = "delete_deformer";
  std::string deformer;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
  }
  friend bool operator==(const DeleteDeformer&, const DeleteDeformer&) = default;
};

/// Takes a deformer out of the list and puts it back as number `to`, from 0.
struct MoveDeformer {
  static constexpr std::string_view k_name = "move_deformer";
  std::string deformer;
  std::uint32_t to = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("deformer", self.deformer);
    visit("to", self.to);
  }
  friend bool operator==(const MoveDeformer&, const MoveDeformer&) = default;
};

// Timeline and views.

/// Keys the pose at a moment, in place of a key that is there. The pose may have a name.
struct SetKey {
  static constexpr std::string_view k_name = "set_key";
  double time_s = 0;
  std::string name;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("time_s", self.time_s);
    visit("name", self.name);
  }
  friend bool operator==(const SetKey&, const SetKey&) = default;
};

/// Keys what was performed: some controls at each of some moments. All else at a moment is what the timeline has there,
/// or the pose where nothing is keyed; keys between the moments are kept, with these controls evenly between. Errors:
/// no such parameter or one named twice, a value out of range, moments that do not ascend, another number of values.
struct KeyPoses {
  static constexpr std::string_view k_name = "key_poses";
  std::vector<std::string> names;
  std::vector<double> times_s;
  std::vector<double> values;  ///< one row a moment, one a name in it
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("names", self.names);
    visit("times_s", self.times_s);
    visit("values", self.values);
  }
  friend bool operator==(const KeyPoses&, const KeyPoses&) = default;
};

struct DeleteKey {
  static constexpr std::string_view k_name = "delete_key";
  double time_s = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("time_s", self.time_s);
  }
  friend bool operator==(const DeleteKey&, const DeleteKey&) = default;
};

/// Errors: no key there, another key where it should go.
struct MoveKey {
  static constexpr std::string_view k_name = "move_key";
  double from_s = 0;
  double to_s = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("from_s", self.from_s);
    visit("to_s", self.to_s);
  }
  friend bool operator==(const MoveKey&, const MoveKey&) = default;
};

struct SetKeyInterpolation {
  static constexpr std::string_view k_name = "set_key_interpolation";
  KeyInterpolation interpolation = KeyInterpolation::smooth;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("interpolation", self.interpolation);
  }
  friend bool operator==(const SetKeyInterpolation&, const SetKeyInterpolation&) = default;
};

/// Takes the pose of the timeline at a moment.
struct GoToTime {
  static constexpr std::string_view k_name = "go_to_time";
  double time_s = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("time_s", self.time_s);
  }
  friend bool operator==(const GoToTime&, const GoToTime&) = default;
};

/// Keeps a view under a name, in place of one of that name.
struct SaveView {
  static constexpr std::string_view k_name = "save_view";
  std::string name;
  View view;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
    visit("view", self.view);
  }
  friend bool operator==(const SaveView&, const SaveView&) = default;
};

struct DeleteView {
  static constexpr std::string_view k_name = "delete_view";
  std::string name;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
  }
  friend bool operator==(const DeleteView&, const DeleteView&) = default;
};

using Command = std::variant<SetParameters, ResetParameters, LockParameters, DrawReference, DrawTarget,
                             OversketchTarget, DragTarget, DrawConstraint, Pin, KeepCurve, DeleteCurve, EraseCurves,
                             ClearCurves, SolvePose, SetPressureWeighting, NameCurve, DeleteNamedCurve, BeginDeformer,
                             SketchCurve, CancelDeformer, RedrawCurve, ChangeDeformer, MirrorDeformer, RenameDeformer,
                             DeleteDeformer, MoveDeformer, SetKey, DeleteKey, MoveKey, SetKeyInterpolation, GoToTime,
                             SaveView, DeleteView, SuggestRest, SetHand, BeginCorrection, DeleteCorrection, TakeRegion,
                             DrawBetween, DeleteBetween, PullBetween, PullTarget, PlaceCurve, PlaceTarget, KeyPoses>;

/// The command's name in files.
[[nodiscard]] inline std::string_view name_of(const Command& command) {
  return std::visit([](const auto& one) { return std::decay_t<decltype(one)>::k_name; }, command);
}

}  // namespace penpose::document
