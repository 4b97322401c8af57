float g() { return 1; }
float g() { return 2; }
[node("Test/F")]
float F(float a = 1) {
    return g();
}
