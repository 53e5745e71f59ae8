#include "core/portrait/surface/pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penpose::portrait {
namespace {

/// Half the extent of a piece, as shares of the picture's height.
constexpr double k_smallest_piece = 0.01, k_largest_piece = 0.15;
/// Pieces mirror each other within this share of their half extent, and their numbers of vertices within this one.
constexpr double k_pieces_mirrored = 0.3;
constexpr double k_numbers = 0.15;
/// What lies this far beyond a piece's box still belongs to it, as a share of its half extent.
constexpr double k_within = 0.05;
/// Single strands of hair are many.
constexpr std::size_t k_most_pieces = 400;

double half_extent(const Piece& piece) {
  const ModelVector d = piece.box.maximum - piece.box.minimum;
  return std::max(d.x, d.y) / 2;
}

bool is_within(const geometry::Box& inner, const geometry::Box& outer, double margin) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.minimum[axis] < outer.minimum[axis] - margin || inner.maximum[axis] > outer.maximum[axis] + margin) {
      return false;
    }
  }
  return true;
}

std::vector<Piece> pieces_of(const FaceSurface& surface) {
  const mesh::TriangleMesh& mesh = surface.mesh();
  std::vector<Piece> all(mesh.component_count());
  for (std::size_t v = 0; v < surface.places().size(); ++v) {
    Piece& piece = all[mesh.components()[v]];
    piece.box.add(surface.places()[v]);
    ++piece.vertices;
  }
  const FaceImage& image = surface.image();
  const double height = image.height() * image.px();
  std::vector<Piece> pieces;
  for (std::uint32_t c = 0; c < all.size() && pieces.size() < k_most_pieces; ++c) {
    const double half = half_extent(all[c]);
    const ModelPoint centre = all[c].box.center();
    if (c == surface.skin() || half < k_smallest_piece * height || half > k_largest_piece * height) continue;
    if (!image.inside(static_cast<int>(image.column(centre.x)), static_cast<int>(image.row(centre.y)))) continue;
    Piece piece = all[c];
    piece.components.push_back(c);
    for (std::uint32_t other = 0; other < all.size(); ++other) {
      if (other != c && other != surface.skin() && is_within(all[other].box, piece.box, k_within * half)) {
        piece.components.push_back(other);
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool mirror_each_other(const Piece& right, const Piece& left) {
  const double half = std::min(half_extent(right), half_extent(left));
  const ModelPoint r = right.box.center();
  const ModelPoint l = left.box.center();
  if (!(r.x < 0.0 && l.x > 0.0) || l.x - r.x < half) return false;
  if (geometry::length({r.x + l.x, r.y - l.y, r.z - l.z}) > k_pieces_mirrored * half) return false;
  const auto few = static_cast<double>(std::min(right.vertices, left.vertices));
  const auto many = static_cast<double>(std::max(right.vertices, left.vertices));
  return few > (1.0 - k_numbers) * many && std::abs(half_extent(right) - half_extent(left)) < k_numbers * half;
}

}  // namespace

std::vector<PiecePair> find_piece_pairs(const FaceSurface& surface) {
  const std::vector<Piece> pieces = pieces_of(surface);
  std::vector<PiecePair> pairs;
  for (const Piece& right : pieces) {
    for (const Piece& left : pieces) {
      if (mirror_each_other(right, left)) pairs.push_back({right, left});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const PiecePair& a, const PiecePair& b) { return half_extent(a[0]) > half_extent(b[0]); });
  return pairs;
}

}  // namespace penpose::portrait
