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
half4 BRDF1_Unity_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness, half3 normal,
                      half3 viewDir, UnityLight light, UnityIndirect gi)
{
    return 0;
}
