const float K = 1;
[node("Test/F")]
float F(float a = 1) {
    const float b = 2;
    b = 3;
    K = 2;
    (a + b) = 1;
    return a;
}
