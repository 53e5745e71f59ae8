#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/articulation/edit.h"
#include "core/articulation/sketch.h"
#include "core/curve/bend.h"
#include "core/document/commands/named_value.h"
#include "core/document/drawing/pose_curve.h"

// Commands of sketched deformers and corrections (command.h).

namespace penpose::document {

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

}  // namespace penpose::document
