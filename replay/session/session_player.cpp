#include "replay/session/session_player.h"

#include <utility>

#include "core/base/edition.h"
#include "replay/session/by_today/redrawing.h"

namespace penpose::replay {
namespace {

constexpr std::size_t k_most_refusals = 10;

base::Error at_line(std::uint64_t number, base::Error error) {
  const std::string line = "line " + std::to_string(number);
  error.place = error.place.empty() ? line : line + ", " + error.place;
  return error;
}

class Player {
 public:
  Player(ReadBytes read, const PlayerOptions& options)
      : options_(options),
        source_(std::move(read), options.pace, options.wait),
        observer_(options.observer != nullptr ? *options.observer : nobody_) {}

  base::Result<ReplayResult> play();

 private:
  bool stopped() const;
  void on_line(const TraceLine& line);
  bool begins_by_today(std::string_view text, std::uint64_t number);
  void redraw(std::string_view step, std::uint64_t number);
  void perform(const SessionLine& line, std::uint64_t number);
  void on_session_line(const SessionLine& line, std::uint64_t number);
  void begin(const std::string& path, const base::Hash128* expected, std::uint64_t number);
  void begin_plain(std::uint64_t number);
  void note_steps(std::uint64_t number);
  void compare(const StateReached& reached, std::uint64_t number);

