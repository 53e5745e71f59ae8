#include "core/articulation/sketch.h"

#include <gtest/gtest.h>

#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

base::Hash128 hash_of(const Sketch& sketch) {
  base::StateHash hash;
  add_to_hash(hash, sketch);
  return hash.digest();
}

TEST(Sketch, EveryThingDrawnIsPartOfTheHash) {
  const Sketch sketch = tests::make_eye().blink();
  EXPECT_EQ(hash_of(sketch), hash_of(Sketch(sketch)));
  std::vector<Sketch> changed(12, sketch);
  changed[0].name += "x";
  changed[1].viewport.width += 1;
  changed[2].camera.eye.x += 1e-9;
  changed[3].general[0].x += 1e-9;
  changed[4].specific.pop_back();
  changed[5].reference.clear();
  changed[6].target[2].y += 1;
  changed[7].mode = Mode::rotate;
  changed[8].surface = PartSurface{"ball_L"};
  changed[9].surface = Sphere{{0, 0, 0}, 1};
  changed[10].maximum = 2;
  changed[11].target_camera = sketch.camera;
  for (const Sketch& other : changed) {
    EXPECT_FALSE(hash_of(other) == hash_of(sketch));
    EXPECT_FALSE(other == sketch);
  }
}

TEST(Sketch, RefusesCurvesOfUnboundedSize) {
  Sketch sketch = tests::make_eye().blink();
  sketch.target.assign(k_most_points + 1, {1, 1});
  EXPECT_EQ(check_sketch(sketch).error().place, "target");
  sketch.target = {{0, 0}, {1e300, 0}};
  EXPECT_EQ(check_sketch(sketch).error().place, "target/1");
}

}  // namespace
}  // namespace penpose::articulation
