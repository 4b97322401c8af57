// Unity's BRDF1, with two numbers instead of the surroundings.
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
    vec4 _Color;
    vec4 _MainTex_ST;
    float _Glossiness;
    float _Metallic;
    float _IndirectDiffuseValue;
    float _IndirectSpecularValue;
};

layout(set = 1, binding = 1) uniform texture2D _MainTex;
layout(set = 1, binding = 2) uniform sampler _MainTexSampler;

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

float pow5(float x)
{
    float x2 = x * x;
    return x2 * x2 * x;
}

void main()
{
    vec3 n = normalize(normal);
    vec3 v = normalize(mix(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
    vec3 albedo = texture(sampler2D(_MainTex, _MainTexSampler), uv * _MainTex_ST.xy + _MainTex_ST.zw).rgb * _Color.rgb;
    float oneMinusReflectivity = 0.96 * (1.0 - _Metallic);
    vec3 diffuse = albedo * oneMinusReflectivity;
    vec3 f0 = mix(vec3(0.04), albedo, _Metallic);
    float hasSpecular = any(greaterThan(f0, vec3(0.0))) ? 1.0 : 0.0;
    float roughness = 1.0 - _Glossiness;
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
    float grazing = clamp(_Glossiness + 1.0 - oneMinusReflectivity, 0.0, 1.0);
    vec3 reflected = mix(f0, vec3(grazing), viewWeight) * (_IndirectSpecularValue / (a2 + 1.0));
    outColor = vec4(direct + diffuse * _IndirectDiffuseValue + reflected, 1.0);
}
