#include <algorithm>
#include <string_view>

#include "core/document/words/face_marks.h"

namespace penpose::document {

using geometry::ModelPoint;
using geometry::ModelVector;
using portrait::FeatureCurve;

namespace {

/// Vertices that stand for a patch of skin.
constexpr std::size_t k_patch = 12;
/// An eye that is open by less, of the distance between the eyes, is closed at rest.
constexpr double k_least_open = 0.08;

/// The curve of one of two names.
const FeatureCurve* find_curve(std::span<const FeatureCurve> features, std::string_view name,
                               std::string_view other = {}) {
  for (const std::string_view one : {name, other}) {
    const auto at = std::find_if(features.begin(), features.end(), [&](const auto& f) { return f.name == one; });
    if (at != features.end() && at->points.size() > 1) return &*at;
  }
  return nullptr;
}

/// A box in the picture of the face, and what lies in it.
struct Piece {
  geometry::Box box;
  std::vector<std::uint32_t> vertices;
};

}  // namespace

/// Finds the places of a face's marks.
class FaceMarks::Maker {
 public:
  Maker(FaceMarks& face, const Model& model, std::span<const FeatureCurve> features)
      : face_(face), model_(model), features_(features), rest_(model.rig->vertex_count()) {
    model.rig->evaluate(rig::rest_pose(*model.rig), rest_);
  }

  bool make() {
    face_.frame_ = front_of(model_);
    if (!place_features()) return false;
    for (std::size_t side = 0; side < 2; ++side) {
      add_brow(side);
      add_lids(side);
      add_lips(side);
      add_skin(side);
    }
    find_pieces();
    face_.bound_ = face_.rig_->bind(vertices_);
    face_.rest_.resize(vertices_.size());
    face_.bound_->evaluate(rig::rest_pose(*face_.rig_), face_.rest_);
    measure_opening();
    return true;
  }

 private:
  static double sign(std::size_t side) { return side == 0 ? 1.0 : -1.0; }
  static const char* suffix(std::size_t side) { return side == 0 ? "_L" : "_R"; }

  [[nodiscard]] ModelPoint place(const posing::CurvePoint& point) const {
    ModelPoint sum(0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (point.weight[k] != 0.0) sum += rest_[point.vertex[k]] * point.weight[k];
    }
    return face_.frame_.local(sum);
  }

  [[nodiscard]] ModelPoint middle(const FeatureCurve& curve) const {
    ModelPoint sum(0);
    for (const posing::CurvePoint& point : curve.points) sum += place(point);
    return sum / static_cast<double>(curve.points.size());
  }

  /// Where eyes and mouth are; what is not found lies where it does in most faces.
  bool place_features() {
    bool eyes = true;
    double wide = 0;
    for (std::size_t side = 0; side < 2; ++side) {
      const auto* upper = find_curve(features_, std::string("eyelid_upper") + suffix(side));
      const auto* lower = find_curve(features_, std::string("eyelid_lower") + suffix(side));
      eyes = eyes && upper != nullptr && lower != nullptr;
      if (!eyes) break;
      const ModelPoint up = middle(*upper);
      const ModelPoint low = middle(*lower);
      face_.eyes_[side] = 0.5 * (up + low);
      wide = std::abs(place(upper->points.back()).x - place(upper->points.front()).x);
    }
    upper_ = find_curve(features_, "lip_upper_inner", "lip_upper");
    lower_ = find_curve(features_, "lip_lower_inner", "lip_lower");
    const bool lips = upper_ != nullptr && lower_ != nullptr;
    if (!eyes && !lips) return false;
    eyes_found_ = eyes;
    lips_found_ = lips;
    if (lips) {
      mouth_ = 0.5 * (middle(*upper_) + middle(*lower_));
      mouth_wide_ = std::abs(place(upper_->points.back()).x - place(upper_->points.front()).x);
    }
    if (!eyes) {
      const double apart = 1.25 * mouth_wide_;
      for (std::size_t side = 0; side < 2; ++side)
        face_.eyes_[side] = mouth_ + ModelVector(0.5 * sign(side) * apart, apart, -0.2 * apart);
      wide = 0.45 * apart;
    }
    face_.unit_ = std::max(geometry::distance(face_.eyes_[0], face_.eyes_[1]), 1e-9);
    if (!lips) place_mouth();
    eye_wide_ = wide;
    middle_x_ = 0.5 * (face_.eyes_[0].x + face_.eyes_[1].x);
    return true;
  }

