using System.Collections.Generic;
using UnityEngine.XR;

namespace UnityEngine.Rendering;

/// <summary>The graphics processor as tests set it up: which of its times can be had, and how late it answers.</summary>
sealed class Gpu
{
    readonly List<Readback> _readbacks = new();
    readonly Stack<Readback> _done = new();

    /// <summary>Null where no headset's display runs.</summary>
    internal XRDisplaySubsystem Display { get; private set; }

    /// <summary>Seconds, what the headset's display says of the last frame; null where it knows none.</summary>
    internal float? DisplayGpuTime { get; set; }

    /// <summary>Refreshes per second of the headset's display; null where it does not tell.</summary>
    internal float? DisplayHz { get; set; }

    internal GraphicsDeviceType Api { get; set; } = GraphicsDeviceType.Direct3D11;

    internal RenderingThreadingMode Threading { get; set; } = RenderingThreadingMode.MultiThreaded;

    /// <summary>Null for the built-in pipeline.</summary>
    internal RenderPipelineAsset RenderPipeline { get; set; }

    /// <summary>Milliseconds of the last frames, newest first; empty where nothing is measured.</summary>
    internal List<FrameTiming> FrameTimings { get; } = new();

    /// <summary>Frames until a readback is done, when that frame begins: 1 the next one, as soon as can be; negative where there is none.</summary>
    internal int ReadbackFrames { get; set; } = -1;

    /// <summary>Readbacks report an error.</summary>
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

    /// <summary>At the beginning of a frame.</summary>
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
