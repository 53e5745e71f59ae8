#include "ui/app/face/face_follow.h"

#include <utility>

#include "core/document/commands/command.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

bool FaceFollow::follow(const document::View& view, const std::vector<curve::PxPoint>& line) {
  const std::int64_t began = editing_.now_us();
  if (began < rests_until_us_) return false;
  auto read = editing_.after(document::DrawFaceLine{{view, line}});
  const std::int64_t ended = editing_.now_us();
  rests_until_us_ = ended + (ended - began);
  // A model without features has none to follow.
  if (!read || !read->face || read->face == editing_.document().face) return false;
  read_ = std::move(*read);
  return true;
}

}  // namespace penpose::app
