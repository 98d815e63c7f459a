using System;

namespace Nowpose.Latency
{
    /// <summary>Names of render-time sources in files.</summary>
    static class RenderTimeSourceNames
    {
        static readonly string[] Names = { "", "display_gpu_time", "engine_gpu_time", "gpu_completion", "camera_cpu" };

        /// <returns>Empty for <see cref="RenderTimeSourceKind.None"/>.</returns>
        public static string NameOf(RenderTimeSourceKind source) => Names[(int)source];

        /// <param name="name">Exactly as written; empty for <see cref="RenderTimeSourceKind.None"/>.</param>
        public static bool TryParse(string name, out RenderTimeSourceKind source)
        {
            var index = Array.IndexOf(Names, name);
            source = index < 0 ? RenderTimeSourceKind.None : (RenderTimeSourceKind)index;
            return index >= 0;
        }

        /// <summary>All names except the empty one, separated by commas, for messages.</summary>
        public static string All => string.Join(", ", Names, 1, Names.Length - 1);
    }
}
