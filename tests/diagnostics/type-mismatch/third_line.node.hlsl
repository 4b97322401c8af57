[node("Test/F")]
float F(float2 uv = uv0) {
    float3 wide = uv;
    return wide.x;
}
