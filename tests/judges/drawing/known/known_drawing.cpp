#include "tests/judges/drawing/known/known_drawing.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/math.h"
#include "core/portrait/proportions.h"
#include "core/portrait/sheet_warp.h"
#include "tests/judges/drawing/known/camera_picture.h"

namespace penpose::judges::drawn {
namespace {

/// Lines within twice what a hand strays are at one place, px.
constexpr double k_same_place = 4;
constexpr std::size_t k_fewest = 5, k_most = 12;

/// All controls of a pose that are not at rest, each alone.
std::vector<rig::Pose> single_moves(const rig::Rig& rig, const rig::Pose& pose) {
  const rig::Pose rest = rig::rest_pose(rig);
  std::vector<rig::Pose> out;
  for (std::size_t p = 0; p < pose.size(); ++p) {
    if (pose[p] == rest[p]) continue;
    out.push_back(rest);
    out.back()[p] = pose[p];
  }
  return out;
}

std::vector<std::size_t> shuffled(std::size_t count, tests::Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
  return order;
}

/// The marks that an artist draws: of each control one that it moves at least half as much as any.
std::vector<std::size_t> chosen(const JudgedFace& face, const CameraPicture& picture, const rig::Pose& pose,
                                tests::Random& random) {
  std::vector<std::vector<double>> ways;
  for (const rig::Pose& one : single_moves(face.rig(), pose)) {
    std::vector<double> way;
    const Lines lines = picture.seen(one);
    for (std::size_t c = 0; c < lines.size(); ++c) way.push_back(moved(lines[c], picture.rest()[c]));
    ways.push_back(std::move(way));
  }
  const auto shows = [&](const std::vector<std::size_t>& kept) {
    return std::all_of(ways.begin(), ways.end(), [&](const std::vector<double>& way) {
      double most = 0;
      for (const std::size_t c : kept) most = std::max(most, way[c]);
      return most >= 0.5 * *std::max_element(way.begin(), way.end());
    });
  };
  std::vector<std::size_t> kept(face.marks.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  const std::size_t fewer = random.index(4);
  const std::size_t least = std::max(k_fewest, std::min(k_most, kept.size()) - std::min(fewer, kept.size()));
  for (const std::size_t c : shuffled(face.marks.size(), random)) {
    if (kept.size() <= least) break;
    std::vector<std::size_t> without = kept;
    std::erase(without, c);
    if (shows(without)) kept = std::move(without);
  }
  return kept;
}

/// A smooth map of the picture by proportions that are off by so much, each up or down.
portrait::SheetWarp warp_of(const JudgedFace& face, const Lines& rest, double off, tests::Random& random) {
  std::vector<portrait::Part> parts;
  for (const auto& mark : face.marks) parts.push_back(portrait::part_named(mark.name));
  std::vector<PxPoint> from, to;
  std::vector<double> factors;
  const auto ways = portrait::proportions_of(rest, parts);
  for (std::size_t p = 0; p < ways.size(); ++p)
    factors.push_back(off * (random(0, 1) < 0.5 ? -1 : 1) * random(0.75, 1.25));
  for (std::size_t c = 0; c < rest.size(); ++c) {
    for (std::size_t i = 0; i < rest[c].size(); i += std::max<std::size_t>(1, rest[c].size() / 7)) {
      from.push_back(rest[c][i]);
      to.push_back(rest[c][i]);
      for (std::size_t p = 0; p < ways.size(); ++p) to.back() = to.back() + ways[p].ways[c][i] * factors[p];
    }
  }
  return {from, to};
}

/// Where the picture lies on the sheet.
struct Placing {
  double size = 1, cosine = 1, sine = 0;
  PxPoint shift;
  [[nodiscard]] PxPoint operator()(const PxPoint& p) const {
    const PxPoint d = (p - k_picture_middle) * size;
    return k_picture_middle + shift + PxPoint{d.x * cosine - d.y * sine, d.x * sine + d.y * cosine};
  }
};
Placing placing_of(const Freedom& freedom, tests::Random& random) {
  // Over the face as far as it is off; on a sheet anywhere.
  const double turn = base::radians(freedom.over ? random(-30, 30) * freedom.off : random(-10, 10));
  const double size = freedom.over ? 1 + random(-0.5, 0.5) * freedom.off : random(0.6, 1.4);
  const double reach = k_face_px * (freedom.over ? 0.25 * freedom.off : 1);
  return {size, base::cos(turn), base::sin(turn), {random(-reach, reach), random(-reach, reach)}};
}

/// What lies at one place at rest and now is drawn once, as long as enough lines are left.
void draw_once(std::vector<std::size_t>& kept, const Lines& rest, const Lines& now) {
  for (std::size_t a = 0; a < kept.size(); ++a) {
    for (std::size_t b = a + 1; b < kept.size() && kept.size() > k_fewest;) {
      const bool same =
          apart(rest[kept[a]], rest[kept[b]]) < k_same_place && apart(now[kept[a]], now[kept[b]]) < k_same_place;
      if (same) {
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(b));
      } else {
        ++b;
      }
    }
  }
}

std::set<std::uint32_t> vertices_of(const portrait::FeatureCurve& curve) {
  std::set<std::uint32_t> all;
  for (const auto& point : curve.points) all.insert(portrait::nearest_vertex(point));
  return all;
}

std::vector<std::size_t> right_marks(const JudgedFace& face, const Lines& now, std::size_t of) {
  const auto own = vertices_of(face.marks[of]);
  std::vector<std::size_t> right;
  for (std::size_t c = 0; c < now.size(); ++c) {
    const auto others = vertices_of(face.marks[c]);
    const bool part = std::includes(others.begin(), others.end(), own.begin(), own.end());
    if (c == of || part || apart(now[of], now[c]) < k_same_place) right.push_back(c);
  }
  return right;
}

}  // namespace

portrait::Drawing KnownDrawing::drawing() const {
  portrait::Drawing out;
  for (const MeantLine& line : lines) out.lines.push_back(line.points);
  out.in_view = over;
  return out;
}

KnownDrawing draw_known(const JudgedFace& face, const rig::Pose& pose, const Artist& artist, const Freedom& freedom,
                        std::uint64_t face_seed, std::uint64_t hand_seed) {
  tests::Random choice(face_seed), random(hand_seed);
  const double aside = choice(0, 1) < 0.5 ? 0 : (choice(0, 1) < 0.5 ? -1 : 1) * choice(8, 20);
  KnownDrawing out{{}, freedom.over, face.front_yaw_degrees() + aside};
  const CameraPicture picture(face, out.yaw_degrees);
  Lines now = picture.seen(pose);
  std::vector<std::size_t> kept = chosen(face, picture, pose, choice);
  draw_once(kept, picture.rest(), now);
  const auto warp = warp_of(face, picture.rest(), freedom.off, random);
  const Placing placing = placing_of(freedom, random);
  for (const std::size_t c : kept) {
    const auto right = right_marks(face, now, c);
    portrait::DrawnLine meant = now[c];
    for (PxPoint& p : meant) p = placing(freedom.off > 0 ? p + warp.offset(p) : p);
    for (DrawnStroke& one : strokes_of(artist.stroke, meant, c, random)) out.lines.push_back({one.points, right});
  }
  for (std::size_t i = out.lines.size(); i > 1; --i) std::swap(out.lines[i - 1], out.lines[random.index(i)]);
  for (MeantLine& line : out.lines) {
    for (PxPoint& p : line.points) p = freedom.over ? picture.on_camera(p) : p;
  }
  return out;
}

std::size_t right_labels(const KnownDrawing& drawing, std::span<const portrait::LineRead> read) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const auto& right = drawing.lines[i].right;
    if (read[i].curve && std::find(right.begin(), right.end(), *read[i].curve) != right.end()) ++count;
  }
  return count;
}

bool is_shown_by_lines(const JudgedFace& face, const rig::Pose& pose) {
  const CameraPicture picture(face, face.front_yaw_degrees());
  const Lines lines = picture.seen(pose);
  for (std::size_t c = 0; c < lines.size(); ++c) {
    if (moved(lines[c], picture.rest()[c]) >= 0.01 * k_face_px) return true;
  }
  return false;
}

}  // namespace penpose::judges::drawn
