#include "tests/judges/rigs/random/random_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"
#include "tests/judges/rigs/random/density.h"
#include "tests/judges/rigs/random/gaze.h"
#include "tests/judges/rigs/random/habits.h"
#include "tests/judges/rigs/random/landmarks.h"
#include "tests/judges/rigs/random/pieces/eye_pieces.h"
#include "tests/judges/rigs/random/pieces/head_pieces.h"
#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

using Where = std::function<ModelPoint(const ModelPoint&)>;

/// Scales what is around a place by shares more or less than one.
struct Swell {
  ModelPoint center;
  ModelVector radii, more;
  ModelVector shift{0};
  [[nodiscard]] ModelVector at(const ModelPoint& p) const {
    return ((p - center) * more + shift) * around(std::span(&p, 1), center, radii)[0];
  }
};

/// Bumps of all sizes: waves of random directions.
struct Waves {
  struct Wave {
    ModelVector along, way;
    double phase;
  };
  std::vector<Wave> waves;

  Waves(Dice& dice, double w, double size) {
    for (int k = 0; k < 5; ++k) {
      const double length = w * dice.real(0.6, 4);
      const auto direction = [&] { return ModelVector{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)}; };
      const ModelVector along = geometry::normalized(direction()) * (2 * base::k_pi / length);
      waves.push_back({along, direction() * (size * length), dice.real(0, 2 * base::k_pi)});
    }
  }
  [[nodiscard]] ModelVector at(const ModelPoint& p) const {
    ModelVector sum{0};
    for (const Wave& wave : waves) sum += wave.way * base::sin(glm::dot(wave.along, p) + wave.phase);
    return sum;
  }
};

Where proportions(const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double w = marks.mouth_w;
  std::vector<Swell> swells;
  const double eye = dice.chance(0.35) ? dice.real(0.2, 0.75) : dice.real(-0.25, 0.2);
  const double tall = dice.real(-0.1, 0.2);
  const double apart = dice.real(-0.1, 0.12) * marks.eye;
  const double crooked = dice.chance(0.6) ? dice.real(0, 0.05) : 0;
  for (const std::size_t side : {0U, 1U}) {
    const double out = side == 0 ? 1 : -1;
    const double own = eye + out * crooked;
    swells.push_back({marks.eyes[side], ModelVector{1.5, 1.6, 2.5} * marks.eye, ModelVector{own, own + tall, 0.1 * own},
                      ModelVector{out * apart, out * crooked * 0.5 * marks.eye, 0}});
  }
  const double mouth = dice.chance(0.35) ? dice.real(-0.45, -0.15) : dice.real(-0.15, 0.4);
  swells.push_back({marks.mouth,
                    ModelVector{1.9, 1.3, 2.2} * w,
                    {mouth, mouth * dice.real(0.2, 1), 0},
                    ModelVector{crooked * dice.real(-1, 1), dice.real(-0.18, 0.15), 0} * w});
  if (dice.chance(0.2)) {
    const ModelPoint muzzle = (marks.mouth + marks.nose) * 0.5;
    swells.push_back({muzzle, ModelVector{1.7, 1.5, 2.5} * w, {-0.1, 0, 0}, {0, 0, dice.real(0.3, 1.3) * w}});
  }
  const ModelVector stretch{dice.about_one(0.2), dice.about_one(0.2), dice.about_one(0.15)};
  const double jaw_width = dice.real(-0.25, 0.25);
  const double jaw_length = dice.real(-0.3, 0.35) * w;
  const double forehead = dice.real(-0.12, 0.2);
  const double brow = dice.real(-0.05, 0.15) * w;
  const double lean = crooked * dice.real(-1, 1);
  const double eyes_y = marks.eyes[0].y;
  const Waves waves(dice, w, dice.chance(0.7) ? dice.real(0, 0.006) : 0);
  return [=](const ModelPoint& p) {
    ModelPoint q = p + waves.at(p);
    for (const Swell& swell : swells) q += swell.at(p);
    const double low = smooth_step(eyes_y, marks.chin.y, p.y);
    q.x *= 1 + jaw_width * low;
    q.x += lean * (p.y - eyes_y);
    q.y -= jaw_length * smooth_step(marks.mouth.y - 0.2 * w, marks.chin.y, p.y);
    const double above = std::max(0.0, p.y - marks.brows[0].y);
    q.y += forehead * above + brow * smooth_step(eyes_y + 0.2 * w, marks.brows[0].y, p.y);
    return q * stretch;
  };
}

