#include <zlib.h>

#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"

namespace penpose::replay {
namespace {

/// Recordings of real tablets pack to a tenth at best, that of a pen that lies still to a twentieth.
constexpr std::uint64_t k_most_growth = 100;
constexpr std::uint64_t k_always_unpacked = std::uint64_t{8} << 20;
/// As much as is read of a file that is not packed.
constexpr std::uint64_t k_most_unpacked = std::uint64_t{1} << 31;
/// zlib's: 15 is the largest window, 16 takes gzip alone.
constexpr int k_gzip_window = 15 + 16;

bool is_gzip(base::Bytes front) { return front.size() > 2 && front[0] == 0x1f && front[1] == 0x8b && front[2] == 8; }

/// Unpacks members one after another (RFC 1952, section 2.2).
class Unpacker {
 public:
  explicit Unpacker(ReadBytes read) : read_(std::move(read)), packed_(k_chunk), unpacked_(k_chunk) {}
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;
  ~Unpacker() { inflateEnd(&stream_); }

  base::Result<bool> next(std::string& out) {
    if (!begun_ && inflateInit2(&stream_, k_gzip_window) != Z_OK)
      return base::Error{"cannot be unpacked", "", "free memory"};
    begun_ = true;
    if (stream_.avail_in == 0) {
      const auto got = read_(packed_);
      if (!got) return got.error();
      if (*got == 0 && in_member_) return damaged("ends in the middle");
      if (*got == 0) return false;
      stream_.next_in = packed_.data();
      stream_.avail_in = static_cast<uInt>(*got);
    }
    const auto* const from = stream_.next_in;
    if (!in_member_) {
      // Zeros may fill up the last block of a tape.
      if (*from == 0 && packed_bytes_ > 0) {
        ++stream_.next_in;
        --stream_.avail_in;
        return true;
      }
      inflateReset(&stream_);
      in_member_ = true;
    }
    stream_.next_out = unpacked_.data();
    stream_.avail_out = static_cast<uInt>(unpacked_.size());
    const int status = inflate(&stream_, Z_NO_FLUSH);
    packed_bytes_ += static_cast<std::uint64_t>(stream_.next_in - from);
    const std::size_t made = unpacked_.size() - stream_.avail_out;
    unpacked_bytes_ += made;
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) return damaged("is damaged");
    if (unpacked_bytes_ > k_most_unpacked || unpacked_bytes_ > k_always_unpacked + k_most_growth * packed_bytes_) {
      return base::Error{
          "unpacks to more than " + std::to_string(k_most_growth) + " times its size, which no recording does", place(),
          "unpack it and look what it is"};
    }
    in_member_ = status != Z_STREAM_END;
    out += base::as_text(base::Bytes(unpacked_).first(made));
    return true;
  }

 private:
  [[nodiscard]] std::string place() const { return "byte offset " + std::to_string(packed_bytes_); }
  [[nodiscard]] base::Error damaged(const std::string& how) const {
    return {"the gzip file " + how, place(), "copy it again, or save what `gzip -dc` still gives of it"};
  }

  ReadBytes read_;
  std::vector<std::uint8_t> packed_;
  std::vector<std::uint8_t> unpacked_;
  z_stream stream_{};
  bool begun_ = false;
  bool in_member_ = false;
  std::uint64_t packed_bytes_ = 0;
  std::uint64_t unpacked_bytes_ = 0;
};

}  // namespace

RecordingFormat gzip_recording() { return {"gzip", is_gzip, nullptr, read_through<Unpacker>, nullptr}; }

}  // namespace penpose::replay
