#include "ui/demo/run_demo.h"

#include <chrono>
#include <utility>

#include "ui/demo/demo_head.h"

namespace penpose::demo {
namespace {

/// Files keep the keys of animations as floats; keys that are floats from the start read back as they are. Volatile,
/// because GCC 12 drops the rounding of double -> float -> double when it packs two of them into one vector.
double to_float_precision(double value) {
  const volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

/// From rest to every expression and back; each is reached, held and left.
document::Animation through_all(const document::Model& model, const std::vector<PosedExpression>& expressions) {
  constexpr double k_move_s = 0.4;
  constexpr double k_hold_s = 0.8;
  document::Animation animation{"expressions", {document::Channel{}}};
  document::Channel& channel = animation.channels.front();
  double now_s = 0;
  const auto key = [&](const rig::Pose& pose) {
    channel.times_s.push_back(to_float_precision(now_s));
    for (std::size_t i = 0; i < document::weight_count(model); ++i)
      channel.values.push_back(to_float_precision(pose[i]));
  };
  const rig::Pose rest = rig::rest_pose(*model.rig);
  key(rest);
  for (const PosedExpression& expression : expressions) {
    now_s += k_move_s;
    key(expression.solution.pose);
    now_s += k_hold_s;
    key(expression.solution.pose);
    now_s += k_move_s;
    key(rest);
  }
  return animation;
}

}  // namespace

base::Result<Demo> run_demo() {
  const auto before = std::chrono::steady_clock::now();
  auto model = make_demo_head();
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - before;
  if (!model) return model.error();
  const auto file = demo_expressions();
  if (!file) return file.error();
  Demo demo{std::move(model).value(), {}, took.count()};
  const geometry::TriangleBvh surface = rest_surface(demo.model);
  posing::SolveWorkspace work;
  for (const Expression& expression : file->expressions) {
    auto posed = pose_expression(demo.model, surface, expression, file->viewport, work);
    if (!posed) return posed.error();
    demo.expressions.push_back(std::move(posed).value());
  }
  demo.model.animations.push_back(through_all(demo.model, demo.expressions));
  if (!demo.expressions.empty()) demo.model.pose = demo.expressions.front().solution.pose;
  return demo;
}

}  // namespace penpose::demo