/// How far a muscle goes, of what it was made for. Real smiles are large and brows and lids go but a little.
double strength_of(const std::string& base, double lot) {
  const auto between = [&](double low, double high) { return low + (high - low) * lot; };
  if (base == "smile_") return between(0.7, 1.9);
  if (base.starts_with("brow_")) return between(0.2, 1.1);
  if (base == "wide_" || base == "cheek_" || base == "frown_") return between(0.35, 1.2);
  if (base == "jaw_open") return between(0.75, 2);
  if (base == "puff_") return between(0.8, 3);
  return between(0.75, 1.3);
}

/// Every maker sculpts a muscle in a way of his own; sides are alike within a few per cent.
void vary_muscles(Parts& parts, const Dice& dice) {
  const double uneven = Dice(dice.about("uneven")).real(0, 0.06);
  const bool plain = Dice(dice.about("plain")).chance(0.2);
  for (auto& [name, field] : parts.fields) {
    const std::string base = name.starts_with("lips_close") ? "jaw_open" : without_side(name);
    Dice own = dice.about(base);
    const bool lid = base == "blink_" || base.starts_with("lid_");
    const bool rigid = base.starts_with("look_") || base.starts_with("jaw_") || name == "lips_close";
    const double strength = plain ? 1 : lid ? own.real(0.9, 1.03) : strength_of(base, own.real(0, 1));
    const double tilt = plain || lid || rigid || !has_side(name) ? 0 : own.real(-14, 14);
    const double reach = plain || lid || rigid ? 0 : own.real(-0.45, 0.5);
    const double side = Dice(dice.about(name)).about_one(lid ? 0.3 * uneven : uneven);
    const double turn = base::radians(name.ends_with("_R") ? -tilt : tilt);
    const double c = base::cos(turn);
    const double s = base::sin(turn);
    double most = 0;
    for (const ModelVector& d : field) most = std::max(most, geometry::length(d));
    for (ModelVector& d : field) {
      const double size = geometry::length(d);
      if (size <= 1e-3 * most) continue;
      d = ModelVector{c * d.x - s * d.y, s * d.x + c * d.y, d.z} *
          (strength * side * (reach == 0 ? 1 : base::pow(size / most, reach)));
    }
  }
}

void add_halves(Parts& parts) {
  const Landmarks marks = landmarks_of(parts);
  const double w = marks.mouth_w;
  std::vector<double> above;
  for (const double share : parts.jaw_share) above.push_back(1 - share);
  for (const std::size_t i : {0U, 1U}) {
    const std::string side = i == 0 ? "L" : "R";
    const double out = i == 0 ? 1 : -1;
    const auto from_middle = [&](double low, double high, bool outer) {
      std::vector<double> share;
      for (const ModelPoint& p : parts.rest()) {
        const double far = smooth_step(low, high, out * (p.x - marks.mouth.x) / w);
        share.push_back(outer ? far : 1 - far);
      }
      return share;
    };
    for (const bool outer : {false, true}) {
      const char* part = outer ? "_out" : "_in";
      const auto share = from_middle(0.2, 0.6, outer);
      // The outer half moves less at its muscle's most, so that it is made larger.
      const auto of = [&](const char* muscle, double size) {
        Field field = times(parts.field(muscle + side), share);
        for (ModelVector& d : field) d *= size;
        return field;
      };
      parts.fields[std::string("upper") + part + "_up_" + side] = of("upper_up_", outer ? 1.6 : 1.1);
      parts.fields[std::string("lower") + part + "_down_" + side] = of("lower_down_", outer ? 1.6 : 1.1);
    }
    parts.fields["smile_top_" + side] = times(parts.field("smile_" + side), above);
    parts.fields["smile_bottom_" + side] = times(parts.field("smile_" + side), parts.jaw_share);
    const ModelPoint& eye = marks.eyes[i];
    for (const bool outer : {false, true}) {
      std::vector<double> share;
      for (const ModelPoint& p : parts.rest()) {
        const double far = smooth_step(-0.6, 0.6, out * (p.x - eye.x) / marks.eye);
        share.push_back(outer ? far : 1 - far);
      }
      parts.fields[std::string("lid") + (outer ? "_out_" : "_in_") + side] = times(parts.field("blink_" + side), share);
    }
    const ModelPoint& brow = marks.brows[i];
    parts.fields["brow_mid_up_" + side] =
        pushed(around(parts.rest(), brow, ModelVector{0.6, 0.45, 0.9} * w), ModelVector{0, 0.35 * w, 0.02 * w});
  }
}

