#include "core/curve/polyline.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "tests/support/models/test_rigs.h"

namespace penpose::curve {
namespace {

using Px = std::vector<PxPoint>;
using Model = std::vector<ModelPoint>;

const Px k_corner{{0, 0}, {3, 0}, {3, 1}};  // 4 px long

TEST(Polyline, MeasuresLength) {
  EXPECT_EQ(cumulative_length<PxPoint>(k_corner), (std::vector<double>{0, 3, 4}));
  EXPECT_EQ(arc_length<PxPoint>(k_corner), 4);
  EXPECT_EQ(arc_length<ModelPoint>(Model{{0, 0, 0}, {2, 3, 6}, {2, 3, 8}}), 9);
  EXPECT_EQ(arc_length<PxPoint>(Px{}), 0);
  EXPECT_EQ(arc_length<PxPoint>(Px{{5, 5}}), 0);
  EXPECT_TRUE(cumulative_length<PxPoint>(Px{}).empty());
}

TEST(Polyline, FindsThePlaceAtAShareOfTheLength) {
  const std::vector<double> cumulative{0, 3, 3, 4};  // the second segment has no length
  const auto expect = [&](double share, std::size_t segment, double fraction) {
    const PolylinePlace place = place_at(cumulative, share);
    EXPECT_EQ(place.segment, segment) << share;
    EXPECT_NEAR(place.fraction, fraction, 1e-12) << share;
  };
  expect(0, 0, 0);
  expect(0.375, 0, 0.5);
  expect(0.75, 2, 0);
  expect(0.875, 2, 0.5);
  expect(1, 2, 1);
}

TEST(Resample, PutsPointIAtFractionIMinusOneOverNMinusOne) {
  const auto points = resample<PxPoint>(k_corner, 5).value();
  EXPECT_EQ(points, (Px{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}}));
  EXPECT_EQ(resample<PxPoint>(k_corner, 2).value(), (Px{{0, 0}, {3, 1}}));
  const auto line = resample<ModelPoint>(Model{{0, 0, 0}, {0, 0, 6}}, 4).value();
  EXPECT_EQ(line, (Model{{0, 0, 0}, {0, 0, 2}, {0, 0, 4}, {0, 0, 6}}));
}

TEST(Resample, KeepsBothEndsExactlyAndSpacesEvenly) {
  tests::Random random(3);
  for (int run = 0; run < 200; ++run) {
    Px line;
    const std::size_t size = 2 + random.index(40);
    for (std::size_t i = 0; i < size; ++i) {
      line.push_back({random(0, 1000), random(0, 1000)});
      if (random.index(4) == 0) line.push_back(line.back());  // the pen rests
    }
    const std::size_t count = 2 + random.index(60);
    const auto points = resample<PxPoint>(line, count).value();
    ASSERT_EQ(points.size(), count);
    EXPECT_EQ(points.front(), line.front());
    EXPECT_EQ(points.back(), line.back());
    // A chord is never longer than the length along the line between its ends.
    const double spacing = arc_length<PxPoint>(line) / static_cast<double>(count - 1);
    for (std::size_t i = 1; i < count; ++i)
      EXPECT_LE(geometry::distance(points[i - 1], points[i]), spacing * (1 + 1e-9));
  }
}

TEST(Resample, RefusesWhatIsNoCurve) {
  EXPECT_FALSE(resample<PxPoint>(Px{}, 4));
  EXPECT_FALSE(resample<PxPoint>(Px{{1, 1}}, 4));
  EXPECT_FALSE(resample<PxPoint>(k_corner, 1));
  EXPECT_FALSE(resample<PxPoint>(k_corner, 0));
  EXPECT_EQ((resample<PxPoint>(Px{{1, 1}, {1, 1}, {1, 1}}, 4).error().what), "the curve has no length");
  EXPECT_EQ((resample<PxPoint>(Px{{0, 0}, {1, 0}, {NAN, 1}}, 4).error().place), "point 2");
  EXPECT_EQ((resample<ModelPoint>(Model{{0, 0, 0}, {0, INFINITY, 0}}, 4).error().place), "point 1");
  EXPECT_FALSE(resample<PxPoint>(Px{{0, 0}, {1e308, 1e308}, {-1e308, 0}}, 4)) << "a length beyond all numbers";
}

TEST(ResampleAt, TakesSharesInAnyOrder) {
  const std::vector<double> shares{1, 0.5, 0, -0.1, 1.1};
  EXPECT_EQ(resample_at<PxPoint>(k_corner, shares).value(), (Px{{3, 1}, {2, 0}, {0, 0}, {0, 0}, {3, 1}}));
}

TEST(SharesOf, GoFromZeroToOne) {
  EXPECT_EQ(shares_of<PxPoint>(k_corner).value(), (std::vector<double>{0, 0.75, 1}));
  EXPECT_FALSE(shares_of<PxPoint>(Px{{2, 2}, {2, 2}}));
  EXPECT_FALSE(shares_of<PxPoint>(Px{}));
}

TEST(TriangleFilter, WeighsLinearlyToZeroJustPastTheKernel) {
  // A single spike shows the kernel: 1 2 1 over 4, and 1 2 3 2 1 over 9.
  Px spike;
  for (int i = 0; i < 9; ++i) spike.push_back({static_cast<double>(i), i == 4 ? 36.0 : 0.0});
  const auto three = triangle_filter<PxPoint>(spike, 3, Ends::fixed);
  const auto five = triangle_filter<PxPoint>(spike, 5, Ends::fixed);
  const std::array<double, 9> expected3{0, 0, 0, 9, 18, 9, 0, 0, 0};
  const std::array<double, 9> expected5{0, 0, 4, 8, 12, 8, 4, 0, 0};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(three[i].y, expected3[i], 1e-12) << i;
    EXPECT_NEAR(five[i].y, expected5[i], 1e-12) << i;
    EXPECT_NEAR(three[i].x, static_cast<double>(i), 1e-12) << "a straight even line stays";
  }
}

