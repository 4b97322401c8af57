// Inputs from the mesh and the camera. A link such as "@normalWS" reads the same values; these nodes also offer a
// choice of space and appear in an editor.

/// The coordinate system of a position or a direction.
enum Space {
    Object,  ///< the mesh's own
    World,   ///< the scene's: metres, y up
    View,    ///< the camera's: x right, y up
    Tangent  ///< the surface's: x along u, y up in the texture's picture, z along the normal
};

// A vector of the world in the mesh's own space: scaled as the mesh is.
float3 VectorWorldToObject(float3 direction) {
    return mul(worldToObject, float4(direction, 0)).xyz;
}

// A direction of the world in the mesh's own space, of length 1.
float3 DirectionWorldToObject(float3 direction) {
    return normalize(VectorWorldToObject(direction));
}

// A vector of the world in the camera's space, of the same length.
float3 DirectionWorldToView(float3 direction) {
    return mul(worldToView, float4(direction, 0)).xyz;
}

/// The coordinate system of a direction that belongs to the surface.
enum SurfaceSpace {
    World,   ///< the scene's
    Tangent  ///< the surface's: x along u, y up in the texture's picture, z along the normal
};

/// The sets of texture coordinates.
enum UvChannel {
    UV0,  ///< the first set
    UV1,  ///< the second set: often used for baked light
    UV2,  ///< the third set
    UV3   ///< the fourth set
};

/// The position of this point of the surface. In tangent space, whose origin it is, the position is zero.
///
/// test: Position(Object, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(1, 0, 0)
/// test: Position(World, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 1, 0)
/// test: Position(View, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 0, 1)
/// test: Position(Tangent, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 0, 0)
[node("Input/Position")] [also("GeometryPosition")] [is("position", "space")]
float3 Position(
    const Space space = World,                ///< the coordinate system
    [hidden] float3 inObject = positionOS,  ///< read in object space
    [hidden] float3 inWorld = positionWS,   ///< read in world space
    [hidden] float3 inView = positionVS     ///< read in view space
) {
    if (space == Tangent) { return float3(0); }
    return space == Object ? inObject : space == World ? inWorld : inView;
}

/// The direction that points out of the surface: the mesh's interpolated normal, unit length.
///
/// In a lighting graph, the world-space normal is the shading normal, which includes the normal map.
///
/// test: Normal(Object, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1), 0) == float3(1, 0, 0)
/// test: Normal(World, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1), 0) == float3(0, 1, 0)
/// test: Normal(View, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1), 0) == float3(0, 0, 1)
/// test: Normal(Tangent, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1), float3(0.6, -0.8, 0)) == float3(0.6, -0.8, 0)
[node("Input/Normal")] [also("NormalVector")] [is("direction", "space")]
float3 Normal(
    const Space space = World,              ///< the coordinate system
    [hidden] float3 inObject = normalOS,  ///< read in object space
    [hidden] float3 inWorld = normalWS,   ///< read in world space
    [hidden] float3 inView = normalVS,    ///< read in view space
    [hidden] float3 inTangent = WorldToTangent(normalWS, geometryNormalWS, tangentWS, bitangentWS)  ///< read in tangent space
) {
    if (space == Tangent) { return inTangent; }
    return space == Object ? inObject : space == World ? inWorld : inView;
}

/// The direction in which the texture's u grows on the surface, of length 1.
///
/// test: TangentVector(Object, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(1, 0, 0)
/// test: TangentVector(World, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 1, 0)
/// test: TangentVector(View, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 0, 1)
/// test: TangentVector(Tangent, float3(0, 1, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(1, 0, 0)
[node("Input/Tangent Vector")] [also("GeometryTangent", "VertexTangent")] [is("direction", "space")]
float3 TangentVector(
    const Space space = World,  ///< the coordinate system
    [hidden] float3 inObject = DirectionWorldToObject(tangentWS),  ///< read in object space
    [hidden] float3 inWorld = tangentWS,                           ///< read in world space
    [hidden] float3 inView = DirectionWorldToView(tangentWS)       ///< read in view space
) {
    if (space == Tangent) { return float3(1, 0, 0); }
    return space == Object ? inObject : space == World ? inWorld : inView;
}

/// The direction on the surface that is up in the texture's picture, of length 1.
///
/// test: BitangentVector(Object, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(1, 0, 0)
/// test: BitangentVector(World, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 1, 0)
/// test: BitangentVector(View, float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)) == float3(0, 0, 1)
/// test: BitangentVector(Tangent, float3(1, 0, 0), float3(1, 0, 0), float3(0, 0, 1)) == float3(0, 1, 0)
[node("Input/Bitangent Vector")] [also("GeometryBitangent", "Binormal")] [is("direction", "space")]
float3 BitangentVector(
    const Space space = World,  ///< the coordinate system
    [hidden] float3 inObject = DirectionWorldToObject(bitangentWS),  ///< read in object space
    [hidden] float3 inWorld = bitangentWS,                           ///< read in world space
    [hidden] float3 inView = DirectionWorldToView(bitangentWS)       ///< read in view space
) {
    if (space == Tangent) { return float3(0, 1, 0); }
    return space == Object ? inObject : space == World ? inWorld : inView;
}

