namespace UnityEngine.Rendering;

public struct AsyncGPUReadbackRequest
{
    readonly Readback _readback;

    internal AsyncGPUReadbackRequest(Readback readback) => _readback = readback;

    public readonly bool done => _readback?.Done ?? true;
    public readonly bool hasError => _readback?.Failed ?? true;

    public readonly void Update() { }

    public readonly void WaitForCompletion() => _readback?.Finish();
}
