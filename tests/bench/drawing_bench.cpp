// Drawings of known poses, read without labels: how many lines are known, how far the face is off, how long it takes.
//
//   drawing_bench [MODEL...]      without one: builtin:demo
//
// For each model 40 poses of one to three units (a control, or both sides of a pair), each drawn once a level: its
// feature curves as lines by a hand with a tremor of a 400th of the face, in any order and direction; 2 or 4 of them
// missing; proportions 10 or 20 % off; scaled, turned and shifted on the sheet; in pieces and twice; with a drawing of
// the face at rest by the same hand; and all of that. Errors are |found - true| / |true| over all vertices.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/curve/polyline.h"
#include "core/document/features/drawing_start.h"
#include "core/document/features/feature_curves.h"
#include "core/portrait/pose_from_drawing.h"
#include "core/portrait/proportions.h"
#include "core/portrait/sheet_warp.h"
#include "tests/support/hands/tremor.h"
#include "tests/support/random.h"
#include "ui/files/load_model.h"

namespace penpose {
namespace {

using portrait::DrawnLine;
using portrait::PxPoint;

struct Level {
  const char* name;
  double off;
  std::size_t missing;
  bool placed, sketchy, neutral;
};
constexpr Level k_levels[] = {
    {"exact", 0, 0, false, false, false},
    {"2 missing", 0, 2, false, false, false},
    {"4 missing", 0, 4, false, false, false},
    {"10 % off", 0.1, 0, false, false, false},
    {"20 % off", 0.2, 0, false, false, false},
    {"placed", 0, 0, true, false, false},
    {"sketchy", 0, 0, false, true, false},
    {"10 % off, neutral", 0.1, 0, false, false, true},
    {"20 % off, neutral", 0.2, 0, false, false, true},
    {"all of it", 0.1, 2, true, true, false},
    {"all of it, neutral", 0.1, 2, true, true, true},
};
constexpr std::size_t k_poses = 40;

struct Line {
  DrawnLine points;
  std::size_t curve = 0;
};

class Artist {
 public:
  Artist(const document::Model& model, const intent::WholeModel& whole, std::vector<portrait::FeatureCurve> curves)
      : model_(model),
        whole_(whole),
        curves_(std::move(curves)),
        rest_(rig::rest_pose(*model.rig)),
        camera_(portrait::camera_of_drawing(*model.rig, curves_, rest_, 0)) {
    free_ = document::drawing_start(document::make_document(model), whole, curves_).free;
  }

