#include <algorithm>
#include <iterator>

#include "tests/judges/cases/picture.h"
#include "tests/judges/hands/hand.h"
#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/least_sum.h"
#include "tests/judges/measures/measure.h"
#include "tests/support/random.h"

namespace penpose::judges {
namespace {

/// The lines of known poses with the true place of each vertex as its target, met by the true pose.
std::vector<KnownFace> exact_faces(const Rig& rig) {
  std::vector<KnownFace> faces;
  for (KnownFace& face : known_faces(rig, Extent::brief)) {
    const std::string name = face.asked.name.substr(0, face.asked.name.find('/'));
    if (name.starts_with("still_") || (!faces.empty() && faces.back().asked.name == name)) continue;
    const auto places = posed(rig.model, face.truth);
    for (io::CaseReference& reference : face.asked.references) {
      reference.target.clear();
      for (const std::uint32_t v : reference.vertices) reference.target.push_back(places[v]);
    }
    face.asked.name = name;
    face.asked.optimum_energy = 0;
    face.hand.clear();
    faces.push_back(std::move(face));
  }
  return faces;
}

/// What each control that moves the lines of a case does to their vertices. Precondition: no joints.
std::vector<std::vector<ModelVector>> columns_of(const document::Model& model, const io::PoseCase& one) {
  const rig::Pose rest = rig::rest_pose(*model.rig);
  const auto from = posed(model, rest);
  std::vector<std::vector<ModelVector>> columns;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    rig::Pose pose = rest;
    pose[i] = model.rig->parameters()[i].maximum;
    const auto to = posed(model, pose);
    std::vector<ModelVector> column;
    bool moves = false;
    for (const io::CaseReference& reference : one.references) {
      for (const std::uint32_t v : reference.vertices) {
        column.push_back(to[v] - from[v]);
        moves = moves || column.back() != ModelVector{0};
      }
    }
    if (moves) columns.push_back(std::move(column));
  }
  return columns;
}

/// The same with targets that no pose meets: each line is off as a whole, and each of its points a little more. The
/// least energy is found by a method of its own.
std::vector<KnownFace> missed_faces(const Rig& rig, const std::vector<KnownFace>& exact) {
  std::vector<KnownFace> faces;
  const auto rest = posed(rig.model, rig::rest_pose(*rig.model.rig));
  const double size = size_of(rest, rig.lines);
  for (KnownFace face : exact) {
    face.asked.name += "/missed";
    tests::Random random(seed_of(rig.name, face.asked.name));
    std::vector<ModelVector> goals;
    for (io::CaseReference& reference : face.asked.references) {
      const ModelVector off = random.vector(0.02 * size);
      for (std::size_t i = 0; i < reference.target.size(); ++i) {
        reference.target[i] += off + random.vector(0.004 * size);
        goals.push_back(reference.target[i] - rest[reference.vertices[i]]);
      }
    }
    face.asked.optimum_energy = least_sum_of_distances(columns_of(rig.model, face.asked), goals);
    faces.push_back(std::move(face));
  }
  return faces;
}

/// The sum of distances, recomputed.
double energy_of(const WholeFace& face, const io::PoseCase& one, const std::vector<ModelVector>& moved) {
  double sum = 0;
  for (const io::CaseReference& reference : one.references) {
    for (std::size_t i = 0; i < reference.vertices.size(); ++i) {
      const std::uint32_t v = reference.vertices[i];
      sum += geometry::distance(face.rest()[v] + moved[v], reference.target[i]);
    }
  }
  for (const io::CaseConstraint& constraint : one.constraints) {
    for (const std::uint32_t v : constraint.vertices) sum += geometry::length(moved[v]);
  }
  return sum;
}

bool is_face(const Rig& rig) { return !rig.lines.empty(); }

}  // namespace

std::vector<Outcome> judge_exact(const document::Model& model, const std::vector<KnownFace>& cases) {
  CaseSet set(model, cases);
  const WholeFace& face = set.whole();
  const std::vector<ModelVector> still(face.rest().size(), ModelVector{0});
  return set.outcomes(Ask::exact, [&](const KnownFace& one, const rig::Pose& pose, Outcome& outcome) {
    const double rest = one.asked.rest_energy.value_or(energy_of(face, one.asked, still));
    const double least = one.asked.optimum_energy.value_or(0);
    const double gap = (energy_of(face, one.asked, face.moved(pose)) - least) / (rest - least);
    // The reference may end a little above the least itself.
    outcome.error = 100 * std::max(gap, 0.0);
    face.count_controls(pose, outcome);
  });
}

std::vector<Outcome> judge_meant(const document::Model& model, const std::vector<KnownFace>& cases) {
  CaseSet set(model, cases);
  return set.outcomes(Ask::points, [&](const KnownFace& one, const rig::Pose& pose, Outcome& outcome) {
    set.whole().judge(set.whole().moved(one.truth), set.whole().moved(pose), outcome);
    set.whole().count_controls(pose, outcome);
    outcome.true_controls = one.true_controls;
  });
}

Measure exact_measure() {
  return {"exact", is_face, [](const Rig& rig, Extent) {
            auto cases = exact_faces(rig);
            // Joints turn: their least sum has no method that is as sure.
            if (!rig.model.skeleton) {
              auto missed = missed_faces(rig, cases);
              std::move(missed.begin(), missed.end(), std::back_inserter(cases));
            }
            return judge_exact(rig.model, cases);
          }};
}
Measure meant_measure() {
  return {"meant", is_face, [](const Rig& rig, Extent) { return judge_meant(rig.model, exact_faces(rig)); }};
}

}  // namespace penpose::judges
