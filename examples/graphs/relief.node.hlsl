/// Turns a height into a normal, for heights that no texture holds. It looks at the neighbouring pixels, so it needs
/// neither tangents nor texture coordinates.
///
/// formula: normalize(|d| n - sign(d) (dh/dx (p_y x n) + dh/dy (n x p_x))), d = p_x . (p_y x n)
/// source: Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010
[node("Examples/Relief")]
float3 Relief(
    [unit("m")] float height,               ///< above the mesh, along its normal
    float3 normal = geometry_normal_ws,     ///< unit normal of the mesh, in the world
    [hidden] float3 position = position_ws  ///< where this pixel is, in the world
) {
    float3 right = ddx(position);
    float3 down = ddy(position);
    float3 across_right = cross(down, normal);
    float3 across_down = cross(normal, right);
    float area = dot(right, across_right);
    float3 slope = sign(area) * (ddx(height) * across_right + ddy(height) * across_down);
    return normalize(abs(area) * normal - slope);
}
