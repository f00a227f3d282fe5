/* Baked fields as shapes of MuJoCo: the plugin "nearfield.sdf", whose one attribute is `file`, the path of a .nfd.
 *
 * MuJoCo asks in two ways. While it compiles a model there is no mjData: sdf_attribute turns the attributes into numbers, and
 * sdf_aabb and sdf_staticdistance get those. Later it asks with an mjData that init has prepared. Both find the same field:
 * the number is a place in `loaded_fields`, the mjData keeps a pointer.
 *
 * A file is read when a model is compiled and when an mjData is made. Its bytes are kept until the process ends, once for all
 * models, mjData and threads; a file that has changed is kept beside what it was. */
#include <mujoco/mujoco.h>
#include <nearfield.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct LoadedField {
    NearfieldField field;
    void *bytes;
    size_t length;
} LoadedField;

/* Places never move: a thread may ask one while another is filled. */
static LoadedField loaded_fields[4096];
static int loaded_count = 0;
static pthread_mutex_t loading = PTHREAD_MUTEX_INITIALIZER;

/* The bytes of a file, to be freed, or NULL. */
static void *read_file(const char *path, size_t *length) {
    FILE *file = fopen(path, "rb");
    char *bytes = NULL;
    long size = -1;
    if (file == NULL) return NULL;
    if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
        bytes = malloc(size > 0 ? (size_t)size : 1);
        if (bytes != NULL && fread(bytes, 1, (size_t)size, file) != (size_t)size) {
            free(bytes);
            bytes = NULL;
        }
    }
    fclose(file);
    *length = (size_t)size;
    return bytes;
}

/* Where these bytes are among the loaded, or -1. */
static int find_loaded(const void *bytes, size_t length) {
    for (int place = 0; place < loaded_count; place++) {
        const LoadedField *loaded = &loaded_fields[place];
        if (loaded->length == length && memcmp(loaded->bytes, bytes, length) == 0) return place;
    }
    return -1;
}

/* The place of the field in a file, or -1 and why not. */
static int load_field(const char *path, const char **why_not) {
    if (path == NULL || path[0] == '\0') {
        *why_not = "the attribute \"file\" is missing";
        return -1;
    }
    LoadedField new_field = {.bytes = NULL};
    new_field.bytes = read_file(path, &new_field.length);
    if (new_field.bytes == NULL) {
        *why_not = "the file cannot be read";
        return -1;
    }

    pthread_mutex_lock(&loading);
    int place = find_loaded(new_field.bytes, new_field.length);
    if (place < 0) {
        NearfieldResult result = nearfield_open(&new_field.field, new_field.bytes, new_field.length);
        if (result == NEARFIELD_RESULT_OK) result = nearfield_validate(&new_field.field);
        if (result != NEARFIELD_RESULT_OK) {
            *why_not = nearfield_result_text(result);
        } else if (loaded_count == (int)(sizeof loaded_fields / sizeof loaded_fields[0])) {
            *why_not = "too many different fields in one process";
        } else {
            place = loaded_count++;
            loaded_fields[place] = new_field;
            new_field.bytes = NULL;
        }
    }
    pthread_mutex_unlock(&loading);
    free(new_field.bytes);
    return place;
}

static NearfieldVector vector(const mjtNum point[3]) {
    return (NearfieldVector){(float)point[0], (float)point[1], (float)point[2]};
}

/* While a model is compiled */

static void sdf_attribute(mjtNum attribute[], const char *name[], const char *value[]) {
    (void)name;
    const char *why_not = NULL;
    const int place = load_field(value[0], &why_not);
    if (place < 0) mju_error("nearfield.sdf: %s: %s", value[0] == NULL ? "" : value[0], why_not);
    attribute[0] = place;
}

static const NearfieldField *field_of_attributes(const mjtNum *attributes) {
    return &loaded_fields[(int)attributes[0]].field;
}

static void sdf_aabb(mjtNum aabb[6], const mjtNum *attributes) {
    const NearfieldInfo info = nearfield_info(field_of_attributes(attributes));
    const mjtNum low[3] = {info.box_min.x, info.box_min.y, info.box_min.z};
    const mjtNum high[3] = {info.box_max.x, info.box_max.y, info.box_max.z};
    for (int axis = 0; axis < 3; axis++) {
        aabb[axis] = 0.5 * (low[axis] + high[axis]);
        aabb[3 + axis] = 0.5 * (high[axis] - low[axis]);
    }
}

static mjtNum sdf_staticdistance(const mjtNum point[3], const mjtNum *attributes) {
    return nearfield_distance(field_of_attributes(attributes), vector(point));
}

/* Later: what an mjData keeps for an instance */

typedef struct Shape {
    const NearfieldField *field;
    /* From the frame of the geom to that of the field. They differ where the geom has a mesh of a file, which MuJoCo puts into the
     * frame of its inertia. */
    mjtNum position[3];
    mjtNum rotation[9];
} Shape;

/* The mesh of the geoms of an instance, -1 if there is none, -2 if there are several. */
static int mesh_of_instance(const mjModel *model, int instance) {
    int mesh = -1;
    for (int geom = 0; geom < model->ngeom; geom++) {
        if (model->geom_plugin[geom] != instance || model->geom_dataid[geom] == mesh) continue;
        if (mesh != -1) return -2;
        mesh = model->geom_dataid[geom];
    }
    return mesh;
}

