#include "ui/cli/pose/keyed_poses.h"

#include <algorithm>
#include <optional>

#include "core/document/time/animation_poses.h"
#include "replay/session/session_player.h"
#include "ui/files/load_model.h"
#include "ui/files/session_model.h"
#include "ui/files/trace_file.h"

namespace penpose::cli {
namespace {

base::Error too_many(std::size_t count, std::size_t every) {
  const std::size_t needed = every * ((count + k_most_keyed_poses - 1) / k_most_keyed_poses);
  return {"holds " + std::to_string(count) + " key poses, of which " + std::to_string(k_most_keyed_poses) +
              " can be learned from at most",
          "", "take fewer, such as with --every " + std::to_string(needed)};
}

base::Result<document::Document> replayed(const std::string& path) {
  const auto file = files::open_trace(path);
  if (!file) return file.error();
  replay::PlayerOptions options;
  options.open = [&](const std::string& model) {
    return files::load_document(files::find_session_model(path, model), files::NamedBy::file);
  };
  const auto played = replay::play_session(files::read_recording_file(file->get()), options);
  if (!played) return played.error();
  if (!played->session) return base::Error{"holds nothing to replay", "", "name a session as the window records it"};
  if (played->divergence) return replay::error_of(*played->divergence);
  return played->session->editor().document();
}

}  // namespace

base::Result<document::Document> load_posed(const std::string& path) {
  return path.ends_with(".session") ? replayed(path) : files::load_document(path);
}

base::Result<std::vector<document::PoseKey>> keyed_poses(const document::Document& document, std::size_t every) {
  std::vector<document::PoseKey> keys;
  const auto& timeline = document.timeline->keys;
  if (!timeline.empty()) {
    for (std::size_t k = 0; k < timeline.size(); k += every) keys.push_back(timeline[k]);
    if (keys.size() > k_most_keyed_poses) return too_many(keys.size(), every);
    return keys;
  }
  if (document.model->animations.empty()) {
    return base::Error{"has neither key poses nor an animation", "",
                       "key poses in the window and save the project, or name a file that has them with --keys"};
  }
  const document::Animation& animation = document.model->animations.front();
  const std::vector<double> all = document::moments_of(animation);
  std::vector<double> moments;
  for (std::size_t k = 0; k < all.size(); k += every) moments.push_back(all[k]);
  if (moments.size() > k_most_keyed_poses) return too_many(moments.size(), every);
  return document::poses_at(*document.model, animation, moments);
}

base::Result<std::vector<document::PoseKey>> carried_over(std::vector<document::PoseKey> keys,
                                                          std::span<const rig::Parameter> from,
                                                          std::span<const rig::Parameter> to) {
  std::vector<std::optional<std::size_t>> source;
  bool any = false;
  for (const rig::Parameter& parameter : to) {
    source.push_back(rig::find_parameter(from, parameter.name));
    any = any || source.back();
  }
  if (!any) {
    return base::Error{"none of its parameters has the name of one of the model's", "",
                       "name poses of the same model; `penpose info` lists the names"};
  }
  for (document::PoseKey& key : keys) {
    rig::Pose pose;
    for (std::size_t i = 0; i < to.size(); ++i) {
      pose.push_back(source[i] ? std::clamp(key.pose[*source[i]], to[i].minimum, to[i].maximum) : to[i].rest);
    }
    key.pose = std::move(pose);
  }
  return keys;
}

}  // namespace penpose::cli
