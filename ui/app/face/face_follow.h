#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/document/document.h"

namespace penpose::app {

class EditingSession;

/// What the face does while a line of it is being drawn: a preview alone, read with the lines that are there. The
/// command that the stroke becomes has the last word.
class FaceFollow {
 public:
  explicit FaceFollow(EditingSession& editing) : editing_(editing) {}

  /// The line so far, in the view in which it began. True when the face was read anew; no more of the time is spent on
  /// that than on all else.
  bool follow(const document::View& view, const std::vector<curve::PxPoint>& line);
  void end() { read_.reset(); }

  [[nodiscard]] bool active() const { return read_.has_value(); }
  /// The pose to show; precondition: active.
  [[nodiscard]] const rig::Pose& pose() const { return read_->pose; }
  /// What the line would be; empty: nothing known. Precondition: active.
  [[nodiscard]] const std::string& feature() const { return read_->face->lines.back().feature; }

 private:
  EditingSession& editing_;
  std::optional<document::Document> read_;
  std::int64_t rests_until_us_ = 0;
};

}  // namespace penpose::app
