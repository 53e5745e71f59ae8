#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tests/support/random_session.h"

namespace penpose::tests {

/// A hand that knows what is there: every command of the list comes as often as any other, and nearly always means
/// something. A command that is added to the list and is not made here does not compile.
class KnowingHand {
 public:
  KnowingHand(SessionScript& script, std::uint64_t seed) : script_(script), random_(seed), hand_(script, seed + 7777) {}

  void run(std::size_t actions) {
    for (std::size_t i = 0; i < actions; ++i) act();
  }

  void act() {
    if (random_.chance(0.3)) return stroke();
    const std::size_t what = random_.below(k_commands.size() + 6);
    if (what >= k_commands.size() + 4) return stroke();
    if (what >= k_commands.size()) {
      if (random_.chance(0.6)) {
        static_cast<void>(script_.act(replay::Undone{}));
      } else {
        static_cast<void>(script_.act(replay::Redone{}));
      }
      return;
    }
    const document::Command command =
        make_named(k_commands[what], std::make_index_sequence<std::variant_size_v<document::CommandTypes>>());
    if (!script_.perform(command)) return;
    if (command.holds<document::MirrorDeformer>()) drawn_.emplace("mirror");
    if (command.holds<document::KeyPoses>()) drawn_.emplace("perform");
  }

  /// The kinds of strokes, tools in the order of drawing::ToolKind; `none` draws nothing.
  static constexpr std::array<std::string_view, 15> k_kinds{
      "pose",  "reference", "target",  "oversketch", "constraint", "pin",    "articulate", "redraw",
      "erase", "none",      "between", "draw",       "feature",    "mirror", "perform"};
  /// Those that did something so far.
  [[nodiscard]] const std::set<std::string>& drawn_kinds() const { return drawn_; }

 private:
  template <typename One>
  using Tag = std::type_identity<One>;

  template <std::size_t... I>
  document::Command make_named(std::string_view name, std::index_sequence<I...>) {
    std::optional<document::Command> out;
    const auto makes = [&]<typename One>(Tag<One> one) {
      if (One::k_called.name != name) return false;
      out = make(one);
      return true;
    };
    static_cast<void>((makes(Tag<std::variant_alternative_t<I, document::CommandTypes>>{}) || ...));
    return *out;
  }