TEST(TriangleFilter, CutsAndRenormalisesTheKernelNearTheEnds) {
  const Px line{{0, 3}, {0, 9}, {0, 0}, {0, 6}};
  const auto moving = triangle_filter<PxPoint>(line, 5, Ends::moving);
  EXPECT_NEAR(moving[0].y, (3 * 3 + 2 * 9 + 1 * 0) / 6.0, 1e-12);
  EXPECT_NEAR(moving[1].y, (2 * 3 + 3 * 9 + 2 * 0 + 1 * 6) / 8.0, 1e-12);
  EXPECT_NEAR(moving[3].y, (3 * 6 + 2 * 0 + 1 * 9) / 6.0, 1e-12);
  const auto fixed = triangle_filter<PxPoint>(line, 5, Ends::fixed);
  EXPECT_EQ(fixed[0], line[0]);
  EXPECT_EQ(fixed[3], line[3]);
  EXPECT_EQ(fixed[1], moving[1]);
}

TEST(TriangleFilter, WideKernelsWeighLikeNarrowOnes) {
  std::vector<ModelPoint> line;
  for (int i = 0; i < 900; ++i) line.push_back({100 + i * 0.01, std::sin(i * 0.7), static_cast<double>((i * i) % 17)});
  for (const std::size_t kernel : {301U, 601U, 5001U}) {
    for (const Ends ends : {Ends::moving, Ends::fixed}) {
      const auto filtered = triangle_filter<ModelPoint>(line, kernel, ends);
      const auto half = static_cast<std::ptrdiff_t>(kernel / 2);
      for (std::ptrdiff_t i = 0; i < 900; i += 29) {
        ModelPoint sum{0};
        double weights = 0;
        for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - half); k <= std::min<std::ptrdiff_t>(899, i + half);
             ++k) {
          const auto weight = static_cast<double>(half + 1 - std::abs(k - i));
          sum += line[static_cast<std::size_t>(k)] * weight;
          weights += weight;
        }
        const ModelPoint expected =
            ends == Ends::fixed && (i == 0 || i == 899) ? line[static_cast<std::size_t>(i)] : sum / weights;
        EXPECT_LT(geometry::distance(filtered[static_cast<std::size_t>(i)], expected), 1e-11) << kernel << ' ' << i;
      }
    }
  }
}

TEST(TriangleFilter, RaisesTheKernelToTheNextOddOne) {
  tests::Random random(8);
  Model line;
  for (int i = 0; i < 12; ++i) line.push_back(random.vector(1));
  const auto filtered = [&](std::size_t kernel) { return triangle_filter<ModelPoint>(line, kernel, Ends::moving); };
  EXPECT_EQ(filtered(0), filtered(3));
  EXPECT_EQ(filtered(1), filtered(3));
  EXPECT_EQ(filtered(4), filtered(5));
  EXPECT_NE(filtered(3), filtered(5));
}

TEST(TriangleFilter, AnyKernelLeavesPointsWithinTheCurvesBox) {
  const Px line{{0, 0}, {10, 5}, {20, -5}, {30, 0}};
  for (const std::size_t kernel : {3UL, 9UL, 1001UL, 1UL << 40U, ~0UL}) {
    for (const PxPoint& p : triangle_filter<PxPoint>(line, kernel, Ends::moving)) {
      EXPECT_GE(p.x, 0);
      EXPECT_LE(p.x, 30);
      EXPECT_LE(std::abs(p.y), 5);
    }
  }
  EXPECT_TRUE(triangle_filter<PxPoint>(Px{}, 3, Ends::moving).empty());
  EXPECT_EQ((triangle_filter<PxPoint>(Px{{4, 4}}, 3, Ends::moving)), (Px{{4, 4}}));
}

}  // namespace
}  // namespace penpose::curve
