#include "core/base/state_hash.h"

#include <array>
#include <bit>
#include <limits>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::base {

struct StateHash::State {
  XXH3_state_t* xxh = XXH3_createState();
  State() { XXH3_128bits_reset(xxh); }
  ~State() { XXH3_freeState(xxh); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

namespace {

std::uint64_t canonical_bits(double value) {
  if (value == 0.0) return 0;
  if (value != value) return std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());
  return std::bit_cast<std::uint64_t>(value);
}

std::array<std::uint8_t, 8> little_endian(std::uint64_t value) {
  std::array<std::uint8_t, 8> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
  return bytes;
}

Hash128 from_xxh(XXH128_hash_t hash) { return {hash.high64, hash.low64}; }

}  // namespace

std::string Hash128::hex() const {
  std::string text;
  append_hex(text, high, 16);
  append_hex(text, low, 16);
  return text;
}

std::optional<Hash128> parse_hash(std::string_view text) {
  if (text.size() != 32) return std::nullopt;
  if (text.find('+') != std::string_view::npos) return std::nullopt;  // which numbers may have in front
  const auto high = parse_uint(text.substr(0, 16), 16);
  const auto low = parse_uint(text.substr(16), 16);
  if (!high || !low) return std::nullopt;
  return Hash128{*high, *low};
}

StateHash::StateHash() : state_(make_hidden<State>()) {}

void StateHash::add(std::uint64_t value) { add_bytes(little_endian(value)); }
void StateHash::add(double value) { add(canonical_bits(value)); }

void StateHash::add(std::string_view text) {
  add(static_cast<std::uint64_t>(text.size()));
  add_bytes(as_bytes(text));
}

void StateHash::add(std::span<const double> values) {
  add(static_cast<std::uint64_t>(values.size()));
  for (const double value : values) add(value);
}

void StateHash::add_bytes(Bytes bytes) {
  if (!bytes.empty()) XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
}

Hash128 StateHash::digest() const { return from_xxh(XXH3_128bits_digest(state_->xxh)); }

Hash128 hash_bytes(Bytes bytes) {
  static constexpr std::uint8_t k_nothing = 0;
  return from_xxh(XXH3_128bits(bytes.empty() ? &k_nothing : bytes.data(), bytes.size()));
}

}  // namespace penpose::base