  document::Command make(Tag<document::SetParameters>) {
    return document::SetParameters{{{parameter(), random_.real(0, 1)}}};
  }
  document::Command make(Tag<document::ResetParameters>) {
    document::ResetParameters command;
    if (random_.chance(0.7)) command.names = {parameter()};
    return command;
  }
  document::Command make(Tag<document::LockParameters>) {
    const auto& locked = doc().locked;
    if (!locked.empty() && random_.chance(0.5)) return document::LockParameters{{any(locked)}, false};
    return document::LockParameters{{parameter()}, true};
  }
  document::Command make(Tag<document::DrawReference>) { return document::DrawReference{view(), hand_.line()}; }
  document::Command make(Tag<document::DrawTarget>) {
    document::DrawTarget command{curve(false), view(), hand_.line(), {}};
    for (std::size_t i = 0; pressed_ && i < command.line.size(); ++i) command.pressure.push_back(random_.real(0.1, 1));
    pressed_ = !pressed_;
    return command;
  }
  document::Command make(Tag<document::OversketchTarget>) {
    return document::OversketchTarget{curve(true), view(), along_target()};
  }
  document::Command make(Tag<document::DragTarget>) {
    const document::CurveId id = curve(true);
    const double x = random_.real(-30, 30);
    return document::DragTarget{id, {x, random_.real(-30, 30)}};
  }
  document::Command make(Tag<document::DrawConstraint>) { return document::DrawConstraint{view(), hand_.line()}; }
  document::Command make(Tag<document::Pin>) { return document::Pin{view(), hand_.line().front()}; }
  document::Command make(Tag<document::KeepCurve>) { return document::KeepCurve{curve(false)}; }
  document::Command make(Tag<document::DeleteCurve>) {
    if (doc().curves.empty()) return document::DeleteCurve{document::CurveId{1}};
    return document::DeleteCurve{any(doc().curves)->id};
  }
  document::Command make(Tag<document::EraseCurves>) { return document::EraseCurves{view(), along_target()}; }
  document::Command make(Tag<document::ClearCurves>) { return document::ClearCurves{}; }
  document::Command make(Tag<document::SolvePose>) {
    return document::SolvePose{random_.chance(0.8) ? document::Preset::meant : document::Preset::exact};
  }
  document::Command make(Tag<document::TakeReading>) {
    const auto& moment = doc().moment;
    if (!moment || moment->lines.empty()) return document::TakeReading{curve(true), 0};
    return document::TakeReading{moment->lines.back().curve, static_cast<std::uint32_t>(random_.below(2))};
  }
  document::Command make(Tag<document::SetPressureWeighting>) {
    return document::SetPressureWeighting{!doc().pressure_weighting};
  }
  document::Command make(Tag<document::SetHand>) { return document::SetHand{random_.real(0.25, 4)}; }
  document::Command make(Tag<document::NameCurve>) {
    const std::string name = random_.chance(0.5) ? "brow" : "lip";
    return document::NameCurve{doc().curves.empty() ? document::CurveId{1} : any(doc().curves)->id, name};
  }
  document::Command make(Tag<document::DeleteNamedCurve>) {
    const auto& named = doc().model->curves;
    return document::DeleteNamedCurve{named.empty() ? "brow" : any(named).name};
  }
  document::Command make(Tag<document::BeginDeformer>) {
    return document::BeginDeformer{"", articulation::Mode::automatic, {}, random_.real(-1, 0), random_.real(1, 2)};
  }
  /// The next curve of the sketch that was begun.
  document::Command make(Tag<document::SketchCurve>) {
    using articulation::CurveRole;
    const document::View from = view();
    const auto& pending = doc().pending;
    const geometry::PxPoint middle{from.viewport.width * 0.5, from.viewport.height * 0.5};
    if (!pending || pending->sketch.general.empty()) {
      return document::SketchCurve{CurveRole::general, from, hand_.lasso(middle, random_.real(180, 300))};
    }
    if (pending->sketch.specific.empty()) {
      return document::SketchCurve{CurveRole::specific, from, hand_.lasso(middle, random_.real(60, 170))};
    }
    const bool reference = pending->sketch.reference.empty() && random_.chance(0.3);
    return document::SketchCurve{reference ? CurveRole::reference : CurveRole::target, from, hand_.line()};
  }
  document::Command make(Tag<document::CancelDeformer>) { return document::CancelDeformer{}; }
  document::Command make(Tag<document::RedrawCurve>) {
    const std::string name = deformer();
    const bool target = random_.chance(0.6);
    return document::RedrawCurve{name, target ? articulation::CurveRole::target : articulation::CurveRole::reference,
                                 view(), hand_.line()};
  }
  document::Command make(Tag<document::ChangeDeformer>) {
    document::ChangeDeformer command{deformer(), std::nullopt, std::nullopt, std::nullopt, std::nullopt};
    if (random_.chance(0.3))
      command.mode = random_.chance(0.5) ? articulation::Mode::rotate : articulation::Mode::translate;
    if (random_.chance(0.2)) command.surface = articulation::Surface(articulation::Sphere{{0, 0, -0.5}, 0.8});
    command.maximum = random_.real(1, 2);
    return command;
  }
  document::Command make(Tag<document::MirrorDeformer>) {
    if (!doc().model->deformers) sketch_control();
    return document::MirrorDeformer{deformer(), fresh_name()};
  }
  document::Command make(Tag<document::RenameDeformer>) {
    const std::string name = deformer();
    return document::RenameDeformer{name, fresh_name()};
  }
  document::Command make(Tag<document::DeleteDeformer>) { return document::DeleteDeformer{deformer()}; }
  document::Command make(Tag<document::MoveDeformer>) {
    const auto& set = doc().model->deformers;
    const std::string name = deformer();
    return document::MoveDeformer{name, static_cast<std::uint32_t>(set ? random_.below(set->size()) : 0)};
  }
  document::Command make(Tag<document::SetKey>) {
    const double time_s = random_.real(0, 4);
    return document::SetKey{time_s, random_.chance(0.3) ? "smile" : ""};
  }
  document::Command make(Tag<document::DeleteKeys>) { return document::DeleteKeys{some_keys()}; }
  document::Command make(Tag<document::MoveKeys>) {
    const document::OfKeys keys = some_keys();
    const double by_s = random_.real(0, 4) - keys.times_s.front();
    document::MoveKeys command{keys, by_s};
    command.about_s = keys.times_s.front();
    command.scale = random_.real(0.5, 1.5);
    command.copies = random_.chance(0.3);
    command.rate = random_.chance(0.5) ? 24 : 0;
    return command;
  }
  document::Command make(Tag<document::SetKeyKind>) {
    return document::SetKeyKind{some_keys(), static_cast<document::KeyKind>(random_.below(8))};
  }
  document::Command make(Tag<document::SetKeyValues>) {
    document::SetKeyValues command{one_key(), {}};
    for (const std::string& name : command.names) {
      const auto known = doc().model->rig->parameters();
      const auto number = rig::find_parameter(known, name);
      command.values.push_back(number ? random_.real(known[*number].minimum, known[*number].maximum) : 0);
    }
    return command;
  }
  document::Command make(Tag<document::SetKeySlopes>) {
    const document::OfKeys key = one_key();
    return document::SetKeySlopes{key.times_s.front(), key.names.front(), random_.real(-3, 3), random_.real(-3, 3)};
  }
  document::Command make(Tag<document::Tween>) {
    return document::Tween{random_.real(0, 4), random_.real(-0.2, 1.2), {}};
  }
  document::Command make(Tag<document::GoToTime>) { return document::GoToTime{random_.real(0, 4)}; }
  document::Command make(Tag<document::SaveView>) {
    document::View from = view();
    from.camera.eye.x += random_.real(-1, 1);
    return document::SaveView{random_.chance(0.5) ? "front" : "side", from};
  }
  document::Command make(Tag<document::NameView>) {
    return document::NameView{doc().views.empty() ? "side" : any(doc().views)->name, fresh_name()};
  }
  document::Command make(Tag<document::KeyCamera>) {
    document::View from = view();
    from.camera.eye.x += random_.real(-1, 1);
    const document::KeyKind kinds[] = {document::KeyKind::smooth, document::KeyKind::linear,
                                       document::KeyKind::stepped};
    return document::KeyCamera{random_.real(0, 4), from, kinds[random_.below(3)]};
  }
  document::Command make(Tag<document::DeleteCameraKeys>) {
    if (!doc().camera) return make(Tag<document::KeyCamera>{});
    return document::DeleteCameraKeys{{any(doc().camera->keys).time_s}};
  }
  document::Command make(Tag<document::MoveCameraKey>) {
    if (!doc().camera) return make(Tag<document::KeyCamera>{});
    return document::MoveCameraKey{any(doc().camera->keys).time_s, random_.real(0, 4)};
  }
  document::Command make(Tag<document::SetReference>) {
    document::ReferencePicture picture;
    picture.file = fresh_name();
    picture.opacity = random_.real(0, 1);
    picture.beside = random_.chance(0.5);
    return document::SetReference{picture};
  }
  document::Command make(Tag<document::RemoveReference>) { return document::RemoveReference{}; }
  document::Command make(Tag<document::DeleteView>) {
    return document::DeleteView{doc().views.empty() ? "side" : any(doc().views)->name};
  }

