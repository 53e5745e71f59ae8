#include "core/inference/terms.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace penpose::inference {
namespace {

TEST(Terms, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < k_term_count; ++k) names.insert(name_of(static_cast<Term>(k)));
  EXPECT_EQ(names.size(), k_term_count);
  EXPECT_STREQ(name_of(Term::evidence), "evidence");
  EXPECT_STREQ(name_of(Term::against), "against");
  EXPECT_STREQ(name_of(Term::leaning), "leaning") << "names are in the order of the terms";
}

TEST(Terms, TheirDotProductWeighsEachAlone) {
  Terms terms, weights;
  terms[Term::unit] = 2;
  terms[Term::tie] = 0.5;
  weights[Term::unit] = 3;
  weights[Term::tie] = 4;
  weights[Term::axis] = 100;
  EXPECT_EQ(weights.dot(terms), 8);
  terms += terms;
  EXPECT_EQ(weights.dot(terms), 16);
}

}  // namespace
}  // namespace penpose::inference
