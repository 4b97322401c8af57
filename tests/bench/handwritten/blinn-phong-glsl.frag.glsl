// Blinn-Phong with a texture and a white highlight.
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

layout(set = 0, binding = 2, std140) uniform Lights
{
    int lightCount;
    vec4 lightPosition[16];  // w: 0 directional, 1 point, 2 spot
    vec4 lightColor[16];     // w: range
    vec4 lightAxis[16];
    vec4 lightCone[16];  // cosines of the half angles: inner, outer
    int vertexLightCount;
};

layout(set = 0, binding = 5, std140) uniform Ambient
{
    vec4 ambientSH[9];
};

layout(set = 1, binding = 0, std140) uniform Material
{
    float u_specExp;
};

layout(set = 1, binding = 1) uniform texture2D u_texDiffuse;
layout(set = 1, binding = 2) uniform sampler u_texDiffuseSampler;

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 position;
layout(location = 2) in vec3 normal;
layout(location = 0) out vec4 outColor;

// The direction to a light, and its radiance at this point.
void lightAt(int i, out vec3 direction, out vec3 radiance)
{
    vec4 place = lightPosition[i];
    vec4 color = lightColor[i];
    direction = place.xyz;
    radiance = color.rgb;
    if (place.w > 0.5) {
        vec3 toLight = place.xyz - position;
        float d2 = dot(toLight, toLight);
        float ratio = d2 / (color.w * color.w);
        float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
        float attenuation = window * window / max(d2, 0.0001);
        direction = toLight * inversesqrt(max(d2, 1e-12));
        if (place.w > 1.5) {
            vec2 cone = lightCone[i].xy;
            float cosine = -dot(lightAxis[i].xyz, direction);
            float spot = clamp((cosine - cone.y) / max(cone.x - cone.y, 0.001), 0.0, 1.0);
            attenuation *= spot * spot;
        }
        radiance *= attenuation;
    }
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
    vec3 n = normalize(normal);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
    vec3 albedo = texture(sampler2D(u_texDiffuse, u_texDiffuseSampler), uv).rgb;
    vec3 direct = vec3(0.0);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 l, radiance;
        lightAt(i, l, radiance);
        float ndotl = clamp(dot(n, l), 0.0, 1.0);
        vec3 h = l + v;
        h *= inversesqrt(max(dot(h, h), 1e-7));
        float ndoth = clamp(dot(n, h), 0.0, 1.0);
        float highlight = min(ndotl, ndoth) > 0.0 ? pow(ndoth, u_specExp) : 0.0;  // 0 to the power of 0 has no value
        direct += (albedo * ndotl + highlight) * radiance;
    }
    outColor = vec4(direct + albedo * irradiance(n), 1.0);
}
