namespace UnityEngine.Rendering;

public static class AsyncGPUReadback
{
    public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0, Action<AsyncGPUReadbackRequest> callback = null)
    {
        if (!src) throw new ArgumentNullException(nameof(src));

        return World.Current.Gpu.Request(callback);
    }
}
