// The mesh: vertex attributes, and values computed from them in object and world space.
// Right-handed world, y up; normals are unit; tangentOS.w is the handedness of the bitangent, 1 or -1.

/// Vertex position in object space; in the fragment stage after displacement.
[attribute] [vertexOutput] float3 positionOS;
/// Vertex normal in object space, unit.
[attribute] [vertexOutput] float3 normalOS;
/// Vertex tangent in object space, unit; w is the handedness of the bitangent, 1 or -1.
[attribute] [vertexOutput] float4 tangentOS;
/// First texture coordinates; v grows downwards, as texels are stored.
[attribute] [uv] float2 uv0;
/// Second texture coordinates.
[attribute] [uv] float2 uv1;
/// Third texture coordinates.
[attribute] [uv] float2 uv2;
/// Fourth texture coordinates.
[attribute] [uv] float2 uv3;
/// Vertex colour, linear.
[attribute] float4 vertexColor;

/// True on the side of a triangle whose vertices run counter-clockwise.
[builtin("frontFacing")] bool frontFacing;
/// Pixel centre in x and y (from the top left), depth in z.
[builtin("fragCoord")] float4 fragCoord;

/// Which vertex of the mesh it is: 0 for the first. It is exact up to 16777216 (2^24). In the fragment stage it is interpolated.
[semantic("vertex")]
float vertexId(int index = vertexIndex) {
    return float(index);
}
/// Which instance of the draw it is: 0 for the first, and where only one object is drawn. It is exact up to 16777216 (2^24).
[semantic("pixel")]
float instanceId(int index = instanceIndex) {
    return float(index);
}

/// The material is visible from both sides ("cull": "off" or "front").
[static("cull", "off", "front")] bool twoSided;
/// The material is not drawn where alpha is below alphaClip.
[static("surface", "cutout", "clipped")] bool alphaClip;
/// The material is transparent, but its reflections keep full strength.
[static("surface", "transparent")] bool premultiplied;
/// The material fades as a whole, including its reflections.
[static("surface", "fade")] bool fades;
/// The colour of the material is added to the background.
[static("surface", "additive")] bool adds;
/// The background is multiplied by the colour of the material.
[static("surface", "multiply")] bool multiplies;
/// The background is seen through the material.
[static("surface", "fade", "transparent", "additive", "multiply")] bool blends;
/// Each material chooses which of these it is ("materialOverride"): they are known only to the engine's preprocessor.
[static("surface", "chosen")] bool choosesKind;
/// The material may be one that is not drawn where alpha is below alphaClip.
[static("surface", "cutout", "clipped", "chosen")] bool mayClip;

/// Object to world space.
/// space: object to world
/// block: The drawn object. The engine fills it for each draw, or for each instance of a draw.
[extern("Object")] [perObject] float4x4 objectToWorld;
/// The inverse of objectToWorld.
/// space: world to object
[extern("Object")] [perObject] float4x4 worldToObject;

/// Position in world space.
[semantic("vertex")]
float3 positionWS(float3 position = positionOS) {
    return mul(objectToWorld, float4(position, 1)).xyz;
}

// A mesh may hold zeros instead of normals and tangents. The vertex stage adds to each a vector that rounding removes
// from all others: so a missing normal points up in the world, and a missing tangent lies anyhow in the surface, of a
// frame that is right-handed. No mesh has the normal (81, 37, 46) to the last bit, of which there is no such tangent.

/// Mesh normal in world space as it leaves the vertex stage; interpolation makes it shorter than 1. If the mesh has none
/// (its length is zero), it is (0, 1, 0).
[semantic("vertex")]
float3 vertexNormalWS(float3 normal = normalOS) {
    return normalObjectToWorld(normal);
}

/// Mesh tangent in world space as it leaves the vertex stage; w is the bitangent's handedness, mirroring included. If the
/// mesh has none (its length is zero), it is a direction across the normal, and w is 1.
[semantic("vertex")]
float4 vertexTangentWS(float4 tangent = tangentOS, float3 normal = vertexNormalWS) {
    float handedness = determinant(objectToWorld) * tangent.w < 0 ? -1 : 1;
    float3 anyhow = cross(normal, float3(8.1e-14, 3.7e-14, 4.6e-14));
    return float4(normalize(mul(objectToWorld, float4(tangent.xyz, 0)).xyz + anyhow), handedness);
}

/// Mesh normal in world space, unit; on the back of a two-sided material it points to the viewer.
[semantic("pixel")]
float3 geometryNormalWS(float3 interpolated = vertexNormalWS, bool front = frontFacing) {
    float3 normal = normalize(interpolated);
    return twoSided && !front ? -normal : normal;
}

/// Mesh normal in world space, unit. In a lighting graph: the shading normal, which includes the normal map.
[semantic("pixel")]
float3 normalWS(float3 normal = geometryNormalWS) {
    return normal;
}

/// Mesh tangent in world space, unit. On the back of a two-sided material the whole frame is flipped, as in glTF: a
/// bump in front is a dent behind.
[semantic("pixel")]
float3 tangentWS(float4 interpolated = vertexTangentWS, bool front = frontFacing) {
    float3 tangent = normalize(interpolated.xyz);
    return twoSided && !front ? -tangent : tangent;
}

/// Bitangent in world space: cross(normal, tangent) with the mesh's handedness.
[semantic("pixel")]
float3 bitangentWS(float3 normal = geometryNormalWS, float3 tangent = tangentWS,
                    float4 interpolated = vertexTangentWS, bool front = frontFacing) {
    float3 bitangent = cross(normal, tangent) * interpolated.w;
    return twoSided && !front ? -bitangent : bitangent;
}

/// `@tangentWS`, and in w the handedness with which `@bitangentWS` is cross(normal, tangent) w: 1 or -1.
[semantic("pixel")]
float4 handedTangentWS(float3 tangent = tangentWS, float4 interpolated = vertexTangentWS, bool front = frontFacing) {
    return float4(tangent, twoSided && !front ? -interpolated.w : interpolated.w);
}

/// Transforms a normal by the inverse transpose, so that it stays perpendicular under non-uniform scale.
float3 normalObjectToWorld(float3 normal) {
    return normalize(mul(float4(normal, 0), worldToObject).xyz + float3(0, 1e-15, 0));
}

/// The same for the material's own normal in a pixel; on the back of a two-sided material it is flipped, too.
float3 shownNormalObjectToWorld(float3 normal, bool front = frontFacing) {
    float3 world = normalObjectToWorld(normal);
    return twoSided && !front ? -world : world;
}

/// The object's origin in world space.
[semantic("uniform")]
float3 objectPositionWS() {
    return mul(objectToWorld, float4(0, 0, 0, 1)).xyz;
}

/// The object's scale: the lengths of its three axes in world space.
[semantic("uniform")]
float3 objectScale() {
    float scaleX = length(mul(objectToWorld, float4(1, 0, 0, 0)).xyz);
    float scaleY = length(mul(objectToWorld, float4(0, 1, 0, 0)).xyz);
    float scaleZ = length(mul(objectToWorld, float4(0, 0, 1, 0)).xyz);
    return float3(scaleX, scaleY, scaleZ);
}
