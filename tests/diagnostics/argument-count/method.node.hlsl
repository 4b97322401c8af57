[node("Test/F")]
float F(Texture2D texture) {
    return texture.SampleLevel(float2(0)).r;
}
