[node("Test/F")]
float F(int count = 3, float2 uv = uv0) {
    float k[count];
    uv[count] = 1;
    return k[0] + uv.x;
}
