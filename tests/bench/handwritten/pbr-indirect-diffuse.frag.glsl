// PBR 4: indirect diffuse light.
#version 450

layout(set = 0, binding = 1) uniform Camera
{
    mat4 worldToClip, worldToView;
    vec3 cameraPositionWS;
    float viewIsOrthographic;
    vec3 cameraForwardWS;
};

layout(set = 0, binding = 5) uniform Ambient
{
    vec4 ambientSH[9];
};

layout(set = 1, binding = 0) uniform Material
{
    vec4 BaseColor;
    float Metallic;
    float Roughness;
};

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

float pow5(float x)
{
    float x2 = x * x;
    return x2 * x2 * x;
}

// Diffuse light of the surroundings, from nine coefficients.
vec3 irradiance(vec3 n)
{
    vec3 sum = ambientSH[0].rgb * 0.2820948;
    sum += (ambientSH[1].rgb * n.y + ambientSH[2].rgb * n.z + ambientSH[3].rgb * n.x) * 0.325735;
    sum += (ambientSH[4].rgb * (n.x * n.y) + ambientSH[5].rgb * (n.y * n.z) + ambientSH[7].rgb * (n.x * n.z)) * 0.27313712;
    sum += ambientSH[6].rgb * (0.07884789 * (3.0 * n.z * n.z - 1.0));
    sum += ambientSH[8].rgb * (0.13656856 * (n.x * n.x - n.y * n.y));
    return max(sum, 0.0);
}

void main()
{
    vec3 normal = bumpedNormal(texture(sampler2D(_NormalTex, sampler_NormalTex), vUv).xy * 2.0 - 1.0);
    vec3 view = viewDirection();
    vec3 f0 = mix(vec3(0.04), BaseColor.rgb, Metallic);
    float ndotv = clamp(dot(normal, view), 0.0, 1.0);
    vec3 fresnel = f0 + (max(f0, 1.0 - Roughness) - f0) * pow5(1.0 - ndotv);
    outColor = vec4(BaseColor.rgb * ((1.0 - fresnel) * (1.0 - Metallic)) * irradiance(normal), 1.0);
}
