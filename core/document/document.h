#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/sketch.h"
#include "core/base/result.h"
#include "core/document/drawing/face_drawing.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/model.h"
#include "core/document/sound/mouths.h"
#include "core/document/sound/sound_reference.h"
#include "core/document/sound/spoken_words.h"
#include "core/document/time/bookmark.h"
#include "core/document/time/clips/clip.h"
#include "core/document/time/timeline.h"
#include "core/document/view/camera_track.h"
#include "core/document/view/reference_picture.h"

namespace penpose::document {

/// A deformer whose strokes are not all drawn yet.
struct PendingSketch {
  articulation::Sketch sketch;                     ///< curves are empty until they are drawn
  std::vector<articulation::Driver> drivers = {};  ///< of a correction: the pose in which it is drawn; else empty
  friend bool operator==(const PendingSketch&, const PendingSketch&) = default;
};

/// Lines that are read together: drawn one after the other, with only changes of values in between. They are read from
/// the pose before the first of them.
struct Moment {
  struct Line {
    CurveId curve;
    /// Points of the reference for which a later line was drawn in about the same view: they are ignored. Empty: none.
    std::vector<bool> covered;
    /// For lines from before the moment: where the reference was in the target's picture when it began. This replaces
    /// the target. Empty: the target as drawn.
    std::vector<curve::PxPoint> held;
    friend bool operator==(const Line&, const Line&) = default;
  };
  std::shared_ptr<const rig::CharacterRig> rig;
  double time_s = 0;        ///< Document::time_s
  rig::Pose base;           ///< before the first line
  rig::Pose posed;          ///< result of the last solve
  std::vector<Line> lines;  ///< in the order in which their targets were drawn
  struct Other {
    rig::Pose pose;
    double above = 0;        ///< intent::OtherReading::above
    double probability = 0;  ///< intent::OtherReading::probability
  };
  /// Other readings of the lines, the likeliest first. A reading that is taken swaps places with the one it replaces.
  std::vector<Other> others = {};
  double probability = 1;  ///< of the reading that was taken
};

/// What the artist chose between two readings (TakeReading): controls that it moved, and those that the other one moved
/// in their place, by name in the order of the rig. One of both may be empty.
struct TakenReading {
  std::vector<std::string> taken, instead_of;
  /// The log of the odds that the choice adds in favour of the reading it took.
  double by = 12;
  friend bool operator==(const TakenReading&, const TakenReading&) = default;
};
/// So many are remembered, the latest ones.
inline constexpr std::size_t k_most_taken = 64;
/// TakenReading::by is at most this.
inline constexpr double k_most_taught = 1000.0;

/// Views have the keys 1 to 9.
inline constexpr std::uint32_t k_view_keys = 9;
/// A named view.
struct NamedView {
  std::string name;
  View view;
  std::uint32_t key = 0;  ///< 1..9: the key that goes there, which no other view has; 0: none
  friend bool operator==(const NamedView&, const NamedView&) = default;
};

/// The range of Document::hand.
inline constexpr double k_steadiest_hand = 0.25, k_shakiest_hand = 4.0;

/// Everything a user works on. A value type whose large parts are shared and immutable, so that a copy costs a few
/// hundred bytes whatever the size of the mesh. Only commands (core/document/commands/apply.h) change it.
struct Document {
  std::shared_ptr<const Model> model;                    ///< its own pose is not used, only `pose`
  rig::Pose pose;                                        ///< one value a parameter of the rig
  std::vector<std::string> locked;                       ///< parameters that no solve may move, in ascending order
  double hand = 1;                                       ///< unsteadiness of the artist's hand, 1 being usual (SetHand)
  bool pressure_weighting = false;                       ///< targets pull harder where the pen pressed harder
  std::vector<std::shared_ptr<const PoseCurve>> curves;  ///< in the order of drawing
  std::uint32_t last_curve = 0;                          ///< the highest id given out
  std::shared_ptr<const PendingSketch> pending;          ///< null: none
  std::shared_ptr<const Timeline> timeline;              ///< never null; of the clip that is shown
  std::vector<std::shared_ptr<const Clip>> clips;        ///< empty: the timeline is the only one
  std::size_t clip = 0;                                  ///< the one that is shown
  double time_s = 0;                                     ///< where on the timeline the pose was last taken from
  std::shared_ptr<const Moment> moment;                  ///< null: nothing drawn yet
  std::shared_ptr<const FaceDrawing> face;               ///< lines of a face as it should be; null: none
  std::shared_ptr<const FaceDrawing> neutral;            ///< the face at rest as the artist draws it; null: not known
  std::shared_ptr<const std::vector<TakenReading>> taken;  ///< later lines follow them, the latest last; null: none
  std::vector<std::shared_ptr<const NamedView>> views;
  std::shared_ptr<const CameraTrack> camera;          ///< that moves along the timeline; null: none
  std::shared_ptr<const ReferencePicture> reference;  ///< that one animates after; null: none
  std::shared_ptr<const SoundReference> sound;        ///< beside the timeline; null: none
  Mouths mouths;                                      ///< in the order in which they were first kept
  std::shared_ptr<const SpokenMouths> spoken;         ///< what KeyMouths keyed last; null: nothing
  std::shared_ptr<const SpokenWords> words;           ///< said in the sound; null: they are not known
  std::shared_ptr<const Bookmarks> bookmarks;         ///< of the clip that is shown; null: none
};

/// A new document of a model: its pose, no curves, no keys.
[[nodiscard]] Document make_document(Model model);

/// The document with its model replaced by one of the same mesh: poses are kept by the names of parameters, new ones
/// are at rest; locks of removed parameters are dropped. The model's own pose is ignored.
[[nodiscard]] Document with_model(const Document& document, Model model);

/// Those of the readings whose controls a rig has; null: none.
[[nodiscard]] std::shared_ptr<const std::vector<TakenReading>> taken_of_rig(std::vector<TakenReading> taken,
                                                                            std::span<const rig::Parameter> parameters);

/// Whether the document is only its model in a pose: no curves, keys, views, locks, settings or strokes of an
/// unfinished deformer.
[[nodiscard]] bool is_plain(const Document& document);

/// The pose of the timeline at a moment, within the ranges of the parameters; controls that have no key are as they
/// are.
[[nodiscard]] rig::Pose pose_at(const Document& document, double time_s);

/// What the clip that is shown is called, or one of Document::clips: an animation without a name by its number from 1.
[[nodiscard]] std::string shown_clip_name(const Document& document);
[[nodiscard]] std::string clip_name(const Clip& clip);
/// The keys of one of Document::clips.
[[nodiscard]] const Timeline& keys_of_clip(const Document& document, std::size_t number);

/// The model with the pose of the document and its clips as animations, those that were made here in front (without
/// clips: the timeline as "timeline"), those of the model in its order, without those that have no keys left, and with
/// their own channels where their keys are as they were: the content of a file for other programs.
[[nodiscard]] Model model_of(const Document& document);
/// The names of the animations that model_of puts in front.
[[nodiscard]] std::vector<std::string> made_animations(const Document& document);

[[nodiscard]] const PoseCurve* find_curve(const Document& document, CurveId id);
/// The first reference that has no target yet.
[[nodiscard]] std::optional<CurveId> waiting_reference(const Document& document);
/// The line of the face drawing; null: none of that number.
[[nodiscard]] const FaceLine* find_face_line(const Document& document, CurveId id);

}  // namespace penpose::document
