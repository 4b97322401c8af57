// A stand-in for Unity's include of this name, written for these tests. The test says what the runtime has of it.
#ifdef STAND_IN_REGISTERS
#define _LightColor0 float4(handed_over(light_color[0].rgb), 1)
#else
fixed4 _LightColor0;
fixed4 _SpecColor;
#endif
