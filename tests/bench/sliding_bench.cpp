// sliding_bench [MODEL CASES]: known poses redrawn in other ways: unevenly, a part of the length only, overshot, with
// tremor, backwards. Each case whose answer the file knows is drawn from that answer, not from the file's own targets;
// the error is that of the whole model, root mean square over the vertices, in percent of the known pose's own
// movement.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/curve/polyline.h"
#include "core/intent/solve.h"
#include "core/io/model/read_model.h"
#include "core/io/project/case_file.h"
#include "core/tracking/case_problem.h"
#include "tests/core/intent/face.h"
#include "tests/support/shared_data.h"

namespace {

using namespace penpose;
using Line = std::vector<geometry::PxPoint>;

struct Way {
  const char* name;
  double from = 0, to = 1;  ///< shares of the true curve's length; outside of 0..1 straight on
  double uneven = 0;        ///< how much the pen's speed changes on the way
  double tremor_px = 0;     ///< root mean square across and along, in slow waves
  bool backwards = false;
};

Line drawn(const Line& truth, const Way& way, std::uint64_t seed) {
  Line line = tests::part(truth, way.from, way.to);
  std::vector<double> shares;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    shares.push_back(t + way.uneven * base::sin(2 * base::k_pi * t) / (2 * base::k_pi));
  }
  line = curve::resample_at<geometry::PxPoint>(line, shares).value();
  if (way.tremor_px > 0) line = tests::shaken(line, way.tremor_px, seed);
  if (way.backwards) std::reverse(line.begin(), line.end());
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 && !tests::has_shared()) {
    std::puts("the shared models are not here: nothing to measure");
    return 0;
  }
  const auto meshes = tests::shared_dir() / "meshes";
  const std::filesystem::path model_path = argc > 2 ? argv[1] : meshes / "ict_face.glb";
  const std::filesystem::path case_path = argc > 2 ? argv[2] : meshes / "ict_face_intent_cases.json";
  const auto model = io::read_model(tests::read_file(model_path), model_path.filename().string()).value();
  const auto file = io::read_cases(tests::read_file(case_path)).value();
  const auto whole = intent::measure_whole_model(*model.rig);
  const double hand = tracking::hand_doubt(model, file);
  const Way ways[] = {{"even"},
                      {"uneven", 0, 1, 0.6},
                      {"90 % of the length", 0.05, 0.95},
                      {"70 %", 0.15, 0.85},
                      {"50 %, the first half", 0, 0.5},
                      {"50 %, the middle", 0.25, 0.75},
                      {"30 %, the middle", 0.35, 0.65},
                      {"overshot by 20 %, both ends", -0.1, 1.1},
                      {"overshot by 20 %, one end", 0, 1.2},
                      {"tremor of 1 px", 0, 1, 0, 1},
                      {"tremor of 2 px", 0, 1, 0, 2},
                      {"tremor of 4 px", 0, 1, 0, 4},
                      {"uneven, 90 %, 2 px", 0.05, 0.95, 0.4, 2},
                      {"backwards", 0, 1, 0, 0, true}};
  std::printf("error of the whole model, %%%24s %8s %8s\n", "median", "worst", "of");
  for (const Way& way : ways) {
    std::vector<double> errors;
    std::string worst_name;
    for (const auto& one : file.cases) {
      auto problem = tracking::intent_of_case(model, one, tracking::FreeSet::all, io::TargetForm::drawn, hand).value();
      rig::Pose truth = problem.start;
      for (const auto& [name, value] : one.weights) {
        if (const auto p = rig::find_parameter(model.rig->parameters(), name)) truth[*p] = value;
      }
      if (truth == problem.start) continue;
      const auto there = tests::all_positions(*model.rig, truth);
      const auto rest = tests::all_positions(*model.rig, problem.start);
      for (std::size_t c = 0; c < problem.drawn.size(); ++c) {
        intent::DrawnCurve& curve = problem.drawn[c];
        Line line;
        for (const auto& p : curve.reference) line.push_back(*curve.camera.project(there[p.vertex[0]]));
        curve.target = drawn(line, way, c + 1);
        const double hand_px = hand / curve.camera.units_per_px(curve.camera.depth(rest[curve.reference[0].vertex[0]]));
        curve.doubt_px = intent::stroke_doubt_px(curve.target, hand_px);
      }
      intent::SolveWorkspace work;
      const auto found =
          tests::all_positions(*model.rig, intent::solve(*model.rig, whole, problem, {}, work).value().pose);
      double off = 0, moved = 0;
      for (std::size_t v = 0; v < there.size(); ++v) {
        off += glm::dot(found[v] - there[v], found[v] - there[v]);
        moved += glm::dot(there[v] - rest[v], there[v] - rest[v]);
      }
      errors.push_back(100 * std::sqrt(off / moved));
      if (errors.back() >= *std::max_element(errors.begin(), errors.end())) worst_name = one.name;
    }
    if (errors.empty()) continue;
    std::sort(errors.begin(), errors.end());
    std::printf("%-36s %12.1f %8.1f    %s\n", way.name, errors[errors.size() / 2], errors.back(), worst_name.c_str());
  }
}
