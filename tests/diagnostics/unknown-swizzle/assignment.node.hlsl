[node("Test/Assign")]
float3 Assign(float3 v = 1) {
    v.xx = float2(1, 2);
    v.w = 1;
    return v;
}
