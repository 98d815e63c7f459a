using Nowpose.Cli.Messages;
using Nowpose.Editor.Messages;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.Unity.UnityManifests;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>Tests which Unity versions and folders the command <c>unity</c> accepts.</summary>
public class UnityVersionTests
{
    [TestCase("2020.3.48f1", "2021.3", "--check")]
    [TestCase("2021.3.21f1", "2021.3.26", "--mrtk3")]
    [TestCase("6000.3.2f1", UnityVersionMessages.PlugInFails, "--mrtk3")]
    public async Task Unity_UnsupportedVersion_Fails(string version, string reason, string option)
    {
        using var project = new UnityProjectFolder(Empty, version);

        var run = await project.RunAsync(option);

        AssertRefused(run, project.At("ProjectSettings/ProjectVersion.txt") + ": Unity " + version);
        Assert.That(run.Errors, Does.Contain(reason));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_PlugInIncompatibleWithTheVersion_Fails()
    {
        using var project = new UnityProjectFolder(WithMrtk3, "6000.3.0f1");

        AssertRefused(await project.RunAsync(), UnityVersionMessages.PlugInFails);
    }

    [TestCase("6000.3.2f1", UnityVersionMessages.NotComparedNewest)]
    [TestCase("6000.0.78f1", UnityVersionMessages.Compared6000)]
    public async Task Unity_UntestedVersion_PrintsANote(string version, string note)
    {
        using var project = new UnityProjectFolder(Empty, version);

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(run.Errors, Does.Contain(note));
    }

    [Test]
    public async Task Unity_Mrtk4_PrintsANoteAndRejectsTheMrtk3Option()
    {
        const string manifest =
            """{ "dependencies": { "org.mixedrealitytoolkit.core": "4.0.0-pre.2", "com.unity.xr.interaction.toolkit": "3.0.4" } }""";
        using var project = new UnityProjectFolder(manifest);

        var refused = await project.RunAsync("--mrtk3");
        var noted = await project.RunAsync();

        AssertRefused(refused, ManifestMessages.OtherVersion(
            "", "org.mixedrealitytoolkit.core", "4.0.0-pre.2", "3.0.0" + CheckResults.OrNewer(new Version(4, 0, 0))));
        Assert.That(noted.ExitStatus, Is.EqualTo(0));
        Assert.That(noted.Errors, Does.Contain("com.unity.xr.interaction.toolkit 3.0.4 is not supported"));
    }

    [Test]
    public async Task Unity_OpenXrWithoutUwp_PrintsANoteAndRejectsTheMrtk3Option()
    {
        using var project = new UnityProjectFolder(WithMrtk3.Replace("1.14.3", "1.17.1", StringComparison.Ordinal));

        var refused = await project.RunAsync("--mrtk3");
        var noted = await project.RunAsync();

        AssertRefused(refused, ManifestMessages.OtherVersion("", "com.unity.xr.openxr", "1.17.1", "older than 1.17.0"));
        Assert.That(noted.ExitStatus, Is.EqualTo(0));
        Assert.That(noted.Errors, Does.Contain(UnityProjectMessages.TooNewForHoloLens("com.unity.xr.openxr", "1.17.1", "older than 1.17.0")));
    }

    [TestCase(null, "Packages/manifest.json", "Packages/manifest.json is missing")]
    [TestCase(Empty, "ProjectSettings/ProjectVersion.txt", "ProjectSettings/ProjectVersion.txt is missing")]
    public async Task Unity_FolderIsNotAProject_Fails(string manifest, string without, string reason)
    {
        using var project = new UnityProjectFolder(manifest);
        File.Delete(project.At(without).Replace("Packages/manifest.json", "Packages", StringComparison.Ordinal));

        AssertRefused(await project.RunAsync(), "not a Unity project: " + reason.Replace('/', Path.DirectorySeparatorChar));
    }

    [Test]
    public async Task Unity_InvalidPath_Fails()
    {
        using var project = new UnityProjectFolder(Empty);
        Directory.CreateDirectory(project.At("Assets"));

        AssertRefused(await CliRun.OfAsync("unity", project.At("Assets")), "; enter the project's folder " + project.Root);
        var file = project.At("Packages/manifest.json");
        AssertRefused(await CliRun.OfAsync("unity", file), UnityProjectMessages.IsAFile(file));
        AssertRefused(await CliRun.OfAsync("unity", project.At("nowhere")), UnityProjectMessages.NoFolder(project.At("nowhere")));
        AssertRefused(await CliRun.OfAsync("unity", ""), UnityProjectMessages.NoPath);
        AssertRefused(await CliRun.OfAsync("unity"), "argument");
        AssertRefused(
            await project.RunAsync("--on-conflict", "maybe"), OptionMessages.UnknownChoice("--on-conflict", "maybe", "refuse, keep, replace"));
    }

    [TestCase("m_EditorVersion: soon")]
    [TestCase("")]
    public async Task Unity_ProjectVersionMissing_Fails(string text)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("ProjectSettings/ProjectVersion.txt", text);

        AssertRefused(await project.RunAsync(), UnityProjectMessages.NoVersion(project.At("ProjectSettings/ProjectVersion.txt")));
    }
}
