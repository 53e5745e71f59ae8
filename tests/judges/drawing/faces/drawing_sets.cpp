#include "tests/judges/drawing/faces/drawing_sets.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace penpose::judges::drawn {
namespace {

std::vector<SharedDrawing> set_below(const char* folder) {
  auto found = shared_drawings(std::filesystem::path(PENPOSE_DRAWING_SETS) / folder);
  if (found && !found->empty()) return std::move(*found);
  std::fprintf(stderr, "%s\n", found ? PENPOSE_DRAWING_SETS ": no drawings" : found.error().line().c_str());
  std::abort();
}

}  // namespace

std::span<const SharedDrawing> drawing_set(Group group) {
  static const std::vector<SharedDrawing> seen = set_below("seen");
  static const std::vector<SharedDrawing> held_out = set_below("held_out");
  return group == Group::held_out ? held_out : seen;
}

const SharedDrawing* rest_by_the_same_hand(std::span<const SharedDrawing> set, const SharedDrawing& one) {
  const auto found = std::find_if(set.begin(), set.end(), [&](const SharedDrawing& other) {
    return other.folder == one.folder && other.face && other.meant == Expression::rest;
  });
  return found == set.end() ? nullptr : &*found;
}

}  // namespace penpose::judges::drawn
