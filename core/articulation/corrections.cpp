#include "core/articulation/corrections.h"

#include <algorithm>
#include <set>

namespace penpose::articulation {
namespace {

using Lever = Corrections::Lever;

double amount_of(std::span<const Lever> levers, std::span<const double> pose) {
  double amount = 1;
  for (const Lever& one : levers) {
    amount *= std::clamp((pose[one.parameter] - one.rest) / (one.value - one.rest), 0.0, 1.0);
  }
  return amount;
}

/// Corrections at a few vertices.
class BoundCorrections final : public rig::BoundLayer {
 public:
  BoundCorrections(const Corrections& all, std::span<const std::uint32_t> vertices) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Correction& correction = *all.all()[i];
      Part part;
      for (std::uint32_t place = 0; place < vertices.size(); ++place) {
        const auto found = std::lower_bound(correction.vertices.begin(), correction.vertices.end(), vertices[place]);
        if (found == correction.vertices.end() || *found != vertices[place]) continue;
        part.places.push_back(place);
        part.moves.push_back(correction.moves[static_cast<std::size_t>(found - correction.vertices.begin())]);
      }
      if (part.places.empty()) continue;
      part.levers.assign(all.levers(i).begin(), all.levers(i).end());
      parts_.push_back(std::move(part));
    }
  }

  void add(std::span<const double> pose, std::span<ModelVector> displacements) override {
    for (const Part& part : parts_) {
      const double amount = amount_of(part.levers, pose);
      if (amount == 0.0) continue;
      for (std::size_t k = 0; k < part.places.size(); ++k) displacements[part.places[k]] += part.moves[k] * amount;
    }
  }
  [[nodiscard]] bool moves(std::size_t parameter) const override {
    return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
      return std::any_of(part.levers.begin(), part.levers.end(),
                         [&](const Lever& lever) { return lever.parameter == parameter; });
    });
  }
  bool column(std::size_t parameter, std::span<ModelVector> displacements) const override {
    std::fill(displacements.begin(), displacements.end(), ModelVector{0});
    return !moves(parameter);
  }

 private:
  struct Part {
    std::vector<Lever> levers;
    std::vector<std::uint32_t> places;
    std::vector<ModelVector> moves;
  };
  std::vector<Part> parts_;
};

}  // namespace

base::Result<std::shared_ptr<const Correction>> build_correction(CorrectionSketch drawn,
                                                                 std::shared_ptr<const Canvas> canvas) {
  if (drawn.drivers.size() < k_fewest_drivers || drawn.drivers.size() > k_most_drivers) {
    return base::Error{"a correction is for a pose that 2 to 8 controls make together", "drivers",
                       "name the controls and their values"};
  }
  if (!drawn.sketch.betweens.empty()) {
    return base::Error{"a correction has one target", "betweens", "draw another correction at another pose"};
  }
  auto built = build_deformer(drawn.sketch, *canvas);
  if (!built) return built.error();
  Correction correction{std::move(drawn), {}, {}, std::move(canvas), std::move(*built)};
  const Deformer& deformer = *correction.deformer;
  correction.vertices.assign(deformer.vertices().begin(), deformer.vertices().end());
  correction.moves = deformer.displacements(1.0);
  return std::make_shared<const Correction>(std::move(correction));
}

base::Result<Corrections::Shared> Corrections::make(std::vector<std::shared_ptr<const Correction>> corrections,
                                                    std::span<const rig::Parameter> parameters) {
  auto made = std::make_shared<Corrections>();
  std::set<std::string> names;
  for (std::size_t i = 0; i < corrections.size(); ++i) {
    const CorrectionSketch& drawn = corrections[i]->drawn;
    if (!names.insert(drawn.sketch.name).second) {
      return base::Error{"another correction is called '" + drawn.sketch.name + "' too", std::to_string(i) + "/name",
                         "rename one of them"};
    }
    std::vector<Lever> levers;
    std::set<std::size_t> known;
    for (std::size_t k = 0; k < drawn.drivers.size(); ++k) {
      const Driver& driver = drawn.drivers[k];
      const std::string place = std::to_string(i) + "/drivers/" + std::to_string(k);
      const auto parameter = rig::find_parameter(parameters, driver.control);
      if (!parameter) {
        return base::Error{"there is no control \"" + driver.control + "\"", place, "look at the names in the model"};
      }
      if (!known.insert(*parameter).second) return base::Error{"the control is named twice", place, "name it once"};
      const rig::Parameter& one = parameters[*parameter];
      if (driver.value == one.rest || !(driver.value >= one.minimum && driver.value <= one.maximum)) {
        return base::Error{"the control \"" + driver.control + "\" rests at that value or cannot have it", place,
                           "give the value that it has in the corrected pose"};
      }
      levers.push_back({*parameter, one.rest, driver.value});
    }
    made->levers_.push_back(std::move(levers));
  }
  made->corrections_ = std::move(corrections);
  return Shared(std::move(made));
}

double Corrections::amount(std::size_t correction, std::span<const double> pose) const {
  return amount_of(levers_[correction], pose);
}

void Corrections::add(std::span<const double> pose, std::span<ModelVector> displacements) const {
  for (std::size_t i = 0; i < corrections_.size(); ++i) {
    const double amount = amount_of(levers_[i], pose);
    if (amount == 0.0) continue;
    const Correction& one = *corrections_[i];
    for (std::size_t k = 0; k < one.vertices.size(); ++k) displacements[one.vertices[k]] += one.moves[k] * amount;
  }
}

std::unique_ptr<rig::BoundLayer> Corrections::bind(std::span<const std::uint32_t> vertices) const {
  return std::make_unique<BoundCorrections>(*this, vertices);
}

void add_to_hash(base::StateHash& hash, const CorrectionSketch& correction) {
  hash.add("correction");
  add_to_hash(hash, correction.sketch);
  hash.add(std::uint64_t{correction.drivers.size()});
  for (const Driver& driver : correction.drivers) {
    hash.add(driver.control);
    hash.add(driver.value);
  }
}

}  // namespace penpose::articulation
