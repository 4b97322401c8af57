[foreign]
float textured(Texture2D map, floatN any) { return 1; }
[foreign]
void silent(float x) { }
[foreign]
float both(out float x) { x = 1; return x; }
[node("Test/F")]
float F(float x) { return x; }
