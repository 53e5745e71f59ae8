#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "core/document/document.h"

namespace penpose::app {

/// The moments at which drawn curves were drawn, and the one that is looked at: a line belongs to its pose, and over
/// another one it says nothing. Those of a project are taken for lines of the moment at which it was saved.
class CurveMoments {
 public:
  /// Another document: all of its curves are of its moment.
  void begin(const document::Document& document);
  /// The document after a change.
  void follow(const document::Document& document);

  /// Lines of that moment (s) are shown from now on; nothing: none are.
  void look_at(std::optional<double> time_s) { looked_at_s_ = time_s; }
  /// Whether lines are shown at all.
  [[nodiscard]] bool any() const { return looked_at_s_.has_value(); }
  [[nodiscard]] bool shows(document::CurveId curve) const;
  /// Whether lines of a moment are.
  [[nodiscard]] bool shows(double time_s) const;

 private:
  struct Drawn {
    std::shared_ptr<const document::PoseCurve> curve;
    double time_s = 0;
  };
  std::map<std::uint32_t, Drawn> drawn_;  ///< by the curve's id
  std::shared_ptr<const document::Timeline> timeline_;
  double time_s_ = 0;
  std::optional<double> looked_at_s_;
};

}  // namespace penpose::app
