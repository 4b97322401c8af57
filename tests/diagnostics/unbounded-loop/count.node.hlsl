[node("Test/F")]
float F(int count = 3) {
    float sum = 0;
    for (int i = 0; i < count; i++) { sum += 1; }
    for (int i = count; i < 8; i++) { sum += 1; }
    return sum;
}
