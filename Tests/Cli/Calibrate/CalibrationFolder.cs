using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>A folder of measurements and results that is deleted after each test.</summary>
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

    /// <summary>Runs a calibration that must fail because of its input.</summary>
    /// <returns>The single line on stderr.</returns>
    protected async Task<string> RefusalOf(params string[] arguments)
    {
        var run = await CliRun.OfAsync(["calibrate", .. arguments, "--out", Out]);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Complaints, Has.Length.EqualTo(1), run.Errors);
        return run.Complaints[0];
    }
}
