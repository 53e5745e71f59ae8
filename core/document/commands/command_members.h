#pragma once

#include <string>
#include <vector>

#include "core/base/members.h"
#include "core/curve/stroke.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/named_value.h"

// Members that several commands have alike.

namespace penpose::document {

using curve::PxPoint;

struct NoMembers {
  static auto members(auto&) { return base::named(); }
};

/// A line drawn in a view.
struct DrawnLine {
  View view;
  std::vector<PxPoint> line;
  static auto members(auto& self) { return base::named("view", self.view, "line", self.line); }
};

struct OfCurve {
  CurveId curve;
  static auto members(auto& self) { return base::named("curve", self.curve); }
};

struct OfName {
  std::string name;
  static auto members(auto& self) { return base::named("name", self.name); }
};

struct OfDeformer {
  std::string deformer;
  std::string to = {};
  static auto members(auto& self) { return base::named("deformer", self.deformer, "to", self.to); }
};

struct AtTime {
  double time_s = 0;
  static auto members(auto& self) { return base::named("time_s", self.time_s); }
};

}  // namespace penpose::document
