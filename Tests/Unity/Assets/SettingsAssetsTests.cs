using Nowpose.Unity;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Tests the settings assets in the package and in its samples.</summary>
public sealed class SettingsAssetsTests
{
    static IEnumerable<string> Paths => RepositoryFiles.All
        .Where(path => path.StartsWith("Packages/", StringComparison.Ordinal) && path.EndsWith(" Settings.asset", StringComparison.Ordinal));

    // L_visu is constant only from the wait for the display on, and a profile is valid only for apps that compute the pose as it was calibrated.
    [TestCaseSource(nameof(Paths))]
    public void ToSettings_EachAsset_RewritesBeforeRender(string path)
    {
        Assert.That(RepositoryAssets.NewLibrary().Load<SessionSettingsAsset>(path).ToSettings().RewriteBeforeRender);
    }

    [Test]
    public void Paths_Assets_IncludeThePackageAndItsSamples()
    {
        Assert.That(Paths.Count(), Is.GreaterThanOrEqualTo(7));
    }
}
