// What comes of tracked faces, in figures. One of
//   tracked_bench people FIRST COUNT   made-up people by their seeds
//   tracked_bench tremor FIRST COUNT [turning|still]   the rendered clip, calm and shaken
//   tracked_bench shared               the shared recording

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/animation/animate_track.h"
#include "core/animation/solve/seen_points.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/read_track.h"
#include "core/tracking/track_setup.h"
#include "tests/support/models/made_up_person.h"
#include "tests/support/models/nodding_head.h"
#include "tests/support/models/rendered_track.h"
#include "tests/support/shared_data.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

namespace {

using namespace penpose;
using Signal = std::vector<double>;

double correlation(const Signal& a, const Signal& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

double slope(const Signal& of, const Signal& against) {
  const auto n = static_cast<double>(of.size());
  const double mean_a = std::accumulate(of.begin(), of.end(), 0.0) / n;
  const double mean_b = std::accumulate(against.begin(), against.end(), 0.0) / n;
  double ab = 0, bb = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    ab += (of[i] - mean_a) * (against[i] - mean_b);
    bb += (against[i] - mean_b) * (against[i] - mean_b);
  }
  return ab / bb;
}

double median(Signal values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

struct Desk {
  document::Model model = files::load_model((tests::shared_dir() / "meshes" / "ict_face.glb").string()).value();
  std::vector<std::uint32_t> points;
  io::MapFile map = io::read_bundled_map(*io::track_format_named("openface")).value();
  geometry::Camera camera = geometry::frame_box(document::rest_world_box(model), {1000, 1000}, 0);
  bool units = false;
  double unit_weight = -1;

  Desk() {
    const auto bytes = files::read_file((tests::shared_dir() / "meshes" / "ict_face_landmarks.json").string()).value();
    points = nlohmann::json::parse(bytes.begin(), bytes.end())["landmarks68"].get<std::vector<std::uint32_t>>();
    units = std::getenv("UNITS") != nullptr;
    if (const char* w = std::getenv("UNIT_WEIGHT")) unit_weight = std::atof(w);
  }
  [[nodiscard]] std::size_t parameter(const std::string& name) const {
    return rig::find_parameter(model.rig->parameters(), name).value();
  }
  animation::TrackedAnimation animate(const animation::PointTrack& track) const {
    std::vector<std::string> notes;
    auto setup = tracking::make_setup(model, track, map, {}, notes).value();
    if (units) setup.units = tracking::unit_controls(model, track);
    if (unit_weight >= 0) setup.unit_weight = unit_weight;
    if (const char* t = std::getenv("TREMOR")) setup.tremor_px = std::atof(t);
    if (const char* t = std::getenv("NEAR_REST")) setup.frame.near_rest = std::atof(t);
    return animation::animate_track(*model.rig, track, setup, camera).value();
  }
  [[nodiscard]] Signal values(const std::vector<rig::Pose>& poses, const std::string& name) const {
    Signal all;
    for (const auto& pose : poses) all.push_back(pose[parameter(name)]);
    return all;
  }
};

double apart(const animation::PointTrack& track, std::size_t f, std::size_t a, std::size_t b) {
  return geometry::distance(track.frames[f].points[a], track.frames[f].points[b]);
}

Signal gaps(const animation::PointTrack& track) {
  Signal all;
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    all.push_back((apart(track, f, 61, 67) + apart(track, f, 62, 66) + apart(track, f, 63, 65)) / 3 /
                  apart(track, f, 36, 45));
  }
  return all;
}

Signal brow_heights(const animation::PointTrack& track) {
  Signal all;
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    const auto& p = track.frames[f].points;
    const auto mean = [&](std::size_t first, std::size_t last) {
      geometry::PxPoint sum;
      for (std::size_t i = first; i <= last; ++i) sum = sum + p[i] * (1.0 / static_cast<double>(last - first + 1));
      return sum;
    };
    const double height = geometry::distance(mean(17, 21), (p[36] + p[39]) * 0.5) +
                          geometry::distance(mean(22, 26), (p[42] + p[45]) * 0.5);
    all.push_back(height / 2 / apart(track, f, 36, 45));
  }
  return all;
}

/// What a tracker would see of the model.
animation::PointTrack seen(const Desk& desk, const std::vector<rig::Pose>& poses) {
  return tests::track_of(*desk.model.rig, poses, desk.points, desk.camera);
}

struct Figures {
  double jaw, gap, gap_slope, blink_median, blink_least, brows, brow_controls, brow_true, smile, jaw_true, both, jitter,
      eyes, error, false_blinks;
};

