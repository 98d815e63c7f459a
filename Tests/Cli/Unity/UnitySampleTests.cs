using Nowpose.Cli.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.Unity.UnityManifests;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>Tests copying the package's samples to a project.</summary>
public class UnitySampleTests
{
    [TestCase("Virtual Robot Cell")]
    [TestCase("hololens 2 (mrtk3)")]
    public async Task Unity_SampleMissingOrIncomplete_CopiesMissingFiles(string name)
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--sample", name);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var copy = Directory.EnumerateDirectories(project.At("Assets/Samples/Nowpose/0.2.0")).Single();
        var source = Path.Combine(OwnPackage, "Samples~", Path.GetFileName(copy));
        Assert.That(Files(copy), Is.EqualTo(Files(source)));
        Assert.That(Files(copy).Select(f => f.Path), Has.Some.EndsWith(".unity.meta"));

        File.Delete(Path.Combine(copy, "README.md"));
        await project.RunAsync("--sample", name);
        Assert.That(Files(copy), Is.EqualTo(Files(source)));
    }

    [Test]
    public async Task Unity_SampleChangedByTheUser_IsNotOverwritten()
    {
        using var project = new UnityProjectFolder(Empty);
        await project.RunAsync("--sample", "Virtual Robot Cell");
        const string changed = "Assets/Samples/Nowpose/0.2.0/Virtual Robot Cell/README.md";
        project.Write(changed, "mine");

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");

        AssertRefused(run, UnityPackageMessages.SampleChanged(project.At(changed), 0));
        Assert.That(project.Read(changed), Is.EqualTo("mine"));
    }

    // Git on Windows changes the line ends of a project.
    [Test]
    public async Task Unity_SampleWithOtherLineEnds_IsUnchanged()
    {
        using var project = new UnityProjectFolder(Empty);
        await project.RunAsync("--sample", "Virtual Robot Cell");
        const string readme = "Assets/Samples/Nowpose/0.2.0/Virtual Robot Cell/README.md";
        project.Write(readme, project.Read(readme).ReplaceLineEndings("\r\n"));

        var run = await project.RunAsync("--sample", "Virtual Robot Cell", "--check");

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
    }

    [TestCase("Assets/Samples", "--check")]
    [TestCase("Assets/Samples")]
    [TestCase("Assets/Samples/Nowpose/0.2.0/Virtual Robot Cell")]
    public async Task Unity_FileInsteadOfSampleFolder_FailsWithoutChanges(string path, params string[] options)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write(path, "mine");

        var run = await project.RunAsync(["--sample", "Virtual Robot Cell", .. options]);

        AssertRefused(run, UnityPackageMessages.FileInTheWay(project.At(path)));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(project.Backups, Is.Empty);
    }

    [TestCase("--check")]
    [TestCase]
    public async Task Unity_SampleOfAnotherVersionExists_FailsWithoutChanges(params string[] options)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Assets/Samples/Nowpose/0.1.0/Virtual Robot Cell/README.md", "mine");

        var run = await project.RunAsync(["--sample", "Virtual Robot Cell", .. options]);

        AssertRefused(run, UnityPackageMessages.OtherVersion(project.At("Assets/Samples/Nowpose/0.1.0/Virtual Robot Cell"), "Virtual Robot Cell"));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(Directory.Exists(project.At("Assets/Samples/Nowpose/0.2.0")), Is.False);
    }

    [Test]
    public async Task Unity_OtherSampleOfAnotherVersionExists_CopiesTheSample()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Assets/Samples/Nowpose/0.1.0/Connect to a Gateway/README.md", "mine");

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
    }

    [Test]
    public async Task Unity_SampleCannotBeCopied_KeepsTheManifest()
    {
        using var project = new UnityProjectFolder(Empty);
        // This file has the name of the folder to which the sample is copied first.
        project.Write("Assets/Samples/Nowpose/0.2.0/.Virtual Robot Cell", "mine");

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");

        AssertRefused(run, "");
        Assert.That(run.Errors, Does.Match(MessagePattern.Of(
            UnityPackageMessages.NotCopied(MessagePattern.Any, "Virtual Robot Cell", MessagePattern.Any))));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(project.Backups, Is.Empty);
    }

    [Test]
    public async Task Unity_UnknownSample_ListsTheSamplesWithoutChanges()
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--sample", "Virtual");

        AssertRefused(run, UnityPackageMessages.UnknownSample("Virtual", "Virtual Robot Cell, Connect to a Gateway, "));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    static IEnumerable<(string Path, string Content)> Files(string folder) =>
        Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal)
            .Select(file => (Path.GetRelativePath(folder, file), File.ReadAllText(file)));
}
