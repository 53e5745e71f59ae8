#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/base/math.h"
#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

/// A grid seen from its front, cut open along three runs of a row: there each vertex is there twice, above and below.
class Grid {
 public:
  struct Cut {
    std::uint32_t row, first, last;  ///< the ends stay one vertex
  };

  Grid(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {
    for (std::uint32_t r = 0; r < rows; ++r) {
      for (std::uint32_t c = 0; c < columns; ++c) source_.positions.push_back(place(u(c), v(r)));
    }
    twin_.resize(source_.positions.size());
    for (std::uint32_t i = 0; i < twin_.size(); ++i) twin_[i] = i;
  }
  void cut(const Cut& at, double up, double down) {
    for (std::uint32_t c = at.first + 1; c < at.last; ++c) {
      const std::uint32_t i = above(at.row, c);
      twin_[i] = static_cast<std::uint32_t>(source_.positions.size());
      const double t = static_cast<double>(c - at.first) / (at.last - at.first);
      const double open = base::sin(base::k_pi * t);
      source_.positions.push_back(source_.positions[i] - ModelVector{0, down * open, 0});
      source_.positions[i].y += up * open;
    }
  }
  [[nodiscard]] std::shared_ptr<const mesh::TriangleMesh> mesh() {
    for (std::uint32_t r = 0; r + 1 < rows_; ++r) {
      for (std::uint32_t c = 0; c + 1 < columns_; ++c) {
        const std::uint32_t a = above(r, c);
        const std::uint32_t b = above(r, c + 1);
        const std::uint32_t top_a = below(r + 1, c);
        const std::uint32_t top_b = below(r + 1, c + 1);
        source_.triangles.push_back({a, b, top_b});
        source_.triangles.push_back({a, top_b, top_a});
      }
    }
    return mesh::TriangleMesh::build(source_).value();
  }
  [[nodiscard]] std::uint32_t above(std::uint32_t r, std::uint32_t c) const { return r * columns_ + c; }
  [[nodiscard]] std::uint32_t below(std::uint32_t r, std::uint32_t c) const { return twin_[above(r, c)]; }
  [[nodiscard]] double u(std::uint32_t c) const { return 2.0 * c / (columns_ - 1) - 1; }
  [[nodiscard]] double v(std::uint32_t r) const { return 2.0 * r / (rows_ - 1) - 1; }
  [[nodiscard]] std::uint32_t row_at(double v) const { return nearest(v, rows_); }
  [[nodiscard]] std::uint32_t column_at(double u) const { return nearest(u, columns_); }

 private:
  static std::uint32_t nearest(double x, std::uint32_t count) {
    return static_cast<std::uint32_t>((x + 1) / 2 * (count - 1) + 0.5);
  }
  static ModelPoint place(double u, double v) {
    const double muzzle = base::exp(-(u * u / 0.2 + (v + 0.35) * (v + 0.35) / 0.12));
    return {0.8 * u * (1 - 0.15 * v * v), v, 0.7 * (1 - 0.5 * u * u - 0.35 * v * v) + 0.35 * muzzle};
  }

  std::uint32_t columns_, rows_;
  mesh::MeshSource source_;
  std::vector<std::uint32_t> twin_;
};

std::vector<std::uint32_t> along(const Grid& grid, const Grid::Cut& cut, int rows_off, bool upper) {
  std::vector<std::uint32_t> line{grid.above(cut.row, cut.first)};
  for (std::uint32_t c = cut.first + 1; c < cut.last; ++c) {
    const auto row = static_cast<std::uint32_t>(static_cast<int>(cut.row) + rows_off);
    line.push_back(upper ? grid.above(row, c) : grid.below(row, c));
  }
  line.push_back(grid.above(cut.row, cut.last));
  return line;
}

/// From -x to +x, or from the inner to the outer end.
std::vector<std::uint32_t> outwards(std::vector<std::uint32_t> line, bool left) {
  if (!left) std::reverse(line.begin(), line.end());
  return line;
}

void add_eye(Parts& parts, const Grid& grid, const Grid::Cut& eye, const std::string& side) {
  Field blink(parts.rest().size(), ModelVector{0});
  Field wide = blink;
  Field squint = blink;
  for (std::uint32_t c = eye.first + 1; c < eye.last; ++c) {
    const std::uint32_t upper = grid.above(eye.row, c);
    const std::uint32_t lower = grid.below(eye.row, c);
    const ModelVector shut = parts.rest()[lower] - parts.rest()[upper];
    blink[upper] = shut;
    blink[grid.above(eye.row + 1, c)] = shut * 0.35;
    wide[upper] = shut * -0.35;
    wide[grid.above(eye.row + 1, c)] = shut * -0.15;
    squint[lower] = shut * -0.45;
    squint[grid.below(eye.row - 1, c)] = shut * -0.2;
  }
  parts.fields["blink" + side] = std::move(blink);
  parts.fields["wide" + side] = std::move(wide);
  parts.fields["squint" + side] = std::move(squint);
}

void add_side(Parts& parts, bool left) {
  const std::string side = left ? "_L" : "_R";
  const double out = left ? 1 : -1;
  const auto bump = [&](const ModelPoint& center, double size, const ModelVector& way) {
    return pushed(around(parts.rest(), center, ModelVector{size, 0.8 * size, 1.5 * size}),
                  ModelVector{out * way.x, way.y, way.z});
  };
  const auto& lip = parts.line("lip_upper");
  const ModelPoint corner = parts.rest()[left ? lip.back() : lip.front()];
  parts.fields["smile" + side] = bump(corner, 0.3, {0.05, 0.15, -0.04});
  parts.fields["frown" + side] = bump(corner, 0.3, {0, -0.13, 0});
  parts.fields["cheek" + side] = bump(corner + ModelVector{out * 0.15, 0.25, 0}, 0.3, {0, 0.08, 0.04});
  const ModelPoint nose = parts.rest()[parts.line("nose_bridge").back()];
  parts.fields["sneer" + side] = bump(nose + ModelVector{out * 0.12, 0, 0}, 0.2, {0, 0.09, 0.02});
  const auto& brow = parts.line("brow" + side);
  const ModelPoint inner = parts.rest()[brow.front()];
  const ModelPoint outer = parts.rest()[brow.back()];
  parts.fields["brow_inner_up" + side] = bump(inner, 0.25, {0, 0.13, 0});
  parts.fields["brow_outer_up" + side] = bump(outer, 0.3, {0, 0.13, 0});
  Field down = bump(inner, 0.28, {-0.05, -0.12, 0});
  add_to(down, 0.3, bump(outer, 0.3, {0, -0.13, 0}));
  parts.fields["brow_down" + side] = std::move(down);
  std::vector<double> above;
  for (const double share : parts.jaw_share) above.push_back(1 - share);
  const auto upper = around(parts.rest(), parts.rest()[lip[lip.size() / 2]], {0.3, 0.16, 0.4});
  parts.fields["upper_up" + side] =
      pushed(product(product(upper, above), side_share(parts.rest(), left, 0.15)), {0, 0.1, 0.03});
}

}  // namespace

