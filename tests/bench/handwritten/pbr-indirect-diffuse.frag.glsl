// Diffuse light of the surroundings.
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

layout(set = 0, binding = 5, std140) uniform Ambient
{
    vec4 ambientSH[9];
};

layout(set = 1, binding = 0, std140) uniform Material
{
    vec4 BaseColor;
    float Metallic;
    float Roughness;
};

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

float pow5(float x)
{
    float x2 = x * x;
    return x2 * x2 * x;
}

// E / pi of the surroundings (Ramamoorthi and Hanrahan 2001).
vec3 irradiance(vec3 n)
{
    vec3 e = ambientSH[0].rgb * 0.2820948;
    e += (ambientSH[1].rgb * n.y + ambientSH[2].rgb * n.z + ambientSH[3].rgb * n.x) * 0.325735;
    e += (ambientSH[4].rgb * (n.x * n.y) + ambientSH[5].rgb * (n.y * n.z) + ambientSH[7].rgb * (n.x * n.z)) * 0.27313711;
    e += ambientSH[6].rgb * (0.07884789 * (3.0 * n.z * n.z - 1.0));
    e += ambientSH[8].rgb * (0.13656855 * (n.x * n.x - n.y * n.y));
    return max(e, 0.0);
}

void main()
{
    vec3 n = bumped(texture(sampler2D(_NormalTex, _NormalTexSampler), uv).xy * 2.0 - 1.0);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
    vec3 f0 = mix(vec3(0.04), BaseColor.rgb, Metallic);
    float ndotv = clamp(dot(n, v), 0.0, 1.0);
    vec3 fresnel = f0 + (max(vec3(1.0 - Roughness), f0) - f0) * pow5(1.0 - ndotv);
    outColor = vec4(BaseColor.rgb * ((1.0 - fresnel) * (1.0 - Metallic)) * irradiance(n), 1.0);
}
