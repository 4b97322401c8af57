// Direct light by Cook and Torrance, and the diffuse light that Fresnel leaves.
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

void main()
{
    vec3 n = bumped(texture(sampler2D(_NormalTex, _NormalTexSampler), uv).xy * 2.0 - 1.0);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
    vec3 f0 = mix(vec3(0.04), BaseColor.rgb, Metallic);
    float ndotv = clamp(dot(n, v), 0.0, 1.0);
    float alpha = max(Roughness * Roughness, 0.002);
    float k = (Roughness + 1.0) * (Roughness + 1.0) * 0.125;
    float viewPart = ndotv * (1.0 - k) + k;
    vec3 diffuse = BaseColor.rgb * (1.0 - Metallic);
    vec3 direct = vec3(0.0);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 l, radiance;
        lightAt(i, l, radiance);
        float ndotl = clamp(dot(n, l), 0.0, 1.0);
        vec3 h = l + v;
        h *= inversesqrt(max(dot(h, h), 1e-7));
        float ndoth = clamp(dot(n, h), 0.0, 1.0);
        float ldoth = clamp(dot(l, h), 0.0, 1.0);
        float a = ndoth * alpha;
        float p = alpha / ((1.0 - ndoth) * (1.0 + ndoth) + a * a);  // GGX is p^2 / pi
        float visibility = 0.25 / max(viewPart * (ndotl * (1.0 - k) + k), 1e-5);
        vec3 fresnel = f0 + (1.0 - f0) * pow5(1.0 - ldoth);
        direct += ((1.0 - fresnel) * diffuse + fresnel * (p * p * visibility)) * ndotl * radiance;
    }
    outColor = vec4(direct, 1.0);
}
