#include "ui/app/interface.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <utility>

#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panels.h"
#include "ui/app/panels/side/side_width.h"
#include "ui/app/panels/timeline/camera_strip.h"
#include "ui/app/sound/sound_strip.h"
#include "ui/app/tour/tour_panel.h"
#include "ui/app/widgets/font_file.h"
#include "ui/app/widgets/internal/file_pictures.h"
#include "ui/app/widgets/internal/pose_picture.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// A pointer that rests so long wants to know more.
constexpr double k_tip_s = 0.55;
/// Px that it may tremble by meanwhile.
constexpr float k_still_px = 3;
/// So much of a window's width and height is the canvas at least, and so many targets, as far as there is room.
constexpr double k_least_canvas = 0.35, k_least_targets_across = 7, k_least_targets_down = 4.5;
/// Tools and the panel at the side stand at once where so much of its width is left between them.
constexpr double k_canvas_between = 0.5;
/// And so much of its width where the panel at the side is a rail; else there is no rail.
constexpr double k_canvas_beside_rail = 0.72;
/// So far, in targets, a press may tremble before it is a drag.
constexpr double k_drag_slack = 0.25;
constexpr int k_settle_frames = 3;
/// A press that rests so long asks for a menu.
constexpr double k_long_press_s = 0.5;
/// A picture of a pose is looked for so often.
constexpr int k_pose_look_ms = 12;
/// Pictures that are being made are looked for so often.
constexpr int k_picture_look_ms = 60;
/// Latin, dashes, dots and arrows; and the signs that the panels use, which not every font has.
constexpr ImWchar k_letters[] = {0x20, 0x17f, 0x2013, 0x2026, 0x2190, 0x2193, 0x2212, 0x2212, 0};
constexpr ImWchar k_signs[] = {0x21ba, 0x21ba, 0x25b6, 0x25be, 0x2713, 0x2713, 0x270e, 0x270e, 0};
constexpr std::array k_families{"Inter", "Noto Sans", "DejaVu Sans", "Liberation Sans"};
constexpr std::array k_sign_families{"DejaVu Sans"};

}  // namespace

Interface::Interface(App& app)
    : app_(app),
      canvas_(app.of<Canvas>()),
      hits_(app.of<HitMap>()),
      panels_(app.of<PanelState>()),
      dialogs_(app.of<Dialogs>()),
      actions_(app.of<Actions>()),
      input_(app.of<PanelInput>()),
      preferences_(app.of<Preferences>()),
      pictures_(std::make_unique<PosePictures>()),
      file_pictures_(std::make_unique<FilePictures>()) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  map_edit_keys();
  panels_.side_closed = preferences_.settings().side_closed;
  apply_look();
  disturb();
}

Interface::~Interface() { ImGui::DestroyContext(); }

void Interface::share_clipboard(Clipboard clipboard) {
  clipboard_ = std::move(clipboard);
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* self) {
    auto& interface = *static_cast<Interface*>(self);
    interface.pasted_ = interface.clipboard_.read();
    return interface.pasted_.c_str();
  };
  io.SetClipboardTextFn = [](void* self, const char* text) { static_cast<Interface*>(self)->clipboard_.write(text); };
}

void Interface::disturb() { unsettled_ = k_settle_frames; }

void Interface::apply_look() {
  const double scale = canvas_.scale();
  const bool light = preferences_.settings().light;
  const bool pictures = (panels_.pictured() && !pictures_->reserved()) || file_pictures_->wants_room();
  if (scale == look_scale_ && light == look_light_ && !pictures) return;
  if (scale != look_scale_ || pictures) load_fonts(scale);
  look_scale_ = scale;
  look_light_ = light;
  use_theme(light, static_cast<float>(scale));
}

