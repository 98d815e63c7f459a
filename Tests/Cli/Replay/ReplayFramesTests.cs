using System.Globalization;
using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Headless.Tests.Cli.SessionFiles;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

/// <summary>Tests the file with the values of each scored frame.</summary>
public class ReplayFramesTests
{
    string _folder;
    string _file;

    [SetUp]
    public void WriteRecording()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-replay-").FullName;
        _file = new MotionFile(10, MotionFile.EvenTimes(4, 0.01m), Math.Sin, t => Math.Cos(2 * t)).WriteTo(_folder);
    }

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    [Test]
    public async Task Replay_FramesOption_WritesTheValuesOfEachFrame()
    {
        var frames = Path.Combine(_folder, "frames.csv");

        var run = await CliRun.OfAsync("replay", _file, "--json", "--predictor", "gp", "--frames", frames);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        var result = json.RootElement;
        var lines = await File.ReadAllLinesAsync(frames);
        Assert.That(lines[0], Is.EqualTo("t_s,axis,unit,truth,hold,predicted,sd,object,frame,pass,light_ns"));
        var rows = lines.Skip(1).Select(line => line.Split(',')).ToList();
        Assert.That(rows, Has.Count.EqualTo(2 * result.GetProperty("frames").GetInt32()));
        Assert.That((rows[^1][0], rows[^1][^1]), Is.EqualTo(("4", "4000000000")));
        foreach (var axis in result.GetProperty("axes").EnumerateArray())
        {
            double Of(string key) => axis.GetProperty(key).GetDouble();
            var name = axis.GetProperty("name").GetString();
            var ofAxis = rows.Where(row => row[1] == name).Select(row => row[3..7].Select(Number).ToArray()).ToList();
            Assert.That(Math.Sqrt(ofAxis.Average(row => Math.Pow(row[1] - row[0], 2))), Is.EqualTo(Of("rms_hold")).Within(1e-9));
            Assert.That(Math.Sqrt(ofAxis.Average(row => Math.Pow(row[2] - row[0], 2))), Is.EqualTo(Of("rms")).Within(1e-9));
            Assert.That(ofAxis.Where(row => !double.IsNaN(row[3])).Average(row => row[3]), Is.EqualTo(Of("sd")).Within(1e-9));
        }
    }

    static double Number(string text) =>
        text.Length == 0 ? double.NaN : double.Parse(text, CultureInfo.InvariantCulture);

    [Test]
    public async Task Replay_FramesOptionWithTheInput_IsRefused()
    {
        var run = await CliRun.OfAsync("replay", _file, "--frames", _file);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Errors, Does.Contain("--frames"));
        Assert.That(await File.ReadAllTextAsync(_file), Does.StartWith("t,"));
    }

    [Test]
    public async Task Replay_FramesOptionWithACompressedFile_IsRefused()
    {
        var frames = Path.Combine(_folder, "frames.csv.gz");

        var run = await CliRun.OfAsync("replay", _file, "--frames", frames);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Errors, Does.Contain(OptionValueMessages.NotCompressed("--frames", frames)));
        Assert.That(File.Exists(frames), Is.False);
    }

    [Test]
    public async Task Replay_FramesOfASession_HaveUnitsAndControlTimes()
    {
        var (session, frames) = (Path.Combine(_folder, "session.jsonl"), Path.Combine(_folder, "frames.csv"));
        VirtualRecording.To(session, seconds: 8);

        var run = await CliRun.OfAsync("replay", session, "--frames", frames);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var rows = (await File.ReadAllLinesAsync(frames)).Skip(1).Select(line => line.Split(',')).ToList();
        Assert.That(rows.Select(row => row[2]).Distinct(), Is.EquivalentTo(new[] { "rad", "m" }));
        Assert.That(rows.Select(row => Number(row[0])), Is.Ordered.And.All.InRange(1_700_000_500, 1_700_000_509));
    }

    // A script joins the rows of each frame with the line of the frame in the session.
    [Test]
    public async Task Replay_FramesOfASession_HaveTheDisplayTimesOfTheSession()
    {
        var (session, frames) = (Path.Combine(_folder, "session.jsonl"), Path.Combine(_folder, "frames.csv"));
        VirtualRecording.To(session, seconds: 8);

        await CliRun.OfAsync("replay", session, "--frames", frames);

        var displayed = File.ReadLines(session).Where(line => line.StartsWith("{\"kind\":\"frame\"", StringComparison.Ordinal))
            .Select(line => JsonDocument.Parse(line).RootElement).Where(line => line.TryGetProperty("light_ns", out _))
            .Select(line => line.GetProperty("light_ns").GetRawText()).ToHashSet();
        var rows = (await File.ReadAllLinesAsync(frames)).Skip(1).Select(line => line.Split(',')[^1]).Distinct().ToList();
        Assert.That(rows, Has.Count.GreaterThan(200));
        Assert.That(rows.Where(time => !displayed.Contains(time)), Is.Empty);
    }

    [Test]
    public async Task Replay_FramesOfSeveralPasses_HaveTheErrorsOfEachPass([Values] bool isBody)
    {
        var frames = Path.Combine(_folder, "frames.csv");
        var body = Path.Combine(_folder, "body.csv");
        var lines = Enumerable.Range(0, 300).Select(i => FormattableString.Invariant($"{i / 100.0},{Math.Sin(i / 50.0)},0,0,0,0,0,1"));
        await File.WriteAllLinesAsync(body, ["t_s,x,y,z,qx,qy,qz,qw", .. lines]);

        var run = await CliRun.OfAsync("replay", isBody ? body : _file, "--phases", "3", "--json", "--frames", frames);

        using var json = JsonDocument.Parse(run.Output);
        var rows = (await File.ReadAllLinesAsync(frames)).Skip(1).Select(line => line.Split(',')).Where(row => row[1] != "angle").ToList();
        var passes = rows.GroupBy(row => row[^2]).ToList();
        Assert.That(passes.Select(pass => pass.Key), Is.EqualTo(new[] { "1", "2", "3" }));
        foreach (var (pass, expected) in passes.Zip(json.RootElement.GetProperty("passes").EnumerateArray()))
        {
            var square = pass.GroupBy(row => row[1]).Sum(axis => axis.Average(row => Math.Pow(Number(row[5]) - Number(row[3]), 2)));
            Assert.That((isBody ? 1000 : 1) * Math.Sqrt(square), Is.EqualTo(expected.GetProperty("rms").GetDouble()).Within(1e-9));
        }
    }

    [Test]
    public async Task Replay_FramesOfASessionWithObjects_HaveTheErrorsOfTheObjects()
    {
        var (session, frames) = (Path.Combine(_folder, "session.jsonl"), Path.Combine(_folder, "frames.csv"));
        VirtualRecording.To(session, seconds: 20, hasWork: true);

        var run = await CliRun.OfAsync("replay", session, "--json", "--frames", frames);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var rows = (await File.ReadAllLinesAsync(frames)).Skip(1).Select(line => line.Split(',')).ToList();
        var ofObjects = rows.Where(row => row[7].Length > 0).GroupBy(row => row[7]).ToDictionary(group => group.Key, group => group.ToList());
        Assert.That(rows.Where(row => row[7].Length == 0).Select(row => row[8]), Is.All.Empty, "joints have no frame");
        Assert.That(rows.Where(row => row[7].Length > 0).Select(row => row[8]).Distinct(), Is.EqualTo(new[] { "world" }));
        using var json = JsonDocument.Parse(run.Output);
        var bodies = json.RootElement.GetProperty("bodies").EnumerateArray().ToList();
        Assert.That(ofObjects.Keys, Is.EquivalentTo(bodies.Select(body => body.GetProperty("name").GetString())));
        foreach (var body in bodies)
        {
            var own = ofObjects[body.GetProperty("name").GetString()];
            Assert.That(own, Has.Count.EqualTo(4 * body.GetProperty("frames").GetInt32()));
            Assert.That(own.Take(4).Select(row => row[1] + " " + row[2]), Is.EqualTo(new[] { "x m", "y m", "z m", "angle deg" }));
            double Squares(int column, bool isAngle) =>
                own.Where(row => row[1] == "angle" == isAngle).Sum(row => Math.Pow(Number(row[column]) - Number(row[3]), 2)) / (own.Count / 4);
            void AssertError(string kind, double scale, bool isAngle)
            {
                double Of(string key) => body.GetProperty(kind).GetProperty(key).GetDouble();
                Assert.That(scale * Math.Sqrt(Squares(4, isAngle)), Is.EqualTo(Of("rms_hold")).Within(1e-6));
                Assert.That(scale * Math.Sqrt(Squares(5, isAngle)), Is.EqualTo(Of("rms")).Within(1e-6));
            }
            AssertError("error_mm", 1000, isAngle: false);
            AssertError("error_deg", 1, isAngle: true);
        }
    }

    [Test]
    public async Task Replay_FramesOfABody_HavePositionAndAngle()
    {
        var (body, frames) = (Path.Combine(_folder, "body.csv"), Path.Combine(_folder, "frames.csv"));
        var lines = Enumerable.Range(0, 300).Select(i => FormattableString.Invariant($"{i / 100.0},{Math.Sin(i / 50.0)},0,0,0,0,0,1"));
        await File.WriteAllLinesAsync(body, ["t_s,x,y,z,qx,qy,qz,qw", .. lines]);

        var run = await CliRun.OfAsync("replay", body, "--frames", frames);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var rows = (await File.ReadAllLinesAsync(frames)).Skip(1).Select(line => line.Split(',')).ToList();
        Assert.That(rows.Take(4).Select(row => row[1] + " " + row[2]), Is.EqualTo(new[] { "x m", "y m", "z m", "angle deg" }));
        Assert.That(rows.Where(row => row[1] == "x").Max(row => Math.Abs(Number(row[4]) - Number(row[3]))), Is.InRange(0.1, 0.5));
    }
}
