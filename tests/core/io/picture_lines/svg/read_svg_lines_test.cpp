#include "core/io/picture_lines/svg/read_svg_lines.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;

/// A drawing of 1000 x 500 px with black lines of 2 px.
std::string drawing(const std::string& inside, const std::string& more = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 500'" + more + "><g fill='none' stroke='#000'>\n" +
         inside + "</g></svg>";
}

PictureLines lines_of(const std::string& svg) {
  const auto lines = read_svg_lines(base::as_bytes(svg));
  EXPECT_TRUE(lines.ok()) << lines.error().line();
  return lines ? *lines : PictureLines{};
}
std::vector<PxPoint> line_of(const std::string& inside) {
  const PictureLines lines = lines_of(drawing(inside));
  EXPECT_EQ(lines.lines.size(), 1U) << inside;
  return lines.lines.empty() ? std::vector<PxPoint>() : lines.lines[0].points;
}
std::vector<PxPoint> path(const std::string& data) { return line_of("<path d='" + data + "'/>"); }

std::string error(const std::string& svg) {
  const auto lines = read_svg_lines(base::as_bytes(svg));
  return lines ? "(no error)" : lines.error().line("a.svg");
}

void expect_points(const std::vector<PxPoint>& points, std::initializer_list<PxPoint> wanted) {
  ASSERT_EQ(points.size(), wanted.size());
  std::size_t i = 0;
  for (const PxPoint& p : wanted) {
    EXPECT_NEAR(points[i].x, p.x, 1e-9) << i;
    EXPECT_NEAR(points[i].y, p.y, 1e-9) << i;
    ++i;
  }
}

