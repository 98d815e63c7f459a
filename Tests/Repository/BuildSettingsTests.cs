using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public sealed class BuildSettingsTests
{
    [Test]
    public void BuildSettings_Scene_MatchesItsGuid()
    {
        var settings = RepositoryFiles.Read("ProjectSettings/EditorBuildSettings.asset");

        var scene = Regex.Match(settings, @"path: (\S+)\n    guid: (\w+)");

        Assert.That(scene.Success, "no scene is built");
        Assert.That(RepositoryFiles.Read(scene.Groups[1].Value + ".meta"), Does.Contain("guid: " + scene.Groups[2].Value + "\n"));
    }
}
