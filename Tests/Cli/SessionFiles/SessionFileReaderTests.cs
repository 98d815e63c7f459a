using Nowpose.Cli.Messages;
using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Messages;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

public class SessionFileReaderTests
{
    const string Header = """
        {"kind":"session","format":"nowpose-session","version":1,"robot":{"name":"r","joints":[{"name":"a","unit":"rad","upper":2},{"name":"b","unit":"m"}]},"settings":{"predictor":"linear","horizon_cap_ms":300,"maximum_gap_ms":500}}
        """;

    const string Sample = """{"kind":"sample","arrival_ns":200,"stamp_ns":100,"names":["a"],"position":[0.5]}""";

    const string Plan = """
        {"kind":"plan","arrival_ns":200,"stamp_ns":100,"names":["a","b"],"points":[{"time_from_start_ns":0,"position":[1,2]},{"time_from_start_ns":500000000,"position":[0.5,0.75],"velocity":[null,2]}]}
        """;

    static List<SessionLine> Read(string text)
    {
        using var file = new TemporaryFile(text, ".jsonl");
        using var reader = new SessionFileReader(file.Path);
        return [.. reader.Lines()];
    }

    [Test]
    public void Header_Fields_AreRead()
    {
        using var file = new TemporaryFile(Header, ".jsonl");

        using var reader = new SessionFileReader(file.Path);

        Assert.That(reader.Header.Joints.Select(j => j.Name + " " + j.Unit), Is.EqualTo(new[] { "a rad", "b m" }));
        Assert.That(reader.Header.Joints[0].Limits.Upper, Is.EqualTo(2));
        Assert.That(reader.Header.Joints[0].Limits.Lower, Is.EqualTo(double.NegativeInfinity));
        Assert.That(reader.Header.Prediction.Predictor, Is.EqualTo("linear"));
    }

    [Test]
    public void Line_UnknownKindOrField_IsIgnored()
    {
        var lines = Read(Header + "\n{\"kind\":\"weather\",\"rain\":true}\n" + Sample.Replace("}", ",\"more\":1}") + "\n");

        Assert.That(lines, Has.Count.EqualTo(1));
        Assert.That(((SampleLine)lines[0]).Stamp.Nanoseconds, Is.EqualTo(100));
    }

    [Test]
    public void Line_Truncated_IsAcceptedOnlyAtTheEnd()
    {
        Assert.That(Read(Header + "\n" + Sample + "\n" + Sample[..30]), Has.Count.EqualTo(1));

        var torn = Assert.Throws<InputException>(() => Read(Header + "\n" + Sample[..30] + "\n" + Sample + "\n"));
        Assert.That(torn.Message, Does.Contain(SessionFileMessages.NotJson(".jsonl:2", "")).And.Not.Contains("LineNumber"));
    }

    [Test]
    public void Line_SecondHeader_IsRefused()
    {
        var fault = Assert.Throws<InputException>(() => Read(Header + "\n" + Sample + "\n" + Header + "\n" + Sample + "\n"));

        Assert.That(fault.Message, Does.EndWith(SessionFileMessages.SecondHeader(".jsonl:3")));
    }

    static readonly string[][] OtherFiles =
    [
        ["", SessionFileMessages.Empty(".jsonl")],
        ["t,a\n0,1\n", SessionFileMessages.NotJson(".jsonl:1", "")],
        ["[]", SessionFileMessages.LineNotAnObject(".jsonl:1")],
        ["""{"kind":"session"}""", SessionFileMessages.OtherFormat(".jsonl:1", "nowpose-session")],
        ["""{"kind":"session","format":"nowpose-session","version":2}""", SessionFileMessages.NewerVersion(".jsonl:1", 2, 1)],
        ["""{"kind":"session","format":"nowpose-session","version":1}""", Field(1, "robot", SessionFileMessages.Missing)],
    ];

    [TestCaseSource(nameof(OtherFiles))]
    public void File_NotASession_ThrowsWithAOneLineMessage(string text, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(text));

