namespace Nowpose.Editor
{
    /// <summary>A registry beside Unity's own, and the beginning of the names it is asked for.</summary>
    sealed class ScopedRegistry
    {
        public static readonly ScopedRegistry Microsoft = new ScopedRegistry(
            "Microsoft Mixed Reality",
            "https://pkgs.dev.azure.com/aipmr/MixedReality-Unity-Packages/_packaging/Unity-packages/npm/registry/",
            "com.microsoft.mixedreality");

        ScopedRegistry(string name, string url, string scope)
        {
            Name = name;
            Url = url;
            Scope = scope;
        }

        public string Name { get; }
        public string Url { get; }
        public string Scope { get; }
    }
}
