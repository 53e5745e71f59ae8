#include "core/io/model/read_model.h"

#include <gtest/gtest.h>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

TEST(ReadModel, ContentGoesBeforeTheName) {
  const auto glb = tests::square_sample().glb();
  EXPECT_TRUE(read_model(glb, "wrong.obj").ok());
  EXPECT_TRUE(read_model(base::as_bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "").ok());
  EXPECT_TRUE(read_model(base::as_bytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "x.stl").ok());
  EXPECT_TRUE(read_model(base::as_bytes("s 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "by_name.OBJ").ok());
}

TEST(ReadModel, WhatIsNoModelIsAnErrorWithARemedy) {
  for (const char* text : {"", "hello", "%PDF-1.5"}) {
    const auto model = read_model(base::as_bytes(text), "x.pdf");
    ASSERT_FALSE(model.ok());
    EXPECT_EQ(model.error().place, "byte offset 0");
    EXPECT_FALSE(model.error().remedy.empty());
  }
}

}  // namespace
}  // namespace penpose::io
