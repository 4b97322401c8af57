[node("Test/Open")]
[foreign]
float Open(float x) {
    // }
    if (x > 1) { return "}"; /* } */
}
