/* One file above the usual size: it is the whole C interface, which is read as one.
 *
 * penpose: poses and rigs 3D characters by drawing. The C library (C99; also fit for C++ and other languages).
 *
 * Five things to know:
 *
 * 1. Everything lives in a library that you open; there is no global state. What is made in it is named by a handle, a
 *    number that is never given out twice: one that was freed, was never given out or names another kind of thing is
 *    PENPOSE_BAD_HANDLE, whatever was made since. Handles of one library mean nothing in another.
 * 2. Every function gives a status: PENPOSE_OK (0), or why nothing has changed. The last argument, which may be NULL,
 *    takes the code and one line for a person: what is wrong, where, and what to do about it.
 * 3. Different handles may be used by different threads at the same time; calls with one handle wait for each other. A
 *    handle may be freed while another thread uses it: that call ends first.
 * 4. Arrays are the caller's. xyz is three numbers a point, px two (origin top left, x to the right, y down), all one
 *    after the other. Model space is right-handed, y up, in the model's own unit of length (glTF says metres). Angles
 * of joints are radians, those of views degrees. A text is UTF-8 and ends with 0.
 * 5. What is asked for becomes a command of the document, so that the program's window,
 *    a recorded session and a caller come to the same bits.
 *
 * A character is posed so: make it, give it a curve, say where the curve should go, solve, evaluate.
 *
 *     penpose_library* library = NULL;
 *     penpose_handle head = 0;
 *     uint32_t lip = 0;
 *     penpose_error error;
 *     if (penpose_open(&library, &error) ||
 *         penpose_character_built_in(library, "builtin:demo", &head, &error) ||
 *         penpose_curve_named(library, head, "lip_upper", PENPOSE_REFERENCE, &lip, &error) ||
 *         penpose_target_points(library, head, lip, xyz, count, &error) ||
 *         penpose_solve(library, head, PENPOSE_PRESET_DEFAULT, &error) ||
 *         penpose_evaluate(library, head, NULL, 0, positions, vertices, &error))
 *       fprintf(stderr, "%s\n", error.message);
 *     penpose_close(&library);
 *
 * docs/library.md says more, and has the same in C++, in Python and as a conversation with `penpose serve`. */
#ifndef PENPOSE_H
#define PENPOSE_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define PENPOSE_API __attribute__((visibility("default")))
#else
#define PENPOSE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Compare with penpose_abi_version(): another number means other structs or functions, and another libpenpose.so.N. */
#define PENPOSE_ABI_VERSION 0

typedef enum penpose_status {
  PENPOSE_OK = 0,
  PENPOSE_BAD_ARGUMENT = 1, /* a null pointer, a count that does not fit, a value that there is not */
  PENPOSE_BAD_HANDLE = 2,   /* freed, never given out, or of another kind */
  PENPOSE_REFUSED = 3,      /* bytes or a command that mean nothing here: the message says what and where */
  PENPOSE_TOO_SMALL = 4,    /* the caller's array; how much there is has been written */
  PENPOSE_NO_MEMORY = 5,    /* the memory did not suffice */
  PENPOSE_DIVERGED = 6,     /* a session did not come to the states that it holds */
  PENPOSE_INTERNAL = 7      /* something that should not be: a defect of the library */
} penpose_status;

/* Why a call failed; after one that did not, PENPOSE_OK and an empty message. A longer line is cut at a character. */
typedef struct penpose_error {
  int32_t status; /* a penpose_status */
  char message[508];
} penpose_error;

typedef struct penpose_library penpose_library;

/* A character, a live target, an animation or a tablet. 0 names nothing. */
typedef uint64_t penpose_handle;

/* ---- The library ---- */

/* The version of this interface that the library was built with. */
PENPOSE_API uint32_t penpose_abi_version(void);
/* The program's version, such as "0.2.0". Lives as long as the library is loaded. */
PENPOSE_API const char* penpose_version(void);

PENPOSE_API int32_t penpose_open(penpose_library** library, penpose_error* error);
/* Frees the library with all that lives in it and sets the pointer to NULL. A null pointer, or one to NULL, is fine. No
 * other thread may be using it. */
PENPOSE_API void penpose_close(penpose_library** library);
/* Frees what a handle names. */
PENPOSE_API int32_t penpose_free(penpose_library* library, penpose_handle handle, penpose_error* error);
/* How many handles are alive. */
PENPOSE_API int32_t penpose_handle_count(penpose_library* library, size_t* count, penpose_error* error);

/* ---- Characters ---- */

