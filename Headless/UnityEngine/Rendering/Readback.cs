using System;

namespace UnityEngine.Rendering;

/// <summary>One request to the graphics processor.</summary>
sealed class Readback
{
    readonly Action<AsyncGPUReadbackRequest> _callback;
    int _framesLeft;

    internal Readback(Action<AsyncGPUReadbackRequest> callback, int frames, bool failed)
    {
        _callback = callback;
        _framesLeft = frames;
        Failed = failed;
    }

    internal bool Failed { get; }
    internal bool Done { get; private set; }

    internal void Advance()
    {
        if (_framesLeft-- <= 0) Finish();
    }

    internal void Finish()
    {
        if (Done) return;

        Done = true;
        _callback?.Invoke(new AsyncGPUReadbackRequest(this));
    }
}
