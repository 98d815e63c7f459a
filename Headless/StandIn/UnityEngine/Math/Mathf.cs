namespace UnityEngine;

public struct Mathf
{
    public const float PI = MathF.PI;
    public const float Deg2Rad = PI / 180;
    public const float Rad2Deg = 57.29578f;
    public static readonly float Epsilon = float.Epsilon;

    public static float Sin(float f) => MathF.Sin(f);
    public static float Cos(float f) => MathF.Cos(f);
    public static float Tan(float f) => MathF.Tan(f);
    public static float Atan2(float y, float x) => MathF.Atan2(y, x);
    public static float Sqrt(float f) => MathF.Sqrt(f);
    public static float Exp(float power) => MathF.Exp(power);
    public static float Abs(float f) => MathF.Abs(f);
    public static float Round(float f) => MathF.Round(f);
    public static float Sign(float f) => f >= 0 ? 1 : -1;
    public static float Min(float a, float b) => a < b ? a : b;
    public static int Min(int a, int b) => a < b ? a : b;
    public static float Max(float a, float b) => a > b ? a : b;
    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
    public static float Clamp01(float value) => Clamp(value, 0, 1);
    public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
    public static float Repeat(float t, float length) => Clamp(t - MathF.Floor(t / length) * length, 0, length);

    public static float DeltaAngle(float current, float target)
    {
        var turn = Repeat(target - current, 360);
        return turn > 180 ? turn - 360 : turn;
    }

    public static float LerpAngle(float a, float b, float t) => a + DeltaAngle(a, b) * Clamp01(t);
}