  document::Command make(Tag<document::RedrawArc>) {
    const double from_s = random_.real(0, 3);
    return document::RedrawArc{{static_cast<std::uint32_t>(random_.below(40)), {0.5, 0.25, 0.25}},
                               view(),
                               from_s,
                               from_s + random_.real(0.1, 1),
                               24,
                               hand_.line(),
                               {}};
  }

  /// Holds what the keys move, and something else; without keys there is nothing to suggest, so that it keys first.
  document::Command make(Tag<document::SuggestRest>) {
    constexpr std::size_t k_enough_keys = 4;
    if (doc().timeline->keys.size() < k_enough_keys) return make(Tag<document::SetKey>{});
    document::SuggestRest command{{parameter()}, random_.real(0.2, 1)};
    const auto known = doc().model->rig->parameters();
    const auto& keys = doc().timeline->keys;
    for (std::size_t i = 0; i < known.size() && !keys.empty(); ++i) {
      if (keys.front().pose[i] == keys.back().pose[i]) continue;
      command.held.push_back(known[i].name);
      break;
    }
    return command;
  }

  document::Command make(Tag<document::BeginCorrection>) { return document::BeginCorrection{}; }
  document::Command make(Tag<document::DeleteCorrection>) {
    const auto& corrections = doc().model->corrections;
    return document::DeleteCorrection{corrections ? any(corrections->all())->drawn.sketch.name : "correction 1"};
  }
  document::Command make(Tag<document::TakeRegion>) {
    if (random_.chance(0.5)) return document::TakeRegion{articulation::Reach::front, {}};
    return document::TakeRegion{articulation::Reach::through, {}};
  }
  document::Command make(Tag<document::DrawBetween>) {
    const std::string name = deformer();
    const double value = random_.real(0.2, 0.8);
    return document::DrawBetween{name, value, view(), hand_.line()};
  }
  document::Command make(Tag<document::DeleteBetween>) {
    const std::string name = deformer();
    const auto& set = doc().model->deformers;
    const auto number = set ? articulation::find_deformer(*set, name) : std::nullopt;
    if (!number || set->deformers()[*number]->sketch().betweens.empty()) return document::DeleteBetween{name, 0.5};
    return document::DeleteBetween{name, set->deformers()[*number]->sketch().betweens.front().value};
  }
  document::Command make(Tag<document::PullBetween>) {
    const std::string name = deformer();
    const auto line = hand_.line();
    const double x = random_.real(-20, 20);
    return document::PullBetween{name, 1, view(), line.front(), {x, random_.real(-20, 20)}, random_.real(0, 0.6)};
  }
  document::Command make(Tag<document::PullTarget>) {
    const document::CurveId id = curve(true);
    const auto line = along_target();
    const double x = random_.real(-30, 30);
    return document::PullTarget{id, view(), line.front(), {x, random_.real(-30, 30)}, random_.real(0, 0.6)};
  }
  document::Command make(Tag<document::PlaceCurve>) {
    document::PlaceCurve place;
    const std::size_t count = 1 + random_.below(5);
    for (std::size_t i = 0; i < count; ++i) {
      const double a = random_.real(0, 1);
      const double b = random_.real(0, 1 - a);
      place.points.push_back(
          {static_cast<std::uint32_t>(random_.below(doc().model->mesh->triangle_count())), {a, b, 1 - a - b}});
    }
    place.constraint = random_.chance(0.3);
    return place;
  }
  document::Command make(Tag<document::PlaceTarget>) {
    document::PlaceTarget place;
    place.curve = curve(false);
    const document::PoseCurve* known = document::find_curve(doc(), place.curve);
    if (known == nullptr) return place;
    for (const auto& p : document::positions_of(doc(), known->points)) {
      const double x = random_.real(-0.1, 0.1);
      place.points.push_back(p + geometry::ModelVector(x, random_.real(-0.1, 0.1), 0.05));
    }
    return place;
  }