/* A glTF, OBJ, PLY, OFF or STL file in memory, or a project of the program. `hint`: a file name whose ending tells the
 * formats apart that do not say what they are (OBJ); NULL: none. Files that the bytes name are not read: a glTF text
 * file must hold its buffers itself. */
PENPOSE_API int32_t penpose_character_read(penpose_library* library, const void* bytes, size_t size, const char* hint,
                                           penpose_handle* character, penpose_error* error);
/* "builtin:head", the program's own head, which has nothing to pose yet, or "builtin:demo", the same with sketched
 * controls. */
PENPOSE_API int32_t penpose_character_built_in(penpose_library* library, const char* name, penpose_handle* character,
                                               penpose_error* error);

/* A blend shape: vertex vertices[i] moves by deltas[3 i .. 3 i + 2] at value one. */
typedef struct penpose_shape {
  const char* name; /* of its parameter; no other has it */
  double minimum;   /* range of the parameter; 0 lies in it */
  double maximum;
  size_t count;             /* entries */
  const uint32_t* vertices; /* ascending, each once; NULL: vertex i is i, and `count` is the number of vertices */
  const float* deltas;      /* 3 count numbers, model units */
} penpose_shape;

/* A joint: its local matrix is translation * rotation * scale, and a vertex goes from rest to the world by the joint's
 * world matrix * inverse_bind. A posable joint has three parameters NAME.rx, NAME.ry, NAME.rz (radians, about its own
 * axes, after `rotation`). */
typedef struct penpose_joint {
  const char* name;
  int32_t parent;  /* comes before it; -1: none */
  int32_t posable; /* 0: has no parameters */
  double translation[3];
  double rotation[4]; /* at rest, x y z w, of length one */
  double scale[3];
  double inverse_bind[16]; /* column after column, as in glTF */
  double minimum[3];       /* radians about x, y, z; 0 lies in the range */
  double maximum[3];
} penpose_joint;

/* What a character is made of. Counts of 0 go with null pointers. All is copied. */
typedef struct penpose_arrays {
  size_t vertex_count;
  const double* positions; /* at rest, 3 a vertex; rounded to float */
  size_t triangle_count;
  const uint32_t* triangles; /* 3 a triangle, counter-clockwise from outside */
  size_t shape_count;
  const penpose_shape* shapes;
  size_t joint_count;
  const penpose_joint* joints;
  size_t influences;        /* a vertex; 0 without joints */
  const uint32_t* joint_of; /* `influences` a vertex: numbers of joints */
  const double* weight_of;  /* the same: their shares, >= 0; scaled to sum to one; all 0: the vertex stays */
} penpose_arrays;

PENPOSE_API int32_t penpose_character_from_arrays(penpose_library* library, const penpose_arrays* arrays,
                                                  penpose_handle* character, penpose_error* error);
/* Another handle of a character as it is now. Meshes and rigs are shared, so that it costs little; keep one to go back
 * to. It records nothing. */
PENPOSE_API int32_t penpose_character_copy(penpose_library* library, penpose_handle character, penpose_handle* copy,
                                           penpose_error* error);

typedef struct penpose_counts {
  size_t vertices;
  size_t triangles;
  size_t parameters;
  size_t curves;
} penpose_counts;
PENPOSE_API int32_t penpose_count(penpose_library* library, penpose_handle character, penpose_counts* counts,
                                  penpose_error* error);
/* The corners of all triangles, 3 a triangle. `count`: triangles that there is room for, all of them at least. */
PENPOSE_API int32_t penpose_triangles(penpose_library* library, penpose_handle character, uint32_t* corners,
                                      size_t count, penpose_error* error);

/* The canonical hash of the document: 32 hex digits and a 0, as `penpose replay --json` prints it. */
PENPOSE_API int32_t penpose_state(penpose_library* library, penpose_handle character, char state[33],
                                  penpose_error* error);
/* The file of a character: `format` ".glb" (a project, which reads back with the same state), ".obj" (the mesh as it is
 * posed) or ".csv" (its first animation or pose as ARKit's blend shapes, 60 frames a second). Writes `*size` bytes;
 * PENPOSE_TOO_SMALL where `capacity` does not suffice (bytes may be NULL with 0). */
PENPOSE_API int32_t penpose_write(penpose_library* library, penpose_handle character, const char* format, void* bytes,
                                  size_t capacity, size_t* size, penpose_error* error);

/* ---- Parameters ---- */

