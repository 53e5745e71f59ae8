#include "core/portrait/features/brows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/portrait/features/painted_brows.h"
#include "core/portrait/surface/parting.h"
#include "core/portrait/surface/pieces.h"
#include "core/portrait/surface/ray_walk.h"

namespace penpose::portrait {
namespace {

// Lengths are shares of the distance of the eyes.
/// A brow reaches from its eye's centre this far, outwards and inwards.
constexpr double k_outwards = 0.39, k_inwards = 0.34;
/// It lies this far above the lid.
constexpr double k_lowest = 0.05, k_highest = 0.62;
/// Drawn brows are no thicker and no shorter.
constexpr double k_thickest = 0.3, k_shortest = 0.35;
/// A control of the brows moves its farthest place at least this far.
constexpr double k_least_brow_way = 0.015;
constexpr std::size_t k_columns = 21;
/// Middles of different controls that are this far apart say half as much.
constexpr double k_brows_apart = 0.06;
/// Of fields alone, and of the ridge alone.
constexpr double k_of_fields = 0.7, k_of_ridge = 0.2;

BrowWindow window_of(const FaceSurface& surface, const Eye& eye, bool is_left, double distance) {
  const FaceImage& image = surface.image();
  double lid = -1e300;
  for (const mesh::MeshPoint& p : eye.upper.points) lid = std::max(lid, surface.position(p).y);
  const double side = is_left ? 1.0 : -1.0;
  BrowWindow window;
  window.outer = image.column(eye.centre.x + side * k_outwards * distance);
  window.inner = image.column(eye.centre.x - side * k_inwards * distance);
  window.bottom = std::max(0, static_cast<int>(image.row(lid + k_lowest * distance)));
  window.top = std::min(image.height() - 1, static_cast<int>(image.row(lid + k_highest * distance)));
  window.unit = distance / image.px();
  return window;
}

/// The middle line of what `at` gives a place for, over a window and a little around it; nothing where that is not like
/// a brow.
template <typename At>
std::optional<FoundLine> middle_of(const BrowWindow& window, const At& at) {
  const double around = 0.25 * std::abs(window.outer - window.inner);
  const double side = window.outer < window.inner ? -1.0 : 1.0;
  const double step = std::abs(window.outer - window.inner) / 60.0;
  const auto rows = static_cast<double>(window.top - window.bottom);
  FoundLine line;
  double first = 0, last = 0;
  for (double x = window.outer + side * around; side * (x - window.inner) > -around; x -= side * step) {
    int lowest = -1, highest = -1;
    for (int y = window.bottom; y <= window.top; ++y) {
      if (!at(static_cast<int>(std::lround(x)), y)) continue;
      if (lowest < 0) lowest = y;
      highest = y;
    }
    if (lowest < 0) continue;
    if (highest - lowest > k_thickest * window.unit || highest - lowest > 0.8 * rows) return std::nullopt;
    const auto point = at(static_cast<int>(std::lround(x)), (lowest + highest) / 2);
    if (!point) continue;
    if (line.points.empty()) first = x;
    last = x;
    line.points.push_back(*point);
  }
  if (line.points.size() < 8 || std::abs(last - first) < k_shortest * window.unit) return std::nullopt;
  line.sureness = 0.9;
  return line;
}

/// Pieces before the skin above an eye.
std::optional<FoundLine> drawn_piece(const FaceSurface& surface, const BrowWindow& window, const Piece& piece) {
  const FaceImage& skin = surface.image();
  const ModelPoint centre = piece.box.center();
  if (!window.holds(skin.column(centre.x), skin.row(centre.y))) return std::nullopt;
  FaceImage image = skin;
  for (const std::uint32_t component : piece.components) {
    image.draw(surface.places(), surface.mesh().triangles(), surface.triangles_of(component));
  }
  const mesh::TriangleMesh& mesh = surface.mesh();
  return middle_of(window, [&](int x, int y) -> std::optional<mesh::MeshPoint> {
    if (!image.inside(x, y) || image.triangle(x, y) == skin.triangle(x, y)) return std::nullopt;
    const mesh::Triangle& t = mesh.triangles()[image.triangle(x, y)];
    const auto places = surface.places();
    return mesh::MeshPoint{image.triangle(x, y),
                           seen_barycentric(image.place(x, y), places[t[0]], places[t[1]], places[t[2]])};
  });
}

/// A material of the skin of which most is seen above the eyes.
std::optional<std::size_t> brow_part(const FaceSurface& surface, const std::array<BrowWindow, 2>& windows) {
  const FaceImage& image = surface.image();
  const std::size_t parts = surface.mesh().parts().size();
  if (parts < 2) return std::nullopt;
  std::vector<double> seen(parts, 0.0), above(parts, 0.0);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!surface.shows_skin(x, y)) continue;
      const std::size_t part = part_of(surface.mesh(), image.triangle(x, y));
      seen[part] += 1.0;
      if (windows[0].holds(x, y) || windows[1].holds(x, y)) above[part] += 1.0;
    }
  }
  std::optional<std::size_t> best;
  for (std::size_t p = 0; p < parts; ++p) {
    if (above[p] > 0.7 * seen[p] && above[p] > (best ? above[*best] : 20.0)) best = p;
  }
  return best;
}

