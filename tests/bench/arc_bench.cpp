// Arcs that are redrawn: how near the path is to the line, and how many keys that takes.
//
//   arc_bench MODEL... [--seed N] [--clips N]
//
// Each clip has three to six whole poses of random controls within 1 to 3 s, 24 frames a second. The middle of a
// feature that travels at least 15 px of 1000 is seen from the front. Controls that move it go aside by smooth bows of
// up to a third of their ranges; where the point is then, is drawn frame by frame by a hand that strays 0.3 px, and the
// arc of the clip is redrawn so. What is measured, at worst over the frames: px off that path, frames of the spacing
// (where it goes half a px a frame or more); and keys a frame, the roughness of the path (the root mean square of its
// second differences) beside the rougher one of the clip's and of what was asked for, milliseconds.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/curve/distance.h"
#include "core/curve/polyline.h"
#include "core/document/commands/apply.h"
#include "core/document/features/feature_curves.h"
#include "core/document/time/arc.h"
#include "tests/support/random.h"
#include "ui/files/load_model.h"
#include "ui/render/framing.h"

namespace penpose {
namespace {

using document::PxPoint;

constexpr int k_rate = 24;

struct Row {
  std::vector<double> off_px, spacing_frames, key_share, rougher, ms;
  int clips = 0;
};

double roughness(std::span<const PxPoint> places) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const PxPoint second = places[i - 1] + places[i + 1] - places[i] * 2;
    sum += geometry::dot(second, second);
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, places.size() - 2)));
}

double median(std::vector<double> values, double share = 0.5) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

class Clip {
 public:
  Clip(document::Document document, tests::Random& random) : document_(std::move(document)), random_(random) {
    const auto parameters = document_.model->rig->parameters();
    const auto poses = static_cast<std::size_t>(random(3, 6.99));
    const double length_s = random(1, 3);
    for (std::size_t k = 0; k < poses; ++k) {
      document::SetParameters values;
      for (const rig::Parameter& one : parameters) {
        if (random(0, 1) > 0.25) continue;
        const double low = one.rest - 0.7 * (one.rest - one.minimum);
        const double high = one.rest + 0.7 * (one.maximum - one.rest);
        values.values.push_back({one.name, random(low, high)});
      }
      does(document::ResetParameters{});
      if (!values.values.empty()) does(values);
      const double at_s = length_s * static_cast<double>(k) / static_cast<double>(poses - 1);
      does(document::SetKey{std::round(at_s * k_rate) / k_rate, {}});
    }
  }

