namespace UnityEngine;

/// <summary>Timings of one frame in ms.</summary>
public struct FrameTiming
{
    public double gpuFrameTime;
}
