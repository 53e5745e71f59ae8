#include "ui/demo/demo_head.h"

#include <utility>

#include "core/head/head.h"
#include "replay/session/session_player.h"
#include "ui/demo/embedded_files.h"

namespace penpose::demo {

base::Result<document::Model> make_demo_head(head::HeadEdition edition) {
  replay::PlayerOptions options;
  options.open = [edition](const std::string&) {
    return base::Result<document::Document>(document::make_document(head::make_head(edition)));
  };
  options.stop_when = [](const replay::Session& session) {
    return !session.editor().document().timeline->keys.empty();
  };
  auto played = replay::play_session(replay::read_from(base::as_bytes(embedded_session(edition))), options);
  if (!played) return played.error();
  document::Model model = *played->session->editor().document().model;
  model.pose = rig::rest_pose(*model.rig);
  return model;
}

std::size_t stroke_count(const articulation::Sketch& sketch) { return sketch.reference.empty() ? 3 : 4; }

}  // namespace penpose::demo
