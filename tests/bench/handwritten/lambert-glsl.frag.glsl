// Lambert over a texture.
#version 450

layout(set = 0, binding = 2) uniform Lights
{
    int lightCount;
    vec4 lightPosition[16], lightColor[16], lightAxis[16], lightCone[16];
};

layout(set = 0, binding = 5) uniform Ambient
{
    vec4 ambientSH[9];
};

layout(set = 1, binding = 0) uniform texture2D u_texDiffuse;
layout(set = 1, binding = 1) uniform sampler sampleru_texDiffuse;

layout(location = 0) in vec2 vUv;
layout(location = 1) in vec3 vPositionWS;
layout(location = 2) in vec3 vNormalWS;
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
    vec3 normal = normalize(vNormalWS);
    vec3 sum = irradiance(normal);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 lightDir;
        vec3 radiance = light(i, lightDir);
        sum += radiance * clamp(dot(normal, lightDir), 0.0, 1.0);
    }
    outColor = vec4(texture(sampler2D(u_texDiffuse, sampleru_texDiffuse), vUv).rgb * sum, 1.0);
}
