// The Standard shader.
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
    vec4 _Color;
    vec4 _MainTex_ST;
    float _Glossiness;
    float _GlossMapScale;
    float _Metallic;
    float _BumpScale;
    float _Parallax;
    float _OcclusionStrength;
    vec4 _EmissionColor;
    vec4 _DetailAlbedoMap_ST;
    float _DetailNormalMapScale;
    int _UVSec;
};

layout(set = 0, binding = 6) uniform textureCube environmentMap;
layout(set = 0, binding = 12) uniform sampler environmentMapSampler;
layout(set = 1, binding = 1) uniform texture2D _MainTex;
layout(set = 1, binding = 10) uniform sampler sampler_MainTex;
layout(set = 1, binding = 5) uniform texture2D _OcclusionMap;
layout(set = 1, binding = 14) uniform sampler sampler_OcclusionMap;

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

vec3 viewDirection()
{
    return normalize(mix(cameraPositionWS - vPositionWS, -cameraForwardWS, viewIsOrthographic));
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

float srgbToLinear(float x)
{
    return x <= 0.04045 ? max(x, 0.0) / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

void main()
{
    vec2 uv = vUv * _MainTex_ST.xy + _MainTex_ST.zw;
    vec4 main = texture(sampler2D(_MainTex, sampler_MainTex), uv);
    float occlusion = mix(1.0, texture(sampler2D(_OcclusionMap, sampler_OcclusionMap), uv).g, _OcclusionStrength);
    vec3 baseColor = main.rgb * _Color.rgb;
    vec3 normal = normalize(vNormalWS);
    vec3 view = viewDirection();
    float roughness = 1.0 - _Glossiness, metallic = srgbToLinear(_Metallic);
    float oneMinusReflectivity = 0.96 * (1.0 - metallic);
    vec3 diffuseColor = baseColor * oneMinusReflectivity;
    vec3 f0 = mix(vec3(0.04), baseColor, metallic);
    float ndotv = min(abs(dot(normal, view)), 1.0), viewWeight = pow5(1.0 - ndotv);
    float alpha = max(roughness * roughness, 0.002);
    float a2 = alpha * alpha;
    float viewPart = ndotv * (1.0 - alpha) + alpha;
    float hasSpecular = any(greaterThan(f0, vec3(0.0))) ? 1.0 : 0.0;
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
        float visibility = 0.5 / (ndotl * viewPart + ndotv * (ndotl * (1.0 - alpha) + alpha) + 1e-5);
        float spread = (ndoth * a2 - ndoth) * ndoth + 1.0;
        float specular = max(visibility * (a2 / (spread * spread + 1e-7)) * ndotl, 0.0) * hasSpecular;
        color += radiance * (diffuseColor * diffuse + specular * (f0 + (1.0 - f0) * pow5(1.0 - ldoth)));
    }
    float rough = clamp(roughness, 0.0, 1.0), level = rough * (1.7 - 0.7 * rough) * 5.0;
    vec3 environment = textureLod(samplerCube(environmentMap, environmentMapSampler), reflect(-view, normal), level).rgb;
    float grazing = clamp(2.0 - roughness - oneMinusReflectivity, 0.0, 1.0);
    vec3 reflectance = mix(f0, vec3(grazing), viewWeight) / (a2 + 1.0);
    color += (diffuseColor * irradiance(normal) + reflectance * environment) * occlusion;
    outColor = vec4(color, 1.0);
}
