#pragma once

#include "core/inference/weights.h"
#include "core/intent/choosing/selection.h"

namespace penpose::intent {

/// How variables stand to each other near the drawn curves.
class Relations {
 public:
  virtual ~Relations() = default;
  /// The cosine of what two variables do there; 1 where both turn one joint.
  [[nodiscard]] virtual double likeness(std::size_t a, std::size_t b) const = 0;
  /// How much they move the same places, in whatever direction: 0 to 1.
  [[nodiscard]] virtual double overlap(std::size_t a, std::size_t b) const = 0;
  /// Whether a variable is a joint's.
  [[nodiscard]] virtual bool is_joint(std::size_t variable) const = 0;
  /// Whether a variable moves a curve of a group.
  [[nodiscard]] virtual bool moves_group(std::size_t variable, std::size_t group) const = 0;
};

/// Computes the costs of readings of lines on faces (inference::Weights).
class ReadingCosts final : public ChoiceCosts {
 public:
  /// `asked`: for each group of curves the largest D before anything moves.
  ReadingCosts(const Choices& choices, const inference::Weights& weights, const Relations& relations,
               std::span<const double> asked)
      : choices_(choices), weights_(weights), relations_(relations), asked_(asked) {}

  [[nodiscard]] double costs_of(const Choice& choice) const override;
  /// Ends of ranges cost nothing.
  [[nodiscard]] double limit_costs(const Choice&) const override { return 0.0; }
  /// Of the squares of its values.
  [[nodiscard]] double stiffness_of(const Choice& choice) const;
  /// Without those that move one group of curves and no other.
  [[nodiscard]] std::vector<std::size_t> units_besides(std::vector<std::size_t> units, std::size_t group) const;
  /// What the units of a choice cost that move one group of curves and no other.
  [[nodiscard]] double costs_for(const Choice& choice, std::size_t group) const;
  /// Of one more unit beside those of a choice, apart from its value and from cost_of_relations, which is never less
  /// than 0.
  [[nodiscard]] double least_cost_beside(const Choice& choice, std::size_t unit) const;
  /// Of how one more unit stands to others.
  [[nodiscard]] double cost_of_relations(std::span<const std::size_t> units, std::size_t unit) const;
  /// Whether two units cannot move together.
  [[nodiscard]] bool excludes(std::size_t a, std::size_t b) const;
  [[nodiscard]] const Choices& choices() const { return choices_; }
  [[nodiscard]] const inference::Weights& weights() const { return weights_; }
  /// Returns the terms whose weighted sum is costs_of and stiffness_of together.
  [[nodiscard]] inference::Terms terms_of(const Choice& choice) const;

 private:
  /// Of the members' pairs the one farthest from 0.
  [[nodiscard]] double likeness(std::size_t a, std::size_t b) const;
  [[nodiscard]] double overlap(std::size_t a, std::size_t b) const;
  void add_relations(std::span<const std::size_t> units, std::size_t unit, inference::Terms& terms) const;
  /// Of the groups that none of the units moves: a line that asks for more than the hand's doubt is not drawn for
  /// nothing.
  [[nodiscard]] double cost_of_nothing(std::span<const std::size_t> units) const;
  [[nodiscard]] double cost_of_nothing(std::size_t group) const;
  /// Returns by how many decades a group asks for more than a hand strays.
  [[nodiscard]] double decades_asked(std::size_t group) const;
  /// Returns the units of a choice that move anything noticeable.
  [[nodiscard]] std::vector<std::size_t> moving(const Choice& choice) const;
  [[nodiscard]] bool moves(std::size_t unit, std::size_t group) const;

  const Choices& choices_;
  const inference::Weights& weights_;
  const Relations& relations_;
  std::span<const double> asked_;
};

}  // namespace penpose::intent
