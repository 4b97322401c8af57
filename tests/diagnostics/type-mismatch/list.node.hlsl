[node("Test/F")]
float F(float a = 1) {
    const float k[3] = { 1, 2 };
    return a * k[0];
}
