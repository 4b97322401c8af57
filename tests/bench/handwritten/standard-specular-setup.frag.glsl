// Unity's Standard shader, specular set-up.
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
    vec4 _Color;
    vec4 _MainTex_ST;
    float _Glossiness;
    float _GlossMapScale;
    int _SmoothnessTextureChannel;
    vec4 _SpecColor;
    float _BumpScale;
    float _Parallax;
    float _OcclusionStrength;
    vec4 _EmissionColor;
};

layout(set = 0, binding = 7) uniform textureCube environmentMap;
layout(set = 0, binding = 14) uniform sampler environmentMapSampler;
layout(set = 1, binding = 1) uniform texture2D _MainTex;
layout(set = 1, binding = 7) uniform sampler _MainTexSampler;
layout(set = 1, binding = 2) uniform texture2D _SpecGlossMap;
layout(set = 1, binding = 8) uniform sampler _SpecGlossMapSampler;
layout(set = 1, binding = 3) uniform texture2D _BumpMap;
layout(set = 1, binding = 9) uniform sampler _BumpMapSampler;
layout(set = 1, binding = 5) uniform texture2D _OcclusionMap;
layout(set = 1, binding = 11) uniform sampler _OcclusionMapSampler;
layout(set = 1, binding = 6) uniform texture2D _EmissionMap;
layout(set = 1, binding = 12) uniform sampler _EmissionMapSampler;

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

vec3 environment(vec3 direction, float roughness)
{
    float level = roughness * (1.7 - 0.7 * roughness) * 5.0;
    return textureLod(samplerCube(environmentMap, environmentMapSampler), direction, level).rgb;
}

void main()
{
    vec2 at = uv * _MainTex_ST.xy + _MainTex_ST.zw;
    vec4 main_ = texture(sampler2D(_MainTex, _MainTexSampler), at);
    vec3 albedo = main_.rgb * _Color.rgb;
    float smoothness = _SmoothnessTextureChannel == 1 ? main_.a * _GlossMapScale : _Glossiness;
    float roughness = 1.0 - smoothness;
    vec3 n = bumped((texture(sampler2D(_BumpMap, _BumpMapSampler), at).xy * 2.0 - 1.0) * _BumpScale);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
    vec3 f0 = _SpecColor.rgb;
    float oneMinusReflectivity = 1.0 - max(max(f0.r, f0.g), f0.b);
    vec3 diffuse = albedo * oneMinusReflectivity;
    float hasSpecular = any(greaterThan(f0, vec3(0.0))) ? 1.0 : 0.0;
    float ndotv = min(abs(dot(n, v)), 1.0);
    float alpha = max(roughness * roughness, 0.002);
    float a2 = alpha * alpha;
    float viewPart = ndotv * (1.0 - alpha) + alpha;
    float viewWeight = pow5(1.0 - ndotv);
    vec3 direct = vec3(0.0);
    int count = min(lightCount, 16);
    for (int i = 0; i < count; ++i) {
        vec3 l, radiance;
        lightAt(i, l, radiance);
        float ndotl = clamp(dot(n, l), 0.0, 1.0);
        vec3 h = l + v;
        h *= inversesqrt(max(dot(h, h), 0.001));
        float ndoth = clamp(dot(n, h), 0.0, 1.0);
        float ldoth = clamp(dot(l, h), 0.0, 1.0);
        // Disney's diffuse term.
        float f90 = 2.0 * roughness * ldoth * ldoth - 0.5;  // less 1
        float scattered = (1.0 + f90 * pow5(1.0 - ndotl)) * (1.0 + f90 * viewWeight);
        // pi times GGX, and Smith's visibility; pi and 1 / pi cancel.
        float spread = (ndoth * a2 - ndoth) * ndoth + 1.0;
        float visibility = 0.5 / (ndotl * viewPart + ndotv * (ndotl * (1.0 - alpha) + alpha) + 1e-5);
        vec3 fresnel = f0 + (1.0 - f0) * pow5(1.0 - ldoth);
        float specular = max(a2 / (spread * spread + 1e-7) * visibility * ndotl, 0.0) * hasSpecular;
        direct += (diffuse * (scattered * ndotl) + fresnel * specular) * radiance;
    }
    float occlusionTexel = texture(sampler2D(_OcclusionMap, _OcclusionMapSampler), at).g;
    vec3 emission = texture(sampler2D(_EmissionMap, _EmissionMapSampler), at).rgb * _EmissionColor.rgb;
    vec3 reflected = environment(reflect(-v, n), clamp(roughness, 0.0, 1.0)) / (a2 + 1.0);
    float grazing = clamp(smoothness + 1.0 - oneMinusReflectivity, 0.0, 1.0);
    vec3 indirect = diffuse * irradiance(n) + mix(f0, vec3(grazing), viewWeight) * reflected;
    outColor = vec4(direct + indirect * mix(1.0, occlusionTexel, _OcclusionStrength) + emission, 1.0);
}
