using System.Text.RegularExpressions;
using System.Xml.Linq;
using Nowpose.Cli.Figures;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Studies;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

/// <summary>
/// Tests the complete command <c>figures</c> with the minimum number of runs. The results do not depend on how long the computation takes.
/// </summary>
public partial class FiguresVerbTests
{
    static readonly FigureSettings Least = new() { Phases = 1, ClockRuns = 1, ClockSeconds = 30, SwingSeconds = 4, RandomSeconds = 4, Profile = SwingProfile.Of(40) };

    string _folder, _plain, _withPictures;

    string Pictures => Path.Combine(_withPictures, "images");

    // Two runs serve all tests of their results, because a run takes longer than all checks.
    [OneTimeSetUp]
    public void RunTwice()
    {
        _plain = Directory.CreateTempSubdirectory("nowpose-figures-").FullName;
        _withPictures = Directory.CreateTempSubdirectory("nowpose-figures-").FullName;
        Assert.That(FiguresVerb.Run(Least, _plain, pictures: null, CancellationToken.None), Is.EqualTo(0));
        Assert.That(FiguresVerb.Run(Least, _withPictures, Pictures, CancellationToken.None), Is.EqualTo(0));
    }

    [OneTimeTearDown]
    public void RemoveResults()
    {
        Directory.Delete(_plain, recursive: true);
        Directory.Delete(_withPictures, recursive: true);
    }

    [SetUp]
    public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("nowpose-figures-").FullName;

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, recursive: true);

    [Test]
    public void Run_Completed_WritesEachFigureAndThePage()
    {
        foreach (var number in FigureSet.Numbers)
        {
            var lines = File.ReadAllLines(Path.Combine(_plain, $"figure-{number}.csv"));
            Assert.That(lines, Has.Length.GreaterThan(2), number);
            Assert.That(lines[0], Does.Match("^[A-Za-z0-9_]+(,[A-Za-z0-9_]+)+$"), number);
            foreach (var line in lines.Skip(1)) Assert.That(line, Does.Match(Row()), number);
            Assert.That(lines.Select(line => line.Count(c => c == ',')).Distinct().Count(), Is.EqualTo(1), number);
        }
        var page = File.ReadAllText(Path.Combine(_plain, "figures.html"));
        Assert.That(page, Does.Contain("recomputed").And.Not.Contain("__REPORT_DATA__"));
        Assert.That(page.Contains("\"missing\":[]", StringComparison.Ordinal) || !Nowpose.Web.Pages.Figures.HasPlots);
    }

    [Test]
    public void Run_Twice_WritesTheSameNumbers()
    {
        string[] NumbersIn(string folder) => [.. FigureSet.Numbers.Select(n => File.ReadAllText(Path.Combine(folder, $"figure-{n}.csv")))];

        Assert.That(NumbersIn(_withPictures), Is.EqualTo(NumbersIn(_plain)));
    }

    [Test]
    public void Run_PicturesOption_WritesSvgFilesWithEmbeddedStyles()
    {
        var files = Directory.GetFiles(Pictures);
        Assert.That(files.Select(Path.GetFileName), Does.Contain("swing.svg").And.Contain("error-over-stamp-error.svg"));
        foreach (var file in files)
        {
            var svg = File.ReadAllText(file);
            Assert.That(XDocument.Parse(svg).Root!.Name.LocalName, Is.EqualTo("svg"));
            Assert.That(svg, Does.Not.Contain("var(--").And.Not.Contain("NaN"));
            Assert.That(svg.Length, Is.LessThan(60_000), file);
        }
    }

    [Test]
    public void Run_Interrupted_WritesFinishedFiguresAndExitsWith130()
    {
        File.WriteAllText(Path.Combine(_folder, "figure-4.csv"), "of an earlier run");
        using var cancelled = new CancellationTokenSource();
        cancelled.Cancel();

        var status = FiguresVerb.Run(Least, _folder, pictures: null, cancelled.Token);

        Assert.That(status, Is.EqualTo(130));
        Assert.That(File.Exists(Path.Combine(_folder, "figures.html")), Is.True);
        Assert.That(Directory.GetFiles(_folder, "*.csv"), Is.Empty);
    }

    [Test]
    public async Task Run_OtherLimits_AreStatedOnThePageAndAtTheEnd()
    {
        using var cancelled = new CancellationTokenSource();
        cancelled.Cancel();
        var settings = Least with { Limits = new(1000, 2500, 12_500) };

        var (_, output, _) = await CapturedConsole.OfAsync(
            () => Task.FromResult(FiguresVerb.Run(settings, _folder, pictures: null, cancelled.Token)));

        Assert.That(output, Does.Contain(FigurePageTexts.OtherLimits("1000 mm/s, 2500 mm/s², 12500 mm/s³", MotionLimits.Default.Text)));
        Assert.That(FiguresJson.Of([], settings), Does.Contain("2500 mm/s"));
        Assert.That(FiguresJson.Of([], Least), Does.Not.Contain("--limits"));
    }

    static readonly string[][] InvalidOptions =
    [
        ["--out", ImpossiblePath.BelowAFile("x"), $"--out: {ImpossiblePath.BelowAFile("x")}: cannot be written"],
        ["--pictures", ImpossiblePath.BelowAFile("x"), $"--pictures: {ImpossiblePath.BelowAFile("x")}: cannot be written"],
        ["--phases", "3", "'--phases' is unknown"],
        ["--limits", "1000,5000", "--limits"],
        ["--limits", "1000,5000,0", "--limits"],
        ["--predictor", "quartic", "--predictor"],
    ];

    [TestCaseSource(nameof(InvalidOptions))]
    public async Task Figures_InvalidOption_PrintsOneLineAndExitsWith2(string option, string value, string named)
    {
        var arguments = option == "--out" ? new[] { "figures", option, value } : ["figures", "--out", _folder, option, value];

        var run = await CliRun.OfAsync(arguments);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Complaints, Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(named));
    }

    [Test]
    public void Settings_FullAndQuick_IncludeOurPredictorsAndEnoughPhasesAndSteps()
    {
        foreach (var settings in new[] { FigureSettings.Full, FigureSettings.Quick })
        {
            Assert.That(settings.Ours, Is.EqualTo(new[] { "adaptive", "gp" }));
            Assert.That(settings.Phases, Is.GreaterThanOrEqualTo(8));
            Assert.That(new FigureRun(FigureSet.Studies(settings, default)).Total, Is.GreaterThan(300));
        }
    }

    [Test]
    public void With_FurtherPredictor_IsComparedOnce()
    {
        Assert.That(FigureSettings.With(null), Is.EqualTo(FigureSettings.OurPredictors));
        Assert.That(FigureSettings.With("linear-h4"), Is.EqualTo(FigureSettings.OurPredictors.Append("linear-h4")));
        foreach (var known in new[] { "adaptive", "quadratic", "hold" })
            Assert.That(FigureSettings.With(known), Is.EqualTo(FigureSettings.OurPredictors), known);
    }

    [Test]
    public async Task Figures_HelpOption_ListsTheOptions()
    {
        var run = await CliRun.OfAsync("figures", "--help");

        Assert.That(run.Output, Does.Contain("--out").And.Contain("--quick").And.Contain("--pictures"));
    }

    [GeneratedRegex(@"^-?\d+(\.\d{1,6})?(,(-?\d+(\.\d{1,6})?)?)+$")]
    private static partial Regex Row();
}
