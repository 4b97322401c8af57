// The mesh: vertex attributes, and what follows from them in object and world space.
// Right-handed world, y up; normals are unit; tangent_os.w is the handedness of the bitangent, 1 or -1.

/// Vertex position in object space; in the fragment stage after displacement.
[attribute] [vertex_output] float3 position_os;
/// Vertex normal in object space, unit.
[attribute] [vertex_output] float3 normal_os;
/// Vertex tangent in object space, unit; w is the handedness of the bitangent, 1 or -1.
[attribute] [vertex_output] float4 tangent_os;
/// First texture coordinates; v grows downwards, as texels are stored.
[attribute] float2 uv0;
/// Second texture coordinates.
[attribute] float2 uv1;
/// Vertex colour, linear.
[attribute] float4 vertex_color;

/// True on the side of a triangle whose vertices run counter-clockwise.
[builtin("front_facing")] bool front_facing;
/// Pixel centre in x and y (from the top left), depth in z.
[builtin("frag_coord")] float4 frag_coord;

/// The material is seen from both sides ("cull": "off" or "front").
[static("cull", "off", "front")] bool two_sided;
/// The material is cut out where alpha is below alphaClip.
[static("surface", "cutout")] bool alpha_clip;
/// The material lets through what is behind it, and still mirrors as if it were whole.
[static("surface", "transparent")] bool premultiplied;
/// The material fades as a whole, with what it mirrors.
[static("surface", "fade")] bool fades;
/// The material adds to what is behind it.
[static("surface", "additive")] bool adds;
/// What is behind the material is multiplied by it.
[static("surface", "multiply")] bool multiplies;

[extern("Object")] [per_object] float4x4 object_to_world;
[extern("Object")] [per_object] float4x4 world_to_object;

/// Position in world space.
[semantic("vertex")]
float3 position_ws(float3 position = position_os) {
    return mul(object_to_world, float4(position, 1)).xyz;
}

/// Mesh normal in world space as it leaves the vertex stage; interpolation makes it shorter than 1.
[semantic("vertex")]
float3 vertex_normal_ws(float3 normal = normal_os) {
    return normal_object_to_world(normal);
}

/// Mesh tangent in world space as it leaves the vertex stage; w is the bitangent's handedness, mirroring included.
[semantic("vertex")]
float4 vertex_tangent_ws(float4 tangent = tangent_os) {
    float handedness = determinant(object_to_world) < 0 ? -tangent.w : tangent.w;
    return float4(normalize(mul(object_to_world, float4(tangent.xyz, 0)).xyz), handedness);
}

/// Mesh normal in world space, unit; on the back of a two-sided material it is turned to the viewer.
[semantic("pixel")]
float3 geometry_normal_ws(float3 interpolated = vertex_normal_ws, bool front = front_facing) {
    float3 normal = normalize(interpolated);
    return two_sided && !front ? -normal : normal;
}

/// Mesh normal in world space, unit. In a lighting graph: the shaded normal, with the normal map in it.
[semantic("pixel")]
float3 normal_ws(float3 normal = geometry_normal_ws) {
    return normal;
}

/// Mesh tangent in world space, unit. On the back of a two-sided material the whole frame is turned, as in glTF: what
/// is a bump in front is a dent behind.
[semantic("pixel")]
float3 tangent_ws(float4 interpolated = vertex_tangent_ws, bool front = front_facing) {
    float3 tangent = normalize(interpolated.xyz);
    return two_sided && !front ? -tangent : tangent;
}

/// Bitangent in world space: cross(normal, tangent) with the mesh's handedness.
[semantic("pixel")]
float3 bitangent_ws(float3 normal = geometry_normal_ws, float3 tangent = tangent_ws,
                    float4 interpolated = vertex_tangent_ws, bool front = front_facing) {
    float3 bitangent = cross(normal, tangent) * interpolated.w;
    return two_sided && !front ? -bitangent : bitangent;
}

/// Normals go by the inverse transpose, so that they stay perpendicular under uneven scale.
float3 normal_object_to_world(float3 normal) {
    return normalize(mul(float4(normal, 0), world_to_object).xyz);
}

/// The same of a material's own normal in a pixel; on the back of a two-sided material it is turned, as the mesh's is.
float3 shown_normal_object_to_world(float3 normal, bool front = front_facing) {
    float3 world = normal_object_to_world(normal);
    return two_sided && !front ? -world : world;
}

/// The object's origin in world space.
[semantic("uniform")]
float3 object_position_ws() {
    return mul(object_to_world, float4(0, 0, 0, 1)).xyz;
}
