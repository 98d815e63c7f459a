using System;

namespace UnityEngine;

public struct Mathf
{
    public const float PI = MathF.PI;
    public const float Infinity = float.PositiveInfinity;
    public const float NegativeInfinity = float.NegativeInfinity;
    public const float Deg2Rad = PI / 180;
    public const float Rad2Deg = 57.29578f;
    public static readonly float Epsilon = float.Epsilon;

    public static float Sin(float f) => MathF.Sin(f);
    public static float Cos(float f) => MathF.Cos(f);
    public static float Tan(float f) => MathF.Tan(f);
    public static float Asin(float f) => MathF.Asin(f);
    public static float Acos(float f) => MathF.Acos(f);
    public static float Atan(float f) => MathF.Atan(f);
    public static float Atan2(float y, float x) => MathF.Atan2(y, x);
    public static float Sqrt(float f) => MathF.Sqrt(f);
    public static float Pow(float f, float p) => MathF.Pow(f, p);
    public static float Exp(float power) => MathF.Exp(power);
    public static float Log(float f) => MathF.Log(f);
    public static float Log10(float f) => MathF.Log10(f);
    public static float Abs(float f) => MathF.Abs(f);
    public static int Abs(int value) => Math.Abs(value);
    public static float Ceil(float f) => MathF.Ceiling(f);
    public static float Floor(float f) => MathF.Floor(f);
    public static float Round(float f) => MathF.Round(f);
    public static int CeilToInt(float f) => (int)MathF.Ceiling(f);
    public static int FloorToInt(float f) => (int)MathF.Floor(f);
    public static int RoundToInt(float f) => (int)MathF.Round(f);
    public static float Sign(float f) => f >= 0 ? 1 : -1;
    public static float Min(float a, float b) => a < b ? a : b;
    public static int Min(int a, int b) => a < b ? a : b;
    public static float Max(float a, float b) => a > b ? a : b;
    public static int Max(int a, int b) => a > b ? a : b;
    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
    public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;
    public static float Clamp01(float value) => Clamp(value, 0, 1);
    public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
    public static float LerpUnclamped(float a, float b, float t) => a + (b - a) * t;
    public static float InverseLerp(float a, float b, float value) => a == b ? 0 : Clamp01((value - a) / (b - a));
    public static float Repeat(float t, float length) => Clamp(t - Floor(t / length) * length, 0, length);
    public static float PingPong(float t, float length) => length - Abs(Repeat(t, length * 2) - length);

    public static float MoveTowards(float current, float target, float maxDelta) =>
        Abs(target - current) <= maxDelta ? target : current + Sign(target - current) * maxDelta;

    public static float DeltaAngle(float current, float target)
    {
        var turn = Repeat(target - current, 360);
        return turn > 180 ? turn - 360 : turn;
    }

    public static float LerpAngle(float a, float b, float t) => a + DeltaAngle(a, b) * Clamp01(t);

    public static float MoveTowardsAngle(float current, float target, float maxDelta)
    {
        var turn = DeltaAngle(current, target);
        return Abs(turn) <= maxDelta ? target : MoveTowards(current, current + turn, maxDelta);
    }

    public static float SmoothStep(float from, float to, float t)
    {
        t = Clamp01(t);
        return Lerp(from, to, t * t * (3 - 2 * t));
    }

    public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

    public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
    {
        var velocity = new Vector3(currentVelocity, 0);
        var damped = Vector3.SmoothDamp(new Vector3(current, 0), new Vector3(target, 0), ref velocity, smoothTime, maxSpeed, deltaTime);
        currentVelocity = velocity.x;
        return damped.x;
    }

    public static bool Approximately(float a, float b) => Abs(b - a) < Max(1E-06f * Max(Abs(a), Abs(b)), Epsilon * 8);
}
