// A glTF material with five textures.
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

layout(set = 0, binding = 5) uniform Ambient
{
    vec4 ambientSH[9];
};

layout(set = 1, binding = 0) uniform Material
{
    vec4 baseColorFactor;
    float metallicFactor, roughnessFactor;
    vec4 emissiveFactor;
};

layout(set = 0, binding = 6) uniform textureCube environmentMap;
layout(set = 0, binding = 12) uniform sampler environmentMapSampler;
layout(set = 0, binding = 7) uniform texture2D splitSumTable;
layout(set = 0, binding = 13) uniform sampler splitSumTableSampler;
layout(set = 1, binding = 1) uniform texture2D baseColorTexture;
layout(set = 1, binding = 6) uniform sampler samplerbaseColorTexture;
layout(set = 1, binding = 2) uniform texture2D metallicRoughnessTexture;
layout(set = 1, binding = 7) uniform sampler samplermetallicRoughnessTexture;
layout(set = 1, binding = 3) uniform texture2D normalTexture;
layout(set = 1, binding = 8) uniform sampler samplernormalTexture;
layout(set = 1, binding = 4) uniform texture2D occlusionTexture;
layout(set = 1, binding = 9) uniform sampler samplerocclusionTexture;
layout(set = 1, binding = 5) uniform texture2D emissiveTexture;
layout(set = 1, binding = 10) uniform sampler sampleremissiveTexture;

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
    vec3 baseColor = texture(sampler2D(baseColorTexture, samplerbaseColorTexture), vUv).rgb * baseColorFactor.rgb;
    vec2 metallicRoughness = texture(sampler2D(metallicRoughnessTexture, samplermetallicRoughnessTexture), vUv).bg * vec2(metallicFactor, roughnessFactor);
    float metallic = metallicRoughness.x;
    float roughness = metallicRoughness.y;
    float occlusion = texture(sampler2D(occlusionTexture, samplerocclusionTexture), vUv).r;
    vec3 emission = texture(sampler2D(emissiveTexture, sampleremissiveTexture), vUv).rgb * emissiveFactor.rgb;
    vec3 normal = bumpedNormal(texture(sampler2D(normalTexture, samplernormalTexture), vUv).xy * 2.0 - 1.0);
    vec3 view = viewDirection();
    vec3 f0 = mix(vec3(0.04), baseColor, metallic);
    vec3 diffuseColor = baseColor * (1.0 - metallic);
    float ndotv = min(abs(dot(normal, view)), 1.0);
    float alpha = max(roughness * roughness, 0.002);
    float a2 = alpha * alpha;
    float viewRoot = sqrt(ndotv * ndotv * (1.0 - a2) + a2);
    vec3 color = vec3(0.0);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 lightDir;
        vec3 radiance = light(i, lightDir);
        vec3 halfVector = lightDir + view;
        halfVector *= inversesqrt(max(dot(halfVector, halfVector), 0.001));
        float ndotl = clamp(dot(normal, lightDir), 0.0, 1.0);
        float ndoth = clamp(dot(normal, halfVector), 0.0, 1.0);
        float ldoth = clamp(dot(lightDir, halfVector), 0.0, 1.0);
        float ndothAlpha = ndoth * alpha;
        float p = alpha / ((1.0 - ndoth) * (1.0 + ndoth) + ndothAlpha * ndothAlpha);
        float visibility = 0.5 / max(ndotl * viewRoot + ndotv * sqrt(ndotl * ndotl * (1.0 - a2) + a2), 1e-5);
        vec3 fresnel = f0 + (1.0 - f0) * pow5(1.0 - ldoth);
        color += radiance * ndotl * ((1.0 - fresnel) * diffuseColor + fresnel * (p * p * visibility));
    }
    float rough = clamp(roughness, 0.0, 1.0);
    float level = rough * (1.7 - 0.7 * rough) * 5.0;
    vec3 environment = textureLod(samplerCube(environmentMap, environmentMapSampler), reflect(-view, normal), level).rgb;
    vec2 place = vec2(sqrt(ndotv), rough) * 0.984375 + 0.0078125;
    vec2 share = textureLod(sampler2D(splitSumTable, splitSumTableSampler), place, 0.0).xy;
    vec3 reflectance = f0 * share.x + share.y;
    color += ((1.0 - reflectance) * diffuseColor * irradiance(normal) + reflectance * environment) * occlusion;
    outColor = vec4(color + emission, 1.0);
}
