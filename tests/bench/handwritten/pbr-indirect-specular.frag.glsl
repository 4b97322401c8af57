// PBR 3: indirect specular light.
#version 450

layout(set = 0, binding = 1) uniform Camera
{
    mat4 worldToClip, worldToView;
    vec3 cameraPositionWS;
    float viewIsOrthographic;
    vec3 cameraForwardWS;
};

layout(set = 1, binding = 0) uniform Material
{
    vec4 BaseColor;
    float Metallic;
    float Roughness;
};

layout(set = 0, binding = 6) uniform textureCube environmentMap;
layout(set = 0, binding = 12) uniform sampler environmentMapSampler;

layout(set = 1, binding = 1) uniform texture2D _NormalTex;
layout(set = 1, binding = 2) uniform sampler sampler_NormalTex;

layout(location = 0) in vec2 vUv;
layout(location = 1) in vec3 vPositionWS;
layout(location = 2) in vec3 vNormalWS;
layout(location = 3) in vec4 vTangentWS;
layout(location = 0) out vec4 outColor;

vec3 viewDirection()
{
    return normalize(mix(cameraPositionWS - vPositionWS, -cameraForwardWS, viewIsOrthographic));
}

// The normal of the normal map, in world space.
vec3 bumpedNormal(vec2 xy)
{
    vec3 normal = normalize(vNormalWS);
    vec3 tangent = normalize(vTangentWS.xyz);
    vec3 bitangent = cross(normal, tangent) * vTangentWS.w;
    float z = sqrt(clamp(1.0 - dot(xy, xy), 0.0, 1.0));
    return normalize(tangent * xy.x + bitangent * xy.y + normal * z);
}

void main()
{
    vec3 normal = bumpedNormal(texture(sampler2D(_NormalTex, sampler_NormalTex), vUv).xy * 2.0 - 1.0);
    vec3 view = viewDirection();
    vec3 f0 = mix(vec3(0.04), BaseColor.rgb, Metallic);
    float ndotv = clamp(dot(normal, view), 0.0, 1.0);
    float rough = clamp(Roughness, 0.0, 1.0), level = rough * (1.7 - 0.7 * rough) * 5.0;
    vec3 environment = textureLod(samplerCube(environmentMap, environmentMapSampler), reflect(-view, normal), level).rgb;
    vec4 r = Roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * ndotv)) * r.x + r.y;
    outColor = vec4(environment * max(f0 * (r.z - 1.04 * a) + (r.w + 1.04 * a), 0.0), 1.0);
}