/* Name and range of a parameter. `length` (may be NULL) takes the bytes of the name; `name` takes as many as fit below
 * `capacity` and a 0 (NULL with 0: none); PENPOSE_TOO_SMALL where they do not fit. `range` (may be NULL) takes minimum,
 * rest, maximum. */
PENPOSE_API int32_t penpose_parameter(penpose_library* library, penpose_handle character, size_t parameter, char* name,
                                      size_t capacity, size_t* length, double range[3], penpose_error* error);
PENPOSE_API int32_t penpose_find_parameter(penpose_library* library, penpose_handle character, const char* name,
                                           size_t* parameter, penpose_error* error);
/* The pose: one value a parameter. `count` is their number. */
PENPOSE_API int32_t penpose_get_pose(penpose_library* library, penpose_handle character, double* values, size_t count,
                                     penpose_error* error);
PENPOSE_API int32_t penpose_set_pose(penpose_library* library, penpose_handle character, const double* values,
                                     size_t count, penpose_error* error);
PENPOSE_API int32_t penpose_set_parameter(penpose_library* library, penpose_handle character, const char* name,
                                          double value, penpose_error* error);
/* Puts all parameters at rest. */
PENPOSE_API int32_t penpose_reset(penpose_library* library, penpose_handle character, penpose_error* error);
/* Whether a solve may move a parameter: locked 1 no, 0 yes. */
PENPOSE_API int32_t penpose_lock(penpose_library* library, penpose_handle character, const char* name, int32_t locked,
                                 penpose_error* error);

/* World positions of all vertices, 3 a vertex, at the pose of `values` (`value_count` of them) or, where that is NULL
 * and 0, of the character. `vertices` is their number. Values may lie out of their ranges; they must be finite. */
PENPOSE_API int32_t penpose_evaluate(penpose_library* library, penpose_handle character, const double* values,
                                     size_t value_count, double* xyz, size_t vertices, penpose_error* error);
PENPOSE_API int32_t penpose_evaluate_float(penpose_library* library, penpose_handle character, const double* values,
                                           size_t value_count, float* xyz, size_t vertices, penpose_error* error);

/* ---- Views ---- */

/* Where somebody draws from: a pinhole camera and the size of its picture. */
typedef struct penpose_view {
  double eye[3];
  double look_at[3];
  double up[3];
  double vertical_fov_degrees; /* 1..179 */
  int32_t width;               /* px, 1..32768 */
  int32_t height;
} penpose_view;

/* A view of the whole character at rest, turned about +y (0 from +z, 90 from +x) and raised. */
PENPOSE_API int32_t penpose_view_of(penpose_library* library, penpose_handle character, double yaw_degrees,
                                    double pitch_degrees, int32_t width, int32_t height, penpose_view* view,
                                    penpose_error* error);
/* Where a view shows points: 2 numbers for each 3. Refused where one lies behind it. */
PENPOSE_API int32_t penpose_project(const penpose_view* view, const double* xyz, size_t count, double* px,
                                    penpose_error* error);

/* ---- Curves, targets, constraints ---- */

/* A reference is brought to its target, once it has one; a constraint stays where it is when it is made. */
enum { PENPOSE_REFERENCE = 0, PENPOSE_CONSTRAINT = 1 };

/* A point of the surface: shares of the three corners of a triangle, 0..1, that sum to 1. */
typedef struct penpose_mesh_point {
  uint32_t triangle;
  double shares[3];
} penpose_mesh_point;

/* Each makes a curve, glued to the surface, and gives its number in the character (from 1; never given out twice). */
PENPOSE_API int32_t penpose_curve_from_vertices(penpose_library* library, penpose_handle character,
                                                const uint32_t* vertices, size_t count, int32_t role, uint32_t* curve,
                                                penpose_error* error);
PENPOSE_API int32_t penpose_curve_from_points(penpose_library* library, penpose_handle character,
                                              const penpose_mesh_point* points, size_t count, int32_t role,
                                              uint32_t* curve, penpose_error* error);
/* From a stroke of at least two px on the character as it is posed: 32 points, evenly spaced. */
PENPOSE_API int32_t penpose_curve_from_stroke(penpose_library* library, penpose_handle character,
                                              const penpose_view* view, const double* px, size_t count, int32_t role,
                                              uint32_t* curve, penpose_error* error);
/* A curve that has a name in the model (of the built-in head: lip_upper, brow_L and others). */
PENPOSE_API int32_t penpose_curve_named(penpose_library* library, penpose_handle character, const char* name,
                                        int32_t role, uint32_t* curve, penpose_error* error);
