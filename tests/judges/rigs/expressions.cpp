#include "tests/judges/rigs/expressions.h"

namespace penpose::judges {
namespace {

std::vector<Expression> made() {
  const auto both = [](std::vector<std::pair<std::string, double>> muscles) {
    std::vector<std::pair<std::string, double>> out;
    for (const auto& [name, amount] : muscles) {
      if (name.back() != '_') {
        out.emplace_back(name, amount);
        continue;
      }
      out.emplace_back(name + "L", amount);
      out.emplace_back(name + "R", amount);
    }
    return out;
  };
  return {
      {"smile", both({{"smile_", 0.7}})},
      {"open_smile", both({{"jaw_open", 0.35}, {"smile_", 0.6}})},
      {"frown", both({{"frown_", 0.7}})},
      {"surprise", both({{"jaw_open", 0.5}, {"brow_inner_up_", 0.8}, {"brow_outer_up_", 0.8}, {"wide_", 0.5}})},
      {"anger", both({{"brow_down_", 0.9}, {"sneer_", 0.4}})},
      {"sad", both({{"brow_inner_up_", 0.8}, {"frown_", 0.5}})},
      {"wink_L", {{"blink_L", 0.9}}},
      {"blink", both({{"blink_", 0.9}})},
      {"jaw_open", {{"jaw_open", 0.6}}},
      {"pucker", {{"pucker", 0.7}}},
      {"smirk_L", {{"smile_L", 0.7}}},
      {"brows_up", both({{"brow_inner_up_", 0.7}, {"brow_outer_up_", 0.7}})},
      {"brow_up_R", {{"brow_inner_up_R", 0.6}, {"brow_outer_up_R", 0.8}}},
      {"disgust", both({{"sneer_", 0.8}, {"upper_up_", 0.5}})},
      {"talk", {{"jaw_open", 0.25}, {"funnel", 0.5}}},
      {"lips_aside", {{"mouth_L", 0.6}}},
      {"eyes_wide", both({{"wide_", 0.8}})},
      {"laugh", both({{"jaw_open", 0.6}, {"smile_", 0.8}, {"cheek_", 0.5}, {"squint_", 0.5}})},
      {"stretch", both({{"stretch_", 0.7}})},
  };
}

}  // namespace

std::span<const Expression> expressions() {
  static const std::vector<Expression> all = made();
  return all;
}

}  // namespace penpose::judges
