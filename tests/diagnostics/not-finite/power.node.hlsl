[node("Test/F")]
float F(float a = 1) {
    float steep = a * log2(0.0);
    return steep + pow(-2.0, 0.5);
}
