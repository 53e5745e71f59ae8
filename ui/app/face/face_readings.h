#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// Holds another meaning of a line of the face.
struct FaceReading {
  document::NameFaceLine command;  ///< which feature the line is, and whether only its form counts
  document::SharedPose pose;       ///< the face if the line is that
};

/// Other readings of one line of the face: first as the form of what it was read as, then features near it as the face
/// was before the drawing, the nearest first, each by its form and where the line is. With each the face looks
/// different.
class FaceReadings {
 public:
  static constexpr std::size_t k_most = 4;

  /// Looks at one feature more. Begins anew for another line or another state of the document. Call it once a frame.
  void follow(EditingSession& editing, document::CurveId line);
  void forget();

  /// There are features that have not been looked at.
  [[nodiscard]] bool searches() const { return !waiting_.empty() && found_.size() < k_most; }
  /// The line; nothing: none is looked at.
  [[nodiscard]] std::optional<document::CurveId> line() const { return line_; }
  [[nodiscard]] bool is_of(std::uint64_t revision) const { return revision_ == revision; }
  [[nodiscard]] const std::vector<FaceReading>& found() const { return found_; }

 private:
  void begin(EditingSession& editing, document::CurveId line);

  std::optional<document::CurveId> line_;
  std::uint64_t revision_ = 0;
  std::vector<document::NameFaceLine> waiting_;  ///< those that have not been looked at, the last one first
  std::vector<FaceReading> found_;
};

/// The line that the newest step drew or named; nothing: it did something else. Call it once a revision.
class NewestFaceLine {
 public:
  std::optional<document::CurveId> look_at(const EditingSession& editing);

 private:
  std::shared_ptr<const document::FaceDrawing> face_;  ///< as of the last look
  std::size_t steps_ = 0;                              ///< that could be undone then
};

}  // namespace penpose::app