void add_nonsense(Parts& parts) {
  const Landmarks marks = landmarks_of(parts);
  const double w = marks.mouth_w;
  const std::vector<double> all(parts.rest().size(), 1.0);
  parts.fields["nothing"] = pushed(all, ModelVector{0});
  parts.fields["all"] = turned(parts.rest(), all, marks.nose - ModelVector{0, 0, 2 * w}, {0.3, 1, 0.1}, 12);
  const std::array<std::pair<const char*, std::array<const char*, 2>>, 3> pieces{
      {{"hair", {"hair", ""}}, {"teeth", {"teeth", "teeth_lower"}}, {"tongue", {"tongue", ""}}}};
  for (const auto& [name, of] : pieces) {
    Field field(parts.rest().size(), ModelVector{0});
    bool found = false;
    for (const char* piece : of) {
      const mesh::Part* part = *piece ? parts.mesh->find_part(piece) : nullptr;
      if (!part) continue;
      found = true;
      for (std::uint32_t v = part->first_vertex; v < part->first_vertex + part->vertex_count; ++v)
        field[v] = ModelVector{0.03, 0.12, 0.15} * w;
    }
    if (found) parts.fields[name] = std::move(field);
  }
  // Ears are what is far to the sides, at the height of the eyes.
  double far = 0;
  for (const ModelPoint& p : parts.rest()) far = std::max(far, std::abs(p.x));
  Field ears;
  for (const ModelPoint& p : parts.rest()) {
    const double share = smooth_step(0.8 * far, far, std::abs(p.x));
    ears.push_back(ModelVector{p.x > 0 ? 0.1 : -0.1, 0.15, 0} * (w * share));
  }
  parts.fields["ears"] = std::move(ears);
}

/// Meshes of their own that go along with the skin, of which a face has some.
void add_own_pieces(Parts& parts, const Dice& dice) {
  Dice own = dice.about("own pieces");
  const double many = own.chance(0.25) ? 0 : own.real(0.4, 1);
  Pieces pieces(parts);
  const bool lashes = own.chance(many);
  const bool shells = own.chance(many);
  const bool brows = own.chance(0.6 * many);
  if (lashes) add_lashes(pieces, parts, dice.about("lashes"));
  if (shells) add_eye_shells(pieces, parts, dice.about("shells"));
  if (brows) add_brow_hair(pieces, parts, dice.about("brow hair"));
  const bool creature = !parts.mesh->find_part("teeth");
  const bool inside = own.chance(creature ? many : 0.8 * many);
  const bool hair = own.chance(0.5 * many);
  const bool shoulders = own.chance(0.4 * many);
  if (inside) add_mouth_inside(pieces, parts, dice.about("inside of the mouth"));
  if (hair) add_hair_and_ears(pieces, parts, dice.about("hair and ears"));
  if (shoulders) add_shoulders(pieces, parts, dice.about("shoulders"));
  std::move(pieces).attach(parts);
}

}  // namespace

Parts random_parts(const Dice& dice) {
  Dice own = dice.about("face");
  Parts parts;
  if (own.chance(0.2)) {
    const auto columns = static_cast<std::uint32_t>(2 * own.count(9, 21) + 1);
    parts = creature_parts(columns, static_cast<std::uint32_t>(own.count(24, 48)));
  } else {
    parts = head_parts();
  }
  add_halves(parts);
  add_nonsense(parts);
  parts = reshaped(parts, proportions(parts, dice.about("proportions")));
  if (own.chance(0.5) && parts.rest().size() > 1500) parts = thinned(parts, own.real(0.12, 0.8));
  vary_muscles(parts, dice.about("muscles"));
  add_habits(parts, dice);
  add_lips_close(parts, dice);
  Dice pieces = dice.about("pieces");
  if (parts.eyes.empty() && pieces.chance(0.6)) add_balls(parts, dice.about("balls"));
  add_gaze(parts, dice);
  add_own_pieces(parts, dice);
  return parts;
}

void add_corrections(Parts& parts, std::size_t count, Dice dice) {
  const std::array<const char*, 8> from{"smile_L", "smile_R", "frown_L",     "jaw_open",
                                        "pucker",  "blink_L", "brow_down_R", "stretch_R"};
  for (std::size_t k = 0; k < count; ++k) {
    Field field(parts.rest().size(), ModelVector{0});
    const Field& base = parts.field(dice.one_of(from));
    const Field& other = parts.field(dice.one_of(from));
    add_to(field, dice.real(-0.12, 0.12), base);
    add_to(field, dice.real(-0.08, 0.08), other);
    const auto& line = dice.one_of(parts.lines).vertices;
    const ModelPoint& at = parts.rest()[line[dice.below(line.size())]];
    field = times(field, around(parts.rest(), at, ModelVector{1, 1, 1.5} * parts.mouth));
    double most = 0;
    for (const ModelVector& d : field) most = std::max(most, geometry::length(d));
    // Elsewhere than what it was made of there is nothing to move.
    if (most < 1e-4 * parts.mouth) add_to(field, 0.1, base);
    parts.fields["fix_" + std::to_string(k)] = std::move(field);
  }
}

}  // namespace penpose::judges
