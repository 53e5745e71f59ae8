#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/io/tracks/face_points.h"
#include "tests/support/models/nodding_head.h"
#include "tests/support/models/rendered_track.h"

namespace penpose::tests {

/// A person who was never there: another face (a smooth warp of the model's), who talks, blinks, looks about, moves the
/// brows and the head, seen by a tracker that closes lids by a part, shakes, drifts and says action units.
struct MadeUpPerson {
  std::vector<rig::Pose> poses;         ///< what the face did
  animation::PointTrack track;          ///< what the tracker made of it
  std::vector<std::size_t> blinks;      ///< their deepest frames
  std::vector<geometry::PxPoint> gaze;  ///< degrees, to the picture's right and down, relative to the head
};

class PersonMaker {
 public:
  PersonMaker(const rig::Rig& rig, std::vector<std::uint32_t> points, std::uint64_t seed, std::size_t frames = 475)
      : rig_(rig), points_(std::move(points)), random_(seed * 7919 + 17), frames_(frames) {}

  MadeUpPerson make() {
    for (int i = 0; i < 20; ++i) random_();
    make_face();
    act();
    see();
    return std::move(person_);
  }

  static constexpr double k_fps = 25;

 private:
  using Signal = std::vector<double>;

  double between(double low, double high) { return low + (high - low) * 0.5 * (random_() + 1); }
  double normal() {
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += random_() / 2;
    return sum;
  }

  void make_face() {
    std::vector<geometry::ModelPoint> rest(rig_.vertex_count());
    rig_.evaluate(rig::rest_pose(rig_), rest);
    middle_ = (rest[points_[0]] + rest[points_[16]]) * 0.5;
    width_ = geometry::distance(rest[points_[0]], rest[points_[16]]);
    for (int axis = 0; axis < 3; ++axis) stretch_[axis] = 1 + 0.1 * random_();
    for (int i = 0; i < 10; ++i) {
      const geometry::ModelPoint at = rest[points_[static_cast<std::size_t>(between(0, 67.99))]];
      centres_.push_back(at);
      reaches_.push_back(width_ * between(0.15, 0.4));
      pushes_.push_back(geometry::ModelVector(random_(), random_(), random_()) * (0.035 * width_));
    }
  }

  [[nodiscard]] geometry::ModelPoint warped(geometry::ModelPoint p) const {
    geometry::ModelPoint q = middle_ + (p - middle_) * stretch_;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      const double far = geometry::distance(p, centres_[i]) / reaches_[i];
      const double weight = std::exp(-far * far);
      q += pushes_[i] * weight;
      // A face is mostly alike on both sides.
      const geometry::ModelPoint other(2 * middle_.x - p.x, p.y, p.z);
      const double away = geometry::distance(other, centres_[i]) / reaches_[i];
      const double mirrored = 0.8 * std::exp(-away * away);
      q += geometry::ModelVector(-pushes_[i].x, pushes_[i].y, pushes_[i].z) * mirrored;
    }
    return q;
  }

  /// Adds a bump of so many frames.
  static void bump(Signal& to, double middle, double half, double height) {
    for (std::size_t f = 0; f < to.size(); ++f) {
      const double t = std::abs(static_cast<double>(f) - middle) / half;
      if (t < 1) to[f] += height * (0.5 + 0.5 * std::cos(3.14159265 * t));
    }
  }

  [[nodiscard]] Signal silence() const { return Signal(frames_, 0.0); }
  Signal wander(double deviation, double frames) {
    Signal one = silence();
    double slow = deviation * normal();
    double last = slow;
    const double keep = std::exp(-1.0 / frames);
    for (double& value : one) {
      slow = keep * slow + std::sqrt(1 - keep * keep) * deviation * normal();
      last += (slow - last) * std::min(1.0, 3.0 / frames);
      value = last;
    }
    return one;
  }

  void put(const std::string& name, const Signal& values, double gain = 1) {
    for (const std::string side : {"", "_L", "_R"}) {
      const auto p = rig::find_parameter(rig_.parameters(), name + side);
      if (!p) continue;
      const double own = side.empty() ? gain : gain * between(0.85, 1.0);
      for (std::size_t f = 0; f < frames_; ++f) {
        double& value = person_.poses[f][*p];
        value = std::clamp(value + own * values[f], rig_.parameters()[*p].minimum, rig_.parameters()[*p].maximum);
      }
    }
  }