/* The curve's number of points; where they are now (3 numbers each; NULL with 0: not asked for); and how far each is
 * from where it should be, model units: from its known or kept place, or across the drawn line (NULL with 0: not asked
 * for). PENPOSE_TOO_SMALL where there is room for fewer, with the number written. */
PENPOSE_API int32_t penpose_curve_positions(penpose_library* library, penpose_handle character, uint32_t curve,
                                            double* xyz, size_t room, size_t* count, penpose_error* error);
/* The points of the surface that a curve is glued to. As penpose_curve_positions. */
PENPOSE_API int32_t penpose_curve_points(penpose_library* library, penpose_handle character, uint32_t curve,
                                         penpose_mesh_point* points, size_t room, size_t* count, penpose_error* error);
PENPOSE_API int32_t penpose_curve_distances(penpose_library* library, penpose_handle character, uint32_t curve,
                                            double* distances, size_t room, size_t* count, penpose_error* error);
PENPOSE_API int32_t penpose_curve_delete(penpose_library* library, penpose_handle character, uint32_t curve,
                                         penpose_error* error);
/* Deletes all curves; the pose stays. */
PENPOSE_API int32_t penpose_curves_clear(penpose_library* library, penpose_handle character, penpose_error* error);

/* Says where each point of a reference should go (`count` is their number). The pose stays until penpose_solve. */
PENPOSE_API int32_t penpose_target_points(penpose_library* library, penpose_handle character, uint32_t curve,
                                          const double* xyz, size_t count, penpose_error* error);
/* Draws where a reference should go, and solves at once, as the window does when the pen lifts: the line says nothing
 * about depth, and is read together with those drawn just before it. `pressure`: 0..1, one a px, or NULL. */
PENPOSE_API int32_t penpose_target_stroke(penpose_library* library, penpose_handle character, uint32_t curve,
                                          const penpose_view* view, const double* px, const double* pressure,
                                          size_t count, penpose_error* error);

/* ---- Solving ---- */

enum {
  PENPOSE_PRESET_DEFAULT = 0, /* what was meant: what the window does */
  PENPOSE_PRESET_EXACT = 1,   /* the least sum of distances */
  PENPOSE_PRESET_PAPER = 2    /* the same by the single simplex of 2006 */
};

/* Brings all references that have a target to it, from the pose as it is, and keeps constraints where they are. A
 * character without a target, or with nothing free to move, keeps its pose. */
PENPOSE_API int32_t penpose_solve(penpose_library* library, penpose_handle character, int32_t preset,
                                  penpose_error* error);

/* Follows a target while it is being drawn, as the window shows it: a preview that changes no character. It lives on
 * when the character is freed; penpose_target_stroke with the whole line has the last word. */
PENPOSE_API int32_t penpose_live_begin(penpose_library* library, penpose_handle character, uint32_t curve,
                                       const penpose_view* view, penpose_handle* live, penpose_error* error);
/* The line so far, all of it since the pen went down; `values` takes the pose (`value_count` is the number of
 * parameters). `moved` (may be NULL): whether it moved. With fewer than two different px nothing moves. */
PENPOSE_API int32_t penpose_live_follow(penpose_library* library, penpose_handle live, const double* px, size_t count,
                                        double* values, size_t value_count, int32_t* moved, penpose_error* error);

/* ---- Drawings of a whole face ---- */

typedef struct penpose_line {
  const double* px; /* 2 numbers each, two different ones at least */
  size_t count;
} penpose_line;

/* What a line was taken for: a part of a feature curve of the face. */
typedef struct penpose_line_read {
  char curve[64]; /* its name, cut at a character where it is longer; empty: nothing known */
  double from;    /* shares of the curve's length */
  double to;
  int32_t reversed; /* 1: drawn from `to` to `from` */
} penpose_line_read;

/* Poses the face as a drawing of it shows: at most 400 lines, in any order, anywhere on a sheet and in any size.
 * Controls start at rest, joints and what is locked where they are. `neutral`: the same hand's drawing of the face at
 * rest, which takes its proportions out; NULL with 0: none. `view`: from where both see the face; NULL: from the front.
 * `read` (may be NULL) takes an entry a line, then one a neutral line. */
PENPOSE_API int32_t penpose_draw_face(penpose_library* library, penpose_handle character, const penpose_view* view,
                                      const penpose_line* lines, size_t count, const penpose_line* neutral,
                                      size_t neutral_count, penpose_line_read* read, penpose_error* error);

/* ---- Sketched deformers ---- */

