/* Asks a field at the points "x y z" of its input, one a line: `query FIELD.nfd < points`.
 *
 * A line of output for each: distance and gradient; normal; closest point, residual and steps; clearance; the range within
 * 0.1 of the point; the end, steps, distance, point and normal of a ray that leaves it along (1, 2, 3); distance and
 * gradient of the field at twice its size, its x axis along y.
 * Nine digits tell every float from its neighbours. */
#include <nearfield.h>
#include <stdio.h>
#include <stdlib.h>

static void print_vector(NearfieldVector v) { printf(" %.9g %.9g %.9g", v.x, v.y, v.z); }

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

static void print_answers(const NearfieldField *field, NearfieldVector point) {
    const NearfieldSample sample = nearfield_distance_and_gradient(field, point);
    const NearfieldClosestPoint closest = nearfield_closest_point(field, point);
    const NearfieldVector low = {point.x - 0.1f, point.y - 0.1f, point.z - 0.1f};
    const NearfieldVector high = {point.x + 0.1f, point.y + 0.1f, point.z + 0.1f};
    const NearfieldRange range = nearfield_range(field, low, high);
    const NearfieldRay ray = {point, {1.0f, 2.0f, 3.0f}, 1e3f, 0.0f};
    const NearfieldRayHit hit = nearfield_raycast(field, ray);
    const NearfieldPlacement twice = {{0.0f, 2.0f, 0.0f}, {-2.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f}, {1.0f, 0.0f, 0.5f}};
    NearfieldInstance instance;
    NearfieldSample placed;

    printf("%.9g", nearfield_distance(field, point));
    print_vector(sample.gradient);
    print_vector(nearfield_normal(field, point));
    print_vector(closest.point);
    printf(" %.9g %u", closest.residual, (unsigned)closest.steps);
    printf(" %.9g %.9g %.9g", nearfield_clearance(field, point), range.min, range.max);
    printf(" %d %u %.9g", (int)hit.end, (unsigned)hit.steps, hit.distance);
    print_vector(hit.point);
    print_vector(hit.normal);
    if (nearfield_instance(field, twice, &instance) != NEARFIELD_RESULT_OK) abort();
    placed = nearfield_instance_distance_and_gradient(&instance, point);
    printf(" %.9g", placed.distance);
    print_vector(placed.gradient);
    printf("\n");
}

int main(int count, char **arguments) {
    NearfieldField field = NEARFIELD_FIELD_NONE;
    NearfieldResult result;
    NearfieldVector point;
    size_t length = 0;
    void *bytes;

    if (count != 2 || nearfield_abi_version() != NEARFIELD_ABI_VERSION) {
        fprintf(stderr, "usage: query FIELD.nfd < points\n");
        return 2;
    }
    bytes = read_file(arguments[1], &length);
    if (bytes == NULL) {
        fprintf(stderr, "%s: cannot be read\n", arguments[1]);
        return 1;
    }
    result = nearfield_open(&field, bytes, length);
    if (result == NEARFIELD_RESULT_OK) result = nearfield_validate(&field);
    if (result != NEARFIELD_RESULT_OK) {
        fprintf(stderr, "%s: %s\n", arguments[1], nearfield_result_text(result));
        free(bytes);
        return 1;
    }

    while (scanf("%f %f %f", &point.x, &point.y, &point.z) == 3) print_answers(&field, point);
    free(bytes);
    return 0;
}