void Interface::load_fonts(double scale) {
  static const std::string text_file = font_file(k_families);
  static const std::string sign_file = font_file(k_sign_families);
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  for (const float size : {k_text_px, k_small_px, k_title_px}) {
    const float px = std::round(size * static_cast<float>(scale));
    if (text_file.empty() || fonts.AddFontFromFileTTF(text_file.c_str(), px, nullptr, k_letters) == nullptr) {
      ImFontConfig config;
      config.SizePixels = px;
      fonts.AddFontDefault(&config);
    }
    if (sign_file.empty() || size != k_text_px) continue;
    ImFontConfig config;
    config.MergeMode = true;
    fonts.AddFontFromFileTTF(sign_file.c_str(), px, &config, k_signs);
  }
  // Poses are pictured only where somebody looks at them.
  if (panels_.pictured() || pictures_->reserved()) pictures_->reserve(fonts);
  if (file_pictures_->wants_room() || file_pictures_->reserved()) file_pictures_->reserve(fonts);
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
  ++font_revision_;
}

void Interface::rest_pointer(double passed_s) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool moved = std::abs(io.MousePos.x - rested_at_.first) > k_still_px ||
                     std::abs(io.MousePos.y - rested_at_.second) > k_still_px;
  if (moved || io.MouseDown[0]) {
    rested_at_ = {io.MousePos.x, io.MousePos.y};
    rested_s_ = 0;
  } else {
    rested_s_ += passed_s;
  }
}

void Interface::time_press(double passed_s) {
  const bool held = drag_scroll_.held();
  held_s_ = held ? held_s_ + passed_s : 0;
  held_told_ = held && held_told_;
}

int Interface::next_frame_ms() const {
  // A press and its release are told in two frames.
  if (!told_.empty()) return 1;
  if (drag_scroll_.held() && !held_told_)
    return std::max(1, static_cast<int>(std::ceil(1000 * (k_long_press_s - held_s_))));
  if (pictures_->waits()) return k_pose_look_ms;
  if (file_pictures_->waits() && shown_ != Dialog::none) return k_picture_look_ms;
  if (!tip_waits_) return -1;
  return std::max(1, static_cast<int>(std::ceil(1000 * (k_tip_s - rested_s_))));
}

void Interface::frame(double passed_s) {
  ImGuiIO& io = ImGui::GetIO();
  apply_look();
  const auto window = canvas_.window();
  io.DisplaySize = {static_cast<float>(window.width), static_cast<float>(window.height)};
  io.DeltaTime = static_cast<float>(std::clamp(passed_s, 1e-4, 0.5));
  // A dialog that opens knows nothing of what was pressed before.
  const Dialog dialog = dialogs_.open();
  const bool opens = std::exchange(shown_, dialog) != dialog;
  if (opens) {
    dialog_area_.reset();
    types_ = has_field_ = false;
    dialogs_.state<KeyAsked>().waits = false;
    opening_ = panels_.has_keyboard ? 2 : 0;
  }
  time_press(passed_s);
  take_pointer();
  take_typed();
  rest_pointer(passed_s);
  ImGui::NewFrame();
  targets_.clear();
  hits_ = {};
  app_.lay_out();
  const auto unit = static_cast<float>(canvas_.target_px());
  pictures_->begin_frame();
  PanelContext context{actions_,
                       hits_,
                       panels_.own,
                       canvas_.free_area(),
                       panels_.shown,
                       window,
                       targets_,
                       *pictures_,
                       *file_pictures_,
                       unit,
                       static_cast<float>(6 * canvas_.scale())};
  context.dialog_opens = opens;
  context.tip_due = rested_s_ >= k_tip_s;
  context.hovers = hovers_;
  context.long_press = !held_told_ && held_s_ >= k_long_press_s && drag_scroll_.held();
  held_told_ = held_told_ || context.long_press;
  context.accepts = std::exchange(accepts_, false);
  context.cancels = std::exchange(cancels_, false);
  context.field_first = !wants_keys() && !io.MouseDown[0] && (types_ || opening_ > 0);
  if (opening_ > 0) --opening_;
  context.scrolled = drag_scroll_.take();
  if (context.scrolled) disturb();
  show_all(context);
  show_keyboard(context);
  draw_pointer();
  if (pictures_->take_changed()) ++font_revision_;
  if (file_pictures_->take_changed()) ++font_revision_;
  if (file_pictures_->wants_room()) disturb();
  if (pictures_->take_more()) disturb();
  if (context.takes_long_press) {
    drag_scroll_.drop();
    disturb();
  }
  if (panels_.side_closed != preferences_.settings().side_closed) {
    preferences_.settings().side_closed = panels_.side_closed;
    preferences_.changed();
  }
  menu_open_ = context.menu_open;
  fields_ = std::move(context.fields);
  tip_ = std::move(context.tip);
  tip_waits_ = context.tip_waits && !context.tip_due && !io.MouseDown[0];
  // ImGui shows a window that fits its text one frame after it is made.
  const bool tip_shows = context.tip_waits && context.tip_due;
  if (std::exchange(tip_shows_, tip_shows) != tip_shows) disturb();
  has_field_ = context.has_field;
  dialog_area_ = context.dialog_area;
  drag_scroll_.set_areas(std::move(menu_open_ ? context.menu_scrolls : context.scrolls));
  ImGui::Render();
  if (unsettled_ > 0) --unsettled_;
  if (!input_.pointer().empty() || !told_.empty() || !typed_.empty() || shown_ != dialogs_.open()) disturb();
}

