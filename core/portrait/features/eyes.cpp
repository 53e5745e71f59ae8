#include "core/portrait/features/eyes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portrait/surface/openings.h"
#include "core/portrait/surface/parting.h"
#include "core/portrait/surface/pieces.h"

namespace penpose::portrait {
namespace {

/// The smallest opening of an eye, as a share of the picture's px.
constexpr double k_smallest_eye = 0.0004;
/// Openings mirror each other within this share of their distance.
constexpr double k_eyes_mirrored = 0.25;
/// Pairs of pieces that are looked at.
constexpr std::size_t k_most_pairs = 300;
/// Lids cover at least this share of an eyeball.
constexpr double k_covered = 0.25;
/// A lid's thickness as a share of the opening's size.
constexpr double k_behind = 0.03;

struct OpeningPair {
  Opening right, left;
  double sureness = 0;
};

double size_of(const FaceSurface& surface, const Opening& opening) {
  return std::sqrt(opening.area) * surface.image().px();
}

/// How well two openings are the two eyes of a face: 0..1.
double alike(const FaceSurface& surface, const Opening& right, const Opening& left) {
  if (!(right.centre.x < 0.0 && left.centre.x > 0.0)) return 0.0;
  const double size = std::min(size_of(surface, right), size_of(surface, left));
  const double off = geometry::length({right.centre.x + left.centre.x, right.centre.y - left.centre.y, 0}) /
                     (k_eyes_mirrored * (left.centre.x - right.centre.x));
  const double area = std::min(right.area, left.area) / std::max(right.area, left.area);
  const double apart = (left.centre.x - right.centre.x) / size;
  if (off > 1.0 || area < 0.5 || apart < 1.3 || apart > 8.0) return 0.0;
  return (1.0 - 0.5 * off) * std::sqrt(area) * std::min(right.enclosed, left.enclosed);
}

std::optional<OpeningPair> best_pair(const FaceSurface& surface, const std::vector<Opening>& openings) {
  std::optional<OpeningPair> best;
  double most = 0;
  for (const Opening& right : openings) {
    for (const Opening& left : openings) {
      const double sureness = alike(surface, right, left);
      const double score = sureness * std::sqrt(right.area);
      if (sureness < 0.3 || score <= most) continue;
      most = score;
      best = OpeningPair{right, left, sureness};
    }
  }
  return best;
}

/// Where pieces are seen before the skin, and which share of them the skin covers.
struct Seen {
  Mask mask;
  double covered = 0;
  double step = 0;  ///< by which the skin's rim lies before them, model units
};

Seen seen_of(const FaceSurface& surface, const PiecePair& pair) {
  const FaceImage& skin = surface.image();
  Seen seen;
  seen.mask.assign(static_cast<std::size_t>(skin.width()) * skin.height(), false);
  double all = 0, before = 0, borders = 0;
  for (const Piece& piece : pair) {
    const int x0 = std::max(0, static_cast<int>(skin.column(piece.box.minimum.x)) - 1);
    const int y0 = std::max(0, static_cast<int>(skin.row(piece.box.minimum.y)) - 1);
    FaceImage image = skin.part(x0, y0, static_cast<int>(skin.column(piece.box.maximum.x)) + 2,
                                static_cast<int>(skin.row(piece.box.maximum.y)) + 2);
    for (const std::uint32_t component : piece.components) {
      image.draw(surface.places(), surface.mesh().triangles(), surface.triangles_of(component));
    }
    for (int y = 0; y < image.height(); ++y) {
      bool last = false;
      for (int x = 0; x < image.width(); ++x) {
        const bool is_there = image.triangle(x, y) != FaceImage::k_nothing;
        const bool is_before = is_there && image.depth(x, y) > skin.depth(x0 + x, y0 + y);
        all += is_there ? 1.0 : 0.0;
        before += is_before ? 1.0 : 0.0;
        const int outside = last ? x : x - 1;
        const int within = last ? x - 1 : x;
        if (is_before != last && x > 0 && surface.shows_skin(x0 + outside, y0 + y)) {
          seen.step += skin.depth(x0 + outside, y0 + y) - image.depth(within, y);
          borders += 1.0;
        }
        last = is_before;
        if (is_before) seen.mask[x0 + x + static_cast<std::size_t>(y0 + y) * skin.width()] = true;
      }
    }
  }
  if (all > 0.0) seen.covered = 1.0 - before / all;
  if (borders > 0.0) seen.step /= borders;
  return seen;
}

Mask holes_of(const FaceSurface& surface) {
  const FaceImage& image = surface.image();
  Mask mask(static_cast<std::size_t>(image.width()) * image.height(), false);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      mask[x + static_cast<std::size_t>(y) * image.width()] = !surface.shows_skin(x, y);
    }
  }
  return mask;
}

