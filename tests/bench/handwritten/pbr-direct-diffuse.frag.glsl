// PBR 2: and direct diffuse light.
#version 450

layout(set = 0, binding = 1) uniform Camera
{
    mat4 worldToClip, worldToView;
    vec3 cameraPositionWS;
    float viewIsOrthographic;
    vec3 cameraForwardWS;
};

layout(set = 0, binding = 2) uniform Lights
{
    int lightCount;
    vec4 lightPosition[16], lightColor[16], lightAxis[16], lightCone[16];
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

// The light's radiance at this point, and the direction to it.
vec3 light(int index, out vec3 direction)
{
    vec4 place = lightPosition[index];
    vec4 color = lightColor[index];
    bool isLocal = place.w > 0.5;
    vec3 toLight = place.xyz - (isLocal ? vPositionWS : vec3(0.0));
    float distanceSquared = dot(toLight, toLight);
    direction = toLight * inversesqrt(max(distanceSquared, 1e-12));
    float attenuation = 1.0;
    if (isLocal) {
        float ratio = distanceSquared / (color.w * color.w);
        float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
        attenuation = window * window / max(distanceSquared, 1e-4);
        if (place.w > 1.5) {
            vec4 cone = lightCone[index];
            float cosine = -dot(lightAxis[index].xyz, direction);
            float spot = clamp((cosine - cone.y) / max(cone.x - cone.y, 0.001), 0.0, 1.0);
            attenuation *= spot * spot;
        }
    }
    return color.rgb * attenuation;
}

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

void main()
{
    vec3 normal = bumpedNormal(texture(sampler2D(_NormalTex, sampler_NormalTex), vUv).xy * 2.0 - 1.0);
    vec3 view = viewDirection();
    vec3 f0 = mix(vec3(0.04), BaseColor.rgb, Metallic);
    float ndotv = clamp(dot(normal, view), 0.0, 1.0);
    float alpha = max(Roughness * Roughness, 0.002);
    float k = (Roughness + 1.0) * (Roughness + 1.0) * 0.125;
    float viewPart = ndotv * (1.0 - k) + k;
    vec3 direct = vec3(0.0);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 lightDir;
        vec3 radiance = light(i, lightDir);
        vec3 halfVector = lightDir + view;
        halfVector *= inversesqrt(max(dot(halfVector, halfVector), 1e-7));
        float ndotl = clamp(dot(normal, lightDir), 0.0, 1.0);
        float ndoth = clamp(dot(normal, halfVector), 0.0, 1.0);
        float ldoth = clamp(dot(lightDir, halfVector), 0.0, 1.0);
        float ndothAlpha = ndoth * alpha;
        float p = alpha / ((1.0 - ndoth) * (1.0 + ndoth) + ndothAlpha * ndothAlpha);
        float visibility = 0.25 / max(viewPart * (ndotl * (1.0 - k) + k), 1e-5);
        vec3 fresnel = f0 + (1.0 - f0) * pow5(1.0 - ldoth);
        vec3 diffuse = BaseColor.rgb * ((1.0 - fresnel) * (1.0 - Metallic));
        direct += radiance * ndotl * (p * p * visibility * fresnel + diffuse);
    }
    outColor = vec4(direct, 1.0);
}