/// The largest distance of any point of a curve from a polyline.
double furthest(const std::vector<PxPoint>& curve, const std::vector<PxPoint>& line) {
  double most = 0;
  for (const PxPoint& p : curve) {
    double least = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const PxPoint along = line[i] - line[i - 1];
      least = std::min(least, distance(p, line[i - 1] + along * nearest_share(p, line[i - 1], line[i])));
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(ReadSvgLines, StraightCommands) {
  expect_points(path("M 10 20 L 30 40 H 50 V 60 h -5 v-6 l1,2 z"),
                {{10, 20}, {30, 40}, {50, 40}, {50, 60}, {45, 60}, {45, 54}, {46, 56}, {10, 20}});
  // What follows a move without a letter is lines, and relative ones add up.
  expect_points(path("m10 20 5 5 5-5"), {{10, 20}, {15, 25}, {20, 20}});
}

TEST(ReadSvgLines, NumbersNeedNoBlanks) {
  expect_points(path("M1.5.5-2,3e1L+1e-1.25"), {{1.5, 0.5}, {-2, 30}, {0.1, 0.25}});
  expect_points(path("M10,20L30 ,\n40\t50\r\n60"), {{10, 20}, {30, 40}, {50, 60}});
}

TEST(ReadSvgLines, ASubPathBeginsWhereTheLastOneWasClosed) {
  const PictureLines lines = lines_of(drawing("<path id='two' d='M10 10H20V20zl5 5M0 0m1 1h2'/>"));
  ASSERT_EQ(lines.lines.size(), 3U);
  EXPECT_TRUE(lines.lines[0].closed);
  EXPECT_FALSE(lines.lines[1].closed);
  expect_points(lines.lines[1].points, {{10, 10}, {15, 15}});
  expect_points(lines.lines[2].points, {{1, 1}, {3, 1}});
  for (const PictureLine& line : lines.lines) {
    EXPECT_EQ(line.element, 0U);
    EXPECT_EQ(line.name, "two");
  }
}

TEST(ReadSvgLines, CurvesStayWithinATenthOfAPx) {
  std::vector<PxPoint> cubic;
  std::vector<PxPoint> quadratic;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    const double s = 1 - t;
    cubic.push_back(PxPoint{100, 400} * (s * s * s) + PxPoint{200, -300} * (3 * s * s * t) +
                    PxPoint{800, 900} * (3 * s * t * t) + PxPoint{900, 100} * (t * t * t));
    quadratic.push_back(PxPoint{100, 400} * (s * s) + PxPoint{500, -900} * (2 * s * t) + PxPoint{900, 400} * (t * t));
  }
  const auto curve = path("M100 400C200-300 800 900 900 100");
  EXPECT_LT(furthest(cubic, curve), 0.1);
  EXPECT_LT(curve.size(), 150U);
  EXPECT_LT(furthest(quadratic, path("M100 400Q500-900 900 400")), 0.1);
  // Relative ones, and those whose first handle mirrors the last one, are the same.
  EXPECT_EQ(path("M0 0C10 20 30 40 50 50S90 80 100 100"), path("M0 0C10 20 30 40 50 50C70 60 90 80 100 100"));
  EXPECT_EQ(path("M0 0c10 20 30 40 50 50s40 30 50 50"), path("M0 0C10 20 30 40 50 50S90 80 100 100"));
  EXPECT_EQ(path("M0 0Q50 100 100 0T200 0t100 0"), path("M0 0Q50 100 100 0Q150-100 200 0q50 100 100 0"));
  // Without a curve before, the handle is where the pen is.
  EXPECT_EQ(path("M0 0S90 80 100 100"), path("M0 0C0 0 90 80 100 100"));
}

TEST(ReadSvgLines, Arcs) {
  // Flags need no separators, and the same four arcs as a browser draws.
  for (const auto& [data, centre] :
       std::initializer_list<std::pair<const char*, PxPoint>>{{"M100 200A100 100 0 01200 300", {100, 300}},
                                                              {"M100 200A100 100 0 0 0 200 300", {200, 200}},
                                                              {"M100 200a100 100 0 1,1,100 100", {200, 200}},
                                                              {"M100 200A100 100 0 10200 300", {100, 300}}}) {
    const auto points = path(data);
    for (const PxPoint& p : points) EXPECT_NEAR(distance(p, centre), 100, 0.1) << data;
    EXPECT_EQ(points.back(), (PxPoint{200, 300})) << data;
  }
  EXPECT_GT(path("M100 200A100 100 0 1 1 200 300").size(), path("M100 200A100 100 0 0 1 200 300").size());
  // Radii that are too small grow, none are a line.
  for (const PxPoint& p : path("M100 200A1 1 0 0 1 300 200")) EXPECT_NEAR(distance(p, {200, 200}), 100, 0.1);
  expect_points(path("M1 2A0 5 0 0 1 3 4"), {{1, 2}, {3, 4}});
  // A turned ellipse: in its own axes it is a circle.
  const auto turned = path("M500 250m-173.2050807568877-100a200 50 30 1 1 346.4101615137754 200");
  for (const PxPoint& p : turned) {
    const PxPoint d = p - PxPoint{500, 250};
    const double c = base::cos(base::radians(30.0));
    const double s = base::sin(base::radians(30.0));
    EXPECT_NEAR(std::sqrt(std::pow((c * d.x + s * d.y) / 200, 2) + std::pow((c * d.y - s * d.x) / 50, 2)), 1, 0.002);
  }
}

TEST(ReadSvgLines, ShapesAreLinesInTheOrderOfTheFile) {
  const PictureLines lines = lines_of(
      drawing("<line x1='1' y1='2' x2='3' y2='4'/><polyline points='0,0 5,5 10-5'/><polygon points='0 0 9 0 9 9'/>"
              "<path d=''/><rect x='10%' y='20%' width='100' height='50'/><circle cx='50' cy='60' r='10'/>"
              "<ellipse cx='500' cy='250' rx='40' ry='20'/><rect width='80' height='60' rx='10'/>"));
  ASSERT_EQ(lines.lines.size(), 7U);
  expect_points(lines.lines[0].points, {{1, 2}, {3, 4}});
  expect_points(lines.lines[1].points, {{0, 0}, {5, 5}, {10, -5}});
  expect_points(lines.lines[2].points, {{0, 0}, {9, 0}, {9, 9}, {0, 0}});
  expect_points(lines.lines[3].points, {{100, 100}, {200, 100}, {200, 150}, {100, 150}, {100, 100}});
  for (const PxPoint& p : lines.lines[4].points) EXPECT_NEAR(distance(p, {50, 60}), 10, 0.1);
  for (const PxPoint& p : lines.lines[5].points) {
    EXPECT_NEAR(std::pow((p.x - 500) / 40, 2) + std::pow((p.y - 250) / 20, 2), 1, 0.01);
  }
  for (const PxPoint& p : lines.lines[6].points) {
    EXPECT_TRUE(p.x >= 0 && p.x <= 80 && p.y >= 0 && p.y <= 60);
    EXPECT_GT(distance(p, {0, 0}), 4);  // the corner is round
  }
  std::vector<std::size_t> elements;
  for (const PictureLine& line : lines.lines) elements.push_back(line.element);
  EXPECT_EQ(elements, (std::vector<std::size_t>{0, 1, 2, 4, 5, 6, 7}));
  EXPECT_FALSE(lines.lines[1].closed);
  EXPECT_TRUE(lines.lines[2].closed && lines.lines[3].closed && lines.lines[4].closed);
}

TEST(ReadSvgLines, TransformsOfGroupsAndElements) {
  expect_points(line_of("<g transform='translate(10 20) scale(2)'><path transform='rotate(90)' d='M1 0H3'/></g>"),
                {{10, 22}, {10, 26}});
  expect_points(line_of("<path transform='matrix(1 2,3 4 5-6)' d='M1 1L0 0'/>"), {{9, 0}, {5, -6}});
  expect_points(line_of("<path transform='rotate(180,50,50),skewX(45)' d='M0 0L0 10'/>"), {{100, 100}, {90, 90}});
  expect_points(line_of("<path transform=' skewY( 45 ) scale(2 3) ' d='M0 0L10 0'/>"), {{0, 0}, {20, 20}});
  // The tolerance is that of the drawing, however small the units are.
  EXPECT_EQ(line_of("<circle transform='scale(1000)' r='.1'/>").size(), line_of("<circle r='100'/>").size());
}

TEST(ReadSvgLines, TheSizeIsThatOfTheViewBox) {
  const std::string shape = "<path stroke='red' d='M10 20L30 40'/></svg>";
  PictureLines lines = lines_of("<svg width='210mm' height='297mm' viewBox='-10 -20 400 200'>" + shape);
  EXPECT_EQ(lines.width, 400);
  EXPECT_EQ(lines.height, 200);
  expect_points(lines.lines[0].points, {{20, 40}, {40, 60}});
  lines = lines_of("<svg width='2in' height='72pt'>" + shape);
  EXPECT_EQ(lines.width, 192);
  EXPECT_EQ(lines.height, 96);
  lines = lines_of("<svg width='100%' height='100%'>" + shape);
  EXPECT_EQ(lines.width, 30);
  EXPECT_EQ(lines.height, 40);
}

TEST(ReadSvgLines, NestedDrawingsFillTheirPlace) {
  expect_points(
      line_of("<svg x='100' y='50' width='200' height='100' viewBox='0 0 10 10'><path d='M0 0L10 10'/></svg>"),
      {{150, 50}, {250, 150}});
  expect_points(line_of("<svg width='200' height='100' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMid slice'>"
                        "<path d='M0 0L10 10'/></svg>"),
                {{0, -50}, {200, 150}});
  expect_points(line_of("<svg width='200' height='100' viewBox='0 0 10 10' preserveAspectRatio='none'>"
                        "<path d='M0 0L10 10'/></svg>"),
                {{0, 0}, {200, 100}});
}

TEST(ReadSvgLines, UseDrawsWhatItNames) {
  const PictureLines lines = lines_of(drawing(
      "<defs><path id='brow' d='M0 0H10'/><symbol id='eye' viewBox='0 0 10 10'><path d='M0 5H10'/></symbol></defs>"
      "<use href='#brow' x='100' y='50'/><use xmlns:xlink='http://www.w3.org/1999/xlink' xlink:href='#brow' "
      "transform='translate(7 8)'/><use href='#eye' x='20' y='30' width='100' height='100'/><use href='#nobody'/>"));
  ASSERT_EQ(lines.lines.size(), 3U);
  expect_points(lines.lines[0].points, {{100, 50}, {110, 50}});
  expect_points(lines.lines[1].points, {{7, 8}, {17, 8}});
  expect_points(lines.lines[2].points, {{20, 80}, {120, 80}});
  EXPECT_EQ(lines.lines[1].element, 1U);
  EXPECT_EQ(lines.lines[1].name, "brow");
}

TEST(ReadSvgLines, WhatIsNotSeenIsNoLine) {
  const PictureLines lines = lines_of(drawing(
      "<g display='none'><path d='M0 0H1'/></g><path style='display : none' d='M0 0H2'/>"
      "<g visibility='hidden'><path d='M0 0H3'/><path visibility='visible' d='M0 0H4'/></g>"
      "<path stroke='none' d='M0 0H5'/><clipPath><rect width='6' height='6'/></clipPath><mask><path d='M0 0H7'/></mask>"
      "<pattern><path d='M0 0H7'/></pattern><marker><path d='M0 0H7'/></marker><text>M0 0H8</text>"
      "<x:path xmlns:x='urn:x' d='M0 0H9'/><switch><foreignObject/><g><path d='M0 0H10'/></g><path d='M0 "
      "0H11'/></switch>"));
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(lines.lines[0].points[1].x, 4);
  EXPECT_EQ(lines.lines[1].points[1].x, 10);
  EXPECT_EQ(lines.lines[1].element, 1U);
}

TEST(ReadSvgLines, StyleSheetsSayWhatIsSeen) {
  const PictureLines lines = lines_of(
      "<svg viewBox='0 0 9 9'><style>/* p{} */ @import url(x); .guide , #g{display:none} path.guide{display:inline}\n"
      "@media print{path{display:none}} g path{display:none}</style><style><![CDATA[.bare{fill:none}]]></style>"
      "<path class='a guide' d='M0 0H1'/><line class='guide' x2='2'/><path id='g' d='M0 0H3'/>"
      "<path class='bare' d='M0 0H4'/><path class='bare' style='stroke:#123 !important' d='M0 0H5'/></svg>");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(lines.lines[0].points[1].x, 1);
  EXPECT_EQ(lines.lines[1].points[1].x, 5);
}

TEST(ReadSvgLines, PaperIsNoLine) {
  const std::string page = "<svg viewBox='0 0 100 50'><rect width='100%' height='100%' fill='white'/>";
  EXPECT_TRUE(lines_of(page + "</svg>").lines.empty());
  EXPECT_EQ(lines_of(page + "<rect width='99' height='50' fill='none' stroke='red'/></svg>").lines.size(), 1U);
}

TEST(ReadSvgLines, ALineOfABrushIsTheLineInItsMiddle) {
  // The outline of a wave that is 8 px wide in the middle and pointed at both ends.
  std::string there;
  std::string back;
  std::vector<PxPoint> wave;
  for (int i = 0; i <= 200; ++i) {
    const double t = i / 200.0;
    const double slope = 0.72 * base::cos(8 * t);
    const PxPoint p{100 + 800 * t, 250 + 72 * base::sin(8 * t)};
    const double half = 4 * std::sqrt(std::max(0.0, 1 - (2 * t - 1) * (2 * t - 1))) / std::sqrt(1 + slope * slope);
    wave.push_back(p);
    const auto text = [](double x, double y) { return std::to_string(x) + ' ' + std::to_string(y) + ' '; };
    there += text(p.x - slope * half, p.y + half);
    back.insert(0, text(p.x + slope * half, p.y - half));
  }
  const auto of = [](const std::string& d) {
    return lines_of("<svg viewBox='0 0 1000 500'><path fill='#222' fill-rule='evenodd' d='" + d + "'/></svg>").lines;
  };
  auto lines = of("M" + there + back + "Z");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_LT(furthest(lines[0].points, wave), 0.7);
  EXPECT_LT(distance(lines[0].points.front(), wave.front()), 8);
  EXPECT_LT(distance(lines[0].points.back(), wave.back()), 8);
  // A ring is drawn round.
  const std::string ring = "M600 250a100 100 0 1 0-200 0a100 100 0 1 0 200 0z";
  lines = of(ring + "M594 250a94 94 0 1 1-188 0a94 94 0 1 1 188 0z");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].closed);
  for (const PxPoint& p : lines[0].points) EXPECT_NEAR(distance(p, {500, 250}), 97, 0.5);
  // A disc is no line of a brush, nor is what has a stroke or is open.
  lines = of(ring);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(distance(lines[0].points[0], {500, 250}), 100, 0.1);
  EXPECT_EQ(of("M100 100H900V104").size(), 1U);
  EXPECT_EQ(of("M100 100H900V104")[0].points.size(), 3U);
  EXPECT_EQ(line_of("<path fill='#222' d='M100 100H900V104H100z'/>").size(), 5U);
}

