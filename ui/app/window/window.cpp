#include "ui/app/window/window.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <string>
#include <utility>
#include <vector>

#include "firmware_io/device/clock.h"
#include "ui/app/canvas/soft_shadows.h"
#include "ui/app/view/draw_thread.h"
#include "ui/app/window/full_screen.h"
#include "ui/app/window/screen.h"
#include "ui/app/window/stop_watch.h"
#include "ui/app/window/window_handle.h"
#include "ui/files/process/kept_memory.h"

namespace penpose::app {
namespace {

/// A still picture gets smoother once in so long.
constexpr int k_refine_ms = 30;
/// What came of asking for the full screen is looked at so often.
constexpr int k_look_again_ms = 100;

std::string sdl_error() {
  const std::string text = SDL_GetError();
  return text.empty() ? "no reason given" : text.substr(0, text.find('\n'));
}

/// A key as actions name it; 0 for one that has no name there.
std::uint32_t key_of(SDL_Keycode key) {
  switch (key) {
    case SDLK_ESCAPE:
      return k_key_escape;
    case SDLK_TAB:
      return k_key_tab;
    case SDLK_DELETE:
      return k_key_delete;
    case SDLK_HOME:
      return k_key_home;
    case SDLK_LEFT:
      return k_key_left;
    case SDLK_RIGHT:
      return k_key_right;
    case SDLK_UP:
      return k_key_up;
    case SDLK_DOWN:
      return k_key_down;
    case SDLK_END:
      return k_key_end;
    case SDLK_PAGEUP:
      return k_key_page_up;
    case SDLK_PAGEDOWN:
      return k_key_page_down;
    case SDLK_INSERT:
      return k_key_insert;
    case SDLK_KP_ENTER:
      return k_key_return;
    case SDLK_KP_PLUS:
      return '+';
    case SDLK_KP_MINUS:
      return '-';
    case SDLK_KP_PERIOD:
      return k_key_home;
    default:
      break;
  }
  if (key >= SDLK_KP_1 && key <= SDLK_KP_9) return pad_key(static_cast<std::uint32_t>(key - SDLK_KP_1) + 1);
  if (key == SDLK_KP_0) return pad_key(0);
  if (key >= SDLK_F1 && key <= SDLK_F12) return k_key_f1 + static_cast<std::uint32_t>(key - SDLK_F1);
  if (key >= SDLK_F13 && key <= SDLK_F24) return k_key_f1 + 12 + static_cast<std::uint32_t>(key - SDLK_F13);
  // Keys that are no character lie above all of them.
  return key > 0 && key < 0x110000 ? static_cast<std::uint32_t>(key) : 0;
}

/// What was copied, in this program or another.
std::string copied_text() {
  const std::unique_ptr<char, decltype(&SDL_free)> text(SDL_GetClipboardText(), SDL_free);
  return text ? text.get() : std::string();
}

}  // namespace

struct Window::State {
  Screen screen;
  SDL_Window* window = nullptr;
  SDL_GLContext context = nullptr;  ///< null: the processor draws
  render::DrawWay way = render::DrawWay::gl;
  Uint32 wake_event = 0;
  Uint32 picture_event = 0;  ///< a picture was shown
  bool fullscreen = false;
  std::vector<render::DrawWay> untried;  ///< ways to draw, the best first

  explicit State(const files::WindowRequest& request) : screen(request) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { close(); }

