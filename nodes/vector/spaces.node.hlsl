// Vectors from one coordinate system to another.

/// The coordinate systems of Transform.
enum TransformSpace {
    Object,  ///< the mesh's own
    World,   ///< the scene's: metres, y up
    View,    ///< the camera's: x right, y up, looking along -z
    Tangent, ///< the surface's at this point: x along u, y up in the texture's picture, z along the normal
    Screen   ///< the picture's, of points alone: x and y from 0 to 1 from the upper left corner, z the depth
};

/// What Transform moves.
enum TransformKind {
    Position,   ///< a point
    Direction,  ///< a direction: it ignores where the systems begin
    Normal      ///< a normal: it stays perpendicular to its surface if the object is stretched
};

/// Transforms a point, a direction or a normal from one coordinate system to another.
///
/// Tangent space begins at the point that is drawn. A point of the screen must not lie in the camera's plane.
///
/// test: Transform(float3(1, 2, 3), Tangent, World, Position, true, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(8, 11, 7)
/// test: Transform(float3(8, 11, 7), World, Tangent, Position, true, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(1, 2, 3)
/// test: Transform(float3(0, 3, 4), Tangent, World, Direction, true, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(0, 0.8, -0.6)
/// test: Transform(float3(0, 8, -6), World, Tangent, Normal, false, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(0, 6, 8)
/// test: Transform(float3(0, 3, 4), View, View, Direction, true, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(0, 0.6, 0.8)
/// test: Transform(float3(0.25, 0.5, 0.75), Screen, Screen, Position, true, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(0.25, 0.5, 0.75)
/// test: Transform(float3(1, 2, 3), Object, Object, Position, true, float3(7, 8, 9), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(1, 2, 3)
[node("Vector/Transform")] [also("TransformPoint", "TransformVector", "TransformNormal")] [inFloat]
float3 Transform(
    float3 vector = 0,                          ///< point, direction or normal
    const TransformSpace from = Object,         ///< its coordinate system
    const TransformSpace to = World,            ///< the coordinate system of the result
    const TransformKind kind = Position,        ///< what it is
    bool normalized = true,                     ///< directions and normals become unit vectors
    [hidden] float3 position = positionWS,      ///< where the surface is, for tangent space
    [hidden] float3 normal = geometryNormalWS,  ///< the frame, for tangent space
    [hidden] float3 tangent = tangentWS,        ///< the frame, for tangent space
    [hidden] float3 bitangent = bitangentWS     ///< the frame, for tangent space
) {
    const bool moves = kind == Position;
    // 1: the systems' origins count.
    const float w = moves ? 1 : 0;
    float3 result = vector;
    if (from != to) {
        // By way of world space. A camera only turns and moves, so its matrix's transpose turns back.
        if (from == Object) {
            result = kind == Normal ? mul(float4(vector, 0), worldToObject).xyz : mul(objectToWorld, float4(vector, w)).xyz;
        }
        if (from == View) {
            float3 origin = w * mul(worldToView, float4(0, 0, 0, 1)).xyz;
            result = mul(float4(vector - origin, 0), worldToView).xyz;
        }
        if (from == Screen) { result = WorldFromDepth(vector.xy, vector.z, clipToWorld); }
        if (from == Tangent) {
            result = tangent * vector.x + bitangent * vector.y + normal * vector.z + w * position;
        }
        if (to == Object) {
            result = kind == Normal ? mul(float4(result, 0), objectToWorld).xyz : mul(worldToObject, float4(result, w)).xyz;
        }
        if (to == Screen) {
            float4 clip = mul(worldToClip, float4(result, 1));
            float3 seen = clip.xyz / clip.w;
            result = float3(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y, symmetricDepth ? 0.5 + 0.5 * seen.z : seen.z);
        }
        if (to == View) { result = mul(worldToView, float4(result, w)).xyz; }
        if (to == Tangent) { result = WorldToTangent(result - w * position, normal, tangent, bitangent); }
    }
    if (moves) { return result; }
    return normalized ? SafeNormalize(result) : result;
}