Figures figures_of(const Desk& desk, const tests::MadeUpPerson& person, const animation::TrackedAnimation& result) {
  Figures figures{};
  const Signal gap = gaps(person.track);
  const auto shown = seen(desk, result.poses);
  figures.jaw = correlation(desk.values(result.poses, "jawOpen"), gap);
  figures.jaw_true = correlation(desk.values(result.poses, "jawOpen"), desk.values(person.poses, "jawOpen"));
  figures.gap = correlation(gaps(shown), gap);
  figures.gap_slope = slope(gaps(shown), gap);
  Signal peaks;
  for (const std::size_t f : person.blinks) {
    double most = 0;
    for (std::size_t g = f < 3 ? 0 : f - 3; g <= std::min(f + 4, result.poses.size() - 1); ++g) {
      most = std::max(
          most, std::min(result.poses[g][desk.parameter("eyeBlink_L")], result.poses[g][desk.parameter("eyeBlink_R")]));
    }
    peaks.push_back(most);
  }
  figures.blink_median = median(peaks);
  figures.blink_least = *std::min_element(peaks.begin(), peaks.end());
  for (std::size_t f = 1; f + 1 < result.poses.size(); ++f) {
    const double here = result.poses[f][desk.parameter("eyeBlink_L")];
    const bool peak = here > 0.5 && here > result.poses[f - 1][desk.parameter("eyeBlink_L")] &&
                      here >= result.poses[f + 1][desk.parameter("eyeBlink_L")];
    const bool near = std::any_of(person.blinks.begin(), person.blinks.end(),
                                  [&](std::size_t b) { return b <= f + 6 && f <= b + 6; });
    if (peak && !near) figures.false_blinks += 1;
  }
  figures.brows = correlation(brow_heights(shown), brow_heights(person.track));
  const auto combined = [&](const std::vector<rig::Pose>& poses) {
    Signal all(poses.size(), 0.0);
    for (const char* name : {"browInnerUp_L", "browInnerUp_R", "browOuterUp_L", "browOuterUp_R"}) {
      const Signal one = desk.values(poses, name);
      for (std::size_t f = 0; f < all.size(); ++f) all[f] += one[f];
    }
    for (const char* name : {"browDown_L", "browDown_R"}) {
      const Signal one = desk.values(poses, name);
      for (std::size_t f = 0; f < all.size(); ++f) all[f] -= one[f];
    }
    return all;
  };
  figures.brow_controls = correlation(combined(result.poses), brow_heights(person.track));
  figures.brow_true = correlation(combined(result.poses), combined(person.poses));
  figures.smile = correlation(desk.values(result.poses, "mouthSmile_L"), desk.values(person.poses, "mouthSmile_L"));
  for (const auto& pose : result.poses) {
    if (pose[desk.parameter("mouthLeft")] > 0.1 && pose[desk.parameter("mouthRight")] > 0.1) figures.both += 1;
  }
  double sum = 0;
  double off = 0;
  for (std::size_t f = 1; f + 1 < result.poses.size(); ++f) {
    for (std::size_t i = 0; i < result.poses[f].size(); ++i) {
      const double bend = result.poses[f - 1][i] - 2 * result.poses[f][i] + result.poses[f + 1][i];
      const std::string& name = desk.model.rig->parameters()[i].name;
      if (name.starts_with("eye")) continue;
      sum += bend * bend;
      off += (result.poses[f][i] - person.poses[f][i]) * (result.poses[f][i] - person.poses[f][i]);
    }
  }
  figures.jitter = std::sqrt(sum / static_cast<double>(result.poses.size() - 2));
  figures.error = std::sqrt(off / static_cast<double>(result.poses.size() - 2));
  Signal open_seen, open_shown;
  for (std::size_t f = 0; f < person.track.frames.size(); ++f) {
    const auto open = [&](const animation::PointTrack& track) {
      return (apart(track, f, 37, 41) + apart(track, f, 38, 40) + apart(track, f, 43, 47) + apart(track, f, 44, 46)) /
             apart(track, f, 36, 45);
    };
    open_seen.push_back(open(person.track));
    open_shown.push_back(result.poses[f][desk.parameter("eyeBlink_L")] + result.poses[f][desk.parameter("eyeBlink_R")]);
  }
  figures.eyes = -correlation(open_seen, open_shown);
  return figures;
}