TEST(ReadSvgLines, PrefixesDeclarationsAndMarks) {
  const PictureLines lines = lines_of(
      "\xef\xbb\xbf<?xml version='1.0'?>\n<!DOCTYPE svg [<!ENTITY ns 'x'>]>\n<!-- a -->"
      "<s:svg xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><s:g><s:path d='M0 0H1'/></s:g>"
      "<path d='M0 0H2'/></s:svg>");
  ASSERT_EQ(lines.lines.size(), 1U);
  EXPECT_EQ(lines.lines[0].points[1].x, 1);
}

TEST(ReadSvgLines, IsRecognised) {
  const auto looks = [](const std::string& text) { return looks_like_svg(base::as_bytes(text)); };
  EXPECT_TRUE(looks("<svg/>"));
  EXPECT_TRUE(
      looks("\xef\xbb\xbf<?xml version='1.0'?>\n<!-- <a> -->\n<!DOCTYPE svg PUBLIC \"a\" \"b\">\n<svg width='1'>"));
  EXPECT_TRUE(looks("<!DOCTYPE svg [\n<!ENTITY a \"<b>\">\n]>\n<x:svg>"));
  EXPECT_FALSE(looks("<html><svg/></html>"));
  EXPECT_FALSE(looks("<!-- <svg>"));
  EXPECT_FALSE(looks("svg"));
  EXPECT_FALSE(looks(""));
}

