[node("Test/F")]
float F(float a = 1) {
    float b = a * 2
    return b;
}
float g(float x { return x; }
