// BRDF1's direct light; a sky and a lit ball that the material brings along.
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
    vec4 _Albedo_ST;
    float _Roughness;
    float _ReflectIntensity;
    float _SHIntensity;
    float _AOIntensity;
};

layout(set = 1, binding = 1) uniform texture2D _Albedo;
layout(set = 1, binding = 5) uniform sampler _AlbedoSampler;
layout(set = 1, binding = 2) uniform texture2D _SpecularGlossMap;
layout(set = 1, binding = 6) uniform sampler _SpecularGlossMapSampler;
layout(set = 1, binding = 3) uniform texture2D _Normal;
layout(set = 1, binding = 7) uniform sampler _NormalSampler;
layout(set = 1, binding = 4) uniform texture2D _Matcap;
layout(set = 1, binding = 8) uniform sampler _MatcapSampler;

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

// The sky that the shader carries: nine coefficients, each times the constant of its polynomial. y is up.
vec3 sky(vec3 n)
{
    vec3 e = vec3(0.5130655, 0.5263804, 0.4938634);
    e += vec3(0.07610668, 0.08046502, 0.09132518) * n.z;
    e += vec3(0.1610737, 0.2608878, 0.3989371) * n.y;
    e += vec3(-0.01022352, -0.02179495, -0.03747435) * n.x;
    e += vec3(0.05619064, 0.06432423, 0.08460138) * (n.x * n.z);
    e += vec3(0.1265062, 0.1192549, 0.1195237) * (n.z * n.y);
    e += vec3(-0.1058855, -0.09417024, -0.05735049) * (3.0 * n.y * n.y - 1.0);
    e += vec3(0.09475836, 0.07813393, 0.05723741) * (n.x * n.y);
    e += vec3(-0.08230386, -0.04385031, 0.007144338) * (n.x * n.x - n.z * n.z);
    return max(e, 0.0);
}

void main()
{
    vec2 at = uv * _Albedo_ST.xy + _Albedo_ST.zw;
    vec4 albedo = texture(sampler2D(_Albedo, _AlbedoSampler), at);
    vec4 specularGloss = texture(sampler2D(_SpecularGlossMap, _SpecularGlossMapSampler), at);
    vec3 f0 = specularGloss.rgb;
    float roughness = clamp((1.0 - specularGloss.a) * _Roughness, 0.0, 1.0);
    float oneMinusReflectivity = 1.0 - max(max(f0.r, f0.g), f0.b);
    vec3 diffuse = albedo.rgb * oneMinusReflectivity;
    vec3 n = bumped(texture(sampler2D(_Normal, _NormalSampler), at).xy * 2.0 - 1.0);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
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
        float visibility = 0.5 / (ndotl * viewPart + ndotv * (ndotl * (1.0 - alpha) + alpha) + 0.0001);
        vec3 fresnel = f0 + (1.0 - f0) * pow5(1.0 - ldoth);
        float specular = a2 / (spread * spread + 1e-7) * visibility * ndotl;
        direct += (diffuse * (scattered * ndotl) + fresnel * specular) * radiance;
    }
    // The ball is read by the normal of the mesh.
    vec3 inView = (worldToView * vec4(normalize(normal), 0.0)).xyz;
    vec2 ballAt = normalize(inView).xy * vec2(0.5, -0.5) + 0.5;
    vec3 ball = texture(sampler2D(_Matcap, _MatcapSampler), ballAt).rgb;
    float grazing = clamp(2.0 - roughness - oneMinusReflectivity, 0.0, 1.0);
    vec3 reflected = ball * mix(f0, vec3(grazing), viewWeight) * (_ReflectIntensity / (a2 + 1.0));
    vec3 indirect = (diffuse * sky(n) * _SHIntensity + reflected) * mix(1.0, albedo.a, _AOIntensity);
    outColor = vec4(direct + indirect, 1.0);
}
