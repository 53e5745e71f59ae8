#include "core/tracking/drawing_start.h"

#include <algorithm>

namespace penpose::tracking {

DrawingStart drawing_start(const document::Document& document, const intent::WholeModel& whole) {
  const auto parameters = document.model->rig->parameters();
  DrawingStart out{document.pose, {}};
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (std::binary_search(document.locked.begin(), document.locked.end(), parameters[p].name)) continue;
    out.free.push_back(p);
    if (whole.joint[p] == intent::k_no_partner) out.pose[p] = parameters[p].rest;
  }
  return out;
}

}  // namespace penpose::tracking