enum { PENPOSE_MODE_AUTO = 0, PENPOSE_MODE_TRANSLATE = 1, PENPOSE_MODE_ROTATE = 2 };

/* A deformer in four strokes on the character at rest: around all that may move, around what moves as a whole, where
 * the feature is, and where it is at value one. px, 2 numbers each. */
typedef struct penpose_sketch {
  const char* name;                /* of the new parameter; NULL: the first free "deformer N" */
  penpose_view view;               /* of all strokes but the target where that has its own */
  const penpose_view* target_view; /* NULL: the same; its picture is as large */
  const double* general;
  size_t general_count;
  const double* specific;
  size_t specific_count;
  const double* reference; /* NULL with 0: inferred */
  size_t reference_count;
  const double* target;
  size_t target_count;
  int32_t mode;
  double minimum; /* range of the parameter: minimum <= 0 < maximum <= 10 */
  double maximum;
} penpose_sketch;

/* Adds the deformer; the parameter is the last of the sketched ones (penpose_find_parameter). */
PENPOSE_API int32_t penpose_sketch_deformer(penpose_library* library, penpose_handle character,
                                            const penpose_sketch* sketch, penpose_error* error);

/* ---- Commands and sessions ---- */

/* Any command that a session can hold, as its text ("set_key time_s=1 name=smile"): whatever the window can do. */
PENPOSE_API int32_t penpose_perform(penpose_library* library, penpose_handle character, const char* command,
                                    penpose_error* error);

/* What replaying a session came to. */
typedef struct penpose_playback {
  uint64_t reports; /* of tablets */
  uint64_t strokes;
  uint64_t steps;   /* strokes on the canvas and commands */
  uint64_t refused; /* of these, how many changed nothing */
  uint64_t checked; /* states that the session holds */
  uint64_t differing;
  uint64_t line;  /* of the first that differs, from 1; 0: none */
  char state[33]; /* at the end */
} penpose_playback;

/* Replays a session, or a recording of a tablet of any kind that `penpose replay` reads, as fast as it goes. `on`: the
 * character that it was recorded on, whose document is not changed; 0: the built-in one that it names. `character`
 * takes the document at the end, `playback` (may be NULL) what it came to. PENPOSE_DIVERGED with `playback` written,
 * and no character, where a state differs. */
PENPOSE_API int32_t penpose_session_play(penpose_library* library, const void* bytes, size_t size, penpose_handle on,
                                         penpose_handle* character, penpose_playback* playback, penpose_error* error);

/* Begins to record: from now on every change is written down with the state after it, as a session that `penpose
 * replay` and penpose_session_play replay. `model`: where the character as it is now can be found, a hint. What was
 * recorded before is forgotten. */
PENPOSE_API int32_t penpose_record(penpose_library* library, penpose_handle character, const char* model,
                                   penpose_error* error);
/* The text of the session so far, of `*size` bytes and no 0 at the end. As penpose_write. Refused where nothing is
 * recorded. */
PENPOSE_API int32_t penpose_recorded(penpose_library* library, penpose_handle character, char* text, size_t capacity,
                                     size_t* size, penpose_error* error);

/* ---- Animations from tracked faces ---- */

enum { PENPOSE_HEAD_AS_MAP = 0, PENPOSE_HEAD_DROP = 1, PENPOSE_HEAD_APPLY = 2 };

/* How a track is played. Begin with PENPOSE_ANIMATE_DEFAULTS. */
typedef struct penpose_animate_options {
  int32_t head;     /* the head's turn: as the map says, left out, or part of the animation */
  int32_t units;    /* 1: action units of the track (AU12, ...) are evidence beside its points; 0: they are not */
  int64_t neutral;  /* frame, from 0, in which the face is at rest; -1: chosen from the clip */
  double tremor_px; /* how far points shake, 0..1000; -1: 1, less for small faces */
  double smooth_s;  /* smooths over so many seconds to each side, 0..60 */
  double least_confidence; /* frames of less are held, 0..1 */
  double fps;        /* keys at so many even frames a second, 0.1..10000; the length stays; 0: the times of the track */
  double stretch;    /* frames follow each other at this rate, 0.1..10000, whatever the track says; 0: its times */
  double picture[2]; /* width and height of the video, px, for normalised coordinates; 0, 0: unknown */
  const char* curves; /* JSON of curves of the model that the map may name; NULL: the model's own alone */
} penpose_animate_options;
#define PENPOSE_ANIMATE_DEFAULTS \
  { PENPOSE_HEAD_AS_MAP, 0, -1, -1.0, 0.0, 0.2, 0.0, 0.0, {0.0, 0.0}, NULL }

