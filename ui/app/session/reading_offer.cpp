#include "ui/app/session/reading_offer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/document/drawing/moment.h"
#include "core/document/drawing/pose_problem.h"
#include "ui/app/face/feature_words.h"

namespace penpose::app {
namespace {

/// Share of its range from which on a control differs between two readings.
constexpr double k_differs = 0.005;
/// Controls that are named.
constexpr std::size_t k_named_readings = 2;
/// Two sides are one where they go this near to each other, share of the range.
constexpr double k_alike = 0.1;

using Words = std::span<const document::ControlWords>;

struct Change {
  std::string name;     ///< in words
  double by = 0;        ///< from the pose before the line; 0: the reading takes it back
  double share = 0;     ///< of its range, by which the readings differ
  bool is_new = false;  ///< the reading taken does not move it
};

/// Holds the pose before a line, and the one that its reading gave.
struct Taken {
  const rig::Pose& base;
  const rig::Pose& posed;
};

/// Returns what one reading has that the one taken has not, the most first; both sides of a pair as one.
std::vector<Change> changes_of(const document::Document& document, const Taken& moment, Words words,
                               const rig::Pose& reading) {
  const auto parameters = document.model->rig->parameters();
  const std::vector<std::size_t> pairs = side_pairs(parameters);
  std::vector<Change> out;
  const auto range = [&](std::size_t i) { return parameters[i].maximum - parameters[i].minimum; };
  const auto differs = [&](std::size_t i) { return std::abs(reading[i] - moment.posed[i]) > k_differs * range(i); };
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!differs(i)) continue;
    Change one{words[i].text(), reading[i] - moment.base[i], std::abs(reading[i] - moment.posed[i]) / range(i),
               moment.posed[i] == moment.base[i]};
    const std::size_t other = pairs[i];
    if (other != k_no_pair && differs(other) &&
        std::abs(reading[other] - moment.base[other] - one.by) <= k_alike * range(i)) {
      if (other < i) continue;
      one.name = words_of_pair(words[i], words[other]);
    }
    out.push_back(std::move(one));
  }
  std::stable_sort(out.begin(), out.end(), [](const Change& a, const Change& b) { return a.share > b.share; });
  return out;
}

std::string words_of(const document::Document& document, const Taken& moment, Words words, const rig::Pose& reading) {
  std::vector<Change> changes = changes_of(document, moment, words, reading);
  // What it moves says more than what it takes back, and both more than what goes a little further.
  const auto keep = [&](const auto& test) {
    if (std::any_of(changes.begin(), changes.end(), test))
      std::erase_if(changes, [&](const Change& one) { return !test(one); });
  };
  keep([](const Change& one) { return one.is_new || one.by == 0.0; });
  keep([](const Change& one) { return one.is_new; });
  const bool any = changes.empty() || changes.front().by != 0.0;
  std::string text = any ? "" : "without ";
  for (std::size_t i = 0; i < std::min(k_named_readings, changes.size()); ++i) {
    if (i > 0) text += "; ";
    text += changes[i].name;
    if (!any) continue;
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), " %+.2f", changes[i].by);
    text += number.data();
  }
  if (changes.size() > k_named_readings) text += " and " + std::to_string(changes.size() - k_named_readings) + " more";
  return text;
}

}  // namespace

std::string OfferedReading::brief() const {
  std::string first = words.substr(0, words.find(';'));
  first = first.substr(0, first.find(" and "));
  const std::size_t number = first.find_last_of("+-");
  const bool numbered = number != std::string::npos && number > 0 && first[number - 1] == ' ' &&
                        first.find_first_not_of("0123456789.", number + 1) == std::string::npos;
  return numbered ? first.substr(0, number - 1) : first;
}

std::vector<std::string> words_of_readings(const document::Document& document, Words words) {
  std::vector<std::string> out;
  const document::Moment* moment = document.moment.get();
  if (moment == nullptr || moment->lines.empty() || !document::is_last_line(document, moment->lines.back().curve))
    return out;
  for (const document::Moment::Other& one : moment->others)
    out.push_back(words_of(document, {moment->base, moment->posed}, words, one.pose));
  return out;
}

void ReadingOffer::close(EditingSession& editing) {
  show(editing, std::nullopt);
  readings_.clear();
  face_.forget();
  looked_ = false;
}

void ReadingOffer::follow(EditingSession& editing, bool quiet, std::optional<document::CurveId> asked) {
  const bool stepped = revision_ != editing.revision();
  if (stepped) {
    revision_ = editing.revision();
    drawn_ = newest_.look_at(editing);
  }
  if (quiet || editing.pen_is_drawing()) return close(editing);
  if (asked || drawn_) return look_at_face(editing, asked ? *asked : *drawn_);
  if (!editing.last_stroke().is_newest()) return close(editing);
  if (looked_ && !stepped && !face_.line()) return;
  close(editing);
  looked_ = true;
  look_at_target(editing);
}

void ReadingOffer::look_at_target(EditingSession& editing) {
  const document::Document& document = editing.document();
  std::vector<std::string> words = words_of_readings(document, editing.words());
  nothing_moved_ = editing.last_stroke().movements().empty();
  // A line that lies where its curve is asks for nothing.
  if (nothing_moved_ && editing.last_stroke().within_hand(document, editing.editor().view().viewport)) return;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const document::Moment::Other& other = document.moment->others[i];
    readings_.push_back({std::move(words[i]), static_cast<int>(std::lround(100.0 * other.probability)),
                         document::pose_of_reading(document, i),
                         document::TakeReading{document.moment->lines.back().curve, static_cast<std::uint32_t>(i)}});
  }
}

void ReadingOffer::look_at_face(EditingSession& editing, document::CurveId line) {
  const document::FaceLine* drawn = document::find_face_line(editing.document(), line);
  if (drawn == nullptr) return close(editing);
  const bool anew = face_.line() != line || !face_.is_of(editing.revision());
  if (anew) close(editing);
  nothing_moved_ = drawn->feature.empty();
  const std::size_t known = readings_.size();
  face_.follow(editing, line);
  if (face_.found().size() == known) return;
  readings_.clear();
  const document::Document& document = editing.document();
  const rig::Pose& base = document.face->base.size() == document.pose.size() ? document.face->base : document.pose;
  for (const FaceReading& one : face_.found()) {
    std::string words = words_of(document, {base, document.pose}, editing.words(), one.pose);
    if (words.empty()) words = feature_words(one.command.feature);
    readings_.push_back({std::move(words), std::nullopt, one.pose, one.command, one.command.feature});
  }
}

void ReadingOffer::show(EditingSession& editing, std::optional<std::size_t> which) {
  if (which && *which >= readings_.size()) which.reset();
  if (which == shown_) return;
  // What a slider or the timeline shows meanwhile stays.
  const bool ours = shown_ && editing.shown().previews() && editing.shown().pose() == shown_pose_;
  shown_ = which;
  if (which) {
    shown_pose_ = readings_[*which].pose;
    editing.shown().preview(shown_pose_);
  } else if (ours) {
    editing.shown().preview(std::nullopt);
  }
}

void ReadingOffer::take(EditingSession& editing, std::size_t which) {
  if (which >= readings_.size()) return;
  show(editing, std::nullopt);
  const document::Command command = readings_[which].command;
  editing.perform(command);
}

}  // namespace penpose::app
