/* in_c SESSION[@MODEL]...: replays sessions through the C library and prints "NAME STATE" of each; then poses the demo's head and prints how
 * far it came. C99 and nothing else. */
#include <math.h>
#include <penpose.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(const char* what, const penpose_error* error) {
  fprintf(stderr, "%s: %s\n", what, error->message);
  return 1;
}

static char* read_file(const char* path, size_t* size) {
  FILE* file = fopen(path, "rb");
  char* bytes = NULL;
  long length;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (length = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
    *size = (size_t)length;
    bytes = malloc(*size + 1);
    if (bytes != NULL && fread(bytes, 1, *size, file) != *size) {
      free(bytes);
      bytes = NULL;
    }
  }
  fclose(file);
  return bytes;
}

static int replay(penpose_library* library, char* path) {
  penpose_error error;
  penpose_playback playback;
  penpose_handle character = 0, on = 0;
  size_t size = 0;
  char* model = strchr(path, '@');
  char* bytes;
  char state[33];
  if (model != NULL) {
    *model++ = '\0';
    bytes = read_file(model, &size);
    if (bytes == NULL) return 1;
    if (penpose_character_read(library, bytes, size, NULL, &on, &error)) return fail(model, &error);
    free(bytes);
  }
  bytes = read_file(path, &size);
  if (bytes == NULL) return 1;
  if (penpose_session_play(library, bytes, size, on, &character, &playback, &error)) return fail(path, &error);
  free(bytes);
  if (penpose_state(library, character, state, &error)) return fail(path, &error);
  if (strcmp(state, playback.state) != 0 || playback.differing != 0) return 1;
  printf("%s %s\n", strrchr(path, '/') ? strrchr(path, '/') + 1 : path, state);
  return penpose_free(library, character, &error) ? fail(path, &error) : 0;
}

/* Lifts the upper lip by two millimetres. */
static int pose(penpose_library* library) {
  penpose_error error;
  penpose_handle head = 0;
  penpose_counts counts;
  uint32_t lip = 0;
  size_t points = 0, i;
  double *xyz, *positions, *distances, worst = 0;
  if (penpose_character_built_in(library, "builtin:demo", &head, &error) ||
      penpose_curve_named(library, head, "lip_upper", PENPOSE_REFERENCE, &lip, &error) ||
      penpose_curve_positions(library, head, lip, NULL, 0, &points, &error) ||
      penpose_count(library, head, &counts, &error))
    return fail("the head", &error);
  xyz = malloc(3 * points * sizeof *xyz);
  distances = malloc(points * sizeof *distances);
  positions = malloc(3 * counts.vertices * sizeof *positions);
  if (xyz == NULL || distances == NULL || positions == NULL) return 1;
  if (penpose_curve_positions(library, head, lip, xyz, points, &points, &error)) return fail("the lip", &error);
  for (i = 0; i < points; ++i) xyz[3 * i + 1] += 0.002;
  if (penpose_target_points(library, head, lip, xyz, points, &error) ||
      penpose_solve(library, head, PENPOSE_PRESET_DEFAULT, &error) ||
      penpose_curve_distances(library, head, lip, distances, points, &points, &error) ||
      penpose_evaluate(library, head, NULL, 0, positions, counts.vertices, &error))
    return fail("solving", &error);
  for (i = 0; i < points; ++i) worst = fmax(worst, distances[i]);
  printf("pose %.17g %.17g\n", worst, positions[3 * (counts.vertices / 2)]);
  free(xyz);
  free(distances);
  free(positions);
  return 0;
}

int main(int argc, char** argv) {
  penpose_library* library = NULL;
  penpose_error error;
  int i, status = 0;
  if (penpose_abi_version() != PENPOSE_ABI_VERSION) return 1;
  if (penpose_open(&library, &error)) return fail("the library", &error);
  for (i = 1; i < argc && status == 0; ++i) status = replay(library, argv[i]);
  if (status == 0) status = pose(library);
  penpose_close(&library);
  return status;
}
