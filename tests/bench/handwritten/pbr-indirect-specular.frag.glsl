// The surroundings, by the split sum and its fit.
#version 450

layout(set = 0, binding = 1, std140) uniform Camera
{
    mat4 worldToClip;
    mat4 worldToView;
    vec3 cameraPositionWS;
    float viewIsOrthographic;
    vec3 cameraForwardWS;
    float shadowBias;
    mat4 clipToWorld;
    vec2 clipPlanes;
    float shadowNormalBias;
};

layout(set = 1, binding = 0, std140) uniform Material
{
    vec4 BaseColor;
    float Metallic;
    float Roughness;
};

layout(set = 0, binding = 7) uniform textureCube environmentMap;
layout(set = 0, binding = 14) uniform sampler environmentMapSampler;
layout(set = 1, binding = 1) uniform texture2D _NormalTex;
layout(set = 1, binding = 2) uniform sampler _NormalTexSampler;

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 position;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec4 tangent;
layout(location = 0) out vec4 outColor;

// The normal of a normal map, in world space.
vec3 bumped(vec2 xy)
{
    float z = sqrt(clamp(1.0 - dot(xy, xy), 0.0, 1.0));
    vec3 n = normalize(normal);
    vec3 t = normalize(tangent.xyz);
    vec3 b = cross(n, t) * tangent.w;
    return normalize(t * xy.x + b * xy.y + n * z);
}

vec3 environment(vec3 direction, float roughness)
{
    float level = roughness * (1.7 - 0.7 * roughness) * 5.0;
    return textureLod(samplerCube(environmentMap, environmentMapSampler), direction, level).rgb;
}

void main()
{
    vec3 n = bumped(texture(sampler2D(_NormalTex, _NormalTexSampler), uv).xy * 2.0 - 1.0);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
    vec3 f0 = mix(vec3(0.04), BaseColor.rgb, Metallic);
    float ndotv = clamp(dot(n, v), 0.0, 1.0);
    // Karis, "Physically Based Shading on Mobile".
    float x = 1.0 - Roughness;
    float a = min(x * x, exp2(-9.28 * ndotv)) * x + 0.0425 - 0.0275 * Roughness;
    float scale = 1.04 - 0.572 * Roughness - 1.04 * a;
    float offset = 1.04 * a + 0.022 * Roughness - 0.04;
    vec3 reflected = environment(reflect(-v, n), clamp(Roughness, 0.0, 1.0));
    outColor = vec4(reflected * max(f0 * scale + offset, 0.0), 1.0);
}