static int init(const mjModel *model, mjData *data, int instance) {
    const char *path = mj_getPluginConfig(model, instance, "file");
    const char *why_not = NULL;
    const int place = load_field(path, &why_not);
    const int mesh = mesh_of_instance(model, instance);
    Shape *shape = malloc(sizeof *shape);
    if (mesh == -2) why_not = "geoms of one instance must have one mesh";
    if (shape == NULL) why_not = "no memory";
    if (why_not != NULL) {
        free(shape);
        mju_warning("nearfield.sdf: %s: %s", path == NULL ? "" : path, why_not);
        return -1;
    }

    static const mjtNum nowhere[3] = {0, 0, 0}, unturned[4] = {1, 0, 0, 0};
    shape->field = &loaded_fields[place].field;
    mju_copy3(shape->position, mesh < 0 ? nowhere : model->mesh_pos + 3 * mesh);
    mju_quat2Mat(shape->rotation, mesh < 0 ? unturned : model->mesh_quat + 4 * mesh);
    data->plugin_data[instance] = (uintptr_t)shape;
    return 0;
}

static void destroy(mjData *data, int instance) {
    free((Shape *)data->plugin_data[instance]);
    data->plugin_data[instance] = 0;
}

/* One coordinate of a point in the field. */
static float placed(const Shape *shape, int axis, const mjtNum point[3]) {
    const mjtNum *row = shape->rotation + 3 * axis;
    return (float)(row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + shape->position[axis]);
}

static NearfieldVector in_field(const Shape *shape, const mjtNum point[3]) {
    return (NearfieldVector){placed(shape, 0, point), placed(shape, 1, point), placed(shape, 2, point)};
}

/* A point that a shape was asked at, and what is known there. */
typedef struct Question {
    const NearfieldField *field;
    NearfieldVector point;
    enum { NOTHING, DISTANCE, GRADIENT } known;
    NearfieldSample answer;
    NearfieldCursor cursor;
} Question;

static bool is_about(const Question *question, const NearfieldField *field, NearfieldVector point) {
    return question->field == field && question->point.x == point.x && question->point.y == point.y &&
           question->point.z == point.z;
}

/* To find a contact MuJoCo descends on a pair of shapes. It asks them by turns, each up to four times at a point where it
 * stands, then at ten or so that come ever nearer to it: so a thread remembers what it asked of either, and a cursor the leaf. */
typedef struct Asked {
    Question questions[2];
    int latest;
} Asked;

/* Apart, since finding it is a call, which compilers make anew for each use. */
static __attribute__((noinline)) Asked *asked_by_thread(void) {
    static _Thread_local Asked asked;
    return &asked;
}

static Question *ask(const Shape *shape, const mjtNum point[3]) {
    Asked *asked = asked_by_thread();
    const NearfieldField *field = shape->field;
    const NearfieldVector at = in_field(shape, point);
    Question *latest = &asked->questions[asked->latest];
    if (is_about(latest, field, at)) return latest;

    asked->latest = 1 - asked->latest;
    Question *question = &asked->questions[asked->latest];
    if (is_about(question, field, at)) return question;
    if (question->field != field) nearfield_cursor(field, &question->cursor);
    question->field = field;
    question->point = at;
    question->known = NOTHING;
    return question;
}

static mjtNum sdf_distance(const mjtNum point[3], const mjData *data, int instance) {
    Question *question = ask((const Shape *)data->plugin_data[instance], point);
    if (question->known != NOTHING) return question->answer.distance;
    const float distance = nearfield_cursor_distance(&question->cursor, question->point);
    question->answer.distance = distance;
    question->known = DISTANCE;
    return distance;
}

static void sdf_gradient(mjtNum gradient[3], const mjtNum point[3], const mjData *data, int instance) {
    const Shape *shape = (const Shape *)data->plugin_data[instance];
    Question *question = ask(shape, point);
    NearfieldSample answer = question->answer;
    if (question->known != GRADIENT) {
        answer = nearfield_cursor_distance_and_gradient(&question->cursor, question->point);
        question->answer = answer;
        question->known = GRADIENT;
    }
    const NearfieldVector slope = answer.gradient;
    const mjtNum *rotation = shape->rotation;
    for (int axis = 0; axis < 3; axis++) {
        gradient[axis] = rotation[axis] * slope.x + rotation[3 + axis] * slope.y + rotation[6 + axis] * slope.z;
    }
}

/* What MuJoCo requires of every plugin; a field has no state. */

static int nstate(const mjModel *model, int instance) {
    (void)model, (void)instance;
    return 0;
}

static void reset(const mjModel *model, mjtNum *state, void *data, int instance) {
    (void)model, (void)state, (void)data, (void)instance;
}

static void compute(const mjModel *model, mjData *data, int instance, int capability) {
    (void)model, (void)data, (void)instance, (void)capability;
}

mjPLUGIN_LIB_INIT(nearfield) {
    static const char *const attributes[] = {"file"};
    mjpPlugin plugin;
    mjp_defaultPlugin(&plugin);
    plugin.name = "nearfield.sdf";
    plugin.capabilityflags |= mjPLUGIN_SDF;
    plugin.nattribute = 1;
    plugin.attributes = attributes;
    plugin.nstate = nstate;
    plugin.init = init;
    plugin.destroy = destroy;
    plugin.reset = reset;
    plugin.compute = compute;
    plugin.sdf_attribute = sdf_attribute;
    plugin.sdf_aabb = sdf_aabb;
    plugin.sdf_staticdistance = sdf_staticdistance;
    plugin.sdf_distance = sdf_distance;
    plugin.sdf_gradient = sdf_gradient;
    mjp_registerPlugin(&plugin);
}