double Interface::timeline_height(double strips, double most, double buttons, double usual) {
  TimelineShown& shown = panels_.own.of<TimelineShown>();
  shown.rows_px = 0;
  if (most < strips) return buttons;
  if (shown.part == TimelinePart::poses) return strips;
  const Settings& settings = preferences_.settings();
  const double chosen = shown.part == TimelinePart::sheet ? settings.sheet_height : settings.curves_height;
  shown.rows_px = std::min(most - strips, chosen > 0 ? chosen * canvas_.scale() : usual);
  return strips + shown.rows_px;
}

void Interface::show_all(PanelContext& context) {
  const auto unit = static_cast<double>(context.unit);
  const auto gap = static_cast<double>(context.gap);
  const double width = context.window.width;
  const double height = context.window.height;
  const double top = unit + 2 * gap;
  const double open = side_width(context, panels_, width);
  double right = std::min(open, 0.4 * width);
  const double status = 0.7 * unit;
  const bool plays = app_.of<Player>().trace.has_value();
  const double player = plays ? unit + 2 * gap : 0;
  // The sheet and the curves take what the canvas can spare.
  const double most = height - top - player - status - std::max(k_least_canvas * height, k_least_targets_down * unit);
  double bottom = 3 * unit + 4 * gap + sound_strip_height(context, app_.of<SoundTrack>());
  bottom += camera_strip_height(context, app_.of<CameraDesk>());
  // Tools stay as they are when the timeline grows: they scroll where they have no room.
  auto& toolbar = panels_.own.of<ToolbarLayout>();
  toolbar = toolbar_layout(context, static_cast<float>(height - (most < bottom ? unit + 2 * gap : bottom) - top));
  bottom = timeline_height(bottom, most, unit + 2 * gap, std::min(6 * unit, 0.35 * height));
  double left = static_cast<double>(toolbar.width);
  // A small window has the tools or the panel at the side, and of the timeline its buttons alone.
  panels_.narrow = width - left - right < std::max(k_canvas_between * width, k_least_targets_across * unit);
  if (panels_.narrow) {
    right = panels_.side_in_turn ? std::min(open, (1 - k_least_canvas) * width) : 0;
    if (panels_.side_in_turn) left = 0;
  }
  // Closed it is a rail, where that leaves room for the canvas.
  if (!panels_.side_open()) {
    const double rail = unit + 2 * gap;
    const bool fits = width - left - rail >= std::max(k_canvas_beside_rail * width, k_least_targets_across * unit);
    right = fits ? rail : 0;
  }
  const auto show = [&](PanelPlace place, const Area& area) { show_panels(context, app_, place, area); };
  Area free{0, 0, width, height};
  const double foot = height - (panels_.shown ? bottom : 0);
  if (panels_.shown) {
    free = {left, top, width - right, height - bottom - player - status};
    show(PanelPlace::top, {0, 0, width, top});
    if (left > 0) show(PanelPlace::left, {0, top, left, height - bottom});
    if (right > 0) show(PanelPlace::right, {width - right, top, width, height - bottom});
    show(PanelPlace::status, {left, height - bottom - player - status, width - right, height - bottom - player});
    show(PanelPlace::timeline, {0, height - bottom, width, height});
  } else {
    // The way back, for whoever has no keyboard at hand.
    if (begin_panel(context, "back", {0, 0, 3 * unit, top})) action_button(context, Action::panels, -1);
    end_panel();
  }
  if (plays) show(PanelPlace::player, {free.left, foot - player, free.right, foot});
  if (const double card = tour_height(context, free.width(), app_.of<TourGuide>()); card > 0) {
    free.bottom -= card;
    show(PanelPlace::tour, {free.left, free.bottom, free.right, free.bottom + card});
  }
  canvas_.set_free_area(free);
  show(PanelPlace::canvas, free);
  show(PanelPlace::window, {0, 0, width, height});
}