  /// On a model that names no curve, lines of a face are references and targets.
  document::Command make(Tag<document::DrawFaceLine>) {
    name_a_feature();
    return document::DrawFaceLine{{view(), hand_.line()}};
  }
  document::Command make(Tag<document::NameFaceLine>) {
    if (!doc().face) draw_a_face();
    document::NameFaceLine command{doc().face ? any(doc().face->lines).id : document::CurveId{1}, {}, false};
    const auto& named = doc().model->curves;
    if (random_.chance(0.3)) {
      command.nothing = true;
    } else if (!named.empty() && random_.chance(0.7)) {
      command.feature = any(named).name;
      command.form = random_.chance(0.3);
    }
    return command;
  }
  document::Command make(Tag<document::SetNeutral>) {
    if (!doc().face) draw_a_face();
    return document::SetNeutral{random_.chance(0.8) || !doc().neutral};
  }
  [[nodiscard]] std::string any_feature() { return random_.chance(0.5) ? "lip" : "brow"; }
  document::Command make(Tag<document::DrawFeature>) {
    return document::DrawFeature{view(), hand_.line(), random_.chance(0.3) ? std::string() : any_feature()};
  }
  document::Command make(Tag<document::LineIsFeature>) {
    if (doc().face && random_.chance(0.5)) return document::LineIsFeature{any(doc().face->lines).id, any_feature()};
    return document::LineIsFeature{curve(false), any_feature()};
  }
  document::Command make(Tag<document::PlaceFeature>) {
    document::PlaceFeature command{any_feature(), {}};
    const bool none = random_.chance(0.3);
    for (std::size_t i = 2 + random_.below(4); i > 0 && !none; --i) {
      const double share = random_.real(0, 1);
      const auto triangle = static_cast<std::uint32_t>(random_.below(doc().model->mesh->triangle_count()));
      command.points.push_back({triangle, {share, 1 - share, 0}});
    }
    return command;
  }
  document::Command make(Tag<document::FeatureAsFound>) {
    const auto& features = doc().model->features;
    return document::FeatureAsFound{features.empty() ? "lip" : any(features).name};
  }

