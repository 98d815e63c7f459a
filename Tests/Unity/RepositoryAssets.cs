using Nowpose.UnityPlayer;

namespace Nowpose.Unity.Tests;

/// <summary>Gives each test its own objects of the assets in this repository. All tests use the same parsed files, because no test changes them.</summary>
static class RepositoryAssets
{
    static readonly Lazy<AssetLibrary> Read = new(() => new AssetLibrary(RepositoryFiles.Root));

    /// <summary>Creates a library without loaded objects.</summary>
    public static AssetLibrary NewLibrary() => Read.Value.Unloaded();
}
