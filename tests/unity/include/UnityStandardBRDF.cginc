// A stand-in for Unity's include of this name, written for these tests: names that a shader must not declare again.
half PerceptualRoughnessToRoughness(half perceptualRoughness) { return 0; }
half RoughnessToPerceptualRoughness(half roughness) { return 0; }
half SmoothnessToRoughness(half smoothness) { return 0; }
half SmoothnessToPerceptualRoughness(half smoothness) { return 0; }
half Pow4(half x) { return 0; }
half Pow5(half x) { return 0; }
half3 FresnelTerm(half3 F0, half cosA) { return 0; }
half3 FresnelLerp(half3 F0, half3 F90, half cosA) { return 0; }
half3 FresnelLerpFast(half3 F0, half3 F90, half cosA) { return 0; }
half DisneyDiffuse(half NdotV, half NdotL, half LdotH, half perceptualRoughness) { return 0; }
half SmithJointGGXVisibilityTerm(half NdotL, half NdotV, half roughness) { return 0; }
half GGXTerm(half NdotH, half roughness) { return 0; }
half PerceptualRoughnessToSpecPower(half perceptualRoughness) { return 0; }
// Burley's diffuse term, GGX with the approximate joint visibility, Schlick's Fresnel; reflections with a grazing term.
half4 BRDF1_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness, half3 normal,
                      half3 viewDir, UnityLight light, UnityIndirect gi)
{
    float r = 1 - smoothness, alpha = max(r * r, 0.002), a2 = alpha * alpha;
    float3 middle = normalize(light.dir + viewDir);
    float nv = abs(dot(normal, viewDir)), nl = saturate(dot(normal, light.dir));
    float nh = saturate(dot(normal, middle)), lh = saturate(dot(light.dir, middle));
    float grazing = 0.5 + 2 * lh * lh * r;
    float diffuse = (1 + (grazing - 1) * pow(1 - nl, 5)) * (1 + (grazing - 1) * pow(1 - nv, 5)) * nl;
    float visibility = 0.5 / (nl * (nv * (1 - alpha) + alpha) + nv * (nl * (1 - alpha) + alpha) + 1e-5);
    float d = (nh * a2 - nh) * nh + 1;
    float specular = visibility * a2 / (d * d + 1e-7) * nl;
    specular *= any(specColor) ? 1 : 0;
    float3 color = diffColor * (gi.diffuse + light.color * diffuse);
    color += specular * light.color * (specColor + (1 - specColor) * pow(1 - lh, 5));
    float f90 = saturate(smoothness + 1 - oneMinusReflectivity);
    color += gi.specular / (a2 + 1) * lerp(specColor, f90, pow(1 - nv, 5));
    return half4(color, 1);
}
#define UNITY_BRDF_PBS BRDF1_Unity_PBS