  [[nodiscard]] base::Result<portrait::FaceView> view() const {
    return portrait::FaceView::make(*model_.rig, whole_, curves_, rest_, free_, camera_);
  }
  [[nodiscard]] std::vector<DrawnLine> seen(const rig::Pose& pose) const {
    std::vector<geometry::ModelPoint> places(model_.rig->vertex_count());
    model_.rig->evaluate(pose, places);
    std::vector<DrawnLine> out;
    for (const auto& curve : curves_) {
      DrawnLine line;
      for (const auto& point : curve.points) {
        geometry::ModelPoint p(0);
        for (std::size_t k = 0; k < 3; ++k) p += places[point.vertex[k]] * point.weight[k];
        line.push_back(camera_.project(p).value_or(PxPoint{}));
      }
      out.push_back(std::move(line));
    }
    return out;
  }
  /// A map of the picture by proportions that are off by so much, each up or down.
  [[nodiscard]] portrait::SheetWarp warp(double off, tests::Random& random) const {
    const auto lines = seen(rest_);
    std::vector<portrait::Part> parts;
    for (const auto& curve : curves_) parts.push_back(portrait::part_named(curve.name));
    const auto ways = portrait::proportions_of(lines, parts);
    std::vector<PxPoint> from, to;
    std::vector<double> factors;
    for (std::size_t p = 0; p < ways.size(); ++p)
      factors.push_back(off * (random(0, 1) < 0.5 ? -1.0 : 1.0) * random(0.75, 1.25));
    for (std::size_t c = 0; c < lines.size(); ++c) {
      for (std::size_t i = 0; i < lines[c].size(); i += std::max<std::size_t>(1, lines[c].size() / 7)) {
        from.push_back(lines[c][i]);
        to.push_back(lines[c][i]);
        for (std::size_t p = 0; p < ways.size(); ++p) to.back() = to.back() + ways[p].ways[c][i] * factors[p];
      }
    }
    return {from, to};
  }
  /// Lines of a pose; those numbered in `left_out` are missing.
  [[nodiscard]] std::vector<Line> draw(const rig::Pose& pose, const Level& level, const portrait::SheetWarp* warp,
                                       const std::vector<std::size_t>& left_out, double placing,
                                       tests::Random& random) const {
    const double size = level.placed ? 1.0 + placing * random(-0.15, 0.15) : 1.0;
    const double turn = level.placed ? placing * random(-0.17, 0.17) : 0.0;
    const PxPoint shift = level.placed ? PxPoint{placing * random(-60, 60), placing * random(-60, 60)} : PxPoint{};
    auto lines = seen(pose);
    std::vector<Line> out;
    for (std::size_t c = 0; c < lines.size(); ++c) {
      if (std::find(left_out.begin(), left_out.end(), c) != left_out.end()) continue;
      Line one{by_hand(lines[c], random), c};
      for (PxPoint& p : one.points) {
        if (warp != nullptr) p = p + warp->offset(p);
        const PxPoint at = p - PxPoint{500, 500};
        p = PxPoint{500, 500} + shift +
            PxPoint{at.x * std::cos(turn) - at.y * std::sin(turn), at.x * std::sin(turn) + at.y * std::cos(turn)} *
                size;
      }
      if (random(0, 1) < 0.5) std::reverse(one.points.begin(), one.points.end());
      const double how = level.sketchy ? random(0, 3) : 0;
      if (how > 2.0) {
        Line again = one;
        const PxPoint by{random(-2, 2), random(-2, 2)};
        for (PxPoint& p : again.points) p = p + by;
        out.push_back(std::move(again));
      } else if (how > 1.0) {
        const auto cut = one.points.begin() + static_cast<std::ptrdiff_t>(14 + random.index(12));
        out.push_back({DrawnLine(cut, one.points.end()), c});
        one.points.erase(cut + 1, one.points.end());
      }
      out.push_back(std::move(one));
    }
    for (std::size_t i = out.size(); i > 1; --i) std::swap(out[i - 1], out[random.index(i)]);
    return out;
  }
  [[nodiscard]] double error(const rig::Pose& found, const rig::Pose& meant) const {
    std::vector<geometry::ModelPoint> a(model_.rig->vertex_count()), b(a), at_rest(a);
    model_.rig->evaluate(found, a);
    model_.rig->evaluate(meant, b);
    model_.rig->evaluate(rest_, at_rest);
    double off = 0, way = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      off += std::pow(geometry::distance(a[v], b[v]), 2);
      way += std::pow(geometry::distance(at_rest[v], b[v]), 2);
    }
    return std::sqrt(off / way);
  }

  [[nodiscard]] const rig::Pose& rest() const { return rest_; }
  [[nodiscard]] const document::Model& model() const { return model_; }
  [[nodiscard]] std::size_t curve_count() const { return curves_.size(); }

 private:
  /// 40 points along a line with a smooth tremor of a 400th of the picture.
  static DrawnLine by_hand(const DrawnLine& line, tests::Random& random) {
    const auto points = curve::resample<PxPoint>(line, 40);
    if (!points) return line;
    return tests::with_tremor(*points, random, 0.3, 0.6);
  }