int people(const Desk& desk, int first, int count) {
  std::printf(
      "seed   jaw  jawT   gap slope  blinkM blinkL false  eyes  brow browC browT smile both jitter error  ms\n");
  Figures sum{};
  for (int seed = first; seed < first + count; ++seed) {
    const auto person = tests::PersonMaker(*desk.model.rig, desk.points, static_cast<std::uint64_t>(seed)).make();
    const std::clock_t start = std::clock();
    const auto result = desk.animate(person.track);
    const double ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const Figures f = figures_of(desk, person, result);
    std::printf(
        "%4d %5.3f %5.3f %5.3f %5.2f   %5.2f  %5.2f %4.0f  %5.2f  %5.3f %5.3f %5.3f %5.3f %4.0f %6.4f %5.3f %4.0f\n",
        seed, f.jaw, f.jaw_true, f.gap, f.gap_slope, f.blink_median, f.blink_least, f.false_blinks, f.eyes, f.brows,
        f.brow_controls, f.brow_true, f.smile, f.both, f.jitter, f.error, ms);
    sum.jaw += f.jaw / count, sum.jaw_true += f.jaw_true / count, sum.brows += f.brows / count,
        sum.brow_true += f.brow_true / count;
    sum.jitter += f.jitter / count, sum.error += f.error / count, sum.smile += f.smile / count,
        sum.blink_median += f.blink_median / count;
    sum.blink_least += f.blink_least / count, sum.brow_controls += f.brow_controls / count;
  }
  std::printf(
      "mean jaw %.3f jawT %.3f blinkM %.2f blinkL %.2f brow %.3f browC %.3f browT %.3f smile %.3f jitter %.4f error "
      "%.3f\n",
      sum.jaw, sum.jaw_true, sum.blink_median, sum.blink_least, sum.brows, sum.brow_controls, sum.brow_true, sum.smile,
      sum.jitter, sum.error);
  return 0;
}

int tremor(const Desk& desk, int first, int count, const std::string& kind) {
  std::vector<geometry::ModelPoint> rest(desk.model.mesh->vertex_count());
  desk.model.rig->evaluate(rig::rest_pose(*desk.model.rig), rest);
  const double width = geometry::distance(rest[desk.points[0]], rest[desk.points[16]]);
  const geometry::ModelPoint middle = (rest[desk.points[0]] + rest[desk.points[16]]) * 0.5;
  geometry::CameraPose pose{middle + geometry::ModelVector(0, 0, 60), middle, {0, 1, 0}, 30};
  auto video = geometry::Camera::make(pose, {640, 640}).value();
  pose.vertical_fov_degrees = 30 * (width / video.units_per_px(60)) / 320;
  video = geometry::Camera::make(pose, {640, 640}).value();
  auto poses = tests::talking_clip(*desk.model.rig, 300);
  if (kind == "still") poses.assign(300, rig::rest_pose(*desk.model.rig));
  const auto calm_track = kind == "turning"
                              ? tests::track_of(*desk.model.rig, poses, desk.points, video, 0, tests::nodding)
                              : tests::track_of(*desk.model.rig, poses, desk.points, video);
  const auto with_depths = [](animation::PointTrack track) {
    for (auto& frame : track.frames) frame.depths = io::common_depths(frame.points);
    return track;
  };
  const auto calm = desk.animate(with_depths(calm_track));
  double sum = 0, worst = 0;
  int over = 0;
  std::vector<int> blame(desk.model.rig->parameters().size(), 0);
  for (int seed = first; seed < first + count; ++seed) {
    auto track = calm_track;
    tests::Shaker shake(static_cast<std::uint64_t>(seed));
    for (auto& frame : track.frames) {
      for (auto& p : frame.points) p = p + geometry::PxPoint{shake(), shake()};
    }
    const auto shaken = desk.animate(with_depths(std::move(track)));
    double largest = 0;
    std::size_t frame = 0, which = 0;
    for (std::size_t f = 1; f < poses.size(); ++f) {
      for (std::size_t i = 0; i < poses[f].size(); ++i) {
        const double apart =
            std::abs((shaken.poses[f][i] - shaken.poses[f - 1][i]) - (calm.poses[f][i] - calm.poses[f - 1][i]));
        if (apart > largest) largest = apart, frame = f, which = i;
      }
    }
    sum += largest / count;
    worst = std::max(worst, largest);
    if (largest > 0.038 || std::getenv("ALL") != nullptr) {
      if (std::getenv("DUMP") != nullptr) {
        for (std::size_t f = frame - std::min<std::size_t>(frame, 8); f < std::min(frame + 9, poses.size()); ++f) {
          std::printf("    %zu shaken %.3f calm %.3f L %.3f R %.3f\n", f, shaken.poses[f][which], calm.poses[f][which],
                      shaken.poses[f][desk.parameter("eyeBlink_L")], shaken.poses[f][desk.parameter("eyeBlink_R")]);
        }
      }
      ++over;
      std::printf("  seed %d: %.3f at %zu %s; blinks", seed, largest, frame,
                  desk.model.rig->parameters()[which].name.c_str());
      for (const std::size_t b : shaken.eyes.blinks) std::printf(" %zu", b);
      std::printf("\n");
    }
  }
  std::printf("%d clips: mean of the worst %.4f, worst %.4f, %d above 0.038\n", count, sum, worst, over);
  std::printf("calm blinks");
  for (const std::size_t b : calm.eyes.blinks) std::printf(" %zu", b);
  std::printf("\n");
  return 0;
}

