#include "ui/render/gl/textures.h"

#include <deque>
#include <epoxy/gl.h>
#include <future>
#include <utility>

#include "ui/render/picture/texture_picture.h"

namespace penpose::render {
namespace {

constexpr int k_most_side_px = 2048;
constexpr std::size_t k_at_a_time = 2;

unsigned send(const Image& image) {
  unsigned name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  return name;
}

GLint wrap_of(document::Wrap wrap) {
  return wrap == document::Wrap::clamp    ? GL_CLAMP_TO_EDGE
         : wrap == document::Wrap::mirror ? GL_MIRRORED_REPEAT
                                          : GL_REPEAT;
}

}  // namespace

Textures::~Textures() { clear(); }
Textures::Textures(Textures&& other) noexcept { *this = std::move(other); }
Textures& Textures::operator=(Textures&& other) noexcept {
  std::swap(names_, other.names_);
  std::swap(notes_, other.notes_);
  return *this;
}

void Textures::clear() {
  for (const auto& [bytes, name] : names_) {
    if (name != 0) glDeleteTextures(1, &name);
  }
  names_.clear();
}

void Textures::keep(const document::Look& look, const std::vector<bool>& surface_is_used) {
  std::vector<bool> wanted(look.images.size(), false);
  for (std::size_t s = 0; s < look.surfaces.size(); ++s) {
    const auto& use = look.surfaces[s].texture;
    if (surface_is_used[s] && use && use->image < look.images.size()) wanted[use->image] = true;
  }
  for (auto it = names_.begin(); it != names_.end();) {
    bool again = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) again = again || (wanted[i] && look.images[i].bytes == it->first);
    if (again) {
      ++it;
      continue;
    }
    if (it->second != 0) glDeleteTextures(1, &it->second);
    it = names_.erase(it);
  }
  struct Unpacking {
    Bytes bytes;
    std::size_t image;
    std::future<base::Result<Image>> picture;
  };
  std::deque<Unpacking> running;
  const auto finish_first = [&] {
    Unpacking& first = running.front();
    const auto picture = first.picture.get();
    names_[first.bytes] = picture ? send(*picture) : 0;
    const std::string& name = look.images[first.image].name;
    if (!picture) notes_.push_back((name.empty() ? "a picture" : name) + " is shown grey: " + picture.error().what);
    running.pop_front();
  };
  for (std::size_t image = 0; image < wanted.size(); ++image) {
    const Bytes& bytes = look.images[image].bytes;
    if (!wanted[image] || names_.contains(bytes)) continue;
    if (running.size() == k_at_a_time) finish_first();
    // The bytes outlive the work: the deque holds them.
    running.push_back({bytes, image, std::async(std::launch::async, [shared = bytes] {
                         return decode_picture(*shared, k_most_side_px);
                       })});
  }
  while (!running.empty()) finish_first();
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool Textures::bind(const document::Look& look, const document::TextureUse& use) const {
  if (use.image >= look.images.size()) return false;
  const auto found = names_.find(look.images[use.image].bytes);
  if (found == names_.end() || found->second == 0) return false;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, found->second);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, use.nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(use.wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(use.wrap_v));
  return true;
}

std::vector<std::string> Textures::take_notes() { return std::exchange(notes_, {}); }

}  // namespace penpose::render
