#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/portrait/feature_curve.h"
#include "ui/app/notices.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// A pose that was copied together with the face that it is of, so that it can be put on another rig.
class CarriedPose {
 public:
  explicit CarriedPose(EditingSession& editing);

  /// Whether a document has all controls that the pose moves: then it is taken by their names as it is.
  [[nodiscard]] bool fits(const document::Document& document) const;
  /// Keys the pose on another rig at a moment, in one step, by the way to another rig (poses::take_pose), and says how.
  void paste(EditingSession& editing, Notices& notices, const std::string& key_name, double time_s) const;

 private:
  document::Document document_;
  std::vector<portrait::FeatureCurve> features_;
};

}  // namespace penpose::app
