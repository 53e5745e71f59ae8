#include "ui/app/input/view_drag.h"

#include <algorithm>
#include <cmath>

namespace penpose::app {
namespace {

constexpr double k_degrees_per_px = 0.35, k_zoom_per_px = 0.005, k_click_px = 5;

}  // namespace

ViewDrag::ViewDrag(EditingSession& editing, Canvas& canvas, Dialogs& dialogs)
    : editing_(editing), canvas_(canvas), dialogs_(dialogs) {}

void ViewDrag::begin(PxPoint at) {
  if (!editing_.pen_is_drawing()) take(at);
}

void ViewDrag::take(PxPoint at) {
  at_ = at;
  moved_ = false;
}

void ViewDrag::drag_to(PxPoint at, ViewHold how) {
  if (!at_) return;
  const PxPoint by = at - *at_;
  if (!moved_ && std::hypot(by.x, by.y) < k_click_px * canvas_.scale()) return;
  moved_ = true;
  at_ = at;
  switch (how) {
    case ViewHold::zoom:
      canvas_.zoom(std::exp(by.y * k_zoom_per_px / canvas_.scale()),
                   {0.5 * canvas_.view().viewport.width, 0.5 * canvas_.view().viewport.height});
      break;
    case ViewHold::move:
      canvas_.pan(by);
      break;
    case ViewHold::turn:
      canvas_.turn(-by.x * k_degrees_per_px / canvas_.scale(), by.y * k_degrees_per_px / canvas_.scale());
      break;
  }
}

void ViewDrag::do_gesture(const TouchAct& act) {
  if (editing_.pen_is_drawing() || dialogs_.open() != Dialog::none) return;
  if (act.kind == TouchAct::Kind::orbit) {
    canvas_.turn(-act.by.x * k_degrees_per_px / canvas_.scale(), act.by.y * k_degrees_per_px / canvas_.scale());
  } else if (act.kind == TouchAct::Kind::pan) {
    canvas_.pan(act.by);
  } else {
    canvas_.zoom(std::clamp(act.factor, 0.2, 5.0), act.at);
  }
}

}  // namespace penpose::app