  void act() {
    person_.poses.assign(frames_, rig::rest_pose(rig_));
    const auto n = static_cast<double>(frames_);
    Signal jaw = silence(), pucker = silence(), funnel = silence(), smile = silence(), stretch = silence();
    Signal frown = silence(), upper = silence(), lower = silence(), inner = silence(), outer = silence();
    Signal down = silence(), squint = silence(), side = silence();
    // Sentences with pauses between them.
    for (double t = between(8, 30); t < n;) {
      const double end = t + between(30, 90);
      for (; t < end && t < n; t += between(4, 8)) {
        bump(jaw, t, between(3, 5.5), between(0.06, 0.42));
        if (between(0, 1) < 0.3) bump(pucker, t + between(-3, 3), between(3, 6), between(0.1, 0.5));
        if (between(0, 1) < 0.2) bump(funnel, t + between(-3, 3), between(3, 6), between(0.1, 0.4));
        if (between(0, 1) < 0.3) bump(stretch, t, between(3, 6), between(0.1, 0.4));
        if (between(0, 1) < 0.4) bump(lower, t, between(3, 6), between(0.1, 0.4));
        if (between(0, 1) < 0.3) bump(upper, t, between(3, 6), between(0.05, 0.3));
      }
      t += between(12, 45);
    }
    for (std::size_t f = 0; f < 9; ++f) jaw[f] = std::max(jaw[f], 0.15);
    for (int i = 0; i < 3; ++i) bump(smile, between(0, n), between(25, 60), between(0.2, 0.8));
    for (int i = 0; i < 2; ++i) bump(frown, between(0, n), between(15, 40), between(0.1, 0.4));
    for (int i = 0; i < 6; ++i) {
      const double at = between(0, n);
      const double half = between(6, 30);
      bump(inner, at, half, between(0.2, 0.8));
      bump(outer, at, half, between(0.1, 0.8));
    }
    for (int i = 0; i < 3; ++i) bump(down, between(0, n), between(10, 40), between(0.2, 0.8));
    side = wander(0.06, 20);
    put("jawOpen", jaw);
    put("mouthPucker", pucker);
    put("mouthFunnel", funnel);
    put("mouthSmile", smile);
    put("mouthFrown", frown);
    put("mouthStretch", stretch, 0.7);
    put("mouthUpperUp", upper);
    put("mouthLowerDown", lower);
    put("browInnerUp", inner);
    put("browOuterUp", outer);
    put("browDown", down);
    put("eyeSquint", smile, 0.4);
    put("cheekSquint", smile, 0.5);
    Signal left = side, right = side;
    for (double& value : left) value = std::max(value, 0.0);
    for (double& value : right) value = std::max(-value, 0.0);
    put("mouthLeft", left);
    put("mouthRight", right);
    look();
    blink();
  }

  /// Looks from one place to the next.
  void look() {
    Signal right = silence(), down = silence();
    double x = 0, y = 0;
    std::size_t next = 20;
    for (std::size_t f = 0; f < frames_; ++f) {
      if (f == next) {
        const bool home = between(0, 1) < 0.4;
        x = home ? 0 : between(-0.6, 0.6);
        y = home ? 0 : between(-0.35, 0.5);
        next = f + static_cast<std::size_t>(between(8, 50));
      }
      right[f] = x;
      down[f] = y;
    }
    const auto set = [&](const char* name, const Signal& values, double sign) {
      if (const auto p = rig::find_parameter(rig_.parameters(), name)) {
        for (std::size_t f = 0; f < frames_; ++f) person_.poses[f][*p] = std::clamp(sign * values[f], 0.0, 1.0);
      }
    };
    // The picture's right is the person's left.
    set("eyeLookOut_L", right, 1);
    set("eyeLookIn_L", right, -1);
    set("eyeLookIn_R", right, 1);
    set("eyeLookOut_R", right, -1);
    for (const char* name : {"eyeLookDown_L", "eyeLookDown_R"}) set(name, down, 1);
    for (const char* name : {"eyeLookUp_L", "eyeLookUp_R"}) set(name, down, -1);
    for (std::size_t f = 0; f < frames_; ++f) person_.gaze.push_back({right[f], down[f]});
  }

  void blink() {
    closing_ = silence();
    double seen_share = between(0.25, 0.35);
    seen_closing_ = silence();
    for (int i = 0; i < 10; ++i) {
      const double at = std::floor((i + between(0.15, 0.85)) * static_cast<double>(frames_) / 10);
      const double close = between(2, 4);
      const double open = between(3, 6);
      const double floor = std::floor(between(0, 1.99));
      const double share = seen_share * between(0.85, 1.15);
      person_.blinks.push_back(static_cast<std::size_t>(at));
      for (std::size_t f = 0; f < frames_; ++f) {
        const double t = static_cast<double>(f) - at;
        const double value = t < 0 ? 1 + t / close : t <= floor ? 1 : 1 - (t - floor) / open;
        if (value <= closing_[f]) continue;
        closing_[f] = value;
        seen_closing_[f] = share * value;
      }
    }
  }

