[node("Test/F")]
float F(Texture2D texture, float2 uv = uv0) {
    float a = 0;
    if (uv.x > 0.5) { a = texture.Sample(uv).r; }
    for (int i = 0; i < 4; i++) { a += ddx(uv.x * float(i)); }
    return a;
}
