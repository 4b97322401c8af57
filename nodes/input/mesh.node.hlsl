// Inputs from the mesh and the camera. A link such as "@normalWS" reads the same values; these nodes also offer a
// choice of space and appear in an editor.

/// The coordinate system of a position or a direction.
enum Space {
    Object,  ///< the mesh's own
    World,   ///< the scene's: metres, y up
    View     ///< the camera's: x right, y up
};

/// The coordinate system of a direction that belongs to the surface.
enum SurfaceSpace {
    World,   ///< the scene's
    Tangent  ///< the surface's: x along u, y up in the texture's picture, z along the normal
};

/// The sets of texture coordinates.
enum UvChannel {
    UV0,  ///< the first set
    UV1   ///< the second set: often used for baked light
};

/// The position of this point of the surface.
///
/// test: Position(Object, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(1, 0, 0)
/// test: Position(World, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 1, 0)
/// test: Position(View, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 0, 1)
[node("Input/Position")] [also("GeometryPosition")] [is("position", "space")]
float3 Position(
    const Space space = World,                ///< the coordinate system
    [hidden] float3 inObject = positionOS,  ///< read in object space
    [hidden] float3 inWorld = positionWS,   ///< read in world space
    [hidden] float3 inView = positionVS     ///< read in view space
) {
    return space == Object ? inObject : space == World ? inWorld : inView;
}

/// The direction that points out of the surface: the mesh's interpolated normal, unit length.
///
/// In a lighting graph, the world-space normal is the shading normal, which includes the normal map.
///
/// test: Normal(Object, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(1, 0, 0)
/// test: Normal(World, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 1, 0)
/// test: Normal(View, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 0, 1)
[node("Input/Normal")] [also("NormalVector")] [is("direction", "space")]
float3 Normal(
    const Space space = World,              ///< the coordinate system
    [hidden] float3 inObject = normalOS,  ///< read in object space
    [hidden] float3 inWorld = normalWS,   ///< read in world space
    [hidden] float3 inView = normalVS     ///< read in view space
) {
    return space == Object ? inObject : space == World ? inWorld : inView;
}

/// The unit direction from the surface to the camera.
///
/// test: ViewDirection(World, float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1)) == float3(0, 1, 0)
/// test: ViewDirection(Tangent, float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1)) == float3(0, 0, 1)
[node("Input/View Direction")] [also("ViewVector", "CameraVector")] [is("direction", "space")]
float3 ViewDirection(
    const SurfaceSpace space = World,             ///< the coordinate system
    [hidden] float3 inWorld = viewDirWS,       ///< read in world space
    [hidden] float3 normal = geometryNormalWS,  ///< the frame, for tangent space
    [hidden] float3 tangent = tangentWS,         ///< the frame, for tangent space
    [hidden] float3 bitangent = bitangentWS      ///< the frame, for tangent space
) {
    return space == World ? inWorld : WorldToTangent(inWorld, normal, tangent, bitangent);
}

/// The mesh's texture coordinates: (0, 0) is a picture's upper left corner.
///
/// test: UV(UV0, float2(1, 2), float2(3, 4)) == float2(1, 2)
/// test: UV(UV1, float2(1, 2), float2(3, 4)) == float2(3, 4)
[node("Input/UV")] [also("TexCoord", "TextureCoordinate")]
float2 UV(
    const UvChannel channel = UV0,  ///< which set
    [hidden] float2 first = uv0,    ///< the first set
    [hidden] float2 second = uv1    ///< the second set
) {
    return channel == UV0 ? first : second;
}

/// The vertex colour of the mesh, linear; white if the mesh has none.
///
/// test: VertexColor(float4(0.1, 0.2, 0.3, 0.4)) == float4(0.1, 0.2, 0.3, 0.4)
[node("Input/Vertex Color")] [also("GeomColor", "GeometryColor")]
float4 VertexColor(
    [hidden] float4 color = vertexColor  ///< the attribute
) {
    return color;
}