  document::Command make(Tag<document::KeyPoses>) {
    document::KeyPoses keys;
    const auto parameters = doc().model->rig->parameters();
    for (const auto& parameter : parameters) {
      if (random_.chance(0.3)) keys.names.push_back(parameter.name);
    }
    double time = random_.real(0, 3);
    for (std::size_t i = 1 + random_.below(6); i > 0; --i) {
      keys.times_s.push_back(time);
      time += random_.real(0.01, 0.5);
      for (const std::string& name : keys.names) {
        const auto& parameter = parameters[*rig::find_parameter(parameters, name)];
        keys.values.push_back(random_.real(parameter.minimum, parameter.maximum));
      }
    }
    return keys;
  }

  document::Command make(Tag<document::SetSound>) {
    return document::SetSound{
        random_.chance(0.5) ? "talk.wav" : "song.ogg", {random_.below(9), 7}, random_.real(-1, 2)};
  }
  document::Command make(Tag<document::RemoveSound>) { return document::RemoveSound{}; }
  document::Command make(Tag<document::MoveSound>) {
    if (!doc().sound) return make(Tag<document::SetSound>{});
    return document::MoveSound{random_.real(-1, 2)};
  }
  document::Command make(Tag<document::SetMouth>) {
    const auto parameters = doc().model->rig->parameters();
    document::SetMouth command{random_.chance(0.5) ? "open" : "closed", {}};
    const auto& moved = parameters[random_.below(parameters.size())];
    command.values.push_back({moved.name, random_.real(moved.minimum, moved.maximum)});
    return command;
  }
  document::Command make(Tag<document::DeleteMouth>) {
    return document::DeleteMouth{doc().mouths.empty() ? "open" : any(doc().mouths)->name};
  }
  document::Command make(Tag<document::KeyMouths>) {
    if (doc().mouths.empty()) return make(Tag<document::SetMouth>{});
    document::KeyMouths command;
    double time = random_.real(0, 2);
    for (std::size_t i = 1 + random_.below(4); i > 0; --i) {
      command.times_s.push_back(time);
      command.mouths.push_back(any(doc().mouths)->name);
      time += random_.real(0.05, 0.4);
    }
    return command;
  }

  document::Command make(Tag<document::SetWords>) {
    if (!doc().sound) return make(Tag<document::SetSound>{});
    document::SetWords command;
    for (std::size_t i = random_.below(4); i > 0; --i) {
      command.times_s.push_back(random_.real(0, 0.4) + (command.times_s.empty() ? 0 : command.times_s.back()));
      command.words.push_back(fresh_name());
    }
    return command;
  }
  document::Command make(Tag<document::SetBookmark>) {
    return document::SetBookmark{random_.real(0, 3), random_.chance(0.5) ? fresh_name() : std::string(),
                                 static_cast<std::uint32_t>(random_.below(document::k_bookmark_colors))};
  }
  document::Command make(Tag<document::MoveBookmark>) {
    if (!doc().bookmarks) return make(Tag<document::SetBookmark>{});
    return document::MoveBookmark{any(*doc().bookmarks).time_s, random_.real(0, 3)};
  }
  document::Command make(Tag<document::DeleteBookmark>) {
    if (!doc().bookmarks) return make(Tag<document::SetBookmark>{});
    return document::DeleteBookmark{{any(*doc().bookmarks).time_s}};
  }

