using Nowpose.Latency;

namespace Nowpose.Unity.Messages
{
    /// <summary>Names of the render-time sources, for the status panel and the console.</summary>
    static class RenderTimeNames
    {
        public static string NameOf(RenderTimeSourceKind source)
        {
            switch (source)
            {
                case RenderTimeSourceKind.DisplayGpuTime: return "GPU time from headset";
                case RenderTimeSourceKind.EngineGpuTime: return "GPU time from Unity";
                case RenderTimeSourceKind.GpuCompletion: return "time to GPU completion";
                case RenderTimeSourceKind.CameraCpu: return "camera CPU, unverified";
                default: return "not measured";
            }
        }
    }
}
