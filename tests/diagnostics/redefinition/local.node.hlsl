[node("Test/F")]
float F(float a = 1) {
    float a = 2;
    return a;
}