int shared(const Desk& desk) {
  auto input = cli::read_track((tests::shared_dir() / "tracks" / "openface_head_test.csv").string(), {}, {}).value();
  const auto& track = std::get<animation::PointTrack>(input.track);
  const std::clock_t start = std::clock();
  const auto result = desk.animate(track);
  const double ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  Signal lips, open, level_open, level_blink, blink, told, smile12;
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    lips.push_back(apart(track, f, 62, 66));
    open.push_back((apart(track, f, 37, 41) + apart(track, f, 38, 40)) / apart(track, f, 36, 39) +
                   (apart(track, f, 43, 47) + apart(track, f, 44, 46)) / apart(track, f, 42, 45));
    blink.push_back(result.poses[f][desk.parameter("eyeBlink_L")] + result.poses[f][desk.parameter("eyeBlink_R")]);
    told.push_back(track.frames[f].says.closing.value_or(0));
    if (result.still.turns[f].rotation[2][2] < std::cos(0.35)) continue;
    level_open.push_back(open[f]);
    level_blink.push_back(blink[f]);
  }
  const Signal jaw = desk.values(result.poses, "jawOpen");
  const auto shown = seen(desk, result.poses);
  std::printf(
      "rest %zu like %zu; jaw/lips %.4f; jaw/gap %.4f; model gap/gap %.4f slope %.2f; eyes %.4f level %.4f; AU45 %.4f; "
      "brow %.3f; ms %.0f\n",
      result.rest ? result.rest->frame : 9999, result.rest ? result.rest->like_it.size() : 0, correlation(jaw, lips),
      correlation(jaw, gaps(track)), correlation(gaps(shown), gaps(track)), slope(gaps(shown), gaps(track)),
      -correlation(open, blink), -correlation(level_open, level_blink), correlation(blink, told),
      correlation(brow_heights(shown), brow_heights(track)), ms);
  double jitter = 0;
  int both = 0;
  for (std::size_t f = 0; f < result.poses.size(); ++f) {
    both += result.poses[f][desk.parameter("mouthLeft")] > 0.1 && result.poses[f][desk.parameter("mouthRight")] > 0.1;
    for (std::size_t i = 0; f > 0 && f + 1 < result.poses.size() && i < result.poses[f].size(); ++i) {
      const double bend = result.poses[f - 1][i] - 2 * result.poses[f][i] + result.poses[f + 1][i];
      jitter += bend * bend;
    }
  }
  double closed = 0;
  for (std::size_t f = 0; f < jaw.size(); ++f)
    if (lips[f] < 3) closed = std::max(closed, jaw[f]);
  std::printf("jitter %.4f both %d jaw at closed lips %.3f; blink_R at 247 %.3f 126 %.3f 232 %.3f; blinks",
              std::sqrt(jitter / 298), both, closed, result.poses[247][desk.parameter("eyeBlink_R")],
              result.poses[126][desk.parameter("eyeBlink_R")], result.poses[232][desk.parameter("eyeBlink_R")]);
  for (const std::size_t b : result.eyes.blinks) std::printf(" %zu", b);
  std::printf("\n");
  if (std::getenv("DUMP") != nullptr) {
    for (std::size_t f = 0; f < track.frames.size(); ++f) {
      std::printf(
          "%zu lips %.2f jaw %.3f open %.3f blink %.3f told %.2f pitch %.2f doubt %.2f gap %.4f seen %.4f ld %.2f uu "
          "%.2f sm %.2f fu %.2f pu %.2f pr %.2f st %.2f\n",
          f, lips[f], jaw[f], open[f], blink[f], told[f],
          std::atan2(-result.still.turns[f].rotation[2][1], result.still.turns[f].rotation[2][2]),
          result.still.doubt[f], gaps(shown)[f], gaps(track)[f], desk.values(result.poses, "mouthLowerDown_L")[f],
          desk.values(result.poses, "mouthUpperUp_L")[f], desk.values(result.poses, "mouthSmile_L")[f],
          desk.values(result.poses, "mouthFunnel")[f], desk.values(result.poses, "mouthPucker")[f],
          desk.values(result.poses, "mouthPress_L")[f], desk.values(result.poses, "mouthStretch_L")[f]);
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (!tests::has_shared() || argc < 2) return 2;
  const Desk desk;
  const std::string what = argv[1];
  if (what == "shared") return shared(desk);
  if (argc < 4) return 2;
  if (what == "people") return people(desk, std::atoi(argv[2]), std::atoi(argv[3]));
  return tremor(desk, std::atoi(argv[2]), std::atoi(argv[3]), argc > 4 ? argv[4] : "");
}