/// Squares of how far controls of the brow move each place of the window: at each column, by rows.
struct Ways {
  std::vector<std::vector<std::optional<SurfacePlace>>> places;
  std::vector<std::vector<double>> squares;
  std::vector<std::vector<double>> middles;  ///< of each push, the middle row at each column; below 0: none
};

Ways ways_of(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface,
             const BrowWindow& window) {
  const FaceImage& image = surface.image();
  Ways ways;
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < k_columns; ++i) {
    auto& column = ways.places.emplace_back();
    for (int y = window.bottom; y <= window.top; y += 2)
      column.push_back(place_at(surface, window.column(i, k_columns), y));
    ways.squares.emplace_back(column.size(), 0.0);
  }
  // Where a push moves the skin most tells what it is for, so it is looked at on the whole face.
  for (int y = 0; y < image.height(); y += 3) {
    const auto row = vertices_seen(surface, 0, y, image.width() - 1, y);
    vertices.insert(vertices.end(), row.begin(), row.end());
  }
  for (const auto& column : ways.places) {
    for (const auto& place : column) {
      if (!place) continue;
      for (const std::uint32_t v : surface.mesh().triangles()[place->point.triangle]) vertices.push_back(v);
    }
  }
  std::stable_sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  PushField field(rig, surface, vertices);
  const double least = k_least_brow_way * window.unit * image.px();
  geometry::Box box;
  box.add(image.place(window.outer, window.bottom));
  box.add(image.place(window.inner, window.top));
  for (const Push& push : pushes_within(rig, whole, surface, box)) {
    field.set(push);
    double most = 0;
    ModelPoint where{0};
    double rise = 0;
    for (const std::uint32_t v : vertices) {
      const double way = geometry::length(field.of(v));
      if (way <= most) continue;
      most = way;
      where = surface.places()[v];
      rise = field.of(v).y;
    }
    if (most < least || std::abs(rise) < 0.4 * most) continue;
    if (!window.holds(image.column(where.x), image.row(where.y))) continue;
    auto& middles = ways.middles.emplace_back(k_columns, -1.0);
    for (std::size_t i = 0; i < k_columns; ++i) {
      double sum = 0, weights = 0;
      for (std::size_t r = 0; r < ways.places[i].size(); ++r) {
        if (!ways.places[i][r]) continue;
        const double way = geometry::length(field.of(ways.places[i][r]->point));
        const double weight = way * way;
        ways.squares[i][r] += weight;
        sum += weight * static_cast<double>(r);
        weights += weight;
      }
      if (weights > 0.05 * most * most) middles[i] = sum / weights;
    }
  }
  return ways;
}

