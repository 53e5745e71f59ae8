#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/document/document.h"
#include "core/portrait/feature_curve.h"
#include "ui/app/session/pose_library.h"

namespace penpose::app {

/// Which part of the face each parameter is of, by the feature curves that it moves most; by its name where it moves
/// none (part_of). `all`: neither says anything.
[[nodiscard]] std::vector<FacePart> parts_by_effect(const document::Document& document,
                                                    std::span<const portrait::FeatureCurve> features);

/// Those of a document, found once for each model.
class ControlParts {
 public:
  [[nodiscard]] const std::vector<FacePart>& of(const document::Document& document,
                                                std::span<const portrait::FeatureCurve> features);

 private:
  std::shared_ptr<const rig::CharacterRig> rig_;
  std::size_t features_ = 0;
  std::vector<FacePart> parts_;
};

}  // namespace penpose::app
