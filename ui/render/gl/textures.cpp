#include "ui/render/gl/textures.h"

#include <algorithm>
#include <deque>
#include <epoxy/gl.h>
#include <future>
#include <utility>

#include "ui/render/picture/texture_picture.h"

namespace penpose::render {
namespace {

constexpr int k_most_side_px = 2048;
constexpr int k_least_side_px = 64;
constexpr std::uint64_t k_most_px = 9'600'000;
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

struct Wanted {
  std::size_t image = 0;
  int most_px = k_most_side_px;
  bool moves = false;
  std::uint64_t px = 0;  ///< at that size
};

std::uint64_t px_within(std::uint64_t width, std::uint64_t height, int most_px) {
  const std::uint64_t by = std::max<std::uint64_t>(
      1, (std::max(width, height) + static_cast<std::uint64_t>(most_px) - 1) / static_cast<std::uint64_t>(most_px));
  return (width / by) * (height / by);
}

/// The pictures that are to be had, and how large.
std::vector<Wanted> wanted_pictures(const document::Look& look, std::span<const LookBatch> batches) {
  std::vector<Wanted> all;
  for (const LookBatch& batch : batches) {
    const auto& use = look.surfaces[batch.surface].texture;
    if (!use || use->image >= look.images.size()) continue;
    const auto known = std::find_if(all.begin(), all.end(), [&](const Wanted& one) { return one.image == use->image; });
    if (known == all.end()) {
      all.push_back({use->image, k_most_side_px, batch.moves});
    } else {
      known->moves = known->moves || batch.moves;
    }
  }
  std::uint64_t sum = 0;
  const auto measure = [&](Wanted& one) {
    const document::Image& image = look.images[one.image];
    one.px = px_within(image.width, image.height, one.most_px);
    sum += one.px;
  };
  for (Wanted& one : all) measure(one);
  while (sum > k_most_px) {
    const auto largest = std::max_element(all.begin(), all.end(), [](const Wanted& a, const Wanted& b) {
      const auto rank = [](const Wanted& one) { return one.moves ? one.px / 4 : one.px; };
      return rank(a) < rank(b);
    });
    if (largest->most_px <= k_least_side_px) break;
    sum -= largest->px;
    largest->most_px /= 2;
    measure(*largest);
  }
  return all;
}

}  // namespace

Textures::~Textures() { clear(); }
Textures::Textures(Textures&& other) noexcept { *this = std::move(other); }
Textures& Textures::operator=(Textures&& other) noexcept {
  std::swap(names_, other.names_);
  std::swap(undrawn_, other.undrawn_);
  return *this;
}

void Textures::clear() {
  for (const auto& [bytes, texture] : names_) {
    if (texture.name != 0) glDeleteTextures(1, &texture.name);
  }
  names_.clear();
}

void Textures::keep(const document::Look& look, std::span<const LookBatch> batches) {
  const std::vector<Wanted> wanted = wanted_pictures(look, batches);
  std::erase_if(names_, [&](const auto& known) {
    const bool again = std::any_of(wanted.begin(), wanted.end(), [&](const Wanted& one) {
      return look.images[one.image].bytes.view().data() == known.first && one.most_px == known.second.most_px;
    });
    if (!again && known.second.name != 0) glDeleteTextures(1, &known.second.name);
    return !again;
  });
  struct Unpacking {
    Wanted wanted;
    std::future<base::Result<Image>> picture;
  };
  std::deque<Unpacking> running;
  const auto finish_first = [&] {
    const Wanted one = running.front().wanted;
    const auto picture = running.front().picture.get();
    running.pop_front();
    const document::KeptBytes& bytes = look.images[one.image].bytes;
    names_[bytes.view().data()] = {bytes, picture ? send(*picture) : 0, one.most_px};
    const std::string& name = look.images[one.image].name;
    if (!picture) undrawn_.push_back((name.empty() ? "a picture" : name) + " (" + picture.error().what + ")");
  };
  for (const Wanted& one : wanted) {
    const document::KeptBytes& bytes = look.images[one.image].bytes;
    if (names_.contains(bytes.view().data())) continue;
    if (running.size() == k_at_a_time) finish_first();
    running.push_back({one, std::async(std::launch::async,
                                       [bytes, most = one.most_px] { return decode_picture(bytes.view(), most); })});
  }
  while (!running.empty()) finish_first();
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool Textures::bind(const document::Look& look, const document::TextureUse& use) const {
  if (use.image >= look.images.size()) return false;
  const auto found = names_.find(look.images[use.image].bytes.view().data());
  if (found == names_.end() || found->second.name == 0) return false;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, found->second.name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, use.nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(use.wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(use.wrap_v));
  return true;
}

std::vector<std::string> Textures::take_undrawn() { return std::exchange(undrawn_, {}); }

}  // namespace penpose::render
