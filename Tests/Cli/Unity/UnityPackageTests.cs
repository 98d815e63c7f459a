using Nowpose.Cli.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.Unity.UnityManifests;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>Tests the address of the package in the manifest, and the package's dependencies.</summary>
public class UnityPackageTests
{
    [TestCase("https://git.example/me/nowpose.git", "https://git.example/me/nowpose.git?path=/Packages/com.nowpose.mril#v0.2.0")]
    [TestCase("https://git.example/me/nowpose.git#main", "https://git.example/me/nowpose.git?path=/Packages/com.nowpose.mril#main")]
    [TestCase(
        "git@git.example:me/nowpose.git?path=/Packages/com.nowpose.mril#main",
        "git@git.example:me/nowpose.git?path=/Packages/com.nowpose.mril#main")]
    public async Task Unity_PackageFromGit_WritesTheAddress(string given, string written)
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--package", given);
        var again = await project.RunAsync("--check");

        Assert.That(Dependencies(project)["com.nowpose.mril"], Is.EqualTo(written));
        Assert.That(run.Output, Does.Contain(UnityNextSteps.InUnity).And.Not.Contain(UnityNextSteps.KeepPackage("|").Split('|')[0]));
        Assert.That(again.ExitStatus, Is.EqualTo(0), again.Output);
    }

    [Test]
    public async Task Unity_PackageFromFolder_WritesAnAbsoluteOrTheGivenPath()
    {
        using var project = new UnityProjectFolder(Empty);
        var relative = "file:" + Path.GetRelativePath(project.At("Packages"), OwnPackage).Replace('\\', '/');

        await project.RunAsync("--package", OwnPackage);
        Assert.That(Dependencies(project)["com.nowpose.mril"], Is.EqualTo("file:" + OwnPackage));

        AssertRefused(await project.RunAsync("--package", relative), $"com.nowpose.mril is file:{OwnPackage}; {relative} is needed");
        await project.RunAsync("--package", relative, "--on-conflict", "replace");
        Assert.That(Dependencies(project)["com.nowpose.mril"], Is.EqualTo(relative));
    }

    [Test]
    public async Task Unity_PackageOfThisProgram_ReportsThatItsFolderMustStay()
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync();

        Assert.That(run.Output, Does.Contain(UnityNextSteps.KeepPackage(OwnPackage)));
    }

    static readonly string[][] Missing =
    [
        ["https://github.com/OWNER/nowpose.git", UnityPackageMessages.Owner],
        ["no-such-folder", UnityPackageMessages.NotAnAddress("no-such-folder", "com.nowpose.mril")],
        ["file:../nowhere", UnityPackageMessages.NotAnAddress("file:../nowhere", "com.nowpose.mril")],
    ];

    [TestCaseSource(nameof(Missing))]
    public async Task Unity_PackageMissing_Fails(string given, string reason)
    {
        using var project = new UnityProjectFolder(Empty);

        AssertRefused(await project.RunAsync("--package", given), "--package: ");
        AssertRefused(await project.RunAsync("--package", given), reason);
    }

    static readonly string[][] InvalidPackages =
    [
        ["{ 'name': ", UnityPackageMessages.NotJson("", 1)],
        ["[]", ": " + UnityPackageMessages.ObjectExpected],
        ["{ 'displayName': 'x' }", ": " + UnityPackageMessages.NotAString("", "name")],
        ["{ 'name': '\\ud800' }", ": " + UnityPackageMessages.NotAString("", "name")],
        ["{ 'name': 'com.nowpose.mril', 'displayName': 'x', 'version': 1 }", ": " + UnityPackageMessages.NotAString("", "version")],
        [OwnJson + "'samples': {} }", ": " + UnityPackageMessages.SamplesNotAnArray],
        [OwnJson + "'samples': [1] }", ": " + UnityPackageMessages.NotAnObject("samples[0]")],
        [OwnJson + "'samples': [{ 'displayName': 'a', 'description': 'b' }] }", ": " + UnityPackageMessages.NotAString("samples[0].", "path")],
    ];

    const string OwnJson = "{ 'name': 'com.nowpose.mril', 'displayName': 'x', 'version': '1.0.0', ";

    [TestCaseSource(nameof(InvalidPackages))]
    public async Task Unity_InvalidPackageJson_NamesFileAndField(string json, string reason)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("package/package.json", json.Replace('\'', '"'));

        AssertRefused(await project.RunAsync("--package", project.At("package")), project.At("package/package.json") + reason);
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_PackageWithoutSamples_Succeeds()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("package/package.json", """{ "name": "com.nowpose.mril", "displayName": "Nowpose", "version": "0.2.0" }""");

        var run = await project.RunAsync("--package", project.At("package"));

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
    }

    [Test]
    public void ProjectNeeds_Dependencies_MatchThePackageJson()
    {
        var declared = Json(RepositoryFiles.Read(RepositoryFiles.Package + "/package.json")).GetProperty("dependencies").EnumerateObject()
            .Where(d => !d.Name.StartsWith("com.unity.modules.", StringComparison.Ordinal)).Select(d => d.Name + " " + d.Value.GetString());

        var needed = ProjectNeeds.Always.Where(p => p.Name != "com.unity.test-framework").Select(p => p.Name + " " + p.Reference);

        Assert.That(needed, Is.EquivalentTo(declared));
    }

    [Test]
    public void ProjectNeeds_GitDependencies_ArePinned()
    {
        var addresses = ProjectNeeds.HoloLensWithMrtk3.Append(ProjectNeeds.NativeWebSocket).Select(p => p.Reference)
            .Where(reference => reference.StartsWith("https://", StringComparison.Ordinal)).ToList();

        Assert.That(addresses, Has.Count.EqualTo(9));
        Assert.That(addresses, Has.All.Matches("#([0-9a-f]{40}|(.+-)?v[0-9]+\\.[0-9]+\\.[0-9]+)$"));
    }
}
