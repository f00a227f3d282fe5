"""The kernel that `measure.py` gives to Warp, which compiles a file's source."""

import warp


@warp.kernel
def distance(mesh: warp.uint64, points: warp.array(dtype=warp.vec3), answers: warp.array(dtype=float)):
    index = warp.tid()
    query = warp.mesh_query_point_sign_normal(mesh, points[index], 1.0e6)
    closest = warp.mesh_eval_position(mesh, query.face, query.u, query.v)
    answers[index] = query.sign * warp.length(points[index] - closest)