  /// Opens it anew as it is.
  base::Status restart();
  /// Opens the window for the first of the `untried` ways that starts, in place of the one that it is open for. Errors:
  /// what the last one lacks.
  base::Status start();
  base::Status start(render::DrawWay one);
  void close();
  [[nodiscard]] std::unique_ptr<Presenter> presenter();
  void take_event(const SDL_Event& event, App& app, Interface& interface);
  static void take_key(const SDL_KeyboardEvent& key, Interface& interface);
};

void Window::State::close() {
  if (context != nullptr) SDL_GL_DeleteContext(std::exchange(context, nullptr));
  if (window != nullptr) SDL_DestroyWindow(std::exchange(window, nullptr));
}

base::Status Window::State::start() {
  base::Status started{base::Done{}};
  while (!untried.empty()) {
    close();
    way = untried.front();
    untried.erase(untried.begin());
    started = start(way);
    if (!started) continue;
    screen.take(window);
    break;
  }
  return started;
}

base::Status Window::State::restart() {
  untried = {way};
  return start();
}

base::Status Window::State::start(render::DrawWay one) {
  if (const auto started = screen.start(one); !started) return started.error();
  const auto open_window = [&](std::uint32_t flags) {
    flags |= SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    if (fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    const SDL_Rect place = screen.place_of_window(fullscreen);
    return SDL_CreateWindow("penpose", place.x, place.y, place.w, place.h, flags);
  };
  // Px of the window itself, not of a texture that a graphics card shows in it.
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, one == render::DrawWay::cpu ? "0" : nullptr);
  if (one == render::DrawWay::cpu) {
    window = open_window(0);
    if (window != nullptr) return base::Done{};
    return base::Error{"no window could be opened (" + sdl_error() + ")", "", "start it on a desktop"};
  }
  const auto opened = open_gl_window(one, open_window);
  if (!opened) return opened.error();
  window = opened->window;
  context = opened->context;
  return base::Done{};
}

std::unique_ptr<Presenter> Window::State::presenter() {
  if (way == render::DrawWay::cpu) return screen.cpu_presenter();
  return make_gl_presenter({window, context}, way);
}

void Window::State::take_key(const SDL_KeyboardEvent& key, Interface& interface) {
  const bool ctrl = (key.keysym.mod & KMOD_CTRL) != 0;
  const bool shift = (key.keysym.mod & KMOD_SHIFT) != 0;
  const bool down = key.type == SDL_KEYDOWN;
  // Alt belongs to the desktop.
  if (down && (key.keysym.mod & KMOD_ALT) != 0) return;
  interface.key(key.keysym.scancode, {key_of(key.keysym.sym), ctrl, shift}, down);
}

void Window::State::take_event(const SDL_Event& event, App& app, Interface& interface) {
  const auto button_of = [](Uint8 button) {
    return button == SDL_BUTTON_LEFT     ? MouseButton::left
           : button == SDL_BUTTON_MIDDLE ? MouseButton::middle
                                         : MouseButton::right;
  };
  const auto finger = [&](FingerKind kind) {
    const PxPoint at = screen.of_finger(static_cast<double>(event.tfinger.x), static_cast<double>(event.tfinger.y));
    app.of<Pointer>().finger(kind, event.tfinger.fingerId, at);
  };
  switch (event.type) {
    case SDL_QUIT:
      app.of<Leaving>().ask_to_quit();
      break;
    case SDL_MOUSEMOTION: {
      const SDL_MouseMotionEvent& motion = event.motion;
      const PxPoint at = screen.moved_mouse({static_cast<double>(motion.x), static_cast<double>(motion.y)},
                                            {static_cast<double>(motion.xrel), static_cast<double>(motion.yrel)});
      if (screen.lacks_pointer()) interface.show_pointer(at);
      app.of<Pointer>().moved(at);
      break;
    }
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
      if (event.button.button > SDL_BUTTON_RIGHT) break;
      const SDL_Keymod held = SDL_GetModState();
      app.of<Pointer>().button(button_of(event.button.button), event.type == SDL_MOUSEBUTTONDOWN,
                               screen.of_mouse(event.button.x, event.button.y), (held & KMOD_SHIFT) != 0,
                               (held & KMOD_CTRL) != 0);
      break;
    }
    case SDL_MOUSEWHEEL:
      app.of<Pointer>().wheel(static_cast<double>(event.wheel.preciseY));
      break;
    case SDL_FINGERDOWN:
      interface.show_pointer(std::nullopt);
      finger(FingerKind::down);
      break;
    case SDL_FINGERMOTION:
      finger(FingerKind::move);
      break;
    case SDL_FINGERUP:
      finger(FingerKind::up);
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      take_key(event.key, interface);
      break;
    case SDL_TEXTINPUT:
      interface.text(event.text.text);
      break;
    case SDL_DROPFILE:
      app.of<DropDesk>().drop(event.drop.file);
      SDL_free(event.drop.file);
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_LEAVE) app.of<Pointer>().left();
      break;
    default:
      break;
  }
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::~Window() = default;

