/// Turns a height into a normal, for heights that no texture holds. It looks at the neighbouring pixels, so it needs
/// neither tangents nor texture coordinates.
///
/// formula: normalize(|d| n - sign(d) (dh/dx (p_y x n) + dh/dy (n x p_x))), d = p_x . (p_y x n)
/// source: Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010
[node("Examples/Relief")]
float3 Relief(
    [unit("m")] float height,               ///< above the mesh, along its normal
    float3 normal = geometryNormalWS,     ///< unit normal of the mesh, in the world
    [hidden] float3 position = positionWS  ///< where this pixel is, in the world
) {
    float3 right = ddx(position);
    float3 down = ddy(position);
    float3 acrossRight = cross(down, normal);
    float3 acrossDown = cross(normal, right);
    float area = dot(right, acrossRight);
    float3 slope = sign(area) * (ddx(height) * acrossRight + ddy(height) * acrossDown);
    return normalize(abs(area) * normal - slope);
}
