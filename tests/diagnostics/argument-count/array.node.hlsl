[node("Test/F")]
float F(Texture2D texture) {
    const float k[3] = { 1, 2 };
    return k[0] + texture.SampleLevel(float2(0)).r;
}
