#pragma once

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "core/document/document_hash.h"
#include "core/document/history.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::tests {

/// Commands on the bent sheet, looked at from the front, with places given as x and y of the sheet (-1..1).
class DocumentHand {
 public:
  DocumentHand() : DocumentHand(document::make_document(sheet_model())) {}
  explicit DocumentHand(document::Document document) : history_(std::move(document)) {
    view.camera = {{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 30};
  }

  document::View view;

  [[nodiscard]] const document::Document& document() const { return history_.document(); }
  [[nodiscard]] document::DocumentState state() const { return document::DocumentHasher()(document()); }

  /// Where the view shows a place of the sheet at rest.
  [[nodiscard]] geometry::PxPoint seen(double x, double y) const {
    const geometry::ModelPoint p{x, y, 0.4 * (1.0 - 0.5 * (x * x + y * y))};
    return *geometry::Camera::make(view.camera, view.viewport).value().project(p);
  }
  /// A line from place to place.
  [[nodiscard]] std::vector<geometry::PxPoint> line(double x0, double y0, double x1, double y1) const {
    std::vector<geometry::PxPoint> out;
    for (int i = 0; i <= 20; ++i) out.push_back(seen(x0 + (x1 - x0) * i / 20, y0 + (y1 - y0) * i / 20));
    return out;
  }
  /// A diamond around the middle of the sheet.
  [[nodiscard]] std::vector<geometry::PxPoint> diamond(double radius) const {
    std::vector<geometry::PxPoint> out;
    for (const auto& part : {line(radius, 0, 0, radius), line(0, radius, -radius, 0), line(-radius, 0, 0, -radius),
                             line(0, -radius, radius, 0)}) {
      out.insert(out.end(), part.begin(), part.end() - 1);
    }
    return out;
  }

  base::Status perform(const document::Command& command) { return history_.perform(command, work_); }
  /// A command that must work.
  void does(const document::Command& command) {
    const auto status = perform(command);
    EXPECT_TRUE(status.ok()) << document::name_of(command) << ": " << (status.ok() ? "" : status.error().line());
  }
  /// A command that must fail and change nothing. Gives the error.
  base::Error refuses(const document::Command& command) {
    const auto before = state();
    const auto undo_count = history_.undo_count();
    const auto status = perform(command);
    EXPECT_FALSE(status.ok()) << document::name_of(command);
    EXPECT_EQ(state(), before) << document::name_of(command);
    EXPECT_EQ(history_.undo_count(), undo_count);
    return status.ok() ? base::Error{} : status.error();
  }

  base::Status undo() { return history_.undo(); }

  [[nodiscard]] double value(const std::string& parameter) const {
    const auto number = rig::find_parameter(document().model->rig->parameters(), parameter);
    EXPECT_TRUE(number.has_value()) << parameter;
    return number ? document().pose[*number] : -1e9;
  }
  [[nodiscard]] bool has(const std::string& parameter) const {
    return rig::find_parameter(document().model->rig->parameters(), parameter).has_value();
  }

  /// The four strokes of a deformer that brings the middle of the sheet up.
  void sketch(const std::string& name) {
    does(document::BeginDeformer{name, articulation::Mode::automatic, {}, 0, 1});
    does(document::SketchCurve{articulation::CurveRole::general, view, diamond(0.8)});
    does(document::SketchCurve{articulation::CurveRole::specific, view, diamond(0.4)});
    does(document::SketchCurve{articulation::CurveRole::target, view, line(-0.4, 0.3, 0.4, 0.3)});
  }

 private:
  document::History history_;
  document::ApplyWorkspace work_;
};

}  // namespace penpose::tests