/* What came out. */
typedef struct penpose_animated {
  size_t frames;
  size_t held; /* of these, how many show no face and keep the pose before */
  size_t blinks;
  size_t unmatched; /* names of the track that the character has no parameter for */
  int64_t rest;     /* the frame that was taken for rest; -1: none was chosen */
  double fps;
} penpose_animated;

/* Makes keyframes from what a face tracker saw: OpenFace CSV, MediaPipe landmarks (JSON or CSV), 68 points (.pts or
 * CSV), curves (JSON) or ARKit blend shapes (CSV), told apart by their content. `map`: the text of a map file, which
 * says what drives what (docs/command-line.md), or the name of one that the library brings: openface, mediapipe,
 * ibug68, curves, arkit; NULL: the one of the track's format. `options` and `animated` may be NULL. The character stays
 * as it is. */
PENPOSE_API int32_t penpose_animate(penpose_library* library, penpose_handle character, const void* track, size_t size,
                                    const char* map, const penpose_animate_options* options, penpose_handle* animation,
                                    penpose_animated* animated, penpose_error* error);
/* Time (s) and pose of each frame: `values` takes one value a parameter of the character, frame after frame. `room`:
 * frames that there is room for in both; NULL, NULL and 0: the number of frames alone. PENPOSE_TOO_SMALL where it does
 * not suffice, with the number written. */
PENPOSE_API int32_t penpose_animation_frames(penpose_library* library, penpose_handle animation, double* times_s,
                                             double* values, size_t room, size_t* count, penpose_error* error);
/* What was left out or held, a line each, `*size` bytes and no 0 at the end. As penpose_write. */
PENPOSE_API int32_t penpose_animation_notes(penpose_library* library, penpose_handle animation, char* text,
                                            size_t capacity, size_t* size, penpose_error* error);
/* The character with the animation, named "tracked", before those that it had: penpose_write keeps it. */
PENPOSE_API int32_t penpose_animation_character(penpose_library* library, penpose_handle animation,
                                                penpose_handle* character, penpose_error* error);

/* ---- Tablets ---- */

/* One interface of a tablet, as the system knows it. */
typedef struct penpose_interface {
  uint16_t bus; /* 3: USB, 5: Bluetooth */
  uint16_t vendor;
  uint16_t product;
  const char* name;          /* NULL: unknown */
  const uint8_t* descriptor; /* HID report descriptor; NULL with 0: unknown */
  size_t descriptor_size;
} penpose_interface;

typedef struct penpose_axis {
  int32_t present; /* 0: the device has no such axis */
  int32_t minimum;
  int32_t maximum;
  double units_per_mm; /* of tilt: a degree; 0: unknown */
} penpose_axis;
typedef struct penpose_axes {
  penpose_axis x, y, pressure, tilt_x, tilt_y, distance, rotation, wheel;
} penpose_axes;

enum { PENPOSE_TOOL_NONE = 0, PENPOSE_TOOL_PEN = 1, PENPOSE_TOOL_ERASER = 2, PENPOSE_TOOL_MOUSE = 3 };

/* What a pen says in one report, in the device's own units. What the device does not have is 0. */
typedef struct penpose_sample {
  int32_t x, y, pressure, tilt_x, tilt_y, distance, rotation, wheel;
  uint64_t serial;
  uint32_t tool_id;
  uint32_t buttons; /* bit 0: the first */
  int32_t tool;     /* none while nothing is in range */
  int32_t in_range;
  int32_t tip;
  int32_t reserved;
} penpose_sample;

/* Refused where nothing known reads the interface (a mouse, a touch screen). `axes` may be NULL. */
PENPOSE_API int32_t penpose_tablet(penpose_library* library, const penpose_interface* interface_of,
                                   penpose_handle* tablet, penpose_axes* axes, penpose_error* error);
/* One raw report, the report id first as hidraw gives it; feed all of them, in order. Writes the states that it went
 * through, oldest first (mostly one; none where it says nothing of a pen), and their number. PENPOSE_TOO_SMALL where
 * `room` is less; the report counts as fed, and the last ones are written. 16 are always enough. */
PENPOSE_API int32_t penpose_tablet_report(penpose_library* library, penpose_handle tablet, const void* report,
                                          size_t size, penpose_sample* samples, size_t room, size_t* count,
                                          penpose_error* error);

#ifdef __cplusplus
}
#endif

#endif
