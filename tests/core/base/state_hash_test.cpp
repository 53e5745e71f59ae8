#include "core/base/state_hash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/base/byte_writer.h"

namespace penpose::base {
namespace {

TEST(StateHash, IsXxh3Of128Bits) {
  // The algorithm's published value for no input and seed 0.
  EXPECT_EQ(hash_bytes({}).hex(), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(StateHash().digest().hex(), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(hash_bytes(as_bytes("penpose")).hex(), "38d2c1978252db9b599ee1e4e750da88");
}

TEST(StateHash, WritesAllDigits) { EXPECT_EQ((Hash128{0x1f, 0xa}.hex()), "000000000000001f000000000000000a"); }

TEST(StateHash, HashesACanonicalStream) {
  StateHash hash;
  hash.add(std::uint64_t{7});
  hash.add(2.5);
  hash.add("jaw");
  hash.add(std::span<const double>(std::array<double, 2>{1, -1}));

  ByteWriter stream;
  stream.write(std::uint64_t{7});
  stream.write_f64(2.5);
  stream.write(std::uint64_t{3});
  stream.append("jaw");
  stream.write(std::uint64_t{2});
  stream.write_f64(1);
  stream.write_f64(-1);
  EXPECT_EQ(hash.digest(), hash_bytes(stream.bytes()));
  // Pinned: a change of this value breaks every state that somebody wrote down.
  EXPECT_EQ(hash.digest().hex(), "3ffa0757a7eeff444a89318653748449");
}

Hash128 of(double value) {
  StateHash hash;
  hash.add(value);
  return hash.digest();
}

TEST(StateHash, EqualNumbersHashEqual) {
  EXPECT_EQ(of(0.0), of(-0.0));
  EXPECT_EQ(of(std::nan("1")), of(-std::numeric_limits<double>::quiet_NaN()));
  EXPECT_NE(of(1.0), of(std::nextafter(1.0, 2.0)));
  EXPECT_NE(of(std::numeric_limits<double>::infinity()), of(std::nan("1")));
}

TEST(StateHash, TextsDoNotRunIntoEachOther) {
  StateHash one;
  one.add("ab");
  one.add("c");
  StateHash other;
  other.add("a");
  other.add("bc");
  EXPECT_NE(one.digest(), other.digest());
}

TEST(StateHash, ALongStreamInPiecesIsTheSameStream) {
  std::vector<std::uint8_t> bytes(100000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 31 + i / 255);
  StateHash hash;
  for (std::size_t at = 0, step = 1; at < bytes.size(); at += step, step = step * 3 % 997 + 1) {
    step = std::min(step, bytes.size() - at);
    hash.add_bytes(Bytes(bytes).subspan(at, step));
  }
  EXPECT_EQ(hash.digest(), hash_bytes(bytes));
}

TEST(StateHash, CanBeAskedOnTheWayAndMoved) {
  StateHash hash;
  hash.add("a");
  const Hash128 before = hash.digest();
  EXPECT_EQ(hash.digest(), before);
  StateHash moved = std::move(hash);
  EXPECT_EQ(moved.digest(), before);
  moved.add("b");
  EXPECT_NE(moved.digest(), before);
}

}  // namespace
}  // namespace penpose::base
