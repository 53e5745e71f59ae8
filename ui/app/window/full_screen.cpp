#include "ui/app/window/full_screen.h"

#include <SDL2/SDL.h>

namespace penpose::app {
namespace {

/// A window manager has answered by then.
constexpr std::int64_t k_patience_us = 400'000;

}  // namespace

FullScreen::FullScreen(SDL_Window* window) : window_(window) {
  on_ = (SDL_GetWindowFlags(window_) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
  const Place all = screen();
  // One that began full screen has no place of its own yet.
  before_ = {all.x + all.width / 8, all.y + all.height / 8, all.width * 3 / 4, all.height * 3 / 4};
}

FullScreen::Place FullScreen::screen() const {
  SDL_Rect all{0, 0, 1280, 800};
  SDL_GetDisplayBounds(SDL_GetWindowDisplayIndex(window_), &all);
  return {all.x, all.y, all.w, all.h};
}

void FullScreen::toggle(std::int64_t now_us) {
  if (!on_) {
    SDL_GetWindowPosition(window_, &before_.x, &before_.y);
    SDL_GetWindowSize(window_, &before_.width, &before_.height);
  }
  on_ = !on_;
  SDL_SetWindowFullscreen(window_, on_ ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
  asked_us_ = now_us;
}

bool FullScreen::settle(std::optional<geometry::Viewport> real, std::int64_t now_us) {
  if (!asked_us_ || now_us - *asked_us_ < k_patience_us) return false;
  asked_us_.reset();
  if (!real) return false;
  const Place all = screen();
  const bool fills = *real == geometry::Viewport{all.width, all.height};
  const bool should = on_ || (before_.width == all.width && before_.height == all.height);
  if (fills == should) return false;
  SDL_SetWindowFullscreen(window_, 0);
  const Place place = on_ ? all : before_;
  SDL_SetWindowPosition(window_, place.x, place.y);
  SDL_SetWindowSize(window_, place.width, place.height);
  return true;
}

}  // namespace penpose::app
