#include "core/tracking/animate.h"

#include <algorithm>

#include "core/document/time/animation_building.h"
#include "core/document/time/animation_poses.h"
#include "core/document/time/head_joints.h"
#include "core/rig/control_names.h"
#include "core/tracking/head_placement.h"
#include "core/tracking/motion_animation.h"
#include "core/tracking/retime.h"
#include "core/tracking/track_setup.h"
#include "core/tracking/weight_animation.h"

namespace penpose::tracking {
namespace {

/// The head's way, beside the animation of the controls.
struct HeadWay {
  std::vector<document::Placement> placements;
  geometry::ModelPoint pivot{0};
};

struct Solved {
  Animated animated;
  HeadWay head;
  std::optional<document::Animation> animation;  ///< where it is more than the poses say
};

base::Status check_options(const AnimateOptions& options) {
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  const auto wrong = [](const char* place, const char* range) {
    return base::Status(base::Error{"the value is out of range", place, std::string("use ") + range});
  };
  if (!within(options.smooth_s, 0, 60)) return wrong("smooth", "0 to 60 s");
  if (!within(options.least_confidence, 0, 1)) return wrong("confidence", "0 to 1");
  if (options.fps != 0 && !within(options.fps, 0.1, 10000)) return wrong("fps", "0.1 to 10000");
  if (options.stretch != 0 && !within(options.stretch, 0.1, 10000)) return wrong("stretch", "0.1 to 10000");
  if (options.tremor_px && !within(*options.tremor_px, 0, 1000)) return wrong("tremor", "0 to 1000 px");
  return base::Done{};
}

/// The track at the rate that is asked for; `frame` is then the one at its time. Notes of the track with the one on its
/// rate, where it counts.
template <typename Track>
base::Result<std::vector<std::string>> retimed(Track& track, const AnimateOptions& options,
                                               std::optional<std::size_t>& frame) {
  if (options.stretch > 0) stretch(track, options.stretch);
  if (options.fps > 0 && !track.frames.empty()) {
    const double time_s = frame ? track.frames[*frame].time_s - track.frames.front().time_s : 0;
    if (auto done = resample(track, options.fps); !done) return done.error();
    if (frame) *frame = std::min(track.frames.size() - 1, static_cast<std::size_t>(time_s * options.fps + 0.5));
  }
  std::vector<std::string> notes = track.notes;
  if (!track.rate_note.empty()) notes.push_back(track.rate_note);
  return notes;
}

void note_without_effect(const AnimateOptions& options, std::vector<std::string>& notes) {
  const auto note = [&](bool given, const char* option, const char* why) {
    if (given) notes.push_back(std::string(option) + " has no effect: " + why);
  };
  note(options.tremor_px.has_value(), "--tremor", "the track has values, no points; --smooth smooths them");
  note(options.least_confidence != AnimateOptions{}.least_confidence, "--confidence",
       "the track has values, no points");
  note(options.units, "--units", "the track has no points beside its values");
  note(!options.curves.empty(), "--curves", "the track has values, no points");
}

/// Returns true if a turn of the head can be shown.
bool turns_the_head(const animation::WeightTrack& track) {
  constexpr double k_seen = 0.02;
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    const std::string name = rig::folded_name(track.names[i]);
    if (name != "headyaw" && name != "headpitch" && name != "headroll") continue;
    std::optional<double> least, most;
    for (const auto& frame : track.frames) {
      if (!frame.found) continue;
      least = std::min(least.value_or(frame.values[i]), frame.values[i]);
      most = std::max(most.value_or(frame.values[i]), frame.values[i]);
    }
    if (least && *most - *least > k_seen) return true;
  }
  return false;
}

base::Result<Solved> from_values(const document::Model& model, animation::WeightTrack& track, const io::MapFile& map,
                                 const AnimateOptions& options, bool apply_head) {
  Solved solved;
  Animated& out = solved.animated;
  const bool percent = divide_percent(track);
  const bool degrees = take_degrees(track);
  if (options.neutral) {
    if (auto done = subtract_neutral(track, *options.neutral); !done) return done.error();
  }
  std::optional<std::size_t> none;
  auto notes = retimed(track, options, none);
  if (!notes) return notes.error();
  out.notes = *std::move(notes);
  note_without_effect(options, out.notes);
  if (percent) out.notes.emplace_back("its values are percent: they are divided by 100");
  if (degrees) out.notes.emplace_back("its turns are degrees: they are taken so, not as radians");
  WeightAnimation played = animate_weights(model, track, map, apply_head, options.smooth_s);
  if (!played.drives) {
    return base::Error{"the model has a control for none of its " + std::to_string(track.names.size()) + " columns",
                       "line 1", "write a map whose \"names\" say which control each column drives"};
  }
  out.times_s = std::move(played.times_s);
  out.poses = std::move(played.poses);
  out.held = std::move(played.held);
  out.unmatched = std::move(played.unmatched);
  out.nearest = std::move(played.nearest);
  out.notes.insert(out.notes.end(), played.notes.begin(), played.notes.end());
  if (!apply_head && turns_the_head(track))
    out.notes.emplace_back("its head turns, which is left out: --head apply plays it");
  if (apply_head && played.placements.empty()) {
    out.notes.emplace_back(
        "the head cannot be followed and stays still: there is no column HeadYaw, HeadPitch or HeadRoll");
  }
  solved.head = {std::move(played.placements), document::rest_world_box(model).center()};
  return solved;
}

/// What keeps a head from being followed; empty where nothing does, or make_setup has said so.
std::string head_note(const io::MapFile& map, const animation::TrackSetup& setup) {
  const std::size_t count = setup.points.stable.size();
  if (count >= 2 || (map.bundled && count == 0)) return {};
  return count == 0 ? "the head cannot be followed and stays still: the map lists no stable points; list two or more "
                      "in \"stable\""
                    : "the head's turn cannot be followed, only its shift: the map lists a single stable point; list "
                      "two or more in \"stable\"";
}

base::Result<Solved> from_points(const document::Model& model, animation::PointTrack& track, const io::MapFile& map,
                                 const AnimateOptions& options, bool apply_head, const animation::FrameWatch& watch) {
  Solved solved;
  Animated& out = solved.animated;
  if (options.neutral.value_or(0) >= track.frames.size()) {
    return base::Error{"there is no frame " + std::to_string(*options.neutral) + "; the track has " +
                           std::to_string(track.frames.size()),
                       "neutral", "frames count from 0"};
  }
  std::optional<std::size_t> neutral = options.neutral;
  auto notes = retimed(track, options, neutral);
  if (!notes) return notes.error();
  out.notes = *std::move(notes);
  auto setup = make_setup(model, track, map, options.curves, out.notes);
  if (!setup) return setup.error();
  if (std::string note = head_note(map, *setup); apply_head && !note.empty()) out.notes.push_back(std::move(note));
  if (options.units) {
    setup->units = unit_controls(model, track);
    if (setup->units.empty()) out.notes.emplace_back("the track has no action units that the model has controls for");
  }
  setup->neutral = neutral;
  setup->tremor_px = options.tremor_px;
  setup->smooth_s = options.smooth_s;
  setup->least_confidence = options.least_confidence;
  const auto camera = geometry::frame_box(document::rest_world_box(model), {1000, 1000}, model.front_yaw_degrees);
  auto tracked = animation::animate_track(*model.rig, track, *setup, camera, watch);
  if (!tracked) return tracked.error();
  if (apply_head) {
    solved.head.pivot = head_pivot(*model.rig, *setup, *tracked, camera);
    solved.head.placements = head_placements(*tracked, solved.head.pivot, camera, options.smooth_s);
  }
  out.times_s = std::move(tracked->times_s);
  out.poses = std::move(tracked->poses);
  out.held = std::move(tracked->held);
  out.rest = std::move(tracked->rest);
  out.eyes = std::move(tracked->eyes);
  if (out.rest && !out.rest->near_rest) {
    out.notes.emplace_back(
        "nothing in the clip is near rest: the lips never touch; if they do in a frame, name it as the neutral one");
  }
  out.head = std::move(tracked->still.turns);
  return solved;
}

base::Result<Solved> from_motion(const document::Model& model, const io::MotionTrack& motion,
                                 const AnimateOptions& options) {
  auto played = animate_motion(model, motion);
  if (!played) return played.error();
  Solved solved;
  Animated& out = solved.animated;
  out.times_s = std::move(played->times_s);
  const auto& channels = played->animation.channels;
  const bool drives = std::any_of(channels.begin(), channels.end(), [](const document::Channel& channel) {
    return channel.target == document::ChannelTarget::weights;
  });
  for (const document::PoseKey& key : document::poses_at(model, played->animation, out.times_s)) {
    rig::Pose& pose = out.poses.emplace_back(key.pose);
    if (!drives) std::copy_n(model.pose.begin(), document::weight_count(model), pose.begin());
  }
  out.unmatched = std::move(played->unmatched);
  out.notes = std::move(played->notes);
  if (options.fps > 0 || options.stretch > 0 || options.smooth_s > 0) {
    out.notes.emplace_back("a motion keeps its own keys: it is neither smoothed nor given another frame rate");
  }
  if (options.neutral) out.notes.emplace_back("--neutral has no effect: a motion says what rest is");
  note_without_effect(options, out.notes);
  solved.animation = std::move(played->animation);
  return solved;
}

void put_on_whole_frames(Animated& animated) {
  constexpr double k_off_frame = 0.3;
  std::vector<double>& times_s = animated.times_s;
  const double whole = animation::whole_frame_rate(times_s, k_off_frame);
  animated.whole_frames = whole > 0;
  if (whole > 0) times_s = animation::at_whole_frames(times_s, whole);
  animated.fps = whole > 0 ? whole : animation::frames_per_second(times_s.front(), times_s.back(), times_s.size());
}

/// Joints that the first animation does not move keep their pose. One of those that it moves would be added to it.
void keep_pose_of_still_joints(document::Model& model, const rig::Pose& pose) {
  if (!model.skeleton) return;
  const auto joints = model.skeleton->joints();
  std::vector<bool> moves(joints.size(), false);
  for (const document::Channel& channel : model.animations.front().channels) {
    if (channel.target != document::ChannelTarget::weights) moves[channel.joint] = true;
  }
  std::size_t parameter = document::weight_count(model);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (!joints[j].posable) continue;
    for (int axis = 0; axis < 3; ++axis, ++parameter) {
      if (!moves[j] && parameter < pose.size()) model.pose[parameter] = pose[parameter];
    }
  }
}

