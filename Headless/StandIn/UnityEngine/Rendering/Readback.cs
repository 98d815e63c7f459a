namespace UnityEngine.Rendering;

/// <summary>One readback request. Later requests reuse the object, because in Unity requests do not allocate managed memory.</summary>
sealed class Readback
{
    Action<AsyncGPUReadbackRequest> _callback;
    int _framesLeft;

    /// <summary>Number of the current request, which distinguishes it from earlier requests with the same object.</summary>
    internal int Number { get; private set; }

    internal bool Failed { get; private set; }
    internal bool Done { get; private set; }

    internal void Begin(Action<AsyncGPUReadbackRequest> callback, int frames, bool failed)
    {
        _callback = callback;
        _framesLeft = frames;
        Number++;
        Failed = failed;
        Done = false;
    }

    internal void Advance()
    {
        if (--_framesLeft <= 0) Finish();
    }

    internal void Finish()
    {
        if (Done) return;

        Done = true;
        Callbacks.Call(_callback, new AsyncGPUReadbackRequest(this));
    }
}