  document::Command make(Tag<document::OpenClip>) {
    const std::size_t animations = doc().model->animations.size();
    if (animations == 0) return make(Tag<document::AddClip>{});
    return document::OpenClip{static_cast<std::uint32_t>(random_.below(animations))};
  }
  document::Command make(Tag<document::ShowClip>) {
    if (doc().clips.empty()) return make(Tag<document::AddClip>{});
    return document::ShowClip{static_cast<std::uint32_t>(random_.below(doc().clips.size()))};
  }
  document::Command make(Tag<document::AddClip>) {
    return document::AddClip{"clip " + std::to_string(random_.below(1000)), random_.chance(0.5)};
  }
  document::Command make(Tag<document::NameClip>) {
    return document::NameClip{{"clip " + std::to_string(random_.below(1000))}};
  }
  document::Command make(Tag<document::DeleteClip>) {
    if (doc().clips.size() < 2) return make(Tag<document::AddClip>{});
    return document::DeleteClip{};
  }
  document::Command make(Tag<document::TrimClip>) {
    const double from_s = random_.real(0, 1);
    return document::TrimClip{from_s, from_s + random_.real(0.1, 2)};
  }

  /// One stroke of any tool, and before it what it goes on from where that is not there.
  void stroke() {
    drawing::Tool tool;
    tool.kind = static_cast<drawing::ToolKind>(random_.below(k_tools));
    using Kind = drawing::ToolKind;
    if (tool.kind == Kind::target) static_cast<void>(script_.perform(make(Tag<document::DrawReference>{})));
    if (tool.kind == Kind::oversketch || tool.kind == Kind::erase) draw_pair();
    if (tool.kind == Kind::redraw || tool.kind == Kind::between) {
      if (!doc().model->deformers) sketch_control();
      tool.deformer = deformer();
      tool.value = random_.real(0.2, 0.8);
    }
    static_cast<void>(script_.act(replay::ToolChosen{tool}));
    if (tool.kind == Kind::draw) name_a_feature();
    const bool along = tool.kind == Kind::erase || tool.kind == Kind::oversketch;
    auto line = along || random_.chance(0.3) ? along_target() : hand_.line();
    if (tool.kind == Kind::articulate && drawing::next_step(doc(), tool) != articulation::CurveRole::target) {
      const bool inner = drawing::next_step(doc(), tool) == articulation::CurveRole::specific;
      line = hand_.lasso(middle(), inner ? random_.real(60, 170) : random_.real(180, 300));
    }
    if (tool.kind == Kind::feature) line = along_a_feature();
    const double pressure = random_.real(0.05, 1);
    const bool draws = tool.kind != Kind::none;
    if (script_.stroke(line, pressure) && draws) drawn_.emplace(k_kinds[static_cast<std::size_t>(tool.kind)]);
  }
  /// A reference and its target.
  void draw_pair() {
    static_cast<void>(script_.perform(document::DrawReference{view(), hand_.line()}));
    const document::CurveId id{doc().last_curve};
    static_cast<void>(script_.perform(document::DrawTarget{id, view(), hand_.line(), {}}));
  }
  void name_a_feature() {
    if (!doc().model->curves.empty()) return;
    static_cast<void>(script_.perform(document::DrawReference{view(), hand_.line()}));
    static_cast<void>(script_.perform(document::NameCurve{document::CurveId{doc().last_curve}, "lip"}));
  }
  /// A line along which a feature was just drawn.
  std::vector<geometry::PxPoint> along_a_feature() {
    auto line = hand_.line();
    static_cast<void>(script_.perform(document::DrawFeature{view(), line, "lip"}));
    return line;
  }
  void draw_a_face() {
    name_a_feature();
    static_cast<void>(script_.perform(document::DrawFaceLine{{view(), hand_.line()}}));
  }
  /// A control in as few strokes as may be.
  void sketch_control() {
    using articulation::CurveRole;
    const document::View from = view();
    static_cast<void>(script_.perform(document::CancelDeformer{}));
    for (const auto role : {CurveRole::general, CurveRole::specific}) {
      const double half = role == CurveRole::general ? random_.real(180, 300) : random_.real(60, 170);
      static_cast<void>(script_.perform(document::SketchCurve{role, from, hand_.lasso(middle(), half)}));
    }
    static_cast<void>(script_.perform(document::SketchCurve{CurveRole::target, from, hand_.line()}));
  }
  [[nodiscard]] geometry::PxPoint middle() const {
    const geometry::Viewport viewport = view().viewport;
    return {viewport.width * 0.5, viewport.height * 0.5};
  }