TEST(ReadSvgLines, NamesTheFault) {
  EXPECT_EQ(
      error(drawing("<path id='brow' d='M0 0L1'/>")),
      "a.svg: line 2: the element path \"brow\": a number of the path was expected, character 7; the file is damaged; "
      "export it again");
  EXPECT_EQ(
      error(drawing("\n<path d='10 10'/>")),
      "a.svg: line 3: the element path: a path begins with M or m, character 1; the file is damaged; export it again");
  for (const char* data :
       {"M0 0X", "M0 0L1 nan", "M0 0L1 inf", "M0 0A1 1 0 2 0 5 5", "M0 0L1e999 0", "M", "M0 0LL", "Z"}) {
    EXPECT_NE(error(drawing(std::string("<path d='") + data + "'/>")).find("export it again"), std::string::npos)
        << data;
  }
  EXPECT_NE(error(drawing("<path d='M0 0H1e7'/>")).find("beyond a million; scale"), std::string::npos);
  EXPECT_NE(error(drawing("<path transform='scale(1e300)' d='M0 0H1e300'/>")).find("beyond a million"),
            std::string::npos);
  EXPECT_NE(error(drawing("<path transform='turn(3)' d='M0 0H1'/>")).find("transform"), std::string::npos);
  EXPECT_NE(error(drawing("<circle r='two'/>")).find("r is \"two\", which is no length"), std::string::npos);
  EXPECT_NE(error(drawing("<polygon points='1 2 3'/>")).find("a coordinate was expected"), std::string::npos);
  EXPECT_NE(error("<svg viewBox='0 0 0 9'/>").find("viewBox"), std::string::npos);
  EXPECT_NE(error("<html/>").find("does not begin with an svg element"), std::string::npos);
  EXPECT_NE(error("").find("does not begin with an svg element"), std::string::npos);
  EXPECT_NE(error("<svg>\n<path").find("line 2: the XML is damaged"), std::string::npos);
  EXPECT_NE(error("\x1f\x8b\x08").find("gunzip"), std::string::npos);
}

