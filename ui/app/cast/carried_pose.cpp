#include "ui/app/cast/carried_pose.h"

#include "core/poses/keep_pose.h"
#include "core/poses/take_pose.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/view/user_messages.h"

namespace penpose::app {

CarriedPose::CarriedPose(EditingSession& editing)
    : document_(editing.document()), features_(editing.features().begin(), editing.features().end()) {}

bool CarriedPose::fits(const document::Document& document) const {
  if (document.model->rig == document_.model->rig) return true;
  const auto parameters = document_.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool moved = document_.pose[i] != parameters[i].rest;
    if (moved && !rig::find_parameter(document.model->rig->parameters(), parameters[i].name)) return false;
  }
  return true;
}

void CarriedPose::paste(EditingSession& editing, Notices& notices, const std::string& key_name, double time_s) const {
  const auto from = poses::FaceMeasure::of(*document_.model, features_);
  const auto kept = poses::keep_pose(document_, document_.pose, key_name.empty() ? "the pose" : key_name, "",
                                     from ? &*from : nullptr, {});
  const document::Document& document = editing.document();
  const document::Model& model = *document.model;
  const auto to = poses::FaceMeasure::of(model, editing.features());
  const auto taken = poses::take_pose(kept, model, to ? &*to : nullptr, {});
  if (!taken) return notices.tell(message_of(taken.error()), true);
  // The whole face is that of the pose; joints that nothing was said of stay.
  rig::Pose pose = document.pose;
  const auto parameters = model.rig->parameters();
  for (std::size_t i = 0; i < document::weight_count(model); ++i) pose[i] = parameters[i].rest;
  pose = poses::with_values(*model.rig, std::move(pose), taken->values);
  const auto values = values_between(parameters, document.pose, pose);
  const document::SetKey key{time_s, key_name};
  const bool done = values.values.empty() ? editing.perform(key) : editing.perform(values);
  if (!done) return;
  if (!values.values.empty()) editing.perform_with(key);
  notices.tell(poses::words_of(kept, *taken));
}

}  // namespace penpose::app
