using System.Globalization;
using System.Text;
using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Messages;
using Nowpose.Headless.Tests.Cli;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

public class BodyReplayTests
{
    const string Header = "t_s,x,y,z,qx,qy,qz,qw";

    /// <summary>A row of a body at rest.</summary>
    const string Row = "0.1,0,0,1,0,0,0,1";

    string _folder;
    string _file;

    [SetUp]
    public void WriteRecording()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-body-").FullName;
        _file = Path.Combine(_folder, "body.csv");
        File.WriteAllText(_file, Turning(rows: 41));
    }

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    // The body moves at 1 m/s along x and turns at 1 rad/s about z, with a row every 50 ms. Every second quaternion has the opposite sign.
    static string Turning(int rows)
    {
        var text = new StringBuilder(Header).Append('\n');
        for (var row = 0; row < rows; row++)
        {
            var (t, sign) = (0.05 * row, row % 2 == 0 ? 1 : -1);
            text.Append(CultureInfo.InvariantCulture, $"{t:F3},{t:F3},2,3,0,0,{sign * Math.Sin(t / 2):R},{sign * Math.Cos(t / 2):R}\n");
        }
        return text.ToString();
    }

    static Task<CliRun> Run(params string[] arguments) => CliRun.OfAsync(["replay", .. arguments]);

    async Task<JsonElement> RunJson(params string[] arguments)
    {
        var run = await Run([_file, "--json", .. arguments]);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        return json.RootElement.Clone();
    }

    static string[] Keys(JsonElement element) => [.. element.EnumerateObject().Select(property => property.Name)];

    static double Number(JsonElement result, string quantity, string key) =>
        result.GetProperty("body").GetProperty(quantity).GetProperty(key).GetDouble();

    [Test]
    public async Task Replay_BodyAsJson_HasTheDocumentedKeys()
    {
        var result = await RunJson();

        Assert.That(Keys(result), Is.EqualTo(new[] { "file", "predictor", "frames", "body", "conditions" }));
        Assert.That(Keys(result.GetProperty("body")), Is.EqualTo(new[] { "error_mm", "error_deg" }));
        Assert.That(Keys(result.GetProperty("body").GetProperty("error_mm")), Is.EqualTo(new[] { "rms_hold", "rms", "p95" }));
        Assert.That(Keys(result.GetProperty("body").GetProperty("error_deg")), Is.EqualTo(new[] { "rms_hold", "rms", "p95" }));
        Assert.That(result.GetProperty("file").GetString(), Is.EqualTo(_file));
        Assert.That(result.GetProperty("predictor").GetString(), Is.EqualTo("adaptive"));
    }

    // At 20 frames per second, the newest sample is 100 ms old in each frame. Sample 4 arrives at 0.3 s, so frames from 0.3 to 2 s are scored.
    [TestCase("hold", 100, 5.729577951308232)]
    [TestCase("linear", 0, 0)]
    public async Task Replay_BodyWithConstantVelocities_HasTheComputedErrors(string predictor, double errorMm, double errorDegrees)
    {
        var result = await RunJson("--predictor", predictor, "--fps=20", "--sampling-ms=50", "--latency-ms=100");

        Assert.That(result.GetProperty("frames").GetInt32(), Is.EqualTo(35));
        Assert.That(Number(result, "error_mm", "rms_hold"), Is.EqualTo(100).Within(1e-6));
        Assert.That(Number(result, "error_deg", "rms_hold"), Is.EqualTo(5.729577951308232).Within(1e-6));
        foreach (var key in new[] { "rms", "p95" })
        {
            Assert.That(Number(result, "error_mm", key), Is.EqualTo(errorMm).Within(1e-6), key);
            Assert.That(Number(result, "error_deg", key), Is.EqualTo(errorDegrees).Within(1e-6), key);
        }
    }

    [TestCase("--latency-ms=200", "rms_hold", 1)]
    [TestCase("--latency-error-ms=20", "rms", 1)]
    [TestCase("--stamp-error-ms=5", "rms", 1)]
    [TestCase("--jitter-ms=40", "rms_hold", 1)]
    [TestCase("--loss=0.3", "rms_hold", 1)]
    public async Task Replay_OptionForABody_IsApplied(string option, string key, int sign)
    {
        var plain = await RunJson("--predictor=linear");

        var changed = await RunJson("--predictor=linear", option);

        foreach (var quantity in new[] { "error_mm", "error_deg" })
            Assert.That(sign * (Number(changed, quantity, key) - Number(plain, quantity, key)), Is.GreaterThan(0.01), quantity);
    }

    [Test]
    public async Task Replay_BodyWithEachPredictor_Succeeds(
        [Values("quadratic", "cubic", "quadratic-h3", "quadratic-h4", "gp", "adaptive")] string predictor)
    {
        var result = await RunJson("--predictor", predictor);

        Assert.That(Number(result, "error_mm", "rms"), Is.LessThan(5));
        Assert.That(Number(result, "error_deg", "rms"), Is.LessThan(0.3));
    }

    [Test]
    public async Task Replay_Body_PrintsPositionAndRotation()
    {
        var run = await Run(_file, "--predictor=hold", "--fps=20");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Output, Does.Contain("position, mm").And.Contain("rotation, °"));
    }

    [Test]
    public async Task Replay_RoundedQuaternions_AreAccepted()
    {
        File.WriteAllText(_file, $"{Header}\n0,0,0,1,0,0,0.7067,0.7067\n2,0,0,1,0,0,0.7075,0.7075\n");

        var result = await RunJson();

        Assert.That(Number(result, "error_deg", "rms"), Is.LessThan(1e-6));
    }

    static readonly string[][] InvalidRows =
    [
        ["0,0,0,1,0,0,0,1.01", MotionFileMessages.NormRange("qx,qy,qz,qw", 1.01, 0.999, 1.001)],
        ["0.2,0,0,1,0,0,0,0", MotionFileMessages.NormRange("qx,qy,qz,qw", 0, 0.999, 1.001)],
        ["0.2,0,0,1,NaN,0,0,1", MotionFileMessages.NotFinite("'qx'", "'NaN'")],
        ["0.2,0,0,one,0,0,0,1", MotionFileMessages.NotANumber("'z'", "'one'")],
        ["0.2,0,0,1,0,0,0", MotionFileMessages.FieldCount(7, 8)],
        ["0.2,0,0,1,0,0,0,1,5", MotionFileMessages.FieldCount(9, 8)],
        ["0.1,0,0,1,0,0,0,1", MotionFileMessages.TimeOrder("t_s", "'0.1'")],
    ];

    [TestCaseSource(nameof(InvalidRows))]
    public async Task Replay_InvalidRowInABodyFile_PrintsOneLineWithPlaceAndValue(string row, string message)
    {
        // A row with the invalid length 1.01 follows a valid row.
        var first = row.StartsWith("0,", StringComparison.Ordinal) ? Row.Replace("0.1,", "-0.1,", StringComparison.Ordinal) : Row;
        File.WriteAllText(_file, $"{Header}\n{first}\n{row}\n");

        AssertRefused(await Run(_file), $"{_file}:3: {message}");
    }

    [TestCase("t,x,y,z,qx,qy,qz,qw")]
    [TestCase("t_s,x,y,z,qw,qx,qy,qz")]
    [TestCase("t_s,px,py,pz,qx,qy,qz,qw")]
    [TestCase("timestamp,x,y,z,qx,qy,qz,qw")]
    [TestCase("t_s,x,y,z,Qx,Qy,Qz,Qw")]
    [TestCase("t_s,x,y,z,qx,qy,qz,qw,extra")]
    [TestCase("t_s,x,y,z,qx,qy,qz")]
    public async Task Replay_SimilarHeader_PrintsOneLineWithTheExpectedHeader(string header)
    {
        File.WriteAllText(_file, $"{header}\n{Row}\n0.2,0,0,1,0,0,0,1\n");

        AssertRefused(await Run(_file), $"{_file}:1: {MotionFileMessages.BodyHeader($"'{header}'", Header)}");
    }

    [Test]
    public async Task Recommend_Body_PrintsOneLineAndFails() =>
        AssertRefused(await CliRun.OfAsync(["recommend", _file]), RecommendMessages.RigidBody(_file));

    static void AssertRefused(CliRun run, string message)
    {
        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Output);
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(message)));
    }
}
