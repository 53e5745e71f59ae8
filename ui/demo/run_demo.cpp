#include "ui/demo/run_demo.h"

#include <utility>

#include "core/document/commands/apply.h"
#include "core/head/head.h"
#include "ui/demo/embedded_files.h"

namespace penpose::demo {
namespace {

/// Sum of the distances between the curves' points and where they should be.
double distance_left(const document::Model& model, const posing::PoseProblem& problem, const rig::Pose& pose) {
  std::vector<geometry::ModelPoint> positions(model.mesh->vertex_count());
  model.rig->evaluate(pose, positions);
  double sum = 0;
  for (const posing::CurvePair& pair : problem.pairs) {
    for (std::size_t i = 0; i < pair.reference.size(); ++i) {
      geometry::ModelPoint at(0);
      for (std::size_t c = 0; c < 3; ++c) at += positions[pair.reference[i].vertex[c]] * pair.reference[i].weight[c];
      sum += geometry::distance(at, pair.target[i]);
    }
  }
  return sum;
}

/// Notes how a pose that gets a name was reached, while its curves are still there.
class PoseNotes final : public replay::PlayerObserver {
 public:
  std::vector<NamedPose> poses;

  void on_step(replay::Session& session, const replay::SessionStep& step) override {
    const document::Document& document = session.editor().document();
    if (step.is_stroke || document.timeline->keys.size() == keys_) return;
    keys_ = document.timeline->keys.size();
    for (const document::PoseKey& key : document.timeline->keys) {
      if (key.name.empty() || key.time_s != document.time_s) continue;
      const posing::PoseProblem problem = document::pose_problem(document);
      const document::Model& model = *document.model;
      poses.push_back({key.name, key.pose, problem.pairs.size(),
                       distance_left(model, problem, rig::rest_pose(*model.rig)),
                       distance_left(model, problem, key.pose)});
    }
  }

 private:
  std::size_t keys_ = 0;
};

}  // namespace

base::Result<Demo> run_demo() {
  PoseNotes notes;
  replay::PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(head::make_head()));
  };
  options.observer = &notes;
  auto played = replay::play_session(replay::read_from(base::as_bytes(embedded_session())), options);
  if (!played) return played.error();
  if (played->divergence) {
    return base::Error{"the bundled session does not end where it was recorded to end",
                       "line " + std::to_string(played->divergence->line),
                       "this build of the program computes differently; please report it with the compiler's name"};
  }
  return Demo{played->session->editor().document(), std::move(notes.poses), played->reports,
              played->session->stroke_count(), played->checked};
}

}  // namespace penpose::demo
