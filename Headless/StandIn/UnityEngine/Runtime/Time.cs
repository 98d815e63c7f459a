namespace UnityEngine;

public class Time
{
    public static float time => (float)Clock.Scaled;
    public static double unscaledTimeAsDouble => Clock.Real;
    public static float unscaledDeltaTime => (float)Clock.RealDelta;
    public static float realtimeSinceStartup => (float)realtimeSinceStartupAsDouble;
    public static double realtimeSinceStartupAsDouble => Clock.Real;
    public static int frameCount => Clock.Frame;

    static Clock Clock => World.Current.Clock;
}
