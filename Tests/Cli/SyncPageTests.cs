using System.Globalization;
using Nowpose.Cli.Messages;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.SyncVerbTests;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Tests the page that <c>sync --page</c> writes.</summary>
public class SyncPageTests
{
    [TestCase("ransac", SyncPageTexts.Ransac)]
    [TestCase("default", "default")]
    public async Task Sync_PageOption_WritesFigure8AndItsData(string estimator, string name)
    {
        using var file = new TemporaryFile(Log(200), ".csv");
        using var folder = new TemporaryFolder();
        var page = Path.Combine(folder.Path, "clock.html");

        var run = await CliRun.OfAsync("sync", file.Path, "--estimator", estimator, "--page", page);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Lines, Has.Length.EqualTo(201), "the estimates are printed as well");
        Assert.That(run.Errors, Does.Contain(page));
        Assert.That(File.ReadAllText(page), Does.Contain("fitting error").And.Contain(name).And.Contain("clock.csv"));
        var data = File.ReadAllLines(Path.Combine(folder.Path, "clock.csv"));
        Assert.That(data, Has.Length.EqualTo(201));
        Assert.That(double.Parse(data[^1].Split(',')[3], CultureInfo.InvariantCulture), Is.EqualTo(50).Within(0.1), "skew, ppm");
    }

    [Test]
    public async Task Sync_PageWithInvalidExchanges_SkipsAndCountsThem()
    {
        // Adds four exchanges whose reply precedes the request, and four that are logged twice.
        IEnumerable<string> Rows(string line, int i) => i == 0 || i % 25 != 0 ? [line] : i % 50 == 0 ? [line, line] : [line, Reversed(line)];
        using var file = new TemporaryFile(string.Join('\n', Log(200).TrimEnd().Split('\n').SelectMany(Rows)) + "\n", ".csv");
        using var folder = new TemporaryFolder();
        var page = Path.Combine(folder.Path, "clock.html");

        var run = await CliRun.OfAsync("sync", file.Path, "--estimator", "ransac", "--page", page);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Errors.Split('\n').Count(line => line.Contains(": dropped 4 of 208 ", StringComparison.Ordinal)), Is.EqualTo(2), run.Errors);
        Assert.That(File.ReadAllText(page), Does.Contain("8 of 208 exchanges are invalid"));
        Assert.That(File.ReadAllLines(Path.Combine(folder.Path, "clock.csv")), Has.Length.EqualTo(201));
    }

    // Returns an exchange whose reply arrives before its request is sent. It is between the given exchange and the next one.
    static string Reversed(string line)
    {
        var t4 = long.Parse(line.Split(',')[3], CultureInfo.InvariantCulture);
        return FormattableString.Invariant($"{t4 + 20_000_000},{ControlEpoch},{ControlEpoch},{t4 + 10_000_000}");
    }

    [TestCase("log.html", "log.csv")]
    [TestCase("log.csv", "log.csv")]
    [TestCase("instants.html", "instants.csv")]
    [TestCase("other.csv", null)]
    public async Task Sync_PageOverwritesAnInputFile_Fails(string page, string input)
    {
        using var folder = new TemporaryFolder();
        var (log, instants) = (Path.Combine(folder.Path, "log.csv"), Path.Combine(folder.Path, "instants.csv"));
        File.WriteAllText(log, Log(200));
        File.WriteAllText(instants, "t_ns\n1000000000\n");

        var run = await CliRun.OfAsync("sync", log, "--at", instants, "--page", Path.Combine(folder.Path, page));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(
            input == null ? ".html" : OptionValueMessages.WouldOverwriteInput("--page", Path.Combine(folder.Path, input))));
        Assert.That(File.ReadAllText(log), Is.EqualTo(Log(200)), "the log is unchanged");
        Assert.That(File.ReadAllText(instants), Does.StartWith("t_ns"), "the instants are unchanged");
        Assert.That(Directory.GetFiles(folder.Path), Has.Length.EqualTo(2));
    }

    static readonly string[] InvalidPages = [ImpossiblePath.BelowAFile("x/clock.html"), ""];

    [TestCaseSource(nameof(InvalidPages))]
    public async Task Sync_PageWithAnInvalidPath_Fails(string page)
    {
        using var file = new TemporaryFile(Log(20), ".csv");

        var run = await CliRun.OfAsync("sync", file.Path, "--page", page);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain($"--page: {page}: cannot be written"));
    }
}
