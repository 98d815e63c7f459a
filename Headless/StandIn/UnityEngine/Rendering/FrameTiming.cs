namespace UnityEngine;

/// <summary>Timings of one frame in ms.</summary>
public struct FrameTiming
{
    public double cpuFrameTime;
    public double gpuFrameTime;
    public ulong cpuTimePresentCalled;
    public ulong cpuTimeFrameComplete;
    public float heightScale;
    public float widthScale;
    public uint syncInterval;
}
