using System.Collections.Generic;
using UnityEngine.XR;

namespace UnityEngine.Rendering;

/// <summary>The graphics processor as configured by tests: which of its times are available, and how late it answers.</summary>
sealed class Gpu
{
    readonly List<Readback> _readbacks = new();
    readonly Stack<Readback> _done = new();

    /// <summary>Null if no headset display is running.</summary>
    internal XRDisplaySubsystem Display { get; private set; }

    /// <summary>GPU time of the last frame reported by the headset's display, s; null if unknown.</summary>
    internal float? DisplayGpuTime { get; set; }

    /// <summary>Refresh rate reported by the headset's display, Hz; null if unknown.</summary>
    internal float? DisplayHz { get; set; }

    internal GraphicsDeviceType Api { get; set; } = GraphicsDeviceType.Direct3D11;

    internal RenderingThreadingMode Threading { get; set; } = RenderingThreadingMode.MultiThreaded;

    /// <summary>Null for the built-in pipeline.</summary>
    internal RenderPipelineAsset RenderPipeline { get; set; }

    /// <summary>Times of the last frames in ms, newest first; empty if nothing is measured.</summary>
    internal List<FrameTiming> FrameTimings { get; } = new();

    /// <summary>Number of frames until a readback is done, at the start of that frame; at least 1. Negative if readbacks are not supported.</summary>
    internal int ReadbackFrames { get; set; } = -1;

    /// <summary>Whether readbacks report an error.</summary>
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
