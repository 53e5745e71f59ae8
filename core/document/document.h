#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/articulation/sketch.h"
#include "core/base/result.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/model.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// A deformer whose four steps are not all drawn yet.
struct PendingSketch {
  articulation::Sketch sketch;                     ///< curves are empty until they are drawn
  std::vector<articulation::Driver> drivers = {};  ///< of a correction: the pose that it is drawn at; else empty
  friend bool operator==(const PendingSketch&, const PendingSketch&) = default;
};

/// Lines that are read together: those that were drawn one after the other, with nothing else in between but values
/// that were set. What all of them mean is read from the pose before the first of them.
struct Moment {
  struct Line {
    CurveId curve;
    /// Points of the reference that a later line in about the same view was drawn for: they ask for nothing. Empty:
    /// none.
    std::vector<bool> covered;
    /// Where the reference stood in the target's picture when the moment began, of lines from before: they ask for no
    /// more. Empty: the target as it was drawn.
    std::vector<curve::PxPoint> held;
    friend bool operator==(const Line&, const Line&) = default;
  };
  std::shared_ptr<const rig::CharacterRig> rig;
  double time_s = 0;        ///< Document::time_s
  rig::Pose base;           ///< before the first line
  rig::Pose posed;          ///< that the last solve came to
  std::vector<Line> lines;  ///< in the order in which their targets were drawn
};

/// A view that has a name.
struct NamedView {
  std::string name;
  View view;
  friend bool operator==(const NamedView&, const NamedView&) = default;
};

/// The range of Document::hand.
inline constexpr double k_steadiest_hand = 0.25, k_shakiest_hand = 4.0;

/// All that is worked on. A value whose heavy parts are shared and never change, so that a copy costs a few hundred
/// bytes whatever the size of the mesh. Only commands (core/document/commands/apply.h) make another one.
struct Document {
  std::shared_ptr<const Model> model;  ///< its own pose is not used: `pose` is what counts
  rig::Pose pose;                      ///< one value a parameter of the rig
  std::vector<std::string> locked;     ///< parameters that no solve may move, in ascending order
  double hand = 1;                     ///< how unsteady the artist's is, a usual one having 1 (SetHand)
  bool pressure_weighting = false;     ///< targets pull harder where the pen pressed harder
  std::vector<std::shared_ptr<const PoseCurve>> curves;  ///< in the order of drawing
  std::uint32_t last_curve = 0;                          ///< the highest id given out
  std::shared_ptr<const PendingSketch> pending;          ///< null: none
  std::shared_ptr<const Timeline> timeline;              ///< never null
  double time_s = 0;                                     ///< where on the timeline the pose was last taken from
  std::shared_ptr<const Moment> moment;                  ///< null: nothing was drawn yet
  std::vector<std::shared_ptr<const NamedView>> views;
};

/// A document of a model that nothing has been done to: its pose, no curves, no keys.
[[nodiscard]] Document make_document(Model model);

/// The document with its model changed to one of the same mesh: poses are kept by the names of parameters, others are
/// at rest; locks of parameters that are gone are forgotten. The model's own pose counts for nothing.
[[nodiscard]] Document with_model(const Document& document, Model model);

/// Whether it is its model, posed, and no more: no curves, keys, views, locks, settings and strokes of an unfinished
/// deformer.
[[nodiscard]] bool is_plain(const Document& document);

/// The model as it stands, with the pose of the document and its timeline as one more animation, "timeline", in front;
/// what a file for other programs holds.
[[nodiscard]] Model model_of(const Document& document);

[[nodiscard]] const PoseCurve* find_curve(const Document& document, CurveId id);

}  // namespace penpose::document
