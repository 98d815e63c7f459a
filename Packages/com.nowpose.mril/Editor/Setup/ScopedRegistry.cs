using System.Collections.Generic;

namespace Nowpose.Editor.Setup
{
    /// <summary>A package registry other than Unity's own, with its scopes, which are the name prefixes of its packages.</summary>
    sealed class ScopedRegistry
    {
        public static readonly ScopedRegistry UnityNuGet = new ScopedRegistry("UnityNuGet", "https://unitynuget-registry.openupm.com", "org.nuget");

        public static readonly ScopedRegistry Microsoft = new ScopedRegistry(
            "Microsoft Mixed Reality",
            "https://pkgs.dev.azure.com/aipmr/MixedReality-Unity-Packages/_packaging/Unity-packages/npm/registry/",
            "com.microsoft.mixedreality", "com.microsoft.mrtk");

        ScopedRegistry(string name, string url, params string[] scopes)
        {
            Name = name;
            Url = url;
            Scopes = scopes;
        }

        public string Name { get; }
        public string Url { get; }
        public IReadOnlyList<string> Scopes { get; }

        public bool Is(string url) => url != null && url.TrimEnd('/') == Url.TrimEnd('/');
    }
}