  const PlayerOptions& options_;
  TraceSource source_;
  PlayerObserver nobody_;
  PlayerObserver& observer_;
  ReplayResult out_;
  std::optional<Redrawing> redrawing_;
  std::optional<base::Error> error_;  ///< ends the replay
  base::Hash128 model_;               ///< as the session names it
  std::uint64_t long_line_ = 0;       ///< whose pieces are left out
  bool stop_ = false;                 ///< no more is to be drawn
  bool halted_ = false;               ///< and no more is to be read
};

/// All that was asked for is drawn; the state that was recorded after it is still compared.
bool Player::stopped() const {
  if (stop_) return true;
  return options_.stop_after_strokes && out_.session && out_.session->stroke_count() >= *options_.stop_after_strokes;
}

/// Makes the document that is drawn on.
void Player::begin(const std::string& path, const base::Hash128* expected, std::uint64_t number) {
  auto opened = options_.open(path);
  if (!opened) {
    error_ = opened.error();
    if (number > 0) error_ = at_line(number, *error_);
    return;
  }
  if (expected != nullptr) {
    const base::Hash128 hash = document::DocumentHasher()(*opened).whole;
    const bool same = redrawing_ ? redrawing_->began_on(*opened, *expected) : hash == *expected;
    if (!same && !(redrawing_ && options_.may_differ && options_.may_differ(path))) {
      error_ = at_line(number, changed_model_error(path, hash, *expected));
      return;
    }
  }
  out_.model = path;
  out_.session = std::make_unique<Session>(std::move(opened).value(), options_.own_tablets);
  out_.session->listen_to_stroke_ends([this] { observer_.on_stroke_end(); });
  observer_.on_begin(*out_.session, path);
}

/// A plain trace is drawn on the default model; a session says what it was drawn on.
void Player::begin_plain(std::uint64_t number) {
  if (out_.plain) {
    begin({}, nullptr, 0);
    return;
  }
  error_ = number > 0 ? at_line(number, no_model_error()) : no_model_error();
}

void Player::note_steps(std::uint64_t number) {
  for (const SessionStep& step : out_.session->steps()) {
    ++out_.steps;
    if (redrawing_ && step.is_stroke) redrawing_->begin_stroke(number);
    if (redrawing_) redrawing_->did(step.status);
    if (!step.status) {
      ++out_.refused;
      base::Error error = step.status.error();
      if (number > 0) error = at_line(number, std::move(error));
      if (out_.refusals.size() < k_most_refusals) out_.refusals.push_back(std::move(error));
    }
    observer_.on_step(*out_.session, step);
    if (options_.stop_when && options_.stop_when(*out_.session)) stop_ = true;
  }
}

void Player::compare(const StateReached& reached, std::uint64_t number) {
  if (redrawing_) return redrawing_->reached(reached.state, out_.session->editor().document(), number);
  ++out_.checked;
  const document::DocumentState now = out_.session->editor().state();
  if (now == reached.state) return;
  ++out_.differing;
  if (!out_.divergence) out_.divergence = Divergence{number, differing_parts(now, reached.state)};
}

void Player::on_session_line(const SessionLine& line, std::uint64_t number) {
  if (const auto* begins = std::get_if<SessionBegins>(&line)) {
    out_.plain = false;
    out_.program = begins->program;
    return;
  }
  if (const auto* named = std::get_if<ModelNamed>(&line)) {
    if (!out_.session) {
      begin(named->path, &named->hash, number);
      model_ = named->hash;
    } else if (!(named->hash == model_)) {
      error_ = at_line(number, {"another model is named in the middle of the session", "",
                                "replay the sessions that were joined here one by one"});
    }
    return;
  }
  if (!out_.session) begin_plain(number);
  if (error_) return;
  if (const auto* reached = std::get_if<StateReached>(&line)) {
    compare(*reached, number);
    return;
  }
  perform(line, number);
}

void Player::perform(const SessionLine& line, std::uint64_t number) {
  observer_.on_line(line);
  const auto status = out_.session->apply(line, out_.last_us);
  const bool line_refused = !status && out_.session->steps().empty();
  if (line_refused && out_.problems.size() < k_most_refusals) out_.problems.push_back(at_line(number, status.error()));
  note_steps(number);
}

/// Whether a line is the first of a session that is drawn by today.
bool Player::begins_by_today(std::string_view text, std::uint64_t number) {
  const auto origin = options_.by_today ? session_origin(text) : std::nullopt;
  if (!origin || origin->edition > base::k_edition) return false;
  if (!redrawing_) {
    redrawing_.emplace(origin->edition);
  } else if (redrawing_->edition() != origin->edition) {
    error_ = at_line(number, {"another edition is named in the middle of the session", "",
                              "draw the sessions that were joined here again one by one"});
  }
  out_.plain = false;
  out_.program = origin->program;
  return true;
}

/// The line of a step, as what it is today.
void Player::redraw(std::string_view step, std::uint64_t number) {
  if (!out_.session) begin_plain(number);
  if (error_) return;
  const drawing::Editor& editor = out_.session->editor();
  redrawing_->begin_line(number, step);
  const auto lines = redrawing_->today(step, editor.document());
  if (!lines) {
    ++out_.steps;
    ++out_.refused;
  } else {
    for (const SessionLine& line : *lines) perform(line, number);
  }
  if (const auto line = redrawing_->follow_up(editor.document())) perform(*line, number);
}

void Player::on_line(const TraceLine& line) {
  if (error_ || halted_) return;
  // The rest of a last line that was cut off could say something else than the whole, as could a piece of a long one.
  if (line.number == long_line_) return;
  if (line.end.empty()) {
    const bool is_long = line.text.size() >= TraceReader::k_longest_line;
    if (is_long) long_line_ = line.number;
    if (line.text.starts_with('#') && out_.problems.size() < k_most_refusals) {
      out_.problems.push_back(at_line(
          line.number, is_long ? base::Error{"the line is too long for one of a session and was left out", "", ""}
                               : base::Error{"the last line is cut off", "", "everything before it was read"}));
    }
    return;
  }
  std::string_view text = line.text;
  // Editors on some systems put a byte order mark in front of a file.
  if (line.number == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (begins_by_today(text, line.number)) return;
  if (const auto step = redrawing_ ? step_line(text) : std::nullopt) {
    halted_ = stopped();
    if (!halted_) redraw(*step, line.number);
    return;
  }
  const auto parsed = parse_session_line(text);
  if (!parsed) {
    // Lines of a file that says no edition may be anybody's comments; another edition ends everything.
    if (text.starts_with("# penpose session ")) {
      error_ = at_line(line.number, parsed.error());
    } else if (out_.problems.size() < k_most_refusals) {
      out_.problems.push_back(at_line(line.number, parsed.error()));
    }
    return;
  }
  if (!*parsed) return;
  if (stopped() && !std::holds_alternative<StateReached>(**parsed)) {
    halted_ = true;
    return;
  }
  on_session_line(**parsed, line.number);
}

base::Result<ReplayResult> Player::play() {
  source_.listen([this](const TraceLine& line) { on_line(line); },
                 [this](int device, const decode::DeviceIdentity& identity) {
                   if (error_ || stopped()) return;
                   if (!out_.session) begin_plain(0);
                   if (error_) return;
                   observer_.on_device(device, identity);
                   out_.session->connect(device, identity);
                 });
  while (!error_ && !halted_) {
    const auto report = source_.next();
    if (!report) return report.error();
    if (!report->has_value() || error_ || stopped()) break;
    if (out_.reports++ == 0) out_.first_us = (*report)->time_us;
    out_.last_us = (*report)->time_us;
    observer_.on_report(**report);
    out_.session->report((*report)->device, (*report)->time_us, (*report)->bytes);
    note_steps((*report)->line);
  }
  if (error_) return *error_;
  if (redrawing_) out_.redrawn = redrawing_->finish();
  out_.problems.insert(out_.problems.end(), source_.problems().begin(), source_.problems().end());
  return std::move(out_);
}

}  // namespace

base::Error error_of(const Divergence& divergence) {
  std::string parts = divergence.parts.empty() ? "the hash itself" : "";
  for (const std::string_view part : divergence.parts) {
    if (!parts.empty()) parts += ", ";
    parts += part;
  }
  return {"from here on the document is not what was recorded; different are: " + parts,
          "line " + std::to_string(divergence.line),
          "replay with the version that recorded it, or record the session again with --session"};
}

base::Error changed_model_error(const std::string& path, const base::Hash128& found, const base::Hash128& named) {
  return {"the model \"" + path + "\" is not the one that was drawn on: its state is " + found.hex() +
              ", that of the session " + named.hex(),
          "", "name the model of the recording with --model"};
}

base::Error no_model_error() {
  return {"the session does not say what it was drawn on: its line \"# penpose model\" is missing or damaged", "",
          "mend the line, or record the session again"};
}

base::Result<ReplayResult> play_session(ReadBytes read, const PlayerOptions& options) {
  return Player(std::move(read), options).play();
}

}  // namespace penpose::replay
