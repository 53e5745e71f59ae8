#include "tests/learn/fit.h"

#include <gtest/gtest.h>

namespace penpose::learn {
namespace {

using inference::Term;
using inference::Terms;

LearnCase case_of(double right_unit, double right_evidence, double wrong_unit, double wrong_evidence) {
  LearnCase one{"rig", "case", {{{}, true, {}}, {{}, false, {}}}, 1};
  one.candidates[0].terms[Term::unit] = right_unit;
  one.candidates[0].terms[Term::evidence] = right_evidence;
  one.candidates[1].terms[Term::unit] = wrong_unit;
  one.candidates[1].terms[Term::evidence] = wrong_evidence;
  return one;
}

Terms evidence_alone() {
  Terms by;
  by[Term::evidence] = 1;
  return by;
}

Widths unit_alone() {
  Widths widths;
  widths[Term::unit] = 10;
  return widths;
}

TEST(Fit, FindsTheWeightThatMakesRightReadingsLikely) {
  // A second unit gains 3 and is not meant.
  const std::vector<LearnCase> cases(20, case_of(1, 5, 2, 2));
  const Terms by = fit(cases, evidence_alone(), unit_alone());
  EXPECT_GT(by[Term::unit], 3);
  EXPECT_EQ(score(cases, evidence_alone()).right, 0);
  EXPECT_EQ(score(cases, by).right, 1);
  EXPECT_LT(score(cases, by).loss, score(cases, evidence_alone()).loss);
}

TEST(Fit, NoWeightIsNegative) {
  // Here the second unit is meant although the first one alone fits as well.
  const std::vector<LearnCase> cases(20, case_of(2, 2, 1, 2));
  EXPECT_EQ(fit(cases, evidence_alone(), unit_alone())[Term::unit], 0);
}

TEST(Fit, TermsWithoutWidthStay) {
  const std::vector<LearnCase> cases(20, case_of(1, 5, 2, 2));
  Terms by = evidence_alone();
  by[Term::unit] = 0.25;
  EXPECT_EQ(fit(cases, by, {})[Term::unit], 0.25);
}

TEST(Fit, AFewWrongLabelsDoNotTurnTheWeight) {
  std::vector<LearnCase> cases(40, case_of(1, 5, 2, 2));
  cases.push_back(case_of(60, 0, 1, 5));
  EXPECT_GT(fit(cases, evidence_alone(), unit_alone())[Term::unit], 3);
}

TEST(Score, CountsCasesThatHaveARightReading) {
  std::vector<LearnCase> cases{case_of(1, 0, 1, 5), case_of(1, 5, 1, 0)};
  LearnCase none = case_of(1, 0, 1, 5);
  none.candidates[0].right = false;
  cases.push_back(none);
  const Score one = score(cases, evidence_alone());
  EXPECT_EQ(one.of, 2U);
  EXPECT_EQ(one.right, 0.5);
}

}  // namespace
}  // namespace penpose::learn