/// The unit direction from the surface to the camera.
///
/// test: ViewDirection(World, float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1), 0, 0) == float3(0, 1, 0)
/// test: ViewDirection(Tangent, float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1), 0, 0) == float3(0, 0, 1)
/// test: ViewDirection(Object, float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1), float3(1, 0, 0), 0) == float3(1, 0, 0)
/// test: ViewDirection(View, float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1), 0, float3(0, 0, 1)) == float3(0, 0, 1)
[node("Input/View Direction")] [also("CameraVector")] [is("direction", "space")]
float3 ViewDirection(
    const Space space = World,                   ///< the coordinate system
    [hidden] float3 inWorld = viewDirWS,        ///< read in world space
    [hidden] float3 normal = geometryNormalWS,   ///< the frame, for tangent space
    [hidden] float3 tangent = tangentWS,          ///< the frame, for tangent space
    [hidden] float3 bitangent = bitangentWS,      ///< the frame, for tangent space
    [hidden] float3 inObject = DirectionWorldToObject(viewDirWS),  ///< read in object space
    [hidden] float3 inView = DirectionWorldToView(viewDirWS)       ///< read in view space
) {
    if (space == Object) { return inObject; }
    if (space == View) { return inView; }
    return space == World ? inWorld : WorldToTangent(inWorld, normal, tangent, bitangent);
}

// From a point to the camera; if the view is orthographic, to the camera's plane.
float3 ToCamera(float3 position) {
    float3 toCamera = cameraPositionWS - position;
    float3 toPlane = cameraForwardWS * dot(toCamera, cameraForwardWS);
    return lerp(toCamera, toPlane, viewIsOrthographic);
}

/// The way from the surface to the camera: ViewDirection with its length. In an orthographic view, the way to the camera's plane.
///
/// test: ViewVector(World, float3(0, 3, 0), 0, 0, 0) == float3(0, 3, 0)
/// test: ViewVector(Object, float3(0, 3, 0), float3(1, 0, 2), 0, 0) == float3(1, 0, 2)
/// test: ViewVector(View, float3(0, 3, 0), 0, float3(0, 0, 3), 0) == float3(0, 0, 3)
/// test: ViewVector(Tangent, float3(0, 3, 0), 0, 0, float3(2, 0, 0)) == float3(2, 0, 0)
[node("Input/View Vector")] [also("ToCamera")]
float3 ViewVector(
    const Space space = World,           ///< the coordinate system
    [hidden] float3 inWorld = ToCamera(positionWS),   ///< read in world space
    [hidden] float3 inObject = VectorWorldToObject(ToCamera(positionWS)),  ///< read in object space
    [hidden] float3 inView = DirectionWorldToView(ToCamera(positionWS)),  ///< read in view space
    [hidden] float3 inTangent = WorldToTangent(ToCamera(positionWS), geometryNormalWS, tangentWS, bitangentWS)  ///< read in tangent space
) {
    if (space == Object) { return inObject; }
    if (space == View) { return inView; }
    if (space == Tangent) { return inTangent; }
    return inWorld;
}

/// The mesh's texture coordinates: (0, 0) is a picture's upper left corner.
///
/// test: UV(UV0, float2(1, 2), float2(3, 4), 0, 0) == float2(1, 2)
/// test: UV(UV1, float2(1, 2), float2(3, 4), 0, 0) == float2(3, 4)
/// test: UV(UV2, 0, 0, float2(5, 6), float2(7, 8)) == float2(5, 6)
/// test: UV(UV3, 0, 0, float2(5, 6), float2(7, 8)) == float2(7, 8)
[node("Input/UV")] [also("TexCoord", "TextureCoordinate")]
float2 UV(
    const UvChannel channel = UV0,  ///< which set
    [hidden] float2 first = uv0,    ///< the first set
    [hidden] float2 second = uv1,   ///< the second set
    [hidden] float2 third = uv2,    ///< the third set
    [hidden] float2 fourth = uv3    ///< the fourth set
) {
    if (channel == UV1) { return second; }
    if (channel == UV2) { return third; }
    if (channel == UV3) { return fourth; }
    return first;
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

/// Which vertex of the mesh it is: 0 for the first one.
///
/// Each vertex has its own number, in the order of the mesh; vertices that triangles share have one number. The number is
/// exact up to 16777216 (2^24). The fragment stage has no vertices: there, it is interpolated. To have the whole number
/// of a vertex, read it in the `vertex` block or in a node with `"stage": "vertex"`.
///
/// Vulkan's `gl_VertexIndex` includes the vertex offset of the draw. Direct3D's `SV_VertexID` does not. Draw without an
/// offset to have the same numbers in both.
///
/// test: VertexId(0) == 0
/// test: VertexId(70001) == 70001
[node("Input/Vertex Id")] [also("VertexIndex")] [inFloat]
float VertexId(
    [hidden] float index = vertexId  ///< read from the draw
) {
    return index;
}

/// Which instance of the draw it is: 0 for the first one, and where one object is drawn alone.
///
/// A material with this node is drawn with many instances at once. The reflection says how many one draw can have
/// (`mostInstances`), and each draw counts from 0. The number is exact up to 16777216 (2^24). In Unity, it is 0 if the
/// material does not enable GPU instancing.
///
/// Vulkan's `gl_InstanceIndex` includes the first instance of the draw. Direct3D's `SV_InstanceID` does not. Draw from
/// instance 0 to have the same numbers in both.
///
/// test: InstanceId(0) == 0
/// test: InstanceId(70001) == 70001
[node("Input/Instance Id")] [also("InstanceIndex")] [inFloat]
float InstanceId(
    [hidden] float index = instanceId  ///< read from the draw
) {
    return index;
}