  void measure(std::span<const portrait::FeatureCurve> features, const geometry::Camera& camera,
               const document::View& view, Row& row) {
    const auto& feature = features[static_cast<std::size_t>(random_(0, static_cast<double>(features.size()) - 0.01))];
    const auto triangles = document_.model->mesh->triangles();
    const std::uint32_t vertex = portrait::nearest_vertex(feature.points[feature.points.size() / 2]);
    const mesh::MeshPoint point = mesh::mesh_point_at(vertex, triangles).value();
    const auto& keys = document_.timeline->keys;
    const double from_s = keys.front().time_s;
    const double to_s = keys.back().time_s;
    std::vector<double> moments;
    for (int f = 0; f <= static_cast<int>(std::lround((to_s - from_s) * k_rate)); ++f)
      moments.push_back(from_s + static_cast<double>(f) / k_rate);
    const posing::CurvePoint at = posing::at_mesh_point(point, triangles);
    const auto before = document::arc_of(document_, at, camera, document::poses_of_timeline(document_, moments));
    const double travels = curve::arc_length(std::span<const PxPoint>(before));
    if (travels < 15) return;
    ++row.clips;
    // The path that the rig can take and the clip does not: controls that move the point go aside by a smooth bow.
    const document::ArcView seen(document_, at, camera);
    const auto parameters = document_.model->rig->parameters();
    std::vector<double> bow(parameters.size(), 0.0);
    for (std::size_t i = 0; i < bow.size(); ++i) {
      const auto& timeline = *document_.timeline;
      const bool varies = document::sample(timeline, i, from_s) != document::sample(timeline, i, 0.5 * (from_s + to_s));
      if (seen.moves(i) && varies) bow[i] = random_(-0.35, 0.35) * (parameters[i].maximum - parameters[i].minimum);
    }
    std::vector<PxPoint> wanted;
    document::RedrawArc redraw{point, view, from_s, to_s, k_rate, {}, {}};
    for (std::size_t f = 0; f < moments.size(); ++f) {
      const double u = static_cast<double>(f) / static_cast<double>(moments.size() - 1);
      rig::Pose pose = document::pose_at(document_, moments[f]);
      for (std::size_t i = 0; i < bow.size(); ++i)
        pose[i] =
            std::clamp(pose[i] + bow[i] * 16 * u * u * (1 - u) * (1 - u), parameters[i].minimum, parameters[i].maximum);
      wanted.push_back(seen.at(pose).value());
      redraw.line.push_back(wanted.back() + PxPoint{random_(-0.3, 0.3), random_(-0.3, 0.3)});
      redraw.shares.push_back(u);
    }
    redraw.line.front() = wanted.front();
    redraw.line.back() = wanted.back();
    const auto start = std::chrono::steady_clock::now();
    auto changed = document::apply(document_, redraw, work_);
    row.ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    if (!changed) {
      std::printf("%s\n", changed.error().line().c_str());
      return;
    }
    const auto after = document::arc_of(*changed, at, camera, document::poses_of_timeline(*changed, moments));
    double off = 0;
    double frames = 0;
    for (std::size_t f = 0; f < after.size(); ++f) {
      off = std::max(off, curve::distance_to(wanted, after[f]));
      // How far along the path it is from its place, by how far the path goes in a frame.
      const PxPoint along = wanted[std::min(f + 1, wanted.size() - 1)] - wanted[f > 0 ? f - 1 : 0];
      const double both = std::sqrt(geometry::dot(along, along));
      constexpr double k_stands_px = 1;  // slower than half a px a frame: nobody sees when it is where
      if (both < k_stands_px) continue;
      frames = std::max(frames, std::abs(geometry::dot(after[f] - wanted[f], along)) / (0.5 * both * both));
    }
    row.off_px.push_back(off);
    row.spacing_frames.push_back(frames);
    row.key_share.push_back(static_cast<double>(changed->timeline->keys.size()) / static_cast<double>(moments.size()));
    row.rougher.push_back(roughness(after) / std::max(1e-9, std::max(roughness(before), roughness(wanted))));
  }

 private:
  void does(const document::Command& command) {
    auto changed = document::apply(document_, command, work_);
    if (changed) document_ = std::move(changed).value();
  }
  document::Document document_;
  document::ApplyWorkspace work_;
  tests::Random& random_;
};

int measure(const std::vector<std::string>& models, std::uint64_t seed, int clips) {
  for (const std::string& name : models) {
    auto document = files::load_document(name);
    if (!document) {
      std::printf("%s\n", document.error().line(name).c_str());
      return 1;
    }
    const auto& model = *document->model;
    const auto features = document::feature_curves_of(model, intent::measure_whole_model(*model.rig), {});
    if (!features) {
      std::printf("%s\n", features.error().line(name).c_str());
      return 1;
    }
    std::vector<glm::vec3> points;
    for (const auto& p : model.mesh->positions()) points.emplace_back(p);
    document::View view;
    view.viewport = {1000, 1000};
    const auto camera = render::frame_points(points, view.viewport, {0, 0});
    view.camera = camera.pose();
    tests::Random random(seed);
    Row row;
    for (int i = 0; i < clips; ++i) Clip(*document, random).measure(features->curves, camera, view, row);
    std::printf("%s: %d arcs\n", name.c_str(), row.clips);
    const auto line = [](const char* what, const std::vector<double>& values) {
      std::printf("  %-34s median %7.3f   p90 %7.3f   most %7.3f\n", what, median(values), median(values, 0.9),
                  median(values, 1));
    };
    line("px off the line", row.off_px);
    line("frames of the spacing", row.spacing_frames);
    line("keys a frame", row.key_share);
    line("roughness beside what was asked", row.rougher);
    line("milliseconds", row.ms);
  }
  return 0;
}

}  // namespace
}  // namespace penpose

int main(int count, char** arguments) {
  std::vector<std::string> models;
  std::uint64_t seed = 7;
  int clips = 100;
  for (int i = 1; i < count; ++i) {
    const std::string one = arguments[i];
    if (one == "--seed" && i + 1 < count) {
      seed = std::stoull(arguments[++i]);
    } else if (one == "--clips" && i + 1 < count) {
      clips = std::stoi(arguments[++i]);
    } else {
      models.push_back(one);
    }
  }
  if (models.empty()) models = {"builtin:demo"};
  return penpose::measure(models, seed, clips);
}
