using Nowpose.Cli.Messages;
using Nowpose.Editor.Messages;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.Unity.UnityManifests;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>Tests how the manifest file is read and written.</summary>
public class UnityManifestTests
{
    static readonly string[][] Invalid =
    [
        ["{\n  \"dependencies\": {\n    \"a\": \"1.0.0\",\n  }\n}", ManifestMessages.NotJson("", "4", ManifestMessages.NoName, isComment: false)],
        ["{\n  // packages\n  \"dependencies\": {}\n}", ManifestMessages.NotJson("", "2", ManifestMessages.NoName, isComment: true)],
        ["", ManifestMessages.NotJson("", "1", ManifestMessages.Expected('{'), isComment: false)],
    ];

    [TestCaseSource(nameof(Invalid))]
    public async Task Unity_InvalidManifest_NamesTheLineAndKeepsTheFile(string manifest, string reason)
    {
        using var project = new UnityProjectFolder(manifest);

        var run = await project.RunAsync();

        AssertRefused(run, project.At("Packages/manifest.json") + reason);
        Assert.That(project.Manifest, Is.EqualTo(manifest));
        Assert.That(project.Backups, Is.Empty);
    }

    [Test]
    public async Task Unity_ManifestNotUtf8_Fails()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json", System.Text.Encoding.Unicode.GetPreamble());

        AssertRefused(await project.RunAsync(), ManifestMessages.NotUtf8(project.At("Packages/manifest.json")));
    }

    [Test]
    public async Task Unity_ReadOnlyManifest_NamesAndKeepsTheManifest()
    {
        using var project = new UnityProjectFolder(Empty);
        var manifest = project.At("Packages/manifest.json");
        File.SetAttributes(manifest, FileAttributes.ReadOnly);

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");
        var check = await project.RunAsync("--check");
        File.SetAttributes(manifest, FileAttributes.Normal);
        var writable = await project.RunAsync("--check");

        AssertRefused(run, ManifestMessages.ReadOnly(manifest));
        Assert.That(check.ExitStatus, Is.EqualTo(1));
        Assert.That(check.Errors, Does.Contain(ConsoleMessages.WouldFail(ManifestMessages.ReadOnly(manifest))));
        Assert.That(writable.Errors, Is.Empty);
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(Directory.Exists(project.At("Assets")), Is.False, "no other step is executed");
    }

    [Test]
    public async Task Unity_ManifestIsASymbolicLink_WritesItsTarget()
    {
        using var project = new UnityProjectFolder(Empty);
        var link = project.At("Packages/manifest.json");
        var target = project.At("shared.json");
        File.Move(link, target);
        try
        {
            File.CreateSymbolicLink(link, target);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            Assert.Ignore("this account must not create symbolic links: " + e.Message);
        }

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(new FileInfo(link).LinkTarget, Is.EqualTo(target));
        Assert.That(project.Read("shared.json"), Does.Contain("org.nuget.mathnet.numerics"));
        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_TemporaryFileCannotBeWritten_KeepsTheManifest()
    {
        using var project = new UnityProjectFolder(Empty);
        Directory.CreateDirectory(project.At("Packages/manifest.json.nowpose-new"));

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    [Platform("Linux")]
    public async Task Unity_FullDisk_IsAFailedRun()
    {
        using var project = new UnityProjectFolder(Empty);
        File.CreateSymbolicLink(project.At("Packages/manifest.json.nowpose-new"), "/dev/full");

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(1), run.Errors);
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_TemporaryFileOfAnInterruptedRun_ReplacesIt()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json.nowpose-new", new string('x', 10000));

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(() => Dependencies(project), Throws.Nothing);
        Assert.That(project.Backups, Is.EqualTo(new[] { "manifest.json.backup" }));
    }

    [Test]
    public async Task Unity_BackupWithOtherContent_KeepsIt()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json.backup", "precious");

        var run = await project.RunAsync("--json");

        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo("precious"));
        Assert.That(Json(run.Output).GetProperty("backup").GetString(), Is.EqualTo(project.At("Packages/manifest.json.backup-2")));
        Assert.That(project.Read("Packages/manifest.json.backup-2"), Is.EqualTo(Empty));
    }

    [TestCase("\r\n", "\t", true)]
    [TestCase("\r\n", "    ", false)]
    [TestCase("\n", "\t", true)]
    public async Task Unity_LineEndingsIndentAndByteOrderMark_AreKept(string newLine, string indent, bool hasMark)
    {
        byte[] mark = hasMark ? [0xEF, 0xBB, 0xBF] : [];
        var text = Empty.ReplaceLineEndings("\n").TrimEnd()
            .Replace("  ", indent, StringComparison.Ordinal).Replace("\n", newLine, StringComparison.Ordinal);
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json", [.. mark, .. System.Text.Encoding.UTF8.GetBytes(text)]);

        await project.RunAsync();

        var bytes = File.ReadAllBytes(project.At("Packages/manifest.json"));
        var after = System.Text.Encoding.UTF8.GetString(bytes, mark.Length, bytes.Length - mark.Length);
        Assert.That(bytes.Take(mark.Length), Is.EqualTo(mark));
        Assert.That(after.Replace(newLine, "", StringComparison.Ordinal), Does.Not.Contain('\n').And.Not.Contain('\r'));
        Assert.That(after, Does.Contain($"{newLine}{indent}{indent}\"org.nuget.mathnet.numerics\": \"5.0.0\"{newLine}{indent}}},{newLine}"));
        Assert.That(after, Does.EndWith(newLine + "}"), "no line end is added after the last brace");
        foreach (var line in text.Split(newLine).Where(l => l.Contains(':', StringComparison.Ordinal)))
            Assert.That(after, Does.Contain(newLine + line.TrimEnd(',')));
    }
}
