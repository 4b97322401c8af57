// Phong per pixel.
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
    vec4 _Diffuse;
    vec4 _Specular;
    float _Gloss;
};

layout(location = 0) in vec3 vPositionWS;
layout(location = 1) in vec3 vNormalWS;
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

float lobe(float cosine, float exponent)
{
    float positive = cosine > 0.0 ? cosine : 1.0;
    return cosine > 0.0 ? pow(positive, exponent) : 0.0;
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
    vec3 view = viewDirection();
    vec3 direct = vec3(0.0);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 lightDir;
        vec3 radiance = light(i, lightDir);
        float ndotl = clamp(dot(normal, lightDir), 0.0, 1.0);
        float highlight = lobe(clamp(dot(reflect(-lightDir, normal), view), 0.0, 1.0), _Gloss);
        direct += radiance * (_Diffuse.rgb * ndotl + _Specular.rgb * (ndotl > 0.0 ? highlight : 0.0));
    }
    outColor = vec4(direct + _Diffuse.rgb * irradiance(normal), 1.0);
}
