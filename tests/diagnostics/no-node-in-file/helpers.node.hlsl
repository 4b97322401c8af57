float square(float a) {
    return a * a;
}
