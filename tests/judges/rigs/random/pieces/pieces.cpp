#include "tests/judges/rigs/random/pieces/pieces.h"

#include <algorithm>
#include <utility>

#include "core/base/math.h"

namespace penpose::judges {

Pieces::Pieces(const Parts& parts) : first_(parts.rest().size()) {
  source_.positions.assign(parts.rest().begin(), parts.rest().end());
  source_.triangles.assign(parts.mesh->triangles().begin(), parts.mesh->triangles().end());
  source_.parts.assign(parts.mesh->parts().begin(), parts.mesh->parts().end());
}

void Pieces::end_piece() {
  mesh::Part& part = source_.parts.back();
  part.vertex_count = static_cast<std::uint32_t>(source_.positions.size()) - part.first_vertex;
  part.triangle_count = static_cast<std::uint32_t>(source_.triangles.size()) - part.first_triangle;
}

void Pieces::begin(std::string name) {
  end_piece();
  source_.parts.push_back({std::move(name), static_cast<std::uint32_t>(source_.positions.size()), 0,
                           static_cast<std::uint32_t>(source_.triangles.size()), 0});
}

std::uint32_t Pieces::add(const ModelPoint& at, std::vector<Bound> with) {
  source_.positions.push_back(at);
  followers_.push_back({std::move(with), false});
  return static_cast<std::uint32_t>(source_.positions.size() - 1);
}

std::uint32_t Pieces::add_on_jaw(const ModelPoint& at, std::uint32_t chin, double share) {
  source_.positions.push_back(at);
  followers_.push_back({{{chin, share}}, true});
  return static_cast<std::uint32_t>(source_.positions.size() - 1);
}

void Pieces::strip(const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high) {
  for (std::size_t i = 0; i + 1 < low.size(); ++i) {
    triangle(low[i], low[i + 1], high[i + 1]);
    triangle(low[i], high[i + 1], high[i]);
  }
}

ModelVector Pieces::on_ball(std::size_t ring, std::size_t rings, std::size_t k, std::size_t around) {
  const double v = base::k_pi * (static_cast<double>(ring) + 0.5) / (static_cast<double>(rings) + 1);
  const double u = 2 * base::k_pi * static_cast<double>(k) / static_cast<double>(around);
  return {base::sin(u) * base::sin(v), base::cos(v), base::cos(u) * base::sin(v)};
}

std::uint32_t Pieces::nearest(const ModelPoint& at) const {
  std::uint32_t found = 0;
  double least = geometry::distance(at, source_.positions[0]);
  for (std::uint32_t v = 1; v < first_; ++v) {
    const double far = geometry::distance(at, source_.positions[v]);
    if (far >= least) continue;
    least = far;
    found = v;
  }
  return found;
}

void Pieces::attach(Parts& parts) && {
  if (followers_.empty()) return;
  end_piece();
  const std::size_t count = source_.positions.size();
  parts.mesh = mesh::TriangleMesh::build(std::move(source_)).value();
  for (auto& [name, field] : parts.fields) {
    const bool jaw = name.starts_with("jaw_");
    const bool everything = name == "all";
    field.resize(count, ModelVector{0});
    for (std::size_t k = 0; k < followers_.size(); ++k) {
      const Follower& one = followers_[k];
      if (one.jaw_only && !jaw && !everything) continue;
      for (const Bound& bound : one.with) field[first_ + k] += field[bound.to] * bound.share;
      // The whole head goes as one.
      if (everything) field[first_ + k] = field[one.with.empty() ? 0 : one.with.front().to];
    }
  }
  parts.jaw_share.resize(count, 0.0);
  for (std::size_t k = 0; k < followers_.size(); ++k) {
    double share = 0;
    for (const Bound& bound : followers_[k].with) share += bound.share * parts.jaw_share[bound.to];
    parts.jaw_share[first_ + k] = std::clamp(followers_[k].jaw_only ? 1.0 : share, 0.0, 1.0);
  }
  if (parts.skin == 0) parts.skin = first_;
}

}  // namespace penpose::judges
