#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/models/sheet_model.h"
#include "tests/support/session_script.h"

namespace penpose::tests {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers everywhere.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }
  /// 0 .. count - 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  double real(double from, double to) { return from + (to - from) * (static_cast<double>(next() >> 11U) * 0x1p-53); }
  bool chance(double share) { return real(0, 1) < share; }

 private:
  std::uint64_t state_;
};

/// A hand that does anything with a document: all tools and all commands, sensible and senseless.
class RandomHand {
 public:
  RandomHand(SessionScript& script, std::uint64_t seed) : script_(script), random_(seed) {}

  void run(std::size_t actions) {
    for (std::size_t i = 0; i < actions; ++i) act();
  }

  /// One stroke or one command.
  void act() {
    switch (random_.below(10)) {
      case 0:
        static_cast<void>(script_.act(replay::Undone{}));
        break;
      case 1:
        static_cast<void>(script_.act(replay::Redone{}));
        break;
      case 2:
        if (random_.chance(0.3)) {
          turn();
          break;
        }
        [[fallthrough]];
      case 3:
      case 4:
        static_cast<void>(script_.perform(command()));
        break;
      case 5:
        if (random_.chance(0.6)) {
          sketch();
          break;
        }
        [[fallthrough]];
      default:
        script_.choose(static_cast<drawing::ToolKind>(random_.below(9)));
        draw_anything();
        break;
    }
  }

  [[nodiscard]] std::vector<geometry::PxPoint> line() {
    const geometry::Viewport viewport = script_.editor().view().viewport;
    const std::size_t points = 2 + random_.below(24);
    const double reach = random_.chance(0.1) ? 1.2 : 0.5;
    const auto place = [&](double size) { return size * (0.5 + 0.5 * random_.real(-reach, reach)); };
    const geometry::PxPoint from{place(viewport.width), place(viewport.height)};
    const geometry::PxPoint to{place(viewport.width), place(viewport.height)};
    const double bend = random_.real(-80, 80);
    std::vector<geometry::PxPoint> out;
    for (std::size_t i = 0; i < points; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(points - 1);
      out.push_back({from.x + (to.x - from.x) * u + random_.real(-1, 1),
                     from.y + (to.y - from.y) * u + 4 * bend * u * (1 - u) + random_.real(-1, 1)});
    }
    return out;
  }

  /// A diamond around a place, closed by its ends.
  [[nodiscard]] std::vector<geometry::PxPoint> lasso(geometry::PxPoint center, double radius) {
    std::vector<geometry::PxPoint> out;
    const geometry::PxPoint corners[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    for (std::size_t c = 0; c + 1 < 5; ++c) {
      for (int i = 0; i < 6; ++i) {
        const double u = i / 6.0;
        out.push_back(center + (corners[c] * (1 - u) + corners[c + 1] * u) * radius);
      }
    }
    return out;
  }

  [[nodiscard]] document::Command command() {
    using namespace document;  // NOLINT(google-build-using-namespace): every line names a command
    const View view = script_.editor().view();
    const CurveId curve{static_cast<std::uint32_t>(random_.below(6))};
    const double time_s = static_cast<double>(random_.below(12)) * 0.25;
    switch (random_.below(28)) {
      case 0:
      case 1:
        return SetParameters{{{parameter(), random_.real(0, 1)}}};
      case 2:
        return ResetParameters{random_.chance(0.5) ? std::vector<std::string>{parameter()}
                                                   : std::vector<std::string>{}};
      case 3:
        return LockParameters{{parameter()}, random_.chance(0.5)};
      case 4:
        return DragTarget{curve, {random_.real(-30, 30), random_.real(-30, 30)}};
      case 5:
        return KeepCurve{curve};
      case 6:
        return DeleteCurve{curve};
      case 7:
        return random_.chance(0.3) ? Command(ClearCurves{}) : Command(SolvePose{});
      case 8:
        return SetPressureWeighting{random_.chance(0.5)};
      case 9:
        return NameCurve{curve, random_.chance(0.5) ? "brow" : "lip"};
      case 10:
        return DeleteNamedCurve{"brow"};
      case 11:
        return BeginDeformer{"", articulation::Mode::translate, articulation::Sphere{{0, 0, -0.5}, 0.8}, -0.5, 1.5};
      case 12:
        return CancelDeformer{};
      case 13:
        return RedrawCurve{deformer(), articulation::CurveRole::target, view, line()};
      case 14:
        return ChangeDeformer{deformer(), articulation::Mode::rotate, std::nullopt, std::nullopt, 1.25};
      case 15:
        return MirrorDeformer{deformer()};
      case 16:
        return RenameDeformer{deformer(), "name " + std::to_string(random_.below(4))};
      case 17:
        return DeleteDeformer{deformer()};
      case 18:
        return MoveDeformer{deformer(), static_cast<std::uint32_t>(random_.below(3))};
      case 19:
      case 20:
      case 21:
        return SetKey{time_s, random_.chance(0.3) ? "smile" : ""};
      case 22:
        return DeleteKeys{{{time_s}, {}}};
      case 23:
        return MoveKeys{{{time_s}, {}}, static_cast<double>(random_.below(12)) * 0.25 - time_s};
      case 24:
        return SetKeyKind{{{time_s}, {}}, random_.chance(0.5) ? KeyKind::linear : KeyKind::stepped};
      case 25:
        return GoToTime{random_.real(0, 3)};
      case 26:
        return SaveView{random_.chance(0.5) ? "front" : "side", view};
      default:
        return DeleteView{"side"};
    }
  }

 private:
  void turn() {
    document::View view = script_.editor().view();
    view.camera.eye.x += random_.real(-0.5, 0.5);
    if (random_.chance(0.2)) view.viewport = {800 + static_cast<int>(random_.below(3)) * 100, 900};
    static_cast<void>(script_.act(replay::ViewChanged{view}));
  }

  void draw_anything() {
    // One after the other: the order in which arguments are evaluated is each compiler's own.
    const auto drawn = line();
    const double pressure = random_.real(0.05, 1);
    const bool eraser = random_.chance(0.05);
    static_cast<void>(script_.stroke(drawn, pressure, eraser));
  }

  /// A deformer in four strokes.
  void sketch() {
    drawing::Tool tool;
    tool.kind = drawing::ToolKind::articulate;
    tool.draw_reference = random_.chance(0.3);
    static_cast<void>(script_.act(replay::ToolChosen{tool}));
    const geometry::Viewport viewport = script_.editor().view().viewport;
    const geometry::PxPoint center{viewport.width * random_.real(0.4, 0.6), viewport.height * random_.real(0.4, 0.6)};
    const double radius = random_.real(150, 300);
    static_cast<void>(script_.stroke(lasso(center, radius)));
    static_cast<void>(script_.stroke(lasso(center, radius * random_.real(0.3, 0.8))));
    if (tool.draw_reference) static_cast<void>(script_.stroke(line()));
    static_cast<void>(script_.stroke(line()));
  }

  [[nodiscard]] std::string parameter() {
    const auto known = script_.document().model->rig->parameters();
    return random_.chance(0.05) || known.empty() ? "nothing" : known[random_.below(known.size())].name;
  }
  [[nodiscard]] std::string deformer() {
    const auto& set = script_.document().model->deformers;
    return !set || random_.chance(0.1) ? "nothing" : set->parameters()[random_.below(set->size())].name;
  }

  SessionScript& script_;
  SplitMix random_;
};

}  // namespace penpose::tests