TEST(ReadSvgLines, HostileFilesEndEarly) {
  std::string deep = "<path d='M0 0H1'/>";
  for (int i = 0; i < 17; ++i) deep = "<g><g><g><g><g><g>" + deep + "</g></g></g></g></g></g>";
  EXPECT_NE(error(drawing(deep)).find("more than 100 elements are inside each other"), std::string::npos);
  EXPECT_NE(error(drawing("<g id='a'><use href='#a'/></g>")).find("one uses itself"), std::string::npos);
  EXPECT_NE(error(drawing("<symbol id='a'><use href='#a'/></symbol><use href='#a'/>")).find("itself"),
            std::string::npos);
  // Each names the one before ten times.
  std::string laughs = "<path id='l0' d='M0 0h1'/>";
  for (int i = 1; i < 20; ++i) {
    laughs += "<g id='l" + std::to_string(i) + "'>";
    for (int j = 0; j < 10; ++j) laughs += "<use href='#l" + std::to_string(i - 1) + "'/>";
    laughs += "</g>";
  }
  EXPECT_NE(error(drawing(laughs)).find("; "), std::string::npos);
  std::string long_path = "M0 0";
  for (int i = 0; i < 1'100'000; ++i) long_path += "h1v1";
  EXPECT_NE(error(drawing("<path d='" + long_path + "'/>")).find("a million points"), std::string::npos);
  EXPECT_NE(error("<svg>" + std::string(3'000'000, '<')).find("two million"), std::string::npos);
  EXPECT_NE(error(std::string((std::size_t{1} << 25) + 1, ' ')).find("32 MB"), std::string::npos);
  std::string rules;
  for (int i = 0; i < 600; ++i) rules += "a{fill:red}";
  EXPECT_NE(error("<svg><style>" + rules + "</style></svg>").find("512"), std::string::npos);
}

}  // namespace
}  // namespace penpose::io
