using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class SweepLogReaderTests
{
    const string Header = "control_ns,vertices,render_ms,source,device,display_hz\n";

    static SweepRow[] Read(string text, out DisplayConditions conditions) =>
        SweepLogReader.Read(new StringReader(text), "sweep.csv", out conditions).ToArray();

    static SweepRow[] Read(string text) => Read(text, out _);

    static SweepRow Row(
        double? renderMs = 7.25, RenderTimeSourceKind source = RenderTimeSourceKind.DisplayGpuTime, string device = "HoloLens 2") =>
        new(ControlTime.FromNanoseconds(1_700_000_000_123_456_700), 300_000, renderMs, source, device, 60);

    static string Text(DisplayConditions conditions, params SweepRow[] rows)
    {
        var text = new StringWriter();
        SweepLog.WriteHeader(text, conditions);
        foreach (var row in rows) SweepLog.Write(text, row);
        return text.ToString();
    }

    [TestCase(RenderTimeSourceKind.None, null, "HoloLens 2")]
    [TestCase(RenderTimeSourceKind.GpuCompletion, null, "HoloLens 2")]
    [TestCase(RenderTimeSourceKind.CameraCpu, 0.6251, "")]
    [TestCase(RenderTimeSourceKind.EngineGpuTime, 16.6667, "PC \"lab\", left")]
    public void Read_WrittenRow_ReturnsTheSameValues(RenderTimeSourceKind source, double? renderMs, string device)
    {
        var row = Row(renderMs, source, device);

        var read = Read(Text(DisplayConditions.Unknown, row, row), out var conditions);

        Assert.That(read, Has.Length.EqualTo(2));
        Assert.That(read[1].FrameStart, Is.EqualTo(row.FrameStart));
        Assert.That(read[1].Vertices, Is.EqualTo(300_000));
        Assert.That(read[1].RenderMs, Is.EqualTo(renderMs));
        Assert.That(read[1].Source, Is.EqualTo(source));
        Assert.That(read[1].Device, Is.EqualTo(device));
        Assert.That(read[1].DisplayHz, Is.EqualTo(60));
        Assert.That(conditions, Is.EqualTo(DisplayConditions.Unknown), "a log of an older version has no conditions");
    }

    [Test]
    public void Read_HeaderWithConditions_ReturnsTheConditions()
    {
        var written = new DisplayConditions(
            "HoloLens 2", 60, "Direct3D11", "MultiThreaded", "built-in", false, "PrioritizeRendering", ReprojectionMode.Depth);

        Assert.That(Read(Text(written, Row()), out var conditions), Has.Length.EqualTo(1));

        Assert.That(conditions, Is.EqualTo(new DisplayConditions().Or(new DisplayConditions(
            null, null, "Direct3D11", "MultiThreaded", "built-in", false, "PrioritizeRendering", ReprojectionMode.Depth))));
    }

    [Test]
    public void Read_UnknownConditions_IgnoresThem()
    {
        var read = Read("# future: 5\n# a remark\n" + Text(DisplayConditions.Unknown, Row()));

        Assert.That(read, Has.Length.EqualTo(1));
    }

    [Test]
    public void Read_UnknownReprojection_Throws() => Assert.That(
        () => Read("# graphics_api: Vulkan\n# reprojection: sideways\n" + Header),
        Throws.TypeOf<InputException>().With.Message.StartsWith("sweep.csv:2: reprojection: 'sideways'"));

    [Test]
    public void Read_OtherLineBeforeTheHeader_Throws() => Assert.That(
        () => Read("# graphics_api: Vulkan\nother\n" + Header),
        Throws.TypeOf<InputException>().With.Message.EqualTo("sweep.csv:2: " + TableMessages.Header("other", SweepLog.Header)));

    [Test]
    public void Read_OtherLineEndsAndUnknownDisplayRate_Succeeds()
    {
        var read = Read(Header.Replace("\n", "\r\n") + "5,0,,,,\r\n\r\n");

        Assert.That(read.Single().DisplayHz, Is.NaN);
    }

    static readonly string[][] OtherTables =
    [
        ["", "sweep.csv:1: " + TableMessages.Header("", SweepLog.Header)],
        ["time,load\n1,2\n", "sweep.csv:1: " + TableMessages.Header("time,load", SweepLog.Header)],
        [Header, TableMessages.NoRows("sweep.csv", 1)],
        [Header + "5,0,4,display_gpu_time,x\n", "sweep.csv:2: " + TableMessages.FieldCount(5, 6)],
        [Header + "5,0,,,x,60\n\n\"6,0,,,x,60\n7,0,,,x,60\n8,0,,,x,60\n", "sweep.csv:4: " + TableMessages.FieldCount(1, 6)],
    ];

    [TestCaseSource(nameof(OtherTables))]
    [TestCase(Header + "5.5,0,4,display_gpu_time,x,60\n", "sweep.csv:2: control_ns: '5.5'")]
    [TestCase(Header + "5,0,,,x,60\n5,-4294967291,4,display_gpu_time,x,60\n", "sweep.csv:3: vertices: -4294967291")]
    [TestCase(Header + "5,0,,,x,60\n5,2000001,4,display_gpu_time,x,60\n", "sweep.csv:3: vertices: 2000001")]
    [TestCase("# future: 5\n" + Header + "5,0,,,x,60\n5,0,0,display_gpu_time,x,60\n", "sweep.csv:4: render_ms: 0 ms")]
    [TestCase(Header + "5,0,0,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: 0 ms")]
    [TestCase(Header + "5,0,NaN,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: NaN ms")]
    [TestCase(Header + "5,0,-1,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: -1 ms")]
    [TestCase(Header + "5,0,1001,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: 1001 ms")]
    [TestCase(Header + "5,0,4 ms,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: '4 ms'")]
    [TestCase(Header + "5,0,4,gpu,x,60\n", "sweep.csv:2: source: 'gpu'")]
    [TestCase(Header + "5,0,4,,x,60\n", "sweep.csv:2: render_ms: ")]
    [TestCase(Header + "5,0,4,camera_cpu,x,0\n", "sweep.csv:2: display rate: 0 Hz")]
    public void Read_InvalidText_ThrowsWithFileLineAndField(string text, string message)
    {
        var fault = Assert.Throws<InputException>(() => Read(text));

        Assert.That(fault.Message, Does.StartWith(message));
        Assert.That(fault.Message, Does.Not.Contain("\n"));
    }
}
