float Row(float a) {
    float sum = 0;
    for (int i = 0; i < 4096; i++) { sum += a; }
    return sum;
}

[node("Test/F")]
float F(float a = 1) {
    float sum = 0;
    for (int i = 0; i < 64; i++) {
        for (int k = 0; k < 64; k++) { sum += Row(sum); }
    }
    return sum;
}