/// How far the middles of different pushes are from each other, rows: root mean square.
double spread_of(const Ways& ways) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < k_columns; ++i) {
    for (const auto& a : ways.middles) {
      for (const auto& b : ways.middles) {
        if (a[i] < 0.0 || b[i] < 0.0) continue;
        squares += (a[i] - b[i]) * (a[i] - b[i]) / 2.0;
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? std::sqrt(squares / count) : 1e9;
}

FoundLine moved_middle(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface,
                       const BrowWindow& window) {
  const Ways ways = ways_of(rig, whole, surface, window);
  FoundLine line;
  if (ways.middles.empty()) return line;
  for (std::size_t i = 0; i < k_columns; ++i) {
    double sum = 0, weights = 0;
    for (std::size_t r = 0; r < ways.squares[i].size(); ++r) {
      sum += ways.squares[i][r] * static_cast<double>(r);
      weights += ways.squares[i][r];
    }
    if (!(weights > 0.0)) continue;
    const auto& place = ways.places[i][static_cast<std::size_t>(std::lround(sum / weights))];
    if (place) line.points.push_back(place->point);
  }
  // Rows are of two px.
  const double off = 2.0 * spread_of(ways) / (k_brows_apart * window.unit);
  const double many = std::min(1.0, 0.4 + 0.3 * static_cast<double>(ways.middles.size() - 1));
  line.sureness = k_of_fields * many / (1.0 + off * off);
  return line;
}

FoundLine ridge(const FaceSurface& surface, const BrowWindow& window) {
  FoundLine line;
  for (std::size_t i = 0; i < k_columns; ++i) {
    std::vector<std::optional<SurfacePlace>> walk;
    for (int y = window.bottom; y <= window.top; ++y) walk.push_back(place_at(surface, window.column(i, k_columns), y));
    const auto chord = static_cast<std::size_t>(std::max(2.0, 0.08 * window.unit));
    const std::vector<double> turns = turns_of(walk, chord);
    const auto most = static_cast<std::size_t>(std::max_element(turns.begin(), turns.end()) - turns.begin());
    if (!walk.empty() && walk[most]) line.points.push_back(walk[most]->point);
  }
  line.sureness = k_of_ridge;
  return line;
}

}  // namespace

std::array<FoundLine, 2> find_brows(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface,
                                    const SurfacePaint& paint, const std::array<Eye, 2>& eyes) {
  const double distance = geometry::distance(eyes[0].centre, eyes[1].centre);
  const std::array<BrowWindow, 2> windows{window_of(surface, eyes[0], false, distance),
                                          window_of(surface, eyes[1], true, distance)};
  for (const PiecePair& pair : find_piece_pairs(surface)) {
    auto right = drawn_piece(surface, windows[0], pair[0]);
    auto left = right ? drawn_piece(surface, windows[1], pair[1]) : std::nullopt;
    if (left) return {*right, *left};
  }
  if (const auto part = brow_part(surface, windows)) {
    const auto at = [&](int x, int y) -> std::optional<mesh::MeshPoint> {
      if (!surface.shows_skin(x, y)) return std::nullopt;
      if (part_of(surface.mesh(), surface.image().triangle(x, y)) != *part) return std::nullopt;
      return surface.at(x, y);
    };
    const auto right = middle_of(windows[0], at);
    const auto left = middle_of(windows[1], at);
    if (right && left) return {*right, *left};
  }
  std::array<FoundLine, 2> brows = find_painted_brows(surface, paint, windows);
  for (std::size_t side = 0; side < 2; ++side) {
    FoundLine moved = moved_middle(rig, whole, surface, windows[side]);
    if (moved.points.size() >= 8 && moved.sureness > brows[side].sureness) brows[side] = std::move(moved);
    if (brows[side].points.size() < 8) brows[side] = ridge(surface, windows[side]);
    brows[side].sureness *= eyes[side].upper.sureness;
  }
  return brows;
}

}  // namespace penpose::portrait