  void see() {
    const Signal yaw = wander(0.14, 30), pitch = wander(0.09, 25), roll = wander(0.07, 35);
    const Signal shift_x = wander(0.05, 40), shift_y = wander(0.03, 40), near = wander(0.03, 60);
    const bool knows_depths = random_() > 0;
    const double tremor = between(0.2, 0.4);
    // What the tracker's own shape model does wrong goes together over the face, and lasts.
    std::vector<Signal> modes;
    std::vector<std::array<double, 4>> waves;
    for (int i = 0; i < 6; ++i) {
      modes.push_back(wander(0.35, 8));
      waves.push_back({between(0, 6.28), between(2, 9) / width_, between(2, 9) / width_, between(0, 6.28)});
    }
    auto& track = person_.track;
    track.point_count = points_.size();
    track.unit_names = {"AU01", "AU02", "AU04", "AU12", "AU15", "AU20", "AU25", "AU26", "AU45"};
    const std::array<double, 9> gains{between(2, 5), between(2, 5), between(2, 5), between(2, 5),  between(1, 3),
                                      between(1, 3), between(2, 5), between(2, 5), between(1.5, 4)};
    const auto bound = rig_.bind(points_);
    std::vector<geometry::ModelPoint> places(points_.size());
    std::vector<geometry::ModelPoint> common(points_.size());
    bound->evaluate(rig::rest_pose(rig_), common);
    const double distance = 6 * width_;
    const double px = 150 * distance / width_;
    const auto value = [&](std::size_t f, const char* name) {
      double sum = 0;
      for (const std::string side : {"", "_L", "_R"}) {
        if (const auto p = rig::find_parameter(rig_.parameters(), name + side))
          sum += person_.poses[f][*p] * (side.empty() ? 1 : 0.5);
      }
      return sum;
    };
    for (std::size_t f = 0; f < frames_; ++f) {
      rig::Pose seen = person_.poses[f];
      for (const char* name : {"eyeBlink_L", "eyeBlink_R"}) {
        if (const auto p = rig::find_parameter(rig_.parameters(), name)) {
          person_.poses[f][*p] = closing_[f];
          seen[*p] = seen_closing_[f];
        }
      }
      bound->evaluate(seen, places);
      const geometry::ModelPoint neck = middle_ + geometry::ModelVector(0, -0.5 * width_, -0.4 * width_);
      const auto stands = [&](geometry::ModelPoint p) {
        p = turned(p - neck, roll[f], 0, 1);
        p = turned(p, pitch[f], 1, 2);
        p = turned(p, yaw[f], 2, 0);
        return p + neck;
      };
      animation::TrackFrame frame;
      frame.time_s = static_cast<double>(f) / k_fps;
      frame.confidence = 0.95;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const geometry::ModelPoint q = warped(places[i]);
        const geometry::ModelPoint p =
            stands(q) - middle_ + geometry::ModelVector(shift_x[f], shift_y[f], near[f]) * width_;
        const double grow = px / (distance - p.z);
        geometry::PxPoint at{320 + grow * p.x, 240 - grow * p.y};
        for (std::size_t m = 0; m < modes.size(); ++m) {
          const double wave = std::sin(waves[m][0] + waves[m][1] * q.x + waves[m][2] * q.y);
          at = at + geometry::PxPoint{std::cos(waves[m][3]), std::sin(waves[m][3])} * (wave * modes[m][f]);
        }
        at = at + geometry::PxPoint{tremor * normal(), tremor * normal()};
        frame.points.push_back(at);
      }
      // The tracker says turns of its own, a little wrong.
      const auto about = [&](geometry::ModelVector v) {
        v = turned(v, roll[f] + 0.01 * normal(), 0, 1);
        v = turned(v, pitch[f] + 0.01 * normal(), 1, 2);
        return turned(v, yaw[f] + 0.01 * normal(), 2, 0);
      };
      if (knows_depths) {
        for (const auto& p : common) frame.depths.push_back(150 / width_ * (stands(p).z - middle_.z));
        double eyes = 0;
        for (const std::size_t i : {36U, 45U}) eyes += 0.5 * frame.depths[i];
        for (double& depth : frame.depths) depth -= eyes;
        glm::dmat3 r(1);
        for (int c = 0; c < 3; ++c) {
          geometry::ModelVector e(0);
          e[c] = 1;
          const geometry::ModelVector t = about(e);
          for (int k = 0; k < 3; ++k) r[c][k] = ((c > 0) != (k > 0) ? -1 : 1) * t[k];
        }
        frame.rotation = r;
      } else {
        frame.depths = io::common_depths(frame.points);
      }
      const std::array<double, 9> units{value(f, "browInnerUp"), value(f, "browOuterUp"), value(f, "browDown"),
                                        value(f, "mouthSmile"),  value(f, "mouthFrown"),  value(f, "mouthStretch"),
                                        2 * value(f, "jawOpen"), value(f, "jawOpen"),     closing_[f]};
      for (std::size_t u = 0; u < units.size(); ++u) {
        frame.says.units.push_back(std::clamp((gains[u] * units[u] + 0.25 * normal()) / 5, 0.0, 1.0));
      }
      frame.says.closing = frame.says.units.back();
      track.frames.push_back(std::move(frame));
    }
  }

  const rig::Rig& rig_;
  std::vector<std::uint32_t> points_;
  Shaker random_;
  std::size_t frames_;
  MadeUpPerson person_;
  geometry::ModelPoint middle_{0};
  geometry::ModelVector stretch_{1};
  double width_ = 1;
  std::vector<geometry::ModelPoint> centres_;
  std::vector<double> reaches_;
  std::vector<geometry::ModelVector> pushes_;
  Signal closing_;
  Signal seen_closing_;
};

}  // namespace penpose::tests
