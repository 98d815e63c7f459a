using System.Globalization;
using System.Text;
using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

public class SyncVerbTests
{
    internal const long ControlEpoch = 1_700_000_000_000_000_000;
    const string Header = "t1_ns,t2_ns,t3_ns,t4_ns\n";

    /// <summary>
    /// Returns a log of exchanges with a delay of 2 ms in each direction. The headset clock is 50 ppm fast. t4 is not a multiple of 100 ns.
    /// </summary>
    internal static string Log(int exchanges)
    {
        var log = new StringBuilder(Header);
        for (var i = 0; i < exchanges; i++)
        {
            var t1 = 7 + i * 200_000_000L;
            var control = ControlEpoch + t1 + 2_000_000 - (long)(i * 200_000_000L * 50e-6);
            log.Append(CultureInfo.InvariantCulture, $"{t1},{control},{control},{t1 + 4_000_000}\n");
        }
        return log.ToString();
    }

    [TestCase(".csv")]
    [TestCase(".csv.gz")]
    public async Task Sync_SymmetricLog_FollowsOffsetAndSkew(string ending)
    {
        using var file = new TemporaryFile(Log(200), ending);

        var run = await CliRun.OfAsync("sync", file.Path, "--estimator", "ransac");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Lines[0], Is.EqualTo("t4_ns,offset_ns,skew_ppm,error_bound_ns,state,estimated_error_ns"));
        Assert.That(run.Lines, Has.Length.EqualTo(201));
        var last = run.Lines[^1].Split(',');
        var t4 = 7 + 199 * 200_000_000L + 4_000_000;
        Assert.That(last[0], Is.EqualTo(t4.ToString(CultureInfo.InvariantCulture)), "t4 is printed with all its nanoseconds");
        var expected = -ControlEpoch + 199 * 200_000_000L * 50 / 1_000_000;
        Assert.That(long.Parse(last[1], CultureInfo.InvariantCulture) - expected, Is.EqualTo(0).Within(2000));
        Assert.That(double.Parse(last[2], CultureInfo.InvariantCulture), Is.EqualTo(50).Within(0.1));
        Assert.That(long.Parse(last[3], CultureInfo.InvariantCulture), Is.EqualTo(2_000_000).Within(20_000), "half the round trip");
        Assert.That(last[4], Is.EqualTo("synchronised"));
        Assert.That(run.Lines[1].Split(',')[4], Is.EqualTo("converging"));
    }

    [Test]
    public async Task Sync_AtOption_UsesOnlyEarlierExchanges()
    {
        using var file = new TemporaryFile(Log(100));
        using var instants = new TemporaryFile("t_ns\n1\n4000007\n10000000000\n60000000000\n");

        var run = await CliRun.OfAsync("sync", file.Path, "--at", instants.Path);

        Assert.That(run.Lines[0], Is.EqualTo("t_ns,offset_ns,error_bound_ns,state"));
        Assert.That(run.Lines[1], Is.EqualTo("1,,,unsynchronised"));
        Assert.That(run.Lines[2], Does.StartWith("4000007,-").And.EndWith(",converging"), "an instant equal to t4 includes the exchange");
        Assert.That(run.Lines[3], Does.EndWith(",synchronised"));
        Assert.That(run.Lines[4], Does.EndWith(",holdover"));
    }

    [Test]
    public async Task Sync_JsonOption_HasTheSameFieldsAsCsv()
    {
        using var file = new TemporaryFile(Log(5));

        var run = await CliRun.OfAsync("sync", file.Path, "--json");

        var first = JsonDocument.Parse(run.Output).RootElement[0];
        Assert.That(first.GetProperty("t4_ns").GetInt64(), Is.EqualTo(4_000_007));
        Assert.That(first.GetProperty("state").GetString(), Is.EqualTo("converging"));
        Assert.That(first.GetProperty("estimated_error_ns").GetInt64(), Is.GreaterThan(0).And.LessThanOrEqualTo(first.GetProperty("error_bound_ns").GetInt64()));
        Assert.That(first.GetProperty("offset_ns").GetInt64(), Is.EqualTo(-ControlEpoch).Within(1000));
    }

    /// <summary>Returns a log of exchanges at irregular times with short delays. The time stamps of the control clock are whole cycles.</summary>
    static string LogOfCycles(long cycleNs, int rows = 400, int before = 0)
    {
        var random = new Random(5);
        var log = new StringBuilder(Header);
        long Stamp(long t) => (ControlEpoch + t) / cycleNs * cycleNs;
        for (var i = before; i < before + rows; i++)
        {
            var t1 = i * 200_000_000L + random.Next(9_000_000);
            var (t2, t4) = (t1 + 150_000 + random.Next(100_000), t1 + 500_000 + random.Next(100_000));
            log.Append(CultureInfo.InvariantCulture, $"{t1},{Stamp(t2)},{Stamp(t2 + 20_000)},{t4}\n");
        }
        return log.ToString();
    }

    [TestCase(1_000_000)]
    [TestCase(4_000_000)]
    public async Task Sync_ControlClockStampsWholeCycles_HasNoBias(long cycleNs)
    {
        using var file = new TemporaryFile(LogOfCycles(cycleNs));

        var run = await CliRun.OfAsync("sync", file.Path);

        var error = long.Parse(run.Lines[^1].Split(',')[1], CultureInfo.InvariantCulture) + ControlEpoch;
        Assert.That(error, Is.EqualTo(0).Within(cycleNs / 8), "seed 5; half a cycle would be too much");
    }

    /// <summary>The cycle time changes, so that the log shows another resolution from row 101 on.</summary>
    static string LogOfTwoCycles => LogOfCycles(4_000_000, 100) + LogOfCycles(1_000_000, 50, before: 100)[Header.Length..];

    [TestCase(12)]
    [TestCase(20)]
    [TestCase(60)]
    [TestCase(110)]
    public async Task Sync_ControlClockStampsWholeCycles_EstimatesFromTheEarlierRowsOnly(int rows)
    {
        var log = LogOfTwoCycles.Split('\n');
        using var file = new TemporaryFile(LogOfTwoCycles);
        using var part = new TemporaryFile(string.Join('\n', log[..(rows + 1)]) + "\n");
        using var instants = new TemporaryFile($"t_ns\n{log[rows].Split(',')[3]}\n");

        var whole = await CliRun.OfAsync("sync", file.Path);
        var partial = await CliRun.OfAsync("sync", part.Path);
        var wholeAt = await CliRun.OfAsync("sync", file.Path, "--at", instants.Path);
        var partialAt = await CliRun.OfAsync("sync", part.Path, "--at", instants.Path);

        Assert.That(partial.Lines, Is.EqualTo(whole.Lines[..(rows + 1)]), "seed 5");
        Assert.That(wholeAt.Output, Is.EqualTo(partialAt.Output), "seed 5");
    }

    [Test]
    public async Task Sync_ControlClockStampsWholeCycles_HasNoBiasOnceSynchronised()
    {
        using var file = new TemporaryFile(LogOfCycles(1_000_000));

        var run = await CliRun.OfAsync("sync", file.Path);

        var first = run.Lines.First(line => line.Contains("synchronised", StringComparison.Ordinal)).Split(',');
        Assert.That(long.Parse(first[1], CultureInfo.InvariantCulture) + ControlEpoch, Is.EqualTo(0).Within(250_000), "seed 5; half a cycle is 500 µs");
        Assert.That(run.Errors, Is.Empty, "no exchange is dropped");
    }

    [Test]
    public async Task Sync_EstimatorOption_ChangesTheEstimates()
    {
        using var file = new TemporaryFile(LogOfCycles(1));

        var ours = await CliRun.OfAsync("sync", file.Path, "--estimator", "default");
        var papers = await CliRun.OfAsync("sync", file.Path, "--estimator", "ransac");
        var unsaid = await CliRun.OfAsync("sync", file.Path);

        Assert.That(ours.Lines[^1].Split(',')[1], Is.Not.EqualTo(papers.Lines[^1].Split(',')[1]));
        Assert.That(unsaid.Output, Is.EqualTo(ours.Output));
    }

    [Test]
    public async Task Sync_InvalidExchanges_SkipsAndCountsThem()
    {
        using var file = new TemporaryFile(Log(30) + "6000000007,5000,4000,6004000007\n6200000007,5,6,6100000000\n");

        var run = await CliRun.OfAsync("sync", file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(run.Lines, Has.Length.EqualTo(33), "one line per exchange, dropped ones too");
        Assert.That(run.Errors, Does.Contain(ConsoleMessages.DroppedExchanges(file.Path, 1, 32, SyncExchangeFault.ControlTimeReversed)));
        Assert.That(run.Errors, Does.Contain(ConsoleMessages.DroppedExchanges(file.Path, 1, 32, SyncExchangeFault.HeadsetTimeReversed)));
    }

    // With the columns of the two clocks exchanged, the control system takes longer than the complete exchange.
    [TestCase(1, 0, 3, 2, nameof(SyncExchangeFault.NegativeRoundTrip))]
    [TestCase(3, 1, 2, 0, nameof(SyncExchangeFault.HeadsetTimeReversed))]
    public async Task Sync_EveryExchangeDropped_PrintsEachAndNamesTheCause(int t1, int t2, int t3, int t4, string fault)
    {
        string Exchanged(string line) => string.Join(',', new[] { t1, t2, t3, t4 }.Select(column => line.Split(',')[column]));
        using var file = new TemporaryFile(Header + string.Join('\n', Log(20).TrimEnd().Split('\n').Skip(1).Select(Exchanged)) + "\n");

        var run = await CliRun.OfAsync("sync", file.Path);

        Assert.That((run.ExitStatus, run.Lines.Length), Is.EqualTo((0, 21)), "a line for each exchange");
        var message = ExchangeFileMessages.AllDropped(file.Path, 20, [Enum.Parse<SyncExchangeFault>(fault)]);
        Assert.That(run.Complaints, Is.EqualTo(new[] { ConsoleMessages.Line(message) }));
    }

    [Test]
    public async Task Sync_AllInstantsBeforeTheExchanges_IsNoError()
    {
        using var file = new TemporaryFile(Log(20));
        using var instants = new TemporaryFile("t_ns\n1\n");

        var run = await CliRun.OfAsync("sync", file.Path, "--at", instants.Path);

        Assert.That((run.ExitStatus, run.Lines[1]), Is.EqualTo((0, "1,,,unsynchronised")));
    }

    static readonly string[][] InvalidFiles =
    [
        ["", ":1: " + TableMessages.Header("", Header.TrimEnd())],
        ["a,b\n1,2\n", ":1: " + TableMessages.Header("a,b", Header.TrimEnd())],
        [Header, TableMessages.NoRows("", 1)],
        [Header + "1,2,3\n", ":2: " + TableMessages.FieldCount(3, 4)],
        [Header + "1,2,,4\n", ":2: " + TableMessages.NotWhole("t3_ns", "", "nanoseconds")],
        [Header + "1,2,3,4\n1,2.5,3,4\n", ":3: " + TableMessages.NotWhole("t2_ns", "2.5", "nanoseconds")],
        [Header + "1,2,3,4\n\n\"5,6,7,8\n9,10,11,12\n13,14,15,16\n", ":4: " + TableMessages.FieldCount(1, 4)],
        [Header + "1,2,3,99999999999999999999\n", ":2: " + TableMessages.NotWhole("t4_ns", "99999999999999999999", "nanoseconds")],
    ];

    [TestCaseSource(nameof(InvalidFiles))]
    public async Task Sync_InvalidFile_PrintsOneLineAndExitsWith2(string content, string message)
    {
        using var file = new TemporaryFile(content);

        var run = await CliRun.OfAsync("sync", file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.StartWith(ConsoleMessages.Line(file.Path + message)));
    }

    [Test]
    public async Task Sync_InstantsWithALogInAnotherOrder_UsesAllExchangesUntilEachInstant()
    {
        var lines = Log(40).TrimEnd('\n').Split('\n');
        using var file = new TemporaryFile(Log(40));
        using var moved = new TemporaryFile(string.Join('\n', [lines[0], lines[^1], .. lines[1..^1]]) + "\n");
        using var instants = new TemporaryFile("t_ns\n3000000000\n9000000000\n");

        var expected = await CliRun.OfAsync("sync", file.Path, "--at", instants.Path);
        var run = await CliRun.OfAsync("sync", moved.Path, "--at", instants.Path);

        Assert.That(run.Lines[1], Does.Not.Contain("unsynchronised"));
        Assert.That(run.Output, Is.EqualTo(expected.Output));
    }

    [TestCase("t_ns\n5\n5\n", 3)]
    [TestCase("t_ns\n\n5\n\n5\n", 5)]
    public async Task Sync_InstantsNotIncreasing_NamesTheLine(string content, int line)
    {
        using var file = new TemporaryFile(Log(5));
        using var instants = new TemporaryFile(content);

        var run = await CliRun.OfAsync("sync", file.Path, "--at", instants.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain($"{instants.Path}:{line}: " + ExchangeFileMessages.TimeOrder(5, 5)));
    }
}
