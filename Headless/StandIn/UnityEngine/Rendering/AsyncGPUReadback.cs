namespace UnityEngine.Rendering;

public static class AsyncGPUReadback
{
    public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0, Action<AsyncGPUReadbackRequest> callback = null)
    {
        if (!src) throw new ArgumentNullException(nameof(src));

        return World.Current.Gpu.Request(callback);
    }
}

public struct AsyncGPUReadbackRequest
{
    readonly Readback _readback;
    readonly int _number;

    internal AsyncGPUReadbackRequest(Readback readback)
    {
        _readback = readback;
        _number = readback.Number;
    }

    public readonly bool done => IsPast || _readback.Done;

    /// <summary>Whether the request has failed or its data has already been discarded.</summary>
    public readonly bool hasError => IsPast || _readback.Failed;

    readonly bool IsPast => _readback == null || _readback.Number != _number;
}