void Interface::take_pointer() {
  ImGuiIO& io = ImGui::GetIO();
  if (pressed_frames_ > 0) --pressed_frames_;
  // One press or release a frame, so that none is lost.
  if (key_to_release_ >= 0) {
    io.KeysDown[key_to_release_] = false;
    key_to_release_ = -1;
  }
  auto& pointer = input_.pointer();
  while (!told_.empty() || !pointer.empty()) {
    if (told_.empty()) {
      const PanelPointer next = pointer.front();
      pointer.pop_front();
      disturb();
      const bool near = std::hypot(next.at.x - last_told_.at.x, next.at.y - last_told_.at.y) <= k_still_px;
      if (!last_told_.down && (!next.down || !near)) hovers_ = !next.down;
      last_told_ = next;
      if (!drag_scroll_.active() && type_on_screen(next)) {
        if (key_to_release_ >= 0) break;
        continue;
      }
      const auto told = drag_scroll_.add(next, k_drag_slack * canvas_.target_px());
      told_.insert(told_.end(), told.begin(), told.end());
      continue;
    }
    const PanelPointer next = told_.front();
    told_.pop_front();
    io.MousePos = {static_cast<float>(next.at.x), static_cast<float>(next.at.y)};
    // What lies behind a dialog is neither lit nor pressed.
    const bool behind = shown_ != Dialog::none && !(dialog_area_ && dialog_area_->holds(next.at));
    const bool down = next.down && (!behind || io.MouseDown[0]);
    const bool turned = io.MouseDown[0] != down;
    io.MouseDown[0] = down;
    // A field takes the keyboard a frame after it was pressed.
    if (turned && down) pressed_frames_ = 2;
    if (turned) break;
  }
  const PxPoint at{static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y)};
  if (shown_ != Dialog::none && !io.MouseDown[0] && !(dialog_area_ && dialog_area_->holds(at))) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
  }
  io.MouseWheel = static_cast<float>(input_.take_wheel());
  io.MouseDown[1] = input_.take_menu_asked();
  if (io.MouseDown[1]) disturb();
}

const Area* Interface::find(std::string_view label) const {
  const auto found = targets_.find(label);
  return found == targets_.end() ? nullptr : &found->second;
}

const std::map<std::string, Area, std::less<>>& Interface::targets() const { return targets_; }

}  // namespace penpose::app
