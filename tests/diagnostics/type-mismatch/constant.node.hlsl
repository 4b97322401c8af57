[node("Test/F")]
float F(const float3 mode = 1) {
    return mode == 1 ? 0.0 : 1.0;
}
