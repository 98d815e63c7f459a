using Nowpose.Cli.SessionFiles;
using Nowpose.Headless.Tests.Cli;
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
        Assert.That(torn.Message, Does.Contain(".jsonl:2: is not a JSON object"));
    }

    [TestCase("", "is empty")]
    [TestCase("t,a\n0,1\n", ":1: is not a JSON object")]
    [TestCase("[]", ":1: is not a JSON object")]
    [TestCase("{\"kind\":\"session\"}", ":1: field 'format' is not 'nowpose-session'")]
    [TestCase("{\"kind\":\"session\",\"format\":\"nowpose-session\",\"version\":2}", ":1: field 'version': the file has version 2")]
    [TestCase("{\"kind\":\"session\",\"format\":\"nowpose-session\",\"version\":1}", ":1: field 'robot' is missing")]
    public void File_NotASession_ThrowsWithAOneLineMessage(string text, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(text));

        Assert.That(fault.Message, Does.Contain(expected).And.Not.Contain("\n"));
    }

    [TestCase("\"linear\"", "\"quartic\"", "field 'settings' predictor 'quartic' is unknown")]
    [TestCase("300", "-1", "field 'settings' horizon cap: -1 ms is out of range")]
    [TestCase("300", "\"x\"", "field 'horizon_cap_ms'")]
    [TestCase("\"upper\":2", "\"upper\":2,\"lower\":3", "field 'lower' is 3; it must not exceed the upper limit 2")]
    [TestCase("\"upper\":2", "\"velocity\":0", "field 'velocity' is 0; a limit must be more than 0")]
    [TestCase("\"b\"", "\"a\"", "field 'joints' has joint 'a' twice")]
    public void Header_Invalid_NamesTheField(string right, string wrong, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(Header.Replace(right, wrong)));

        Assert.That(fault.Message, Does.Contain(".jsonl:1: " + expected));
    }

    [TestCase("{\"stamp_ns\":1}", "field 'kind' is missing")]
    [TestCase("{\"kind\":\"sample\",\"arrival_ns\":1,\"names\":[\"a\"],\"position\":[1]}", "field 'stamp_ns' is missing")]
    [TestCase("{\"kind\":\"sample\",\"arrival_ns\":1.5,\"stamp_ns\":1,\"names\":[\"a\"],\"position\":[1]}", "field 'arrival_ns' is 1.5; it must be a whole number")]
    [TestCase("{\"kind\":\"sample\",\"arrival_ns\":1,\"stamp_ns\":1,\"names\":[\"a\"],\"position\":[null]}", "field 'position' has null as element 1; it must be a finite number")]
    [TestCase("{\"kind\":\"sample\",\"arrival_ns\":1,\"stamp_ns\":1,\"names\":[\"a\"],\"position\":[1,2]}", "field 'position' has 2 numbers; it must have 1")]
    [TestCase("{\"kind\":\"sample\",\"arrival_ns\":1,\"stamp_ns\":1,\"names\":\"a\",\"position\":[1]}", "field 'names' must be an array")]
    [TestCase("{\"kind\":\"frame\",\"start_ns\":1,\"joints\":7}", "field 'joints' must be an array")]
    [TestCase("{\"kind\":\"sync\",\"t1_ns\":1,\"t2_ns\":99999999999999999999,\"t3_ns\":1,\"t4_ns\":1}", "field 't2_ns' is 99999999999999999999; it must be a whole number (64 bits)")]
    [TestCase("{\"kind\":\"sync\",\"t1_ns\":1,\"t2_ns\":1,\"t3_ns\":1,\"t4_ns\":1,\"server_bound_ns\":-1}", "field 'server_bound_ns' is -1 ns; it must be from 0 to 4294967295000 ns")]
    [TestCase("{\"kind\":\"sync\",\"t1_ns\":1,\"t2_ns\":1,\"t3_ns\":1,\"t4_ns\":1,\"resolution_ns\":5000000000}", "field 'resolution_ns' is 5000000000 ns; it must be from 0 to 4294967295 ns")]
    [TestCase("{\"kind\":\"\\ud800\"}", "field 'kind' must be a string of valid Unicode")]
    [TestCase("{\"kind\":\"sample\",\"arrival_ns\":1,\"stamp_ns\":1,\"names\":[\"a\",\"\\ud800\"],\"position\":[1,2]}", "field 'names' has \"\\ud800\" as element 2")]
    public void Line_Invalid_NamesTheField(string line, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(Header + "\n" + Sample + "\n" + line + "\n" + Sample + "\n"));

        Assert.That(fault.Message, Does.Contain(".jsonl:3: " + expected));
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

    [TestCase("500000000", "0", "field 'time_from_start_ns' of point 2 is negative, or not later than that of the previous point")]
    [TestCase("[0.5,0.75]", "[0.5]", "field 'position' has 1 numbers; it must have 2")]
    [TestCase("\"points\":[", "\"points\":[7,", "field 'points' is 7; it must be an object")]
    [TestCase("\"points\"", "\"dots\"", "field 'points' is missing")]
    public void Plan_Invalid_NamesTheField(string right, string wrong, string expected)
    {
        var fault = Assert.Throws<InputException>(() => Read(Header + "\n" + Plan.Replace(right, wrong) + "\n" + Sample + "\n"));

        Assert.That(fault.Message, Does.Contain(".jsonl:2: " + expected));
    }

    [TestCase("a.jsonl", true)]
    [TestCase("a.JSONL.gz", true)]
    [TestCase("a.csv", false)]
    [TestCase("a.json", false)]
    [TestCase(null, false)]
    public void IsSession_Path_DependsOnTheName(string path, bool expected)
    {
        Assert.That(SessionFileReader.IsSession(path), Is.EqualTo(expected));
    }
}