  [[nodiscard]] const document::Document& doc() const { return script_.document(); }
  [[nodiscard]] document::View view() const { return script_.editor().view(); }
  template <typename List>
  const typename List::value_type& any(const List& list) {
    return list[random_.below(list.size())];
  }
  std::string parameter() {
    const auto known = doc().model->rig->parameters();
    return known[random_.below(known.size())].name;
  }
  std::string deformer() {
    const auto& set = doc().model->deformers;
    return set ? set->parameters()[random_.below(set->size())].name : "nothing";
  }
  std::string fresh_name() { return "name " + std::to_string(++names_); }
  double key_time() { return doc().timeline->keys.empty() ? 0 : any(doc().timeline->keys).time_s; }
  document::OfKeys one_key() {
    if (doc().timeline->keys.empty()) return {{0}, {parameter()}};
    const document::PoseKey& key = any(doc().timeline->keys);
    const auto known = doc().model->rig->parameters();
    std::vector<std::string> keyed;
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (key.controls.has(i)) keyed.push_back(known[i].name);
    }
    return {{key.time_s}, {any(keyed)}};
  }
  /// A whole moment, or one control's key.
  document::OfKeys some_keys() { return random_.chance(0.5) ? document::OfKeys{{key_time()}, {}} : one_key(); }
  document::CurveId curve(bool with_target) {
    std::vector<document::CurveId> found;
    for (const auto& one : doc().curves) {
      const bool wanted = one->role == document::PoseCurveRole::reference &&
                          (!with_target || (one->target && !one->target->line.empty()));
      if (wanted) found.push_back(one->id);
    }
    return found.empty() ? document::CurveId{1} : any(found);
  }
  /// A line near a part of a target that is there, or any line.
  std::vector<geometry::PxPoint> along_target() {
    const document::PoseCurve* found = document::find_curve(doc(), curve(true));
    if (found == nullptr || !found->target || found->target->line.empty()) return hand_.line();
    const auto& line = found->target->line;
    const std::size_t from = random_.below(line.size() / 2);
    std::vector<geometry::PxPoint> out;
    for (std::size_t i = from; i < line.size(); ++i) out.push_back(line[i] + geometry::PxPoint{random_.real(-3, 3), 4});
    return out;
  }

  SessionScript& script_;
  SplitMix random_;
  RandomHand hand_;
  /// In the order of the committed hashes, wherever the program lists them: a new one comes last.
  static constexpr std::array<std::string_view, std::variant_size_v<document::CommandTypes>> k_commands{
      "set_parameters",
      "reset_parameters",
      "lock_parameters",
      "draw_reference",
      "draw_target",
      "oversketch_target",
      "drag_target",
      "draw_constraint",
      "pin",
      "keep_curve",
      "delete_curve",
      "erase_curves",
      "clear_curves",
      "solve_pose",
      "set_pressure_weighting",
      "name_curve",
      "delete_named_curve",
      "begin_deformer",
      "sketch_curve",
      "cancel_deformer",
      "redraw_curve",
      "change_deformer",
      "mirror_deformer",
      "rename_deformer",
      "delete_deformer",
      "move_deformer",
      "set_key",
      "delete_keys",
      "move_keys",
      "set_key_kind",
      "go_to_time",
      "save_view",
      "delete_view",
      "suggest_rest",
      "set_hand",
      "begin_correction",
      "delete_correction",
      "take_region",
      "draw_between",
      "delete_between",
      "pull_between",
      "pull_target",
      "place_curve",
      "place_target",
      "key_poses",
      "take_reading",
      "draw_face_line",
      "name_face_line",
      "set_neutral",
      "set_key_values",
      "set_key_slopes",
      "tween",
      "redraw_arc",
      "set_sound",
      "remove_sound",
      "move_sound",
      "set_mouth",
      "delete_mouth",
      "key_mouths",
      "open_clip",
      "show_clip",
      "add_clip",
      "name_clip",
      "delete_clip",
      "trim_clip",
      "draw_feature",
      "line_is_feature",
      "place_feature",
      "feature_as_found",
      "set_words",
      "set_bookmark",
      "move_bookmark",
      "delete_bookmark",
      "key_camera",
      "delete_camera_keys",
      "move_camera_key",
      "name_view",
      "set_reference",
      "remove_reference"};
  static constexpr std::size_t k_tools = static_cast<std::size_t>(drawing::ToolKind::feature) + 1;
  std::set<std::string> drawn_;
  int names_ = 0;
  bool pressed_ = false;
};

}  // namespace penpose::tests
