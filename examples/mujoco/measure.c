/* Asks a shape of MuJoCo at many points, as its collision code does: for measure.py, so that what is timed is in C. */
#include <mujoco/mujoco.h>
#include <stddef.h>

/* A geom of type sdf: of a plugin, or of MuJoCo's own octree of the mesh. */
typedef struct Shape {
    const mjpPlugin *plugin;
    int id;
    mjtGeom type;
} Shape;

static Shape shape_of(const mjModel *model, int geom) {
    if (model->geom_plugin[geom] < 0) return (Shape){NULL, model->geom_dataid[geom], mjGEOM_MESH};
    return (Shape){mjc_getSDF(model, geom), model->geom_plugin[geom], mjGEOM_SDF};
}

/* Points are in the frame of the shape: of the mesh as MuJoCo keeps it for an octree, of the field for a plugin. */
void measure_distances(const mjModel *model, const mjData *data, int geom, const mjtNum *points, int count,
                       mjtNum *distances) {
    Shape shape = shape_of(model, geom);
    const mjSDF sdf = {&shape.plugin, &shape.id, mjSDFTYPE_SINGLE, NULL, NULL, &shape.type};
    for (int i = 0; i < count; i++) distances[i] = mjc_distance(model, data, &sdf, points + 3 * i);
}

void measure_gradients(const mjModel *model, const mjData *data, int geom, const mjtNum *points, int count,
                       mjtNum *gradients) {
    Shape shape = shape_of(model, geom);
    const mjSDF sdf = {&shape.plugin, &shape.id, mjSDFTYPE_SINGLE, NULL, NULL, &shape.type};
    for (int i = 0; i < count; i++) mjc_gradient(model, data, &sdf, gradients + 3 * i, points + 3 * i);
}
