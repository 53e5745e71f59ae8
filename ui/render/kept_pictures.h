#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/document/look.h"
#include "core/picture/decode_picture.h"
#include "ui/render/picture/image.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// A picture that batches use, and how large it is to be.
struct WantedPicture {
  std::size_t image = 0;
  int most_px = 2048;  ///< a side
  bool moves = false;
  std::uint64_t px = 0;  ///< at that size
};
/// No side has more than 2048 px, and all together have no more than `most_px`: where they would, sides are halved, the
/// largest first and those of what moves last.
[[nodiscard]] std::vector<WantedPicture> wanted_pictures(const document::Look& look, std::span<const LookBatch> batches,
                                                         std::uint64_t most_px);

/// The pictures of models, each as a Texture made of it. A picture is unpacked when it is first drawn, and kept while
/// models that have it are drawn, also when their shapes change. A Texture gives back what it holds when it ends.
template <typename Texture>
class KeptPictures {
 public:
  /// Has the pictures that the batches use, and no others. Two are unpacked at a time, so that memory is little above
  /// that of the textures. `make(Image)` makes a Texture.
  template <typename Make>
  void keep(const document::Look& look, std::span<const LookBatch> batches, std::uint64_t most_px, const Make& make);
  void clear() { kept_.clear(); }
  /// Null: it cannot be read.
  [[nodiscard]] const Texture* find(const document::Look& look, const document::TextureUse& use) const;
  /// Pictures that could not be unpacked, "NAME (why)" as Look::undrawn; each is told once.
  [[nodiscard]] std::vector<std::string> take_undrawn() { return std::exchange(undrawn_, {}); }

 private:
  struct Kept {
    document::KeptBytes bytes;       ///< so that no other picture lies at their place
    std::optional<Texture> texture;  ///< nothing: cannot be read
    int most_px = 0;                 ///< a side was made no longer than this
  };
  std::map<const std::uint8_t*, Kept> kept_;  ///< by where their bytes begin
  std::vector<std::string> undrawn_;
};

template <typename Texture>
template <typename Make>
void KeptPictures<Texture>::keep(const document::Look& look, std::span<const LookBatch> batches, std::uint64_t most_px,
                                 const Make& make) {
  constexpr std::size_t k_at_a_time = 2;
  const std::vector<WantedPicture> wanted = wanted_pictures(look, batches, most_px);
  std::erase_if(kept_, [&](const auto& known) {
    for (const WantedPicture& one : wanted) {
      const bool again = look.images[one.image].bytes.view().data() == known.first;
      if (again && one.most_px == known.second.most_px) return false;
    }
    return true;
  });
  struct Unpacking {
    WantedPicture wanted;
    std::future<base::Result<Image>> picture;
  };
  std::deque<Unpacking> running;
  const auto finish_first = [&] {
    const WantedPicture one = running.front().wanted;
    auto picture = running.front().picture.get();
    running.pop_front();
    const document::KeptBytes& bytes = look.images[one.image].bytes;
    Kept& kept = kept_[bytes.view().data()];
    kept.bytes = bytes;
    kept.most_px = one.most_px;
    if (picture) {
      kept.texture.emplace(make(std::move(*picture)));
      return;
    }
    const std::string& name = look.images[one.image].name;
    undrawn_.push_back((name.empty() ? "a picture" : name) + " (" + picture.error().what + ")");
  };
  for (const WantedPicture& one : wanted) {
    const document::KeptBytes& bytes = look.images[one.image].bytes;
    if (kept_.contains(bytes.view().data())) continue;
    if (running.size() == k_at_a_time) finish_first();
    const auto unpack = [bytes, most = one.most_px] { return picture::decode_picture(bytes.view(), most); };
    try {
      running.push_back({one, std::async(std::launch::async, unpack)});
    } catch (const std::system_error&) {
      running.push_back({one, std::async(std::launch::deferred, unpack)});  // no more threads: this one does it
    }
  }
  while (!running.empty()) finish_first();
}

template <typename Texture>
const Texture* KeptPictures<Texture>::find(const document::Look& look, const document::TextureUse& use) const {
  if (use.image >= look.images.size()) return nullptr;
  const auto found = kept_.find(look.images[use.image].bytes.view().data());
  return found == kept_.end() || !found->second.texture ? nullptr : &*found->second.texture;
}

}  // namespace penpose::render