        Assert.That(fault.Message, Does.Contain(expected).And.Not.Contain("\n"));
    }

    static readonly string[][] InvalidHeaders =
    [
        ["\"linear\"", "\"quartic\"", "settings", PredictionMessages.UnknownPredictor("quartic", string.Join(", ", Predictors.Names))],
        ["300", "-1", "settings", SettingMessages.OutOfRange("horizon cap", -1, " ms", 0, 5000)],
        ["300", "\"x\"", "horizon_cap_ms", SessionFileMessages.NotFinite("\"x\"")],
        ["\"upper\":2", "\"upper\":2,\"lower\":3", "lower", SessionFileMessages.LimitOrder(3, 2)],
        ["\"upper\":2", "\"velocity\":0", "velocity", SessionFileMessages.Limit(0)],
        ["\"b\"", "\"a\"", "joints", SessionFileMessages.JointTwice("a")],
    ];

    [TestCaseSource(nameof(InvalidHeaders))]
    public void Header_Invalid_NamesTheField(string right, string wrong, string field, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(Header.Replace(right, wrong)));

        Assert.That(fault.Message, Does.EndWith(Field(1, field, expected)));
    }

    static readonly string[][] InvalidLines =
    [
        ["""{"stamp_ns":1}""", "kind", SessionFileMessages.Missing],
        ["""{"kind":"sample","arrival_ns":1,"names":["a"],"position":[1]}""", "stamp_ns", SessionFileMessages.Missing],
        ["""{"kind":"sample","arrival_ns":1.5,"stamp_ns":1,"names":["a"],"position":[1]}""", "arrival_ns", SessionFileMessages.NotWhole("1.5")],
        [
            """{"kind":"sample","arrival_ns":1,"stamp_ns":1,"names":["a"],"position":[null]}""", "position",
            SessionFileMessages.ElementNotFinite(1, "null"),
        ],
        ["""{"kind":"sample","arrival_ns":1,"stamp_ns":1,"names":["a"],"position":[1,2]}""", "position", SessionFileMessages.Count(2, 1)],
        ["""{"kind":"sample","arrival_ns":1,"stamp_ns":1,"names":"a","position":[1]}""", "names", SessionFileMessages.NotAnArray],
        ["""{"kind":"frame","start_ns":1,"joints":7}""", "joints", SessionFileMessages.NotAnArray],
        [
            """{"kind":"object","start_ns":1,"frame":"part","state":"current","position":[0,0,0],"rotation":[0,0,0,2]}""", "rotation",
            SessionFileMessages.NotARotation,
        ],
        [
            """{"kind":"sync","t1_ns":1,"t2_ns":99999999999999999999,"t3_ns":1,"t4_ns":1}""", "t2_ns",
            SessionFileMessages.NotWhole("99999999999999999999"),
        ],
        [
            """{"kind":"sync","t1_ns":1,"t2_ns":1,"t3_ns":1,"t4_ns":1,"server_bound_ns":-1}""", "server_bound_ns",
            SessionFileMessages.Nanoseconds(-1, 4294967295000),
        ],
        [
            """{"kind":"sync","t1_ns":1,"t2_ns":1,"t3_ns":1,"t4_ns":1,"resolution_ns":5000000000}""", "resolution_ns",
            SessionFileMessages.Nanoseconds(5_000_000_000, 4294967295),
        ],
        ["""{"kind":"\ud800"}""", "kind", SessionFileMessages.NotAString],
        [
            """{"kind":"sample","arrival_ns":1,"stamp_ns":1,"names":["a","\ud800"],"position":[1,2]}""", "names",
            SessionFileMessages.ElementNotAString(2, "\"\\ud800\""),
        ],
    ];

    [TestCaseSource(nameof(InvalidLines))]
    public void Line_Invalid_NamesTheField(string line, string field, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(Header + "\n" + Sample + "\n" + line + "\n" + Sample + "\n"));

        Assert.That(fault.Message, Does.EndWith(Field(3, field, expected)));
    }

    [Test]
    public void Plan_Fields_AreRead()
    {
        var line = (PlanLine)Read(Header + "\n" + Plan + "\n")[0];

        var message = line.Arrival.Message;
        Assert.That(line.Arrival.At.Nanoseconds, Is.EqualTo(200));
        Assert.That(message.Stamp.Nanoseconds, Is.EqualTo(100));
        Assert.That(message.Names, Is.EqualTo(new[] { "a", "b" }));
        Assert.That(message.Points.Select(p => p.TimeFromStart.Ticks), Is.EqualTo(new[] { 0, 5_000_000 }));
        Assert.That(message.Points[1].Positions, Is.EqualTo(new[] { 0.5, 0.75 }));
        Assert.That(message.Points[1].Velocities, Is.EqualTo(new[] { double.NaN, 2 }));
        Assert.That(message.Points[1].Accelerations, Is.Null);
        Assert.That(line.Dropped, Is.Null);
    }

    static readonly string[][] InvalidPlans =
    [
        ["500000000", "0", "time_from_start_ns", SessionFileMessages.PointOrder(2)],
        ["[0.5,0.75]", "[0.5]", "position", SessionFileMessages.Count(1, 2)],
        ["\"points\":[", "\"points\":[7,", "points", SessionFileMessages.ValueNotAnObject("7")],
        ["\"points\"", "\"dots\"", "points", SessionFileMessages.Missing],
    ];

    [TestCaseSource(nameof(InvalidPlans))]
    public void Plan_Invalid_NamesTheField(string right, string wrong, string field, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(Header + "\n" + Plan.Replace(right, wrong) + "\n" + Sample + "\n"));

        Assert.That(fault.Message, Does.EndWith(Field(2, field, expected)));
    }

    [TestCase("a.jsonl", true)]
    [TestCase("a.JSONL.gz", true)]
    [TestCase("a.csv", false)]
    [TestCase("a.json", false)]
    [TestCase(null, false)]
    public void IsSession_Path_DependsOnTheName(string path, bool expected)
    {
        Assert.That(RecordingText.IsSession(path), Is.EqualTo(expected));
    }

    static string Field(int line, string field, string message) => $".jsonl:{line}: field '{field}' {message}";
}