/// The animation comes first, which is what viewers play.
base::Result<document::Document> with_animation(const document::Document& document, document::Model model,
                                                const Animated& animated, const HeadWay& head,
                                                std::optional<document::Animation> made) {
  if (!made) made = document::make_animation(model, "tracked", animated.times_s, animated.poses);
  model.animations.insert(model.animations.begin(), *std::move(made));
  model.pose = rig::rest_pose(*model.rig);
  std::copy_n(animated.poses.front().begin(), document::weight_count(model), model.pose.begin());
  const auto joints = head.placements.empty() ? std::nullopt : document::head_joints(model);
  if (joints) {
    model = document::with_head_turns(std::move(model), 0, *joints, animated.times_s, head.placements);
  } else if (!head.placements.empty()) {
    auto with_head = document::with_placements(std::move(model), 0, head.pivot, animated.times_s, head.placements);
    if (!with_head) return with_head.error();
    model = std::move(with_head).value();
  }
  keep_pose_of_still_joints(model, document.pose);
  document::Document result = document::with_model(document, model);
  result.timeline = std::make_shared<const document::Timeline>();
  result.pose = model.pose;
  return result;
}

}  // namespace

base::Result<Animated> animate(const document::Document& document, io::Track track, const io::MapFile& map,
                               const AnimateOptions& options, const animation::FrameWatch& watch,
                               AnimateInput* blamed) {
  AnimateInput ignored{};
  AnimateInput& about = blamed == nullptr ? ignored : *blamed;
  about = AnimateInput::track;
  if (const auto fits = check_options(options); !fits) return fits.error();
  document::Model model = document::model_of(document);
  about = AnimateInput::model;
  if (model.rig->parameters().empty()) {
    return base::Error{"the model has no control to animate", "", "articulate it first"};
  }
  const bool apply_head = options.apply_head.value_or(map.apply_head);
  base::Result<Solved> solved = base::Error{};
  if (auto* values = std::get_if<animation::WeightTrack>(&track)) {
    about = AnimateInput::track;
    solved = from_values(model, *values, map, options, apply_head);
  } else if (const auto* motion = std::get_if<io::MotionTrack>(&track)) {
    about = AnimateInput::track;
    solved = from_motion(model, *motion, options);
  } else {
    about = AnimateInput::map;
    solved = from_points(model, std::get<animation::PointTrack>(track), map, options, apply_head, watch);
  }
  if (!solved) return solved.error();
  Animated animated = std::move(solved->animated);
  put_on_whole_frames(animated);
  const auto shifts = [](const document::Placement& one) {
    return one.shift != geometry::ModelVector(0) || one.scale != 1;
  };
  const auto& placements = solved->head.placements;
  if (std::any_of(placements.begin(), placements.end(), shifts) && document::head_joints(model)) {
    animated.notes.emplace_back("the head turns on its neck; its shift and size in the picture are left out");
  }
  auto with = with_animation(document, std::move(model), animated, solved->head, std::move(solved->animation));
  about = AnimateInput::model;
  if (!with) return with.error();
  animated.document = std::move(with).value();
  return animated;
}

}  // namespace penpose::tracking
