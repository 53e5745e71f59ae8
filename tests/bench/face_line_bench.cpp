// The tool Draw, without its window: a live step, which is one reading of the face with the line as far as the pen is,
// and a sheet of ten lines, which are read together. Milliseconds.
//
//   face_line_bench [MODEL...]      without one: builtin:demo
//
// Each feature of the face is drawn on its own, moved and bent by a hand with a tremor, in 24 steps; then ten of them
// on one sheet, five times.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "core/document/commands/apply.h"
#include "core/document/features/drawing_start.h"
#include "core/document/features/feature_near.h"
#include "core/portrait/pose_from_drawing.h"
#include "tests/support/hands/tremor.h"
#include "tests/support/random.h"
#include "ui/files/load_model.h"

namespace penpose {
namespace {

using geometry::PxPoint;
using Line = std::vector<PxPoint>;

constexpr std::size_t k_steps = 24;
constexpr std::size_t k_sheet = 10;

struct Face {
  document::Document document;
  document::View view;
  std::vector<portrait::FeatureCurve> curves;
  std::vector<Line> lines;  ///< at rest, one a curve
};

double cpu_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double share_of(std::vector<double> times, double share) {
  if (times.empty()) return 0;
  std::sort(times.begin(), times.end());
  return times[std::min(times.size() - 1, static_cast<std::size_t>(share * static_cast<double>(times.size())))];
}

Face face_of(document::Document document, document::ApplyWorkspace& work) {
  const auto features = document::features_of(document, work);
  Face face{std::move(document), {}, {features.begin(), features.end()}, {}};
  const document::Model& model = *face.document.model;
  const auto camera =
      portrait::camera_of_drawing(*model.rig, face.curves, rig::rest_pose(*model.rig), model.front_yaw_degrees);
  face.view = {camera.pose(), camera.viewport()};
  for (const portrait::FeatureCurve& curve : face.curves) {
    Line line;
    for (const auto& point : document::positions_of(model, face.document.pose, curve))
      line.push_back(camera.project(point).value_or(PxPoint{}));
    face.lines.push_back(std::move(line));
  }
  return face;
}

/// A line moved and bent by at most a 20th of the face.
Line drawn(const Line& line, tests::Random& random) {
  const PxPoint by{random(-15, 15), random(-30, 30)};
  const double bend = random(-30, 30);
  Line out = tests::with_tremor(line, random, 0.3, 0.6);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(out.size() - 1) - 1.0;
    out[i] = out[i] + by + PxPoint{0, bend * t * t};
  }
  return out;
}

void measure_steps(const Face& face, document::ApplyWorkspace& work) {
  std::vector<double> times;
  for (std::size_t c = 0; c < face.lines.size(); ++c) {
    tests::Random random(10 + c);
    const Line whole = drawn(face.lines[c], random);
    for (std::size_t step = 1; step <= k_steps; ++step) {
      const std::size_t count = std::max<std::size_t>(2, step * whole.size() / k_steps);
      const document::Command command =
          document::DrawFaceLine{{face.view, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count)}}};
      const double start = cpu_ms();
      const auto after = document::apply(face.document, command, work);
      times.push_back(cpu_ms() - start);
      if (!after) std::fprintf(stderr, "%s\n", after.error().line().c_str());
    }
  }
  std::printf("  a live step         median %7.2f  p99 %7.2f  (%zu steps)\n", share_of(times, 0.5),
              share_of(times, 0.99), times.size());
}

void measure_sheets(const Face& face, document::ApplyWorkspace& work) {
  std::vector<double> times, last_steps;
  const auto& model = *face.document.model;
  const auto whole = intent::measure_whole_model(*model.rig);
  const auto start_of = document::drawing_start(face.document, whole, face.curves);
  const auto camera = geometry::Camera::make(face.view.camera, face.view.viewport);
  for (std::size_t k = 0; k < 5; ++k) {
    tests::Random random(100 + k);
    portrait::Drawing drawing;
    document::Document sheet = face.document;
    for (std::size_t i = 0; i < std::min(k_sheet, face.lines.size()); ++i) {
      drawing.lines.push_back(drawn(face.lines[i], random));
      const double start = cpu_ms();
      auto after = document::apply(sheet, document::DrawFaceLine{{face.view, drawing.lines.back()}}, work);
      if (i + 1 == k_sheet) last_steps.push_back(cpu_ms() - start);
      if (after) sheet = std::move(*after);
    }
    const double start = cpu_ms();
    static_cast<void>(
        portrait::pose_from_drawing(*model.rig, whole, face.curves, drawing, *camera, start_of.pose, start_of.free));
    times.push_back(cpu_ms() - start);
  }
  std::printf("  the tenth line      median %7.2f  worst %7.2f\n", share_of(last_steps, 0.5), share_of(last_steps, 1));
  std::printf("  a sheet of ten      median %7.2f  worst %7.2f\n", share_of(times, 0.5), share_of(times, 1));
}

int measure(const std::string& path) {
  auto document = files::load_document(path);
  if (!document) return std::fprintf(stderr, "%s\n", document.error().line(path).c_str()), 1;
  document::ApplyWorkspace work;
  const Face face = face_of(std::move(*document), work);
  std::printf("%s: %zu features\n", path.c_str(), face.lines.size());
  if (face.lines.empty()) return 1;
  measure_steps(face, work);
  measure_sheets(face, work);
  return 0;
}

}  // namespace
}  // namespace penpose

int main(int count, char** arguments) {
  std::vector<std::string> models(arguments + 1, arguments + count);
  if (models.empty()) models.emplace_back("builtin:demo");
  int status = 0;
  for (const std::string& model : models) status = std::max(status, penpose::measure(model));
  return status;
}