  const document::Model& model_;
  const intent::WholeModel& whole_;
  std::vector<portrait::FeatureCurve> curves_;
  rig::Pose rest_;
  geometry::Camera camera_;
  std::vector<std::size_t> free_;
};

/// Poses of units that move the face's curves by a fiftieth of it or more.
std::vector<rig::Pose> poses(const Artist& artist, const portrait::FaceView& view) {
  std::vector<std::size_t> strong;
  for (std::size_t u = 0; u < view.units().size(); ++u) {
    double most = 0;
    for (std::size_t c = 0; c < view.curve_count(); ++c) {
      for (const double way : view.curve(c).ways[view.units()[u].members[0]]) most = std::max(most, std::abs(way));
    }
    if (most > portrait::k_face_px / 50.0 && !view.units()[u].one_side) strong.push_back(u);
  }
  tests::Random random(11);
  std::vector<rig::Pose> out;
  for (std::size_t k = 0; k < k_poses && !strong.empty(); ++k) {
    rig::Pose pose = artist.rest();
    const std::size_t count = 1 + random.index(3);
    for (std::size_t i = 0; i < count; ++i) {
      const portrait::Unit& unit = view.units()[strong[random.index(strong.size())]];
      const double share = random(0.4, 0.9);
      for (std::size_t m = 0; m < unit.count; ++m) {
        const std::size_t p = view.controls()[unit.members[m]].parameter;
        pose[p] += share * (artist.model().rig->parameters()[p].maximum - pose[p]);
      }
    }
    out.push_back(std::move(pose));
  }
  return out;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

int measure(const std::string& path) {
  const auto model = files::load_model(path);
  if (!model) return std::fprintf(stderr, "%s\n", model.error().line(path).c_str()), 1;
  const auto whole = intent::measure_whole_model(*model->rig);
  const auto features = document::feature_curves_of(*model, whole, {});
  if (!features) return std::fprintf(stderr, "%s\n", features.error().line(path).c_str()), 1;
  const Artist artist(*model, whole, features->curves);
  const auto view = artist.view();
  if (!view) return std::fprintf(stderr, "%s\n", view.error().line(path).c_str()), 1;
  const auto meant = poses(artist, *view);
  std::printf("%s: %zu curves, %zu controls, %zu poses\n", path.c_str(), artist.curve_count(), view->controls().size(),
              meant.size());
  for (const Level& level : k_levels) {
    std::size_t right = 0, all = 0;
    std::vector<double> errors, times;
    for (std::size_t k = 0; k < meant.size(); ++k) {
      tests::Random random(100 + k);
      std::vector<std::size_t> left_out;
      for (std::size_t i = 0; i < level.missing; ++i) left_out.push_back(random.index(artist.curve_count()));
      const auto warp = artist.warp(level.off, random);
      const auto* by = level.off > 0 ? &warp : nullptr;
      const auto lines = artist.draw(meant[k], level, by, left_out, 1.0, random);
      portrait::Drawing drawing;
      for (const Line& line : lines) drawing.lines.push_back(line.points);
      if (level.neutral) {
        for (const Line& line : artist.draw(artist.rest(), level, by, left_out, 0.3, random))
          drawing.neutral.push_back(line.points);
      }
      const auto begin = std::chrono::steady_clock::now();
      const auto read = portrait::read_drawing(*view, drawing);
      times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
      if (!read) continue;
      for (std::size_t i = 0; i < lines.size(); ++i) right += read->lines[i].curve == lines[i].curve ? 1U : 0U;
      all += lines.size();
      rig::Pose pose = artist.rest();
      for (std::size_t j = 0; j < read->shares.size(); ++j) {
        const std::size_t p = view->controls()[j].parameter;
        const auto& parameter = model->rig->parameters()[p];
        pose[p] += read->shares[j] * (parameter.maximum - parameter.minimum);
      }
      errors.push_back(100.0 * artist.error(pose, meant[k]));
    }
    std::printf("  %-20s labels %5.1f %%  face %5.1f %%  of ten the ninth %6.1f %%  %6.1f ms  p99 %6.1f ms\n",
                level.name, 100.0 * static_cast<double>(right) / static_cast<double>(std::max<std::size_t>(all, 1)),
                quantile(errors, 0.5), quantile(errors, 0.9), quantile(times, 0.5), quantile(times, 0.99));
  }
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
