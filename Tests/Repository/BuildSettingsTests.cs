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

    [Test]
    public void SolutionTargets_TestProjects_AreAllTestProjectsOfTheSolution()
    {
        var solution = Regex.Matches(RepositoryFiles.Read("Nowpose.slnx"), @"Path=""([^""]+\.csproj)""").Select(match => match.Groups[1].Value);
        var tested = Regex.Matches(RepositoryFiles.Read("Directory.Solution.targets"), @"<TestProject Include=""([^""]+)""").Select(match => match.Groups[1].Value);

        Assert.That(tested, Is.EquivalentTo(solution.Where(path => RepositoryFiles.Read(path).Contains("\"Microsoft.NET.Test.Sdk\""))));
    }
}
