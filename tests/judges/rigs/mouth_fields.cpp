#include <utility>

#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

struct Mouth {
  std::span<const ModelPoint> rest;
  ModelPoint middle, upper, lower, corner_L, corner_R;
  double w;
  std::vector<double> below, above;  ///< shares that go with the jaw, and the others

  explicit Mouth(const Parts& parts) : rest(parts.rest()), w(parts.mouth), below(parts.jaw_share) {
    const auto& top = parts.line("lip_upper");
    const auto& bottom = parts.line("lip_lower");
    corner_R = rest[top.front()];
    corner_L = rest[top.back()];
    upper = rest[top[top.size() / 2]];
    lower = rest[bottom[bottom.size() / 2]];
    middle = (upper + lower) * 0.5;
    for (const double share : below) above.push_back(1 - share);
  }
  [[nodiscard]] std::vector<double> near(const ModelPoint& center, double x, double y, double z) const {
    return around(rest, center, ModelVector{x, y, z} * w);
  }
};

void add_sides(Parts& parts, const Mouth& m) {
  for (const bool left : {true, false}) {
    const std::string side = left ? "_L" : "_R";
    const double out = left ? 1 : -1;
    const ModelPoint corner = left ? m.corner_L : m.corner_R;
    const std::vector<double> half = side_share(m.rest, left, 0.25 * m.w);
    const auto way = [&](double x, double y, double z) { return ModelVector{out * x, y, z} * m.w; };
    parts.fields["stretch" + side] = pushed(m.near(corner, 0.75, 0.6, 1), way(0.26, -0.04, -0.1));
    parts.fields["dimple" + side] = pushed(m.near(corner, 0.45, 0.4, 0.7), way(0.12, 0.01, -0.16));
    const ModelPoint cheek = corner + way(0.45, 0.35, -0.2);
    parts.fields["puff" + side] = pushed(m.near(cheek, 0.7, 0.7, 0.8), way(0.22, 0, 0.12));
    const auto lip = product(product(m.near(m.lower, 0.9, 0.5, 0.9), m.below), half);
    parts.fields["lower_down" + side] = pushed(lip, way(0.02, -0.24, 0));
    // Pressed lips are thinner: each point comes nearer to the line between them.
    const auto flat = product(m.near(m.middle, 1, 0.4, 0.9), half);
    Field press(m.rest.size(), ModelVector{0});
    for (std::size_t v = 0; v < press.size(); ++v) press[v].y = -0.35 * (m.rest[v].y - m.middle.y) * flat[v];
    parts.fields["press" + side] = std::move(press);
  }
}

}  // namespace

void add_mouth_fields(Parts& parts) {
  const Mouth m(parts);
  add_sides(parts, m);
  const auto way = [&](double x, double y, double z) { return ModelVector{x, y, z} * m.w; };
  const auto upper_lip = product(m.near(m.upper, 0.8, 0.35, 0.8), m.above);
  const auto lower_lip = product(m.near(m.lower, 0.8, 0.35, 0.8), m.below);
  parts.fields["roll_upper"] = pushed(upper_lip, way(0, -0.08, -0.14));
  parts.fields["roll_lower"] = pushed(lower_lip, way(0, 0.08, -0.14));
  parts.fields["shrug_upper"] = pushed(product(m.near(m.upper, 0.9, 0.5, 0.9), m.above), way(0, 0.15, 0.06));
  parts.fields["shrug_lower"] = pushed(product(m.near(m.lower, 0.9, 0.6, 0.9), m.below), way(0, 0.17, 0.08));
  const auto all = m.near(m.middle, 1.2, 0.9, 1.2);
  parts.fields["mouth_L"] = pushed(all, way(0.3, 0, -0.04));
  parts.fields["mouth_R"] = pushed(all, way(-0.3, 0, -0.04));
  parts.fields["jaw_L"] = pushed(m.below, way(0.25, 0, 0));
  parts.fields["jaw_R"] = pushed(m.below, way(-0.25, 0, 0));
  parts.fields["jaw_forward"] = pushed(m.below, way(0, 0, 0.25));
  // Lips that stay together while the jaw is open: the lower one comes up by what the jaw takes it down.
  parts.fields["lips_close"] = times(parts.field("jaw_open"), m.near(m.lower, 1.3, 0.5, 1.2));
  for (ModelVector& d : parts.fields["lips_close"]) d = -d;
  Field funnel(m.rest.size(), ModelVector{0});
  add_to(funnel, 0.5, parts.field("pucker"));
  for (const char* side : {"_L", "_R"}) {
    add_to(funnel, 0.45, parts.field(std::string("upper_up") + side));
    add_to(funnel, 0.6, parts.field(std::string("lower_down") + side));
  }
  parts.fields["funnel"] = std::move(funnel);
}

}  // namespace penpose::judges