base::Result<std::unique_ptr<Window>> Window::open(const files::WindowRequest& request) {
  // Fingers come as fingers alone, and a click into a window that was behind another one counts.
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");
  SDL_SetHint(SDL_HINT_MOUSE_TOUCH_EVENTS, "0");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  // Video may start several times; what wakes the window up in between is not lost.
  SDL_InitSubSystem(SDL_INIT_EVENTS);
  auto state = std::make_unique<State>(request);
  const auto way = state->screen.only_way() ? state->screen.only_way() : render::way_of(request.draw);
  state->fullscreen = request.fullscreen;
  state->untried = way ? std::vector{*way} : render::built_in_ways();
  if (const auto started = state->start(); !started) return started.error();
  state->wake_event = SDL_RegisterEvents(2);
  state->picture_event = state->wake_event + 1;
  return std::unique_ptr<Window>(new Window(std::move(state)));
}

std::string Window::handle() const { return window_handle(state_->window); }

void Window::wake() const {
  SDL_Event event{};
  event.type = state_->wake_event;
  SDL_PushEvent(&event);
}

base::Status Window::run(App& app, Interface& interface, Tablets& tablets, Timings& timings, const live::Listener& live,
                         bool until_played) {
  SDL_Event picture_shown{};
  picture_shown.type = state_->picture_event;
  const auto start_drawing = [&] {
    return DrawThread::start(state_->presenter(), [&] { SDL_PushEvent(&picture_shown); });
  };
  auto drawing = start_drawing();
  // A driver may offer what it then refuses.
  while (!drawing && !state_->untried.empty() && state_->start()) drawing = start_drawing();
  if (!drawing) return drawing.error();
  DrawThread* thread = drawing->get();
  Canvas& canvas = app.of<Canvas>();
  const CanvasLook& look = app.of<CanvasLook>();
  const Preferences& preferences = app.of<Preferences>();
  SoftShadows shadows([this] { wake(); });
  const Files& files = app.of<Files>();
  const EditingSession& editing = app.of<EditingSession>();
  UndrawnTextures& undrawn_textures = app.of<UndrawnTextures>();
  const Player& player = app.of<Player>();
  Leaving& leaving = app.of<Leaving>();
  FrameMaker frames({editing, canvas, look, app.of<CanvasDrawing>(), app.of<Controls>(), preferences, app.of<Cast>()});
  interface.share_clipboard({copied_text, [](const char* text) { SDL_SetClipboardText(text); }});
  SDL_StartTextInput();
  unsigned looks = 0;  // at the system's devices
  std::optional<FullScreen> full_screen(state_->window);
  bool wanted_fullscreen = look.fullscreen;
  int fonts = interface.font_revision();
  std::uint64_t pose_number = canvas.surface().pose_number();
  std::string title;
  std::int64_t last_us = device::monotonic_us();
  base::Status status = base::Done{};
  bool due = true;  // something happened that the last frame does not show
  while (!leaving.wants_quit()) {
    // While a frame is being drawn the next one waits, and reports do not.
    const bool busy = thread->busy();
    int wait_ms = interface.unsettled() || due ? 0 : app.next_frame_ms();
    if (const int tip_ms = interface.next_frame_ms(); tip_ms >= 0 && (wait_ms < 0 || wait_ms > tip_ms))
      wait_ms = tip_ms;
    if (thread->refining() && (wait_ms < 0 || wait_ms > k_refine_ms)) wait_ms = k_refine_ms;
    if (full_screen->waits() && (wait_ms < 0 || wait_ms > k_look_again_ms)) wait_ms = k_look_again_ms;
    if (busy) wait_ms = player.trace && player.trace->playing() ? std::max(1, app.next_frame_ms()) : -1;
    SDL_Event event;
    const bool came = wait_ms < 0   ? SDL_WaitEvent(&event) == 1
                      : wait_ms > 0 ? SDL_WaitEventTimeout(&event, wait_ms) == 1
                                    : SDL_PollEvent(&event) == 1;
    if (!came) due = true;
    if (came) {
      do {
        if (event.type == state_->picture_event) continue;
        due = true;
        if (event.type != state_->wake_event) interface.disturb();
        state_->take_event(event, app, interface);
      } while (SDL_PollEvent(&event) == 1);
    }
    tablets.set_exclusive((SDL_GetWindowFlags(state_->window) & SDL_WINDOW_INPUT_FOCUS) != 0);
    tablets.take(app.of<TabletEvents>(), app.of<Notices>());
    const unsigned before = std::exchange(looks, tablets.looks());
    if (looks != before && state_->screen.lacks_input()) {
      drawing->reset();
      if (const auto restarted = state_->restart(); !restarted) return restarted;
      drawing = start_drawing();
      if (!drawing) return drawing.error();
      thread = drawing->get();
      full_screen.emplace(state_->window);
      app.of<Pointer>().left();
      SDL_StartTextInput();
      due = true;
    }
    if (StopWatch::asked()) {
      timings.idle_us = device::monotonic_us() - last_us;
      leaving.quit_at_once();
    }
    // Reports that are due, and the face that follows them, are no part of a frame.
    app.advance();
    if (timings.first_frame_us == 0 && thread->drawn_count() > 0) {
      timings.first_frame_us = device::monotonic_us() - timings.began_us;
      // Loading a model and compiling shaders leave much behind that nobody asks for again.
      files::give_back_memory();
    }
    // Whoever waits for a first picture waits for nothing else, and a slow screen shows flat ones best.
    const bool shaded = preferences.settings().soft_shadows && !state_->screen.slow();
    if (timings.first_frame_us != 0) due = shadows.follow(canvas.surface(), shaded) || due;
    status = thread->status();
    if (!status) break;
    const Undrawn undrawn = thread->take_undrawn();
    undrawn_textures.add(undrawn.look, undrawn.names);
    // The picture that was drawn last may have found the window larger or smaller.
    const auto drawable = thread->drawable();
    due = full_screen->settle(drawable, device::monotonic_us()) || (drawable && !(*drawable == canvas.window())) || due;
    if (!due || thread->busy()) continue;
    due = false;
    if (look.fullscreen != wanted_fullscreen) {
      wanted_fullscreen = look.fullscreen;
      full_screen->toggle(device::monotonic_us());
    }
    const std::int64_t cpu_before = thread_cpu_us();
    const std::int64_t now = device::monotonic_us();
    app.of<Pointer>().resized(thread->drawable().value_or(state_->screen.size()), state_->screen.dpi(),
                              state_->screen.own_scale());
    app.begin_frame();
    interface.frame(static_cast<double>(now - last_us) * 1e-6);
    last_us = now;
    timings.prepared_us.push_back(thread_cpu_us() - cpu_before);
    if (interface.font_revision() != fonts) {
      fonts = interface.font_revision();
      thread->send_letters();
    }
    thread->draw(frames.make(), *ImGui::GetDrawData());
    live({editing.shown().model()->rig->parameters(), editing.shown().pose(), static_cast<double>(now) * 1e-6});
    timings.frames_us.push_back(thread_cpu_us() - cpu_before);
    if (std::exchange(pose_number, canvas.surface().pose_number()) != canvas.surface().pose_number()) {
      timings.posed_us.push_back(timings.frames_us.back());
    }
    const std::string name = files.project().empty() ? files.path() : files.project();
    const std::string now_title = (files.unsaved() ? "* " : "") + name + " - penpose";
    if (now_title != title) SDL_SetWindowTitle(state_->window, (title = now_title).c_str());
    if (until_played && player.trace && player.trace->finished()) leaving.quit();
  }
  timings.drawn_us = thread->times_us();
  timings.way = render::name_of(state_->way);
  return status;
}

}  // namespace penpose::app
