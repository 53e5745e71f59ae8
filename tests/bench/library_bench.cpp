// What a call of the C library costs beyond the C++ that it makes: the same character, curve and target, solved and
// evaluated through both, one call of each in turn so that both see the same machine. Prints medians and what C takes
// more.
//
// library_bench [ROUNDS]. "empty" solves a character without a target: what is left of a call that has next to nothing
// to do, so that a few microseconds show on a machine that others use too.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/character/character.h"
#include "core/character/demo_head.h"
#include "ui/capi/penpose.h"

namespace {

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;

template <typename Call>
double time_us(const Call& call) {
  const auto before = Clock::now();
  call();
  return std::chrono::duration<double, std::micro>(Clock::now() - before).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Both calls in turn, each first as often as the other; what the second costs more is the median of the differences.
template <typename First, typename Second>
void compare(const char* name, int rounds, const First& first, const Second& second) {
  std::vector<double> firsts;
  std::vector<double> seconds;
  std::vector<double> more;
  for (int round = 0; round < rounds; ++round) {
    double a = 0;
    double b = 0;
    if (round % 2 == 0) {
      a = time_us(first);
      b = time_us(second);
    } else {
      b = time_us(second);
      a = time_us(first);
    }
    firsts.push_back(a);
    seconds.push_back(b);
    more.push_back(b - a);
  }
  std::printf("%-10s C++ %9.2f us, C %9.2f us, ratio %.4f, C takes %+.2f us more\n", name, median(firsts),
              median(seconds), median(seconds) / median(firsts), median(more));
}

void check(bool works, const char* what) {
  if (works) return;
  std::fprintf(stderr, "library_bench: %s\n", what);
  std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 2000;
  auto model = character::make_demo_head();
  check(model.ok(), "no head");
  character::Character head(document::make_document(std::move(model).value()));
  penpose_library* library = nullptr;
  penpose_handle handle = 0;
  penpose_error error;
  check(penpose_open(&library, &error) == PENPOSE_OK, error.message);
  check(penpose_character_built_in(library, "builtin:demo", &handle, &error) == PENPOSE_OK, error.message);
  const auto curve = head.place_reference(head.points_of("lip_upper").value()).value();
  std::uint32_t number = 0;
  check(penpose_curve_named(library, handle, "lip_upper", PENPOSE_REFERENCE, &number, &error) == PENPOSE_OK,
        error.message);
  auto places = head.positions_of(curve).value();
  for (auto& p : places) p.y += 0.002;
  check(head.place_target(curve, places).ok(), "no target");
  check(penpose_target_points(library, handle, number, &places[0].x, places.size(), &error) == PENPOSE_OK,
        error.message);
  std::vector<geometry::ModelPoint> positions(head.vertex_count());

  // From rest each time, so that both do the same work.
  const auto reset = [&] {
    static_cast<void>(head.perform(document::ResetParameters{}));
    penpose_reset(library, handle, nullptr);
  };
  reset();
  character::Character empty(head.document());
  static_cast<void>(empty.perform(document::ClearCurves{}));
  penpose_handle nothing = 0;
  check(penpose_character_copy(library, handle, &nothing, &error) == PENPOSE_OK, error.message);
  check(penpose_curves_clear(library, nothing, &error) == PENPOSE_OK, error.message);
  compare(
      "empty", 10 * rounds, [&] { static_cast<void>(empty.solve()); },
      [&] { penpose_solve(library, nothing, PENPOSE_PRESET_DEFAULT, nullptr); });
  for (const std::int32_t preset : {0, 1}) {
    compare(
        preset == 0 ? "solve" : "exact", rounds,
        [&] {
          static_cast<void>(head.perform(document::ResetParameters{}));
          static_cast<void>(head.solve(static_cast<character::Preset>(preset)));
        },
        [&] {
          penpose_reset(library, handle, nullptr);
          penpose_solve(library, handle, preset, nullptr);
        });
  }
  compare(
      "evaluate", rounds, [&] { head.evaluate(head.pose(), positions); },
      [&] { penpose_evaluate(library, handle, nullptr, 0, &positions[0].x, positions.size(), nullptr); });
  char state[33];
  check(penpose_state(library, handle, state, nullptr) == PENPOSE_OK && head.state().whole.hex() == state,
        "C and C++ came to different states");
  penpose_close(&library);
  return 0;
}
