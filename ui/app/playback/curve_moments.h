#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/document/document.h"

namespace penpose::app {

/// Which drawn curves are shown: those of the moment that is looked at. A line belongs to its pose, and over another
/// one it says nothing.
class CurveMoments {
 public:
  /// Another document, of whose moment lines are shown.
  void begin(const document::Document& document);
  /// The document after a change.
  void follow(const document::Document& document) { curves_ = document.curves; }

  /// Lines of that moment (s) are shown from now on; nothing: none are.
  void look_at(std::optional<double> time_s) { looked_at_s_ = time_s; }
  /// Whether lines are shown at all.
  [[nodiscard]] bool any() const { return looked_at_s_.has_value(); }
  [[nodiscard]] bool shows(document::CurveId curve) const;
  /// Whether lines of a moment are.
  [[nodiscard]] bool shows(double time_s) const;

 private:
  std::vector<std::shared_ptr<const document::PoseCurve>> curves_;
  std::optional<double> looked_at_s_;
};

}  // namespace penpose::app