  /// Below the eyes, as in most faces.
  void place_mouth() {
    mouth_ = 0.5 * (face_.eyes_[0] + face_.eyes_[1]) - ModelVector(0, 1.05 * face_.unit_, 0);
    mouth_wide_ = 0.75 * face_.unit_;
  }

  void add_point(Weights& to, const posing::CurvePoint& point, double share) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (point.weight[k] == 0.0) continue;
      to.emplace_back(static_cast<std::uint32_t>(vertices_.size()), share * point.weight[k]);
      vertices_.push_back(point.vertex[k]);
    }
  }

  Weights& at(Mark mark, std::size_t side) { return face_.points_[static_cast<std::size_t>(mark)][side]; }

  /// The mean of the points of a curve whose share of the way from `from` to `to` (along x) is within low..high; the
  /// nearest one where there is none.
  void add_stretch(Mark mark, std::size_t side, const FeatureCurve* curve, double low, double high, double from,
                   double to) {
    if (curve == nullptr || from == to) return;
    const auto share = [&](const posing::CurvePoint& point) { return (place(point).x - from) / (to - from); };
    std::vector<const posing::CurvePoint*> inside;
    for (const posing::CurvePoint& point : curve->points) {
      const double t = share(point);
      if (t >= low && t <= high) inside.push_back(&point);
    }
    if (inside.empty()) {
      const double wanted = 0.5 * (low + high);
      const auto* nearest = &curve->points.front();
      for (const posing::CurvePoint& point : curve->points) {
        if (std::abs(share(point) - wanted) < std::abs(share(*nearest) - wanted)) nearest = &point;
      }
      inside.push_back(nearest);
    }
    for (const auto* point : inside) add_point(at(mark, side), *point, 1.0 / static_cast<double>(inside.size()));
  }

  void measure_opening() {
    const auto height = [&](Mark mark) {
      ModelPoint sum(0);
      for (const auto& [number, share] : at(mark, 0)) sum += face_.rest_[number] * share;
      return face_.frame_.local(sum).y;
    };
    if (face_.has(Mark::lid_upper))
      face_.open_ = std::max((height(Mark::lid_upper) - height(Mark::lid_lower)) / face_.unit_, k_least_open);
  }

  /// From the middle of the face outwards.
  [[nodiscard]] std::pair<double, double> extent(const FeatureCurve& curve, std::size_t side) const {
    double low = 1e300;
    double high = -1e300;
    for (const posing::CurvePoint& point : curve.points) {
      low = std::min(low, sign(side) * place(point).x);
      high = std::max(high, sign(side) * place(point).x);
    }
    return {sign(side) * low, sign(side) * high};
  }

  void add_brow(std::size_t side) {
    const auto* brow = find_curve(features_, std::string("brow") + suffix(side));
    if (brow == nullptr && !eyes_found_) return;
    if (brow == nullptr) {
      const ModelPoint& eye = face_.eyes_[side];
      const double up = eye.y + 0.38 * face_.unit_;
      add_patch(Mark::brow_inner, side, {eye.x - sign(side) * 0.28 * face_.unit_, up, 0});
      add_patch(Mark::brow_middle, side, {eye.x, up, 0});
      add_patch(Mark::brow_outer, side, {eye.x + sign(side) * 0.28 * face_.unit_, up, 0});
      return;
    }
    const auto [from, to] = extent(*brow, side);
    add_stretch(Mark::brow_inner, side, brow, -0.1, 0.25, from, to);
    add_stretch(Mark::brow_middle, side, brow, 0.35, 0.65, from, to);
    add_stretch(Mark::brow_outer, side, brow, 0.75, 1.1, from, to);
  }

  void add_lids(std::size_t side) {
    const auto* upper = find_curve(features_, std::string("eyelid_upper") + suffix(side));
    const auto* lower = find_curve(features_, std::string("eyelid_lower") + suffix(side));
    if (upper == nullptr || lower == nullptr) {
      return;
    }
    const auto [from, to] = extent(*upper, side);
    add_stretch(Mark::lid_upper, side, upper, 0.3, 0.7, from, to);
    add_stretch(Mark::lid_lower, side, lower, 0.3, 0.7, from, to);
    add_stretch(Mark::lid_upper_inner, side, upper, 0.08, 0.35, from, to);
    add_stretch(Mark::lid_upper_outer, side, upper, 0.65, 0.92, from, to);
    add_stretch(Mark::lid_lower_inner, side, lower, 0.08, 0.35, from, to);
    add_stretch(Mark::lid_lower_outer, side, lower, 0.65, 0.92, from, to);
  }

  void add_lip(Mark part, Mark middle, std::size_t side, const FeatureCurve* lip) {
    const double corner = mouth_.x + sign(side) * 0.5 * mouth_wide_;
    add_stretch(part, side, lip, 0.4, 0.65, mouth_.x, corner);
    if (middle != part) add_stretch(middle, side, lip, -0.15, 0.15, mouth_.x, corner);
  }

  void add_lips(std::size_t side) {
    const double corner = mouth_.x + sign(side) * 0.5 * mouth_wide_;
    if (!lips_found_) return;
    add_lip(Mark::lip_upper, Mark::lip_upper_middle, side, upper_);
    add_lip(Mark::lip_lower, Mark::lip_lower_middle, side, lower_);
    for (const auto* lip : {upper_, lower_}) {
      const auto end = std::max_element(lip->points.begin(), lip->points.end(), [&](const auto& a, const auto& b) {
        return sign(side) * place(a).x < sign(side) * place(b).x;
      });
      add_point(at(Mark::corner, side), *end, 0.5);
    }
    const auto* above = find_curve(features_, "lip_upper_outer", "lip_upper");
    const auto* below = find_curve(features_, "lip_lower_outer", "lip_lower");
    if (above == upper_ || below == lower_) return;
    if (above != nullptr) add_stretch(Mark::lip_upper_border, side, above, -0.15, 0.4, mouth_.x, corner);
    if (below != nullptr) add_stretch(Mark::lip_lower_border, side, below, -0.15, 0.4, mouth_.x, corner);
  }

  /// The vertices nearest to a place of the picture, of those in front.
  void add_patch(Mark mark, std::size_t side, const ModelPoint& where) {
    const double reach = 0.16 * face_.unit_;
    std::vector<std::pair<double, std::uint32_t>> near;
    double front = -1e300;
    for (std::uint32_t v = 0; v < rest_.size(); ++v) {
      const ModelPoint p = face_.frame_.local(rest_[v]);
      const double x = p.x - where.x;
      const double y = p.y - where.y;
      const double square = x * x + y * y;
      if (square > reach * reach) continue;
      near.emplace_back(square, v);
      front = std::max(front, p.z);
    }
    std::erase_if(near,
                  [&](const auto& one) { return face_.frame_.local(rest_[one.second]).z < front - 0.3 * face_.unit_; });
    std::stable_sort(near.begin(), near.end());
    if (near.size() > k_patch) near.resize(k_patch);
    for (const auto& one : near)
      add_point(at(mark, side), posing::at_vertex(one.second), 1.0 / static_cast<double>(near.size()));
  }

  /// What lies between features that were found.
  void add_skin(std::size_t side) {
    if (!lips_found_) return;
    const ModelPoint& eye = face_.eyes_[side];
    const double high = eye.y - mouth_.y;
    const double out = sign(side);
    const double half = 0.5 * mouth_wide_;
    if (eyes_found_) add_patch(Mark::cheek, side, {eye.x + out * 0.05 * face_.unit_, eye.y - 0.45 * high, 0});
    add_patch(Mark::cheek_hollow, side,
              {mouth_.x + out * std::max(half + 0.3 * face_.unit_, 0.62 * face_.unit_), mouth_.y + 0.12 * high, 0});
    const auto* base = find_curve(features_, "nose_base");
    const double low = base != nullptr ? middle(*base).y : mouth_.y + 0.32 * high;
    if (eyes_found_) add_patch(Mark::nose_wing, side, {middle_x_ + out * 0.22 * face_.unit_, low + 0.08 * high, 0});
    const auto* chin = find_curve(features_, "chin");
    const double down = chin != nullptr ? middle(*chin).y + 0.1 * high : mouth_.y - 0.5 * high;
    add_patch(Mark::chin, side, {mouth_.x + out * 0.06 * face_.unit_, down, 0});
  }

  /// Balls of eyes and what lies behind the lips: connected pieces beside the largest.
  void find_pieces() {
    const auto components = model_.mesh->components();
    std::vector<Piece> pieces(model_.mesh->component_count());
    for (std::uint32_t v = 0; v < rest_.size(); ++v) {
      pieces[components[v]].box.add(face_.frame_.local(rest_[v]));
      pieces[components[v]].vertices.push_back(v);
    }
    for (const Piece& piece : pieces) {
      if (piece.vertices.size() < 8) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        if (eyes_found_ && is_ball(piece, side)) add_ball(piece, side);
      }
      if (lips_found_ && is_inside(piece)) {
        face_.inside_.emplace_back();
        const std::size_t step = piece.vertices.size() / 24 + 1;
        const double count = static_cast<double>((piece.vertices.size() + step - 1) / step);
        for (std::size_t i = 0; i < piece.vertices.size(); i += step)
          add_point(face_.inside_.back(), posing::at_vertex(piece.vertices[i]), 1.0 / count);
      }
    }
  }

  [[nodiscard]] bool is_ball(const Piece& piece, std::size_t side) const {
    const ModelPoint& eye = face_.eyes_[side];
    const ModelPoint centre = piece.box.center();
    const double width = piece.box.maximum.x - piece.box.minimum.x;
    return std::abs(centre.x - eye.x) < 0.5 * eye_wide_ && std::abs(centre.y - eye.y) < 0.5 * eye_wide_ &&
           width < 2.0 * eye_wide_ && piece.box.maximum.y - piece.box.minimum.y > 0.5 * width &&
           piece.box.maximum.y - piece.box.minimum.y < 2.0 * eye_wide_;
  }

  /// The front against the middle: sixteen vertices of the front, and all.
  void add_ball(const Piece& piece, std::size_t side) {
    const double deep = piece.box.maximum.z - piece.box.minimum.z;
    std::vector<std::uint32_t> front;
    for (const std::uint32_t v : piece.vertices) {
      if (face_.frame_.local(rest_[v]).z > piece.box.maximum.z - 0.15 * deep) front.push_back(v);
    }
    Weights& to = at(Mark::ball, side);
    if (!to.empty()) return;
    const std::size_t step = front.size() / 16 + 1;
    const double count = static_cast<double>((front.size() + step - 1) / step);
    for (std::size_t i = 0; i < front.size(); i += step) add_point(to, posing::at_vertex(front[i]), 1.0 / count);
  }

  [[nodiscard]] bool is_inside(const Piece& piece) const {
    const ModelPoint centre = piece.box.center();
    return std::abs(centre.x - mouth_.x) < 0.25 * mouth_wide_ &&
           piece.box.maximum.x - piece.box.minimum.x < 1.6 * mouth_wide_ &&
           std::abs(centre.y - mouth_.y) < 0.6 * face_.unit_ && centre.z < mouth_.z &&
           piece.box.maximum.y - piece.box.minimum.y < 1.2 * face_.unit_;
  }

  FaceMarks& face_;
  const Model& model_;
  std::span<const FeatureCurve> features_;
  Places rest_;
  std::vector<std::uint32_t> vertices_;
  const FeatureCurve* upper_ = nullptr;
  const FeatureCurve* lower_ = nullptr;
  ModelPoint mouth_{0};
  bool eyes_found_ = false, lips_found_ = false;
  double mouth_wide_ = 0, eye_wide_ = 0, middle_x_ = 0;
};

std::optional<FaceMarks> FaceMarks::of(const Model& model, std::span<const FeatureCurve> features) {
  FaceMarks face;
  face.rig_ = model.rig;
  if (!Maker(face, model, features).make()) return std::nullopt;
  return face;
}

}  // namespace penpose::document
