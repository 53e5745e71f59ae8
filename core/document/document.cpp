#include "core/document/document.h"

#include <utility>

namespace penpose::document {

Document make_document(Model model) {
  Document document;
  document.pose = model.pose;
  document.model = std::make_shared<const Model>(std::move(model));
  document.timeline = std::make_shared<const Timeline>();
  return document;
}

Model model_of(const Document& document) {
  Model model = *document.model;
  model.pose = document.pose;
  if (!document.timeline->keys.empty()) {
    model.animations.insert(model.animations.begin(), to_animation(model, *document.timeline));
  }
  return model;
}

const PoseCurve* find_curve(const Document& document, CurveId id) {
  for (const auto& curve : document.curves) {
    if (curve->id == id) return curve.get();
  }
  return nullptr;
}

}  // namespace penpose::document
