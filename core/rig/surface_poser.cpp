#include "core/rig/surface_poser.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/algebra/simd.h"

namespace penpose::rig {
namespace {

using algebra::Float4;
constexpr std::uint32_t k_block = 4;

Float4 load(const float* p) {
  Float4 value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
/// Three floats and whatever follows them.
Float4 load(const glm::vec3& p) { return load(&p.x); }

/// y z x of a vector, which turns a cross product into two products of whole registers.
Float4 turned(Float4 a) { return __builtin_shufflevector(a, a, 1, 2, 0, 3); }
Float4 cross(Float4 a, Float4 b) { return turned(a * turned(b) - turned(a) * b); }

}  // namespace

SurfacePoser::SurfacePoser(std::shared_ptr<const CharacterRig> rig)
    : rig_(std::move(rig)), rings_(rig_->mesh()), vertex_count_(rig_->vertex_count()) {
  const std::size_t blocks = (vertex_count_ + k_block - 1) / k_block;
  positions_.resize(blocks * k_block + 1, glm::vec3(0));
  normals_.resize(vertex_count_, glm::vec3(0, 0, 1));
  const auto* shapes = rig_->layers().size() == 1 ? dynamic_cast<const BlendShapes*>(rig_->layers()[0].get()) : nullptr;
  blend_only_ = rig_->skeleton() == nullptr && (shapes != nullptr || rig_->layers().empty());
  pose_ = rest_pose(*rig_);
  if (blend_only_) {
    rest_.resize(blocks * k_block, glm::vec3(0));
    for (std::size_t v = 0; v < vertex_count_; ++v) rest_[v] = glm::vec3(rig_->mesh().positions()[v]);
    std::copy(rest_.begin(), rest_.end(), positions_.begin());
    block_changed_.assign(blocks, 0);
    first_delta_.assign(blocks + 1, 0);
    changed_shapes_.assign((pose_.size() + 63) / 64, 0);
    block_shapes_.assign(blocks * changed_shapes_.size(), 0);
    if (shapes != nullptr) build_blocks(*shapes);
    build_neighbors();
    weights_.assign(pose_.size(), 0.0F);
    update_blocks(pose_);
    update_normals_of(0, static_cast<std::uint32_t>(vertex_count_));
  } else {
    update_everything(pose_);
  }
}

void SurfacePoser::build_blocks(const BlendShapes& shapes) {
  std::vector<std::uint32_t> used;
  for (std::uint32_t first = 0; first < vertex_count_; first += k_block) {
    const auto last = std::min(first + k_block, static_cast<std::uint32_t>(vertex_count_));
    used.clear();
    for (std::uint32_t v = first; v < last; ++v) {
      for (const auto& entry : shapes.entries_of(v)) used.push_back(entry.shape);
    }
    std::stable_sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const std::size_t begin = deltas_.size();
    deltas_.resize(begin + used.size(), BlockDelta{});
    delta_shape_.insert(delta_shape_.end(), used.begin(), used.end());
    for (std::uint32_t v = first; v < last; ++v) {
      for (const auto& entry : shapes.entries_of(v)) {
        const auto place = std::lower_bound(used.begin(), used.end(), entry.shape) - used.begin();
        float* out = deltas_[begin + static_cast<std::size_t>(place)].values.data() + 3 * (v - first);
        out[0] = entry.delta.x;
        out[1] = entry.delta.y;
        out[2] = entry.delta.z;
      }
    }
    for (const std::uint32_t s : used)
      block_shapes_[first / k_block * changed_shapes_.size() + s / 64] |= std::uint64_t{1} << (s % 64);
    first_delta_[first / k_block + 1] = static_cast<std::uint32_t>(deltas_.size());
  }
}

void SurfacePoser::build_neighbors() {
  std::vector<std::uint32_t> around;
  first_neighbor_.push_back(0);
  for (std::uint32_t first = 0; first < vertex_count_; first += k_block) {
    const auto last = std::min(first + k_block, static_cast<std::uint32_t>(vertex_count_));
    around.clear();
    for (std::uint32_t v = first; v < last; ++v) {
      for (const auto& quad : rings_.quads(rings_.leader(v))) {
        for (const std::uint32_t corner : quad) around.push_back(corner / k_block);
      }
    }
    std::stable_sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    neighbors_.insert(neighbors_.end(), around.begin(), around.end());
    first_neighbor_.push_back(static_cast<std::uint32_t>(neighbors_.size()));
  }
}

bool SurfacePoser::update(std::span<const double> pose) {
  if (std::equal(pose.begin(), pose.end(), pose_.begin(), pose_.end())) return false;
  if (blend_only_) {
    update_blocks(pose);
    for (std::uint32_t b = 0; b < block_changed_.size(); ++b) {
      const auto around =
          std::span(neighbors_).subspan(first_neighbor_[b], first_neighbor_[b + 1] - first_neighbor_[b]);
      if (std::any_of(around.begin(), around.end(), [&](std::uint32_t n) { return block_changed_[n] != 0; })) {
        update_normals_of(b * k_block, std::min((b + 1) * k_block, static_cast<std::uint32_t>(vertex_count_)));
      }
    }
  } else {
    update_everything(pose);
  }
  pose_.assign(pose.begin(), pose.end());
  ++revision_;
  return true;
}

void SurfacePoser::update_blocks(std::span<const double> values) {
  std::fill(changed_shapes_.begin(), changed_shapes_.end(), std::uint64_t{0});
  for (std::size_t s = 0; s < values.size(); ++s) {
    const auto weight = static_cast<float>(values[s]);
    if (weight != weights_[s]) changed_shapes_[s / 64] |= std::uint64_t{1} << (s % 64);
    weights_[s] = weight;
  }
  const std::size_t words = changed_shapes_.size();
  const float* weights = weights_.data();
  for (std::size_t b = 0; b + 1 < first_delta_.size(); ++b) {
    std::uint64_t any = 0;
    for (std::size_t w = 0; w < words; ++w) any |= block_shapes_[b * words + w] & changed_shapes_[w];
    block_changed_[b] = any != 0 ? 1 : 0;
    if (any == 0) continue;
    const float* rest = &rest_[b * k_block].x;
    Float4 first = load(rest);
    Float4 second = load(rest + 4);
    Float4 third = load(rest + 8);
    for (std::uint32_t i = first_delta_[b]; i < first_delta_[b + 1]; ++i) {
      const Float4 weight = algebra::splat(weights[delta_shape_[i]]);
      const float* delta = deltas_[i].values.data();
      first += weight * load(delta);
      second += weight * load(delta + 4);
      third += weight * load(delta + 8);
    }
    float* out = &positions_[b * k_block].x;
    std::memcpy(out, &first, sizeof first);
    std::memcpy(out + 4, &second, sizeof second);
    std::memcpy(out + 8, &third, sizeof third);
  }
}

void SurfacePoser::update_everything(std::span<const double> pose) {
  scratch_.resize(vertex_count_);
  rig_->evaluate(pose, scratch_);
  for (std::size_t v = 0; v < vertex_count_; ++v) positions_[v] = glm::vec3(scratch_[v]);
  update_normals_of(0, static_cast<std::uint32_t>(vertex_count_));
}

void SurfacePoser::update_normals_of(std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t begin = first; begin < last; begin += k_block) {
    // Four sums, then one square root and one division for the four.
    std::array<Float4, k_block> sums;
    sums.fill(algebra::splat(0.0F));
    const std::uint32_t count = std::min(k_block, last - begin);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      Float4 sum = algebra::splat(0.0F);
      for (const auto& [a, b, c, d] : rings_.quads(rings_.leader(begin + lane))) {
        sum += cross(load(positions_[c]) - load(positions_[a]), load(positions_[d]) - load(positions_[b]));
      }
      sums[lane] = sum;
    }
    Float4 squared;
    for (std::uint32_t lane = 0; lane < k_block; ++lane) {
      const Float4 square = sums[lane] * sums[lane];
      squared[static_cast<int>(lane)] = square[0] + square[1] + square[2];
    }
    const Float4 length = {std::sqrt(squared[0]), std::sqrt(squared[1]), std::sqrt(squared[2]), std::sqrt(squared[3])};
    const Float4 inverse = algebra::splat(1.0F) / length;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      if (!(squared[static_cast<int>(lane)] > 0.0F)) {
        normals_[begin + lane] = glm::vec3(0, 0, 1);
        continue;
      }
      const Float4 unit = sums[lane] * algebra::splat(inverse[static_cast<int>(lane)]);
      std::memcpy(&normals_[begin + lane].x, &unit, 3 * sizeof(float));
    }
  }
}

}  // namespace penpose::rig
