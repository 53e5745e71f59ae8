#pragma once

#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/features/feature_curves.h"
#include "core/portrait/face_view.h"

namespace penpose::document {

/// Reads face drawings, and keeps what is worth keeping from one to the next: the features of a model and how a view
/// shows them. Never changes a result.
class FaceReader {
 public:
  /// The features of the document's model. Errors: none were found.
  const base::Result<FeatureCurves>& features(const Document& document, const intent::WholeModel& whole);

  /// The middle of the features of the document's model as it is posed. Precondition: it has some.
  [[nodiscard]] geometry::ModelPoint middle(const Document& document) const;

  struct Read {
    FaceDrawing drawing;  ///< with what each line was taken for, and `posed`
    rig::Pose pose;
  };
  /// The pose that a drawing of the document's model asks for. Controls that move what is drawn are read from rest;
  /// others, those of the other side among them, stay as they were before the drawing, or were set since. Errors: no
  /// features, no lines, those of FaceView::make and read_drawing.
  base::Result<Read> read(const Document& document, FaceDrawing drawing, const intent::WholeModel& whole);

 private:
  struct Seen {
    View view;
    rig::Pose start;
    std::vector<std::size_t> free;
    portrait::FaceView face;
  };
  base::Result<const portrait::FaceView*> seen(const Document& document, const FeatureCurves& features,
                                               const View& view, const intent::WholeModel& whole);

  std::shared_ptr<const Model> model_;  ///< whose features these are
  std::optional<base::Result<FeatureCurves>> features_;
  std::optional<Seen> seen_;
};

}  // namespace penpose::document