/// The rim between its corners, which are its ends to the sides; `outer_left`: the outer corner is on the left.
Eye eye_of(const FaceSurface& surface, const Opening& opening, bool outer_left) {
  std::vector<ModelPoint> places;
  for (const mesh::MeshPoint& p : opening.rim) places.push_back(surface.position(p));
  const auto by_x = [](const ModelPoint& a, const ModelPoint& b) { return a.x < b.x; };
  const auto left = static_cast<std::size_t>(std::max_element(places.begin(), places.end(), by_x) - places.begin());
  const auto right = static_cast<std::size_t>(std::min_element(places.begin(), places.end(), by_x) - places.begin());
  Eye eye;
  eye.centre = (places[left] + places[right]) * 0.5;
  eye.width = geometry::distance(places[left], places[right]);
  const std::size_t n = places.size();
  // The rim runs counter-clockwise as seen, the face's left being on the right: over the upper lid from left to right.
  for (std::size_t i = left;; i = (i + 1) % n) {
    eye.upper.points.push_back(opening.rim[i]);
    if (i == right) break;
  }
  for (std::size_t i = right;; i = (i + 1) % n) {
    eye.lower.points.push_back(opening.rim[i]);
    if (i == left) break;
  }
  std::reverse(eye.lower.points.begin(), eye.lower.points.end());
  if (!outer_left) {
    std::reverse(eye.upper.points.begin(), eye.upper.points.end());
    std::reverse(eye.lower.points.begin(), eye.lower.points.end());
  }
  return eye;
}

}  // namespace

double closing(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface, const Eye& eye) {
  std::vector<std::uint32_t> vertices;
  for (const FoundLine* line : {&eye.upper, &eye.lower}) {
    for (const mesh::MeshPoint& p : line->points) {
      for (const std::uint32_t v : surface.mesh().triangles()[p.triangle]) vertices.push_back(v);
    }
  }
  std::stable_sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const mesh::MeshPoint& upper = eye.upper.points[eye.upper.points.size() / 2];
  const mesh::MeshPoint& lower = eye.lower.points[eye.lower.points.size() / 2];
  const double open = surface.position(upper).y - surface.position(lower).y;
  if (!(open > 0.0)) return 0.0;
  PushField field(rig, surface, vertices);
  double most = 0;
  geometry::Box box;
  box.add(eye.centre - ModelVector{eye.width});
  box.add(eye.centre + ModelVector{eye.width});
  for (const Push& push : pushes_within(rig, whole, surface, box)) {
    field.set(push);
    most = std::max(most, field.of(lower).y - field.of(upper).y);
  }
  return std::min(1.0, most / open);
}

std::optional<std::array<Eye, 2>> find_eyes(const rig::Rig& rig, const intent::WholeModel& whole,
                                            const FaceSurface& surface) {
  const FaceImage& image = surface.image();
  const double fewest = std::max(12.0, k_smallest_eye * image.width() * image.height());
  std::optional<OpeningPair> best;
  double evidence = 1.0;
  double most = 0;
  const std::vector<PiecePair> pieces = find_piece_pairs(surface);
  for (std::size_t i = 0; i < pieces.size() && i < k_most_pairs; ++i) {
    const Seen seen = seen_of(surface, pieces[i]);
    if (seen.covered < 0.4 * k_covered) continue;
    auto pair = best_pair(surface, openings_of(surface, seen.mask, fewest));
    if (!pair) continue;
    // Tears and shadows over an eyeball lie before the lids.
    const double behind = std::clamp(0.5 + seen.step / (k_behind * size_of(surface, pair->right)), 0.5, 1.0);
    pair->sureness *= std::min(1.0, seen.covered / k_covered) * behind;
    const double score = pair->sureness * std::sqrt(pair->right.area);
    if (pair->sureness < 0.3 || score <= most) continue;
    most = score;
    best = std::move(pair);
  }
  if (!best) {
    best = best_pair(surface, openings_of(surface, holes_of(surface), fewest));
    evidence = 0.9;
  }
  if (!best || best->right.rim.size() < 8 || best->left.rim.size() < 8) return std::nullopt;
  std::array<Eye, 2> eyes{eye_of(surface, best->right, false), eye_of(surface, best->left, true)};
  for (Eye& eye : eyes) {
    if (eye.upper.points.size() < 3 || eye.lower.points.size() < 3) return std::nullopt;
    eye.upper.sureness = eye.lower.sureness =
        best->sureness * evidence * (0.75 + 0.25 * closing(rig, whole, surface, eye));
  }
  return eyes;
}

}  // namespace penpose::portrait
