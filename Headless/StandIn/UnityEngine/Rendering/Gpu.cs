using UnityEngine.XR;

namespace UnityEngine.Rendering;

/// <summary>Simulated GPU and headset display. Tests configure which times they report, and the delay of readbacks.</summary>
sealed class Gpu
{
    readonly List<Readback> _readbacks = new();
    readonly Stack<Readback> _done = new();

    /// <summary>The headset's display; null if no display is running.</summary>
    internal XRDisplaySubsystem Display { get; private set; }

    /// <summary>GPU time of the last frame in s, as reported by the headset's display; null if it is not reported.</summary>
    internal float? DisplayGpuTime { get; set; }

    /// <summary>Refresh rate in Hz, as reported by the headset's display; null if it is not reported.</summary>
    internal float? DisplayHz { get; set; }

    internal GraphicsDeviceType Api { get; set; } = GraphicsDeviceType.Direct3D11;

    internal RenderingThreadingMode Threading { get; set; } = RenderingThreadingMode.MultiThreaded;

    /// <summary>Render pipeline asset; null for the built-in pipeline.</summary>
    internal RenderPipelineAsset RenderPipeline { get; set; }

    /// <summary>Timings of the last frames, newest first; empty if they are not measured.</summary>
    internal List<FrameTiming> FrameTimings { get; } = new();

    /// <summary>
    /// Number of frames after which a readback completes, at the start of a frame; at least 1. A negative value means that readbacks are not
    /// supported.
    /// </summary>
    internal int ReadbackFrames { get; set; } = -1;

    /// <summary>Whether readbacks complete with an error.</summary>
    internal bool ReadbacksFail { get; set; }

    internal int PendingReadbacks => _readbacks.Count;

    internal void ConnectDisplay()
    {
        Display ??= new XRDisplaySubsystem();
        Display.Start();
    }

    internal AsyncGPUReadbackRequest Request(System.Action<AsyncGPUReadbackRequest> callback)
    {
        var readback = _done.Count > 0 ? _done.Pop() : new Readback();
        readback.Begin(callback, ReadbackFrames, failed: ReadbackFrames < 0 || ReadbacksFail);
        _readbacks.Add(readback);
        return new AsyncGPUReadbackRequest(readback);
    }

    /// <summary>Starts a frame.</summary>
    internal void Advance()
    {
        var count = _readbacks.Count;
        for (var i = 0; i < count; i++) _readbacks[i].Advance();
        for (var i = _readbacks.Count - 1; i >= 0; i--)
        {
            if (!_readbacks[i].Done) continue;

            _done.Push(_readbacks[i]);
            _readbacks.RemoveAt(i);
        }
    }
}
