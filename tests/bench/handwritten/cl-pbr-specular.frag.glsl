// CL/pbr-specular.
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
    vec4 _Albedo_ST;
    float _Roughness;
    float _ReflectIntensity;
    float _SHIntensity;
    float _AOIntensity;
};

layout(set = 1, binding = 1) uniform texture2D _Albedo;
layout(set = 1, binding = 5) uniform sampler sampler_Albedo;
layout(set = 1, binding = 2) uniform texture2D _SpecularGlossMap;
layout(set = 1, binding = 6) uniform sampler sampler_SpecularGlossMap;
layout(set = 1, binding = 3) uniform texture2D _Normal;
layout(set = 1, binding = 7) uniform sampler sampler_Normal;
layout(set = 1, binding = 4) uniform texture2D _Matcap;
layout(set = 1, binding = 8) uniform sampler sampler_Matcap;

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

// The sky's radiance as spherical harmonics with y up; the numbers hold those of the basis.
vec3 sky(vec3 n)
{
    vec3 sum = vec3(1.81877, 1.86597, 1.7507) * 0.2820948;
    sum += (vec3(0.155764, 0.164684, 0.186911) * n.z + vec3(0.329662, 0.533947, 0.816486) * n.y +
            vec3(-0.020924, -0.0446067, -0.076697) * n.x) * 0.48860252;
    sum += (vec3(0.0514308, 0.0588754, 0.0774349) * (n.x * n.z) + vec3(0.11579, 0.109153, 0.109399) * (n.z * n.y) +
            vec3(0.0867315, 0.0715153, 0.0523889) * (n.x * n.y)) * 1.0925485;
    sum += vec3(-0.335727, -0.298582, -0.181839) * (0.31539157 * (3.0 * n.y * n.y - 1.0));
    sum += vec3(-0.150664, -0.0802716, 0.0130783) * (0.54627424 * (n.x * n.x - n.z * n.z));
    return max(sum, 0.0);
}

void main()
{
    vec2 uv = vUv * _Albedo_ST.xy + _Albedo_ST.zw;
    vec4 albedo = texture(sampler2D(_Albedo, sampler_Albedo), uv);
    vec4 specularGloss = texture(sampler2D(_SpecularGlossMap, sampler_SpecularGlossMap), uv);
    vec3 normal = bumpedNormal(texture(sampler2D(_Normal, sampler_Normal), uv).xy * 2.0 - 1.0);
    vec3 view = viewDirection();
    vec3 f0 = specularGloss.rgb;
    float oneMinusReflectivity = 1.0 - max(max(f0.r, f0.g), f0.b);
    float roughness = clamp((1.0 - specularGloss.a) * _Roughness, 0.0, 1.0);
    vec3 diffuseColor = albedo.rgb * oneMinusReflectivity;
    float ndotv = min(abs(dot(normal, view)), 1.0), viewWeight = pow5(1.0 - ndotv);
    float alpha = max(roughness * roughness, 0.002);
    float a2 = alpha * alpha;
    float viewPart = ndotv * (1.0 - alpha) + alpha;
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
        float bend = 2.0 * roughness * ldoth * ldoth - 0.5;
        float diffuse = (1.0 + bend * pow5(1.0 - ndotl)) * (1.0 + bend * viewWeight) * ndotl;
        float visibility = 0.5 / (ndotl * viewPart + ndotv * (ndotl * (1.0 - alpha) + alpha) + 1e-4);
        float spread = (ndoth * a2 - ndoth) * ndoth + 1.0;
        float specular = visibility * (a2 / (spread * spread + 1e-7)) * ndotl;
        color += radiance * (diffuseColor * diffuse + specular * (f0 + (1.0 - f0) * pow5(1.0 - ldoth)));
    }
    float occlusion = mix(1.0, albedo.a, _AOIntensity);
    float grazing = clamp(2.0 - roughness - oneMinusReflectivity, 0.0, 1.0);
    vec3 reflectance = mix(f0, vec3(grazing), viewWeight) / (a2 + 1.0);
    vec2 normalVS = normalize(mat3(worldToView) * vNormalWS).xy;
    vec3 ball = texture(sampler2D(_Matcap, sampler_Matcap), normalVS * vec2(0.5, -0.5) + 0.5).rgb;
    vec3 indirect = diffuseColor * sky(normal) * _SHIntensity + ball * reflectance * _ReflectIntensity;
    outColor = vec4(color + indirect * occlusion, 1.0);
}
