// The surface of a field, lit as Bevy lights a mesh: the pixels are those of the far side of the field's box, so that the eye
// may be inside it, and each follows its half line to the surface by sphere tracing (Hart 1996).

#import bevy_pbr::{
    forward_io::VertexOutput,
    mesh_functions::{get_local_from_world, get_world_from_local, mesh_normal_local_to_world},
    mesh_view_bindings::view,
    pbr_fragment::pbr_input_from_standard_material,
    pbr_functions::{apply_pbr_lighting, calculate_view, main_pass_post_lighting_processing},
    pbr_types::STANDARD_MATERIAL_FLAGS_UNLIT_BIT,
    view_transformations::position_world_to_clip,
}
#import nearfield::{Answer, nearfield_evaluate, nearfield_open, nearfield_slope}

// Steps after which a half line is taken for lost along the surface.
const MAX_STEPS: u32 = 256u;
// A half line has arrived within this part of the box's longest side.
const ARRIVED: f32 = 1.0 / 4096.0;

struct Fragment {
    @location(0) color: vec4<f32>,
    // That of the surface: meshes hide it and are hidden by it.
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(box: VertexOutput) -> Fragment {
    let world_from_local = get_world_from_local(box.instance_index);
    let local_from_world = get_local_from_world(box.instance_index);
    let is_orthographic = view.clip_from_view[3].w == 1.0;

    // In the frame of the field, lengths along the half line are negative and end with 0 on the box's far side.
    let toward = local_from_world * vec4(calculate_view(box.world_position, is_orthographic), 0.0);
    let direction = -normalize(toward.xyz);
    let far = (local_from_world * box.world_position).xyz;
    let eye = (local_from_world * vec4(view.world_position, 1.0)).xyz;

    let field = nearfield_open();
    let size = field.high - field.low;
    let near = ARRIVED * max(size.x, max(size.y, size.z));
    let slope = max(nearfield_slope(), 1.0);
    // A direction within a face would divide 0 by 0.
    let safe = select(direction, vec3(1e-20), abs(direction) < vec3(1e-20));
    let enter = min((field.low - far) / safe, (field.high - far) / safe);
    var along = max(enter.x, max(enter.y, enter.z));
    if !is_orthographic {
        along = max(along, -distance(far, eye));
    }

    // The field is evaluated at one place of the code: compilers of shaders write the whole reader out at each.
    var answer: Answer;
    for (var step = 0u; step < MAX_STEPS; step++) {
        answer = nearfield_evaluate(field, far + along * direction);
        if answer.distance <= near || along >= 0.0 {
            break;
        }
        along += answer.distance / slope;
    }
    if answer.distance > near {
        discard;
    }

    var surface = box;
    surface.world_position = world_from_local * vec4(far + along * direction, 1.0);
    surface.world_normal = mesh_normal_local_to_world(answer.gradient, box.instance_index);
    let lit = pbr_input_from_standard_material(surface, true);

    var out: Fragment;
    out.color = lit.material.base_color;
    if (lit.material.flags & STANDARD_MATERIAL_FLAGS_UNLIT_BIT) == 0u {
        out.color = apply_pbr_lighting(lit);
    }
    out.color = main_pass_post_lighting_processing(lit, out.color);
    let clip = position_world_to_clip(surface.world_position.xyz);
    out.depth = clip.z / clip.w;
    return out;
}
