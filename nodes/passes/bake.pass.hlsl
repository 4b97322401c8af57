// Bake: draws the surface where the texture coordinates of the mesh are, so that the targets are textures of it.
// `patina bake` makes a glTF material of them. Every pixel of the targets is a texel: u grows to the right, v grows
// downwards. Nothing is lit.
//
// A texture is the same from every side, in every light and at any time. A surface that reads the camera, lights or the
// time is refused, until a switch says that one value is meant.
// source: Khronos Group, "glTF 2.0 Specification", section 3.9 (materials), 2021

/// The time has one value.
[switch] [otherwise("fix the time: patina bake --time 0")] bool fixedTime;
/// The camera is at one place.
[switch] [otherwise("fix the camera: patina bake --camera position=0,0,4")] bool fixedView;
/// Lights and surroundings are those of one scene.
[switch] [otherwise("fix the light: patina bake --env studio")] bool fixedLight;

struct BakedSurface {
    [target("bakedColor", "rgba32f")] float4 color;            // base colour, alpha
    [target("bakedReflection", "rgba32f")] float4 reflection;  // occlusion, roughness, metallic; what a conversion loses
    [target("bakedNormal", "rgba32f")] float4 normal;          // in tangent space; 1 where the mesh is
    [target("bakedEmission", "rgba32f")] float4 emission;      // radiance, occlusion
    [target("bakedCutoff", "r32f")] float cutoff;              // alphaClip
};

/// The tangent-space normal that NormalTangentToWorld() turns into `normal`. Its frame may be skewed, so it is solved
/// for the three coordinates by Cramer's rule.
[inline]
float3 normalInFrame(float3 normal, float3 tangent, float3 bitangent, float3 up) {
    float3 ofX = cross(bitangent, up);
    float3 solved = float3(dot(normal, ofX), dot(normal, cross(up, tangent)), dot(normal, cross(tangent, bitangent)));
    solved *= dot(tangent, ofX) < 0 ? -1.0 : 1.0;
    return dot(solved, solved) > 1e-12 ? normalize(solved) : float3(0, 0, 1);
}

/// Nothing is seen where a surface that blends is clipped.
[inline]
float bakedAlpha(LightingSurface lit) {
    if (alphaClip) {
        if (blends) { return lit.alpha < lit.alphaClip ? 0 : lit.alpha; }
    }
    return lit.alpha;
}

/// The surface of a material of metallic and roughness.
[inline]
BakedSurface bakedSurface(LightingSurface lit, float3 normal) {
    BakedSurface baked;
    baked.color = float4(lit.baseColor, bakedAlpha(lit));
    baked.reflection = float4(lit.occlusion, lit.roughness, lit.metallic, 0);
    baked.normal = float4(normal, 1);
    baked.emission = float4(lit.emission, lit.occlusion);
    baked.cutoff = lit.alphaClip;
    return baked;
}

[pass("bake")] [pass("bake-converted")] [pass("bake-specular")] [pass("bake-value")] [vertex]
float4 bakeVertex(float2 place = uv0) {
    return float4(2 * place.x - 1, 1 - 2 * place.y, 0.5, 1);
}

[pass("bake")] [fragment] [lights("all")] [blend("one", "zero")] [depth("always", "keep")] [stencil("always", "keep")]
[lacks("fragCoord", "screenSize", "color", "depth")]
[lacks("time", "fixedTime")] [lacks("Camera", "fixedView")]
[lacks("Lights", "Shadows", "Ambient", "environmentMap", "lightCookie", "fixedLight")]
BakedSurface bakeFragment(float3 tangent = tangentWS, float3 bitangent = bitangentWS, float3 up = geometryNormalWS) {
    LightingSurface lit = lightingSurface();
    return bakedSurface(lit, normalInFrame(lit.normalWS, tangent, bitangent, up));
}
