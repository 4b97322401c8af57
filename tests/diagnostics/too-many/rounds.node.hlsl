[node("Test/Loop")]
float Loop(int count = 3) {
    float sum = 0;
    for (int i = 0; i < 1000000000; i++) { sum += 1; }
    for (int i = -3000; i < min(count, 3000); i++) { sum += 1; }
    return sum;
}
