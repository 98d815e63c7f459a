using Nowpose.Cli.Demo;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Tests which files of an earlier run are removed from the output folder.</summary>
public sealed class DemoOutputTests
{
    static readonly string[] OfDemo = ["report.html", "result.json", "session.jsonl"];
    static readonly string[] OfPaper = ["frames.csv", "exchanges.csv", "figure-8.csv", "figure-16.csv", "profile.json", "calibration.html"];

    [Test]
    public void RemoveEarlier_WithoutPaper_RemovesOnlyItsOwnFiles()
    {
        using var folder = Filled();

        using (var output = DemoOutput.At(folder.Path, isPaper: false)) output.RemoveEarlier();

        Assert.That(Names(folder), Is.EquivalentTo(OfPaper));
    }

    [Test]
    public void RemoveEarlier_WithPaper_RemovesTheFilesOfAnEarlierPaperRun()
    {
        using var folder = Filled();

        using (var output = DemoOutput.At(folder.Path, isPaper: true)) output.RemoveEarlier();

        Assert.That(Names(folder), Is.Empty);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void At_EarlierFiles_KeepsThem(bool isPaper)
    {
        using var folder = Filled();

        DemoOutput.At(folder.Path, isPaper).Dispose();

        Assert.That(Names(folder), Is.EquivalentTo(OfDemo.Concat(OfPaper)));
    }

    [TestCase("profile.json")]
    [TestCase("calibration.html")]
    public void At_WithPaperAndACalibrationThatIsNotWritable_ThrowsAndKeepsAllFiles(string name)
    {
        using var folder = Filled();
        File.Delete(Path.Combine(folder.Path, name));
        Directory.CreateDirectory(Path.Combine(folder.Path, name));

        Assert.That(() => DemoOutput.At(folder.Path, isPaper: true), Throws.TypeOf<InputException>());
        Assert.That(Names(folder), Is.EquivalentTo(OfDemo.Concat(OfPaper).Where(each => each != name)));
    }

    [TestCase("result.json")]
    [TestCase("session.jsonl")]
    public void At_InputIsAFileToRemove_ThrowsAndKeepsAllFiles(string name)
    {
        using var folder = Filled();
        var input = Path.Combine(folder.Path, ".", name);

        Assert.That(() => DemoOutput.At(folder.Path, isPaper: false, null, input), Throws.TypeOf<InputException>());
        Assert.That(Names(folder), Is.EquivalentTo(OfDemo.Concat(OfPaper)));
    }

    [TestCase("{\"kind\":\"session\",\"headset\":\"headless\"}\n{\"kind\":\"frame\"}\n")]
    [TestCase("{\"kind\":\"session\",\"recorded_by\":\"gateway\"}\n")]
    public void At_RecordingOfAnotherProgram_ThrowsAndKeepsIt(string text)
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "session.jsonl");
        File.WriteAllText(path, text);

        Assert.That(
            () => DemoOutput.At(folder.Path, isPaper: false),
            Throws.TypeOf<InputException>().With.Message.EqualTo(DemoMessages.OtherRecording(path)));
        Assert.That(File.ReadAllText(path), Is.EqualTo(text));
    }

    [TestCase("{\"kind\":\"session\",\"headset\":\"demo\"}\n{\"kind\":")]
    [TestCase("no recording")]
    [TestCase("")]
    public void At_FilesOfAnEarlierDemoOrWithoutARecording_AcceptsThem(string session)
    {
        using var folder = new TemporaryFolder();
        foreach (var (name, text) in new[] { ("result.json", "{}"), ("report.html", "<h1>Tests</h1>"), ("session.jsonl", session) })
            File.WriteAllText(Path.Combine(folder.Path, name), text);

        using (var output = DemoOutput.At(folder.Path, isPaper: false)) output.RemoveEarlier();

        Assert.That(Names(folder), Is.Empty);
    }

    [Test]
    public void At_FolderOfARunThatHasNotEnded_ThrowsAndKeepsAllFiles()
    {
        using var folder = Filled();
        using (DemoOutput.At(folder.Path, isPaper: false))
        {
            Assert.That(
                () => DemoOutput.At(folder.Path, isPaper: true),
                Throws.TypeOf<InputException>().With.Message.EqualTo(DemoMessages.FolderInUse(folder.Path)));
            Assert.That(OfDemo.Concat(OfPaper), Is.SubsetOf(Names(folder)));
        }
        DemoOutput.At(folder.Path, isPaper: true).Dispose();
        Assert.That(Names(folder), Is.EquivalentTo(OfDemo.Concat(OfPaper)));
    }

    [Test]
    public void At_LockCannotBeWritten_NamesItsPath()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, ".nowpose.lock");
        Directory.CreateDirectory(path);

        Assert.That(
            () => DemoOutput.At(folder.Path, isPaper: false),
            Throws.TypeOf<InputException>().With.Message.StartsWith($"--out: {path}: cannot be written"));
    }

    [Test]
    public void Written_RunWithoutASession_ListsTheOtherFiles()
    {
        using var folder = new TemporaryFolder();
        using var output = DemoOutput.At(folder.Path, isPaper: false);
        foreach (var path in new[] { output.ResultPath, output.ReportPath }) File.WriteAllText(path, "");

        Assert.That(output.Written.Select(file => file.Path), Is.EqualTo(new[] { output.ResultPath, output.ReportPath }));
    }

    static TemporaryFolder Filled()
    {
        var folder = new TemporaryFolder();
        foreach (var name in OfDemo.Concat(OfPaper)) File.WriteAllText(Path.Combine(folder.Path, name), "");
        return folder;
    }

    static string[] Names(TemporaryFolder folder) => [.. Directory.GetFiles(folder.Path).Select(Path.GetFileName)];
}
