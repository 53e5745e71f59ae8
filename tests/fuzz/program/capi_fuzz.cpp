// Calls of the C library in any order, with handles that are alive, freed, made up or of another kind, and with arrays
// of any counts and numbers: no call may crash, leak or throw; one that fails changes nothing of the character it was
// for.

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "ui/capi/penpose.h"

namespace {

/// What the fuzzer chooses with.
class Choice {
 public:
  Choice(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool over() const { return at_ >= size_; }
  std::uint8_t byte() { return over() ? std::uint8_t{0} : data_[at_++]; }
  std::size_t below(std::size_t count) { return byte() % count; }
  /// Mostly moderate, now and then none.
  double number() {
    const std::uint8_t kind = byte();
    if (kind < 4) {
      std::array<std::uint8_t, sizeof(double)> raw{};
      for (std::uint8_t& one : raw) one = byte();
      double any = 0;
      std::memcpy(&any, raw.data(), sizeof any);
      return any;
    }
    return (static_cast<double>(kind) - 128.0) / 64.0 + byte() / 4096.0;
  }
  std::vector<double> numbers(std::size_t most) {
    std::vector<double> out(below(most + 1));
    for (double& one : out) one = number();
    return out;
  }
  /// px around the middle of a picture of 1000.
  std::vector<double> line() {
    std::vector<double> out(2 * below(12));
    for (double& one : out) one = 500.0 + 220.0 * number();
    return out;
  }
  std::string text() {
    std::string out;
    for (std::size_t left = below(20); left > 0; --left) out += static_cast<char>(byte());
    return out;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

/// A bent strip of 4 x 4 vertices with two shapes and a joint.
struct Strip {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<float> up;
  std::vector<float> aside;
  std::vector<std::uint32_t> joint_of = std::vector<std::uint32_t>(16, 0);
  std::vector<double> weight_of = std::vector<double>(16, 1.0);
  std::array<penpose_shape, 2> shapes{};
  penpose_joint joint{"neck", -1, 1, {0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}, {}, {-1, -1, -1}, {1, 1, 1}};
  penpose_arrays arrays{};

  Strip() {
    for (std::uint32_t i = 0; i < 16; ++i) {
      const double x = (i % 4) / 1.5 - 1.0;
      const double y = (i / 4) / 1.5 - 1.0;
      positions.insert(positions.end(), {x, y, -0.2 * x * x});
      up.insert(up.end(), {0.0F, 0.2F * static_cast<float>(i / 4), 0.0F});
      aside.insert(aside.end(), {0.1F * static_cast<float>(i % 4), 0.0F, 0.05F});
      if (i % 4 == 3 || i >= 12) continue;
      triangles.insert(triangles.end(), {i, i + 1, i + 5, i, i + 5, i + 4});
    }
    shapes = {{{"up", 0, 1, 16, nullptr, up.data()}, {"aside", -1, 1, 16, nullptr, aside.data()}}};
    for (const std::size_t i : {0, 5, 10, 15}) joint.inverse_bind[i] = 1;
    arrays = {16, positions.data(), triangles.size() / 3, triangles.data(), 2, shapes.data(), 1, &joint,
              1,  joint_of.data(),  weight_of.data()};
  }
  Strip(const Strip&) = delete;
  Strip& operator=(const Strip&) = delete;
};

class Caller {
 public:
  Caller(const std::uint8_t* data, std::size_t size) : choice_(data, size) {
    if (penpose_open(&library_, nullptr) != PENPOSE_OK) std::abort();
    view_ = {{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 30, 1000, 1000};
    make();
  }
  ~Caller() { penpose_close(&library_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void run() {
    for (int calls = 0; !choice_.over() && calls < 60; ++calls) {
      const penpose_handle on = handle();
      const std::string before = state(on);
      penpose_error error{};
      const std::int32_t status = call(on, &error);
      if (status != error.status || (status == PENPOSE_OK) != (error.message[0] == '\0')) std::abort();
      if (status == PENPOSE_INTERNAL) std::abort();
      if (status != PENPOSE_OK && state(on) != before) std::abort();
    }
  }

 private:
  void make() {
    penpose_handle made = 0;
    const Strip strip;
    if (penpose_character_from_arrays(library_, &strip.arrays, &made, nullptr) == PENPOSE_OK) handles_.push_back(made);
  }
  /// Alive, freed or never given out.
  penpose_handle handle() {
    const std::size_t which = choice_.below(handles_.size() + 2);
    if (which < handles_.size()) return handles_[which];
    if (which == handles_.size()) return handles_.front();
    penpose_handle any = handles_.back();
    for (int i = 0; i < 2; ++i) any ^= std::uint64_t{choice_.byte()} << (8 * choice_.below(8));
    return any;
  }
  std::string state(penpose_handle of) {
    char out[33] = {};
    return penpose_state(library_, of, out, nullptr) == PENPOSE_OK ? out : "";
  }
  penpose_view view() {
    penpose_view out = view_;
    if (choice_.below(4) != 0) return out;
    double* numbers[] = {&out.eye[0], &out.eye[1], &out.eye[2], &out.look_at[0], &out.up[1], &out.vertical_fov_degrees};
    *numbers[choice_.below(6)] = choice_.number();
    if (choice_.below(8) == 0) out.width = choice_.byte() - 10;
    return out;
  }
  std::int32_t made(std::int32_t status, penpose_handle handle) {
    if (status == PENPOSE_OK && handles_.size() < 12) handles_.push_back(handle);
    return status;
  }
  std::uint32_t curve() { return static_cast<std::uint32_t>(choice_.below(6)); }

  std::int32_t call(penpose_handle on, penpose_error* error);
  std::int32_t sketch(penpose_handle on, penpose_error* error);
  std::int32_t play(penpose_handle on, penpose_error* error);

  Choice choice_;
  penpose_library* library_ = nullptr;
  penpose_view view_{};
  std::vector<penpose_handle> handles_;
};

std::int32_t Caller::sketch(penpose_handle on, penpose_error* error) {
  const auto general = choice_.line();
  const auto specific = choice_.line();
  const auto reference = choice_.line();
  const auto target = choice_.line();
  const std::string name = choice_.text();
  penpose_sketch sketch{};
  sketch.name = choice_.below(2) == 0 ? nullptr : name.c_str();
  sketch.view = view();
  sketch.general = general.data();
  sketch.general_count = general.size() / 2;
  sketch.specific = specific.data();
  sketch.specific_count = specific.size() / 2;
  sketch.reference = reference.empty() ? nullptr : reference.data();
  sketch.reference_count = reference.size() / 2;
  sketch.target = target.data();
  sketch.target_count = target.size() / 2;
  sketch.mode = static_cast<std::int32_t>(choice_.below(4));
  sketch.minimum = choice_.below(2) == 0 ? 0 : choice_.number();
  sketch.maximum = choice_.below(2) == 0 ? 1 : choice_.number();
  return penpose_sketch_deformer(library_, on, &sketch, error);
}

/// What was recorded of a character comes to the state that it is in.
std::int32_t Caller::play(penpose_handle on, penpose_error* error) {
  std::size_t size = 0;
  std::int32_t status = penpose_recorded(library_, on, nullptr, 0, &size, error);
  if (status != PENPOSE_OK) return status;
  std::string text(size, ' ');
  if (penpose_recorded(library_, on, text.data(), size, &size, nullptr) != PENPOSE_OK) std::abort();
  for (std::size_t spoiled = choice_.below(3); spoiled > 0; --spoiled)
    text[(choice_.byte() * 256U + choice_.byte()) % text.size()] = static_cast<char>(choice_.byte());
  penpose_handle played = 0;
  status = penpose_session_play(library_, text.data(), text.size(), handle(), &played, nullptr, error);
  return made(status, played);
}

std::int32_t Caller::call(penpose_handle on, penpose_error* error) {
  penpose_handle handle = 0;
  std::uint32_t number = 0;
  std::size_t count = 0;
  std::array<double, 200> out{};
  const auto role = static_cast<std::int32_t>(choice_.below(3));
  switch (choice_.below(26)) {
    case 0:
      return penpose_free(library_, on, error);
    case 1:
      return made(penpose_character_copy(library_, on, &handle, error), handle);
    case 2: {
      const auto px = choice_.line();
      const auto seen = view();
      return penpose_curve_from_stroke(library_, on, &seen, px.data(), px.size() / 2, role, &number, error);
    }
    case 3: {
      std::array<std::uint32_t, 5> vertices{};
      for (std::uint32_t& one : vertices) one = choice_.byte() % 18U;
      return penpose_curve_from_vertices(library_, on, vertices.data(), choice_.below(6), role, &number, error);
    }
    case 4: {
      std::array<penpose_mesh_point, 3> points{};
      for (penpose_mesh_point& one : points) {
        one.triangle = choice_.byte() % 20U;
        const double share = choice_.number();
        one.shares[0] = share;
        one.shares[1] = 1 - share;
      }
      return penpose_curve_from_points(library_, on, points.data(), choice_.below(4), role, &number, error);
    }
    case 5: {
      const std::uint32_t curve_of = curve();
      if (penpose_curve_positions(library_, on, curve_of, out.data(), 60, &count, error) != PENPOSE_OK)
        return error->status;
      for (std::size_t i = 0; i < 3 * count; ++i) out.at(i) += 0.1 * choice_.number();
      return penpose_target_points(library_, on, curve_of, out.data(), count, error);
    }
    case 6: {
      const auto px = choice_.line();
      const auto seen = view();
      return penpose_target_stroke(library_, on, curve(), &seen, px.data(), nullptr, px.size() / 2, error);
    }
    case 7:
      return penpose_solve(library_, on, static_cast<std::int32_t>(choice_.below(4)), error);
    case 8: {
      const auto values = choice_.numbers(6);
      return penpose_set_pose(library_, on, values.data(), values.size(), error);
    }
    case 9: {
      const auto values = choice_.numbers(6);
      return penpose_evaluate(library_, on, values.empty() ? nullptr : values.data(), values.size(), out.data(), 16,
                              error);
    }
    case 10:
      return penpose_curve_distances(library_, on, curve(), out.data(), choice_.below(60), &count, error);
    case 11:
      return penpose_curve_delete(library_, on, curve(), error);
    case 12: {
      const auto seen = view();
      return made(penpose_live_begin(library_, on, curve(), &seen, &handle, error), handle);
    }
    case 13: {
      const auto px = choice_.line();
      return penpose_live_follow(library_, on, px.data(), px.size() / 2, out.data(), 5, nullptr, error);
    }
    case 14:
      return sketch(on, error);
    case 15:
      return penpose_record(library_, on, "strip", error);
    case 16:
      return play(on, error);
    case 17: {
      std::vector<std::uint8_t> bytes(1U << 16U);
      if (penpose_write(library_, on, ".glb", bytes.data(), bytes.size(), &count, error) != PENPOSE_OK)
        return error->status;
      if (choice_.below(2) == 0) bytes[choice_.byte() * 64U % count] = choice_.byte();
      return made(penpose_character_read(library_, bytes.data(), count, nullptr, &handle, error), handle);
    }
    case 18:
      return penpose_perform(library_, on, choice_.text().c_str(), error);
    case 19: {
      const std::array<const char*, 4> commands{"set_key time_s=1", "go_to_time time_s=0.5", "set_hand unsteadiness=2",
                                                "name_curve curve=1 name=a"};
      return penpose_perform(library_, on, commands.at(choice_.below(4)), error);
    }
    case 20:
      return penpose_curve_named(library_, on, "a", role, &number, error);
    case 21: {
      std::array<std::uint8_t, 64> descriptor{};
      for (std::uint8_t& one : descriptor) one = choice_.byte();
      const penpose_interface device{
          3, 0x056a, static_cast<std::uint16_t>(choice_.byte() * 4U), nullptr, descriptor.data(), choice_.below(65)};
      return made(penpose_tablet(library_, &device, &handle, nullptr, error), handle);
    }
    case 22: {
      std::array<std::uint8_t, 32> report{};
      for (std::uint8_t& one : report) one = choice_.byte();
      std::array<penpose_sample, 16> samples{};
      return penpose_tablet_report(library_, on, report.data(), choice_.below(33), samples.data(), 16, &count, error);
    }
    case 23:
      return penpose_lock(library_, on, choice_.below(2) == 0 ? "up" : "neck.rx", role, error);
    case 24:
      return penpose_curves_clear(library_, on, error);
    default:
      make();
      return penpose_count(library_, on, nullptr, error);
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 2048) return 0;
  Caller(data, size).run();
  return 0;
}
