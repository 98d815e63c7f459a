namespace UnityEngine;

public static class FrameTimingManager
{
    public static void CaptureFrameTimings() { }

    public static uint GetLatestTimings(uint numFrames, FrameTiming[] timings)
    {
        var known = World.Current.Gpu.FrameTimings;
        var count = Math.Min(Math.Min((int)numFrames, timings.Length), known.Count);
        for (var i = 0; i < count; i++) timings[i] = known[i];
        return (uint)count;
    }
}

/// <summary>Timings of one frame in ms.</summary>
public struct FrameTiming
{
    public double gpuFrameTime;
}
