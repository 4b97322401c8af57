// A stand-in for Unity's include of this name, written for these tests: what a shader of this project uses of it, and
// names that it must not declare again.
half SpecularStrength(half3 specular) { return 0; }
half3 EnergyConservationBetweenDiffuseAndSpecular(half3 albedo, half3 specColor, out half oneMinusReflectivity)
{
    oneMinusReflectivity = 0;
    return 0;
}
half OneMinusReflectivityFromMetallic(half metallic) { return 0; }
half3 DiffuseAndSpecularFromMetallic(half3 albedo, half metallic, out half3 specColor, out half oneMinusReflectivity)
{
    specColor = 0;
    oneMinusReflectivity = 0;
    return 0;
}
half2 ParallaxOffset1Step(half h, half height, half3 viewDir) { return 0; }
half LerpOneTo(half b, half t) { return 0; }
half3 LerpWhiteTo(half3 b, half t) { return 0; }
half3 BlendNormals(half3 n1, half3 n2) { return 0; }
half3 ShadeSHPerVertex(half3 normal, half3 ambient)
{
    return ambient;
}

// The slope times the scale; z belongs to the unit vector.
half3 UnpackScaleNormal(half4 packednormal, half bumpScale)
{
    half3 normal = half3((packednormal.xy * 2 - 1) * bumpScale, 0);
    normal.z = sqrt(1 - saturate(dot(normal.xy, normal.xy)));
    return normal;
}