Parts creature_parts(std::uint32_t columns, std::uint32_t rows) {
  Grid grid(columns, rows);
  const Grid::Cut mouth{grid.row_at(-0.42), grid.column_at(-0.45), grid.column_at(0.45)};
  const std::uint32_t eyes = grid.row_at(0.3);
  const Grid::Cut eye_L{eyes, grid.column_at(0.22), grid.column_at(0.67)};
  const Grid::Cut eye_R{eyes, grid.column_at(-0.67), grid.column_at(-0.22)};
  grid.cut(mouth, 0, 0);
  for (const Grid::Cut& eye : {eye_L, eye_R}) grid.cut(eye, 0.09, 0.05);

  Parts parts;
  parts.mesh = grid.mesh();
  parts.lines = {{"lip_upper", along(grid, mouth, 1, true)},
                 {"lip_lower", along(grid, mouth, -1, false)},
                 {"lip_upper_inner", along(grid, mouth, 0, true)},
                 {"lip_lower_inner", along(grid, mouth, 0, false)}};
  for (const bool left : {true, false}) {
    const std::string side = left ? "_L" : "_R";
    const Grid::Cut& eye = left ? eye_L : eye_R;
    parts.lines.push_back({"eyelid_upper" + side, outwards(along(grid, eye, 0, true), left)});
    parts.lines.push_back({"eyelid_lower" + side, outwards(along(grid, eye, 0, false), left)});
    FaceLine brow{"brow" + side, {}};
    const std::uint32_t row = grid.row_at(0.62);
    for (std::uint32_t c = grid.column_at(left ? 0.2 : -0.75); c <= grid.column_at(left ? 0.75 : -0.2); ++c)
      brow.vertices.push_back(grid.above(row, c));
    brow.vertices = outwards(std::move(brow.vertices), left);
    parts.lines.push_back(std::move(brow));
  }
  FaceLine jaw{"jaw", {}};
  for (std::uint32_t c = 2; c + 2 < columns; ++c) jaw.vertices.push_back(grid.above(1, c));
  FaceLine nose{"nose_bridge", {}};
  for (std::uint32_t r = eyes; r > grid.row_at(-0.15); --r) nose.vertices.push_back(grid.above(r, columns / 2));
  parts.lines.push_back(std::move(jaw));
  parts.lines.push_back(std::move(nose));

  const auto& lip = parts.line("lip_upper");
  parts.mouth = 0.5 * geometry::distance(parts.rest()[lip.front()], parts.rest()[lip.back()]);
  const double line = grid.v(mouth.row);
  for (const ModelPoint& p : parts.rest())
    parts.jaw_share.push_back(p.y < line - 0.01 ? smooth_step(0.75, 0.3, std::abs(p.x)) : 0.0);
  for (std::uint32_t c = mouth.first + 1; c < mouth.last; ++c) parts.jaw_share[grid.below(mouth.row, c)] = 1;

  parts.fields["jaw_open"] = turned(parts.rest(), parts.jaw_share, {0, -0.2, 0.1}, {1, 0, 0}, 20);
  const auto near = around(parts.rest(), {0, line, 0.9}, {0.5, 0.3, 0.6});
  Field pucker(near.size());
  for (std::size_t v = 0; v < near.size(); ++v) pucker[v] = ModelVector{-0.4 * parts.rest()[v].x, 0, 0.1} * near[v];
  parts.fields["pucker"] = std::move(pucker);
  for (const bool left : {true, false}) {
    add_eye(parts, grid, left ? eye_L : eye_R, left ? "_L" : "_R");
    add_side(parts, left);
  }
  add_mouth_fields(parts);
  return parts;
}

}  // namespace penpose::judges
