using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Base class of tests that need a folder for measurements and results. The folder is deleted after each test.</summary>
public abstract class CalibrationFolder
{
    protected string Folder { get; private set; }

    protected string Out => Path.Combine(Folder, "out");

    protected string ProfilePath => Path.Combine(Out, "profile.json");

    [SetUp]
    public void MakeFolder() => Folder = Directory.CreateTempSubdirectory("nowpose-calibrate-").FullName;

    [TearDown]
    public void RemoveFolder() => Directory.Delete(Folder, recursive: true);

    protected string Write(string name, IEnumerable<string> lines)
    {
        var path = Path.Combine(Folder, name);
        File.WriteAllLines(path, lines);
        return path;
    }

    /// <summary>Runs a calibration that must fail because of invalid input.</summary>
    /// <returns>The only line on stderr.</returns>
    protected async Task<string> RefusalOf(params string[] arguments)
    {
        var run = await CliRun.OfAsync(["calibrate", .. arguments, "--out", Out]);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Complaints, Has.Length.EqualTo(1), run.Errors);
        return run.Complaints[0];
    }
}
