using System.IO.Compression;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class SweepTableTests : CalibrationFolder
{
    static string Log(params string[] deviceAndRate) => SweepLog.Header + "\n"
        + string.Concat(deviceAndRate.Select((each, i) => $"{1_000_000_000 + i * 16_666_667},0,5.5,display_gpu_time,{each}\n"));

    [Test]
    public void Read_CompressedLog_ReturnsTheSameRows()
    {
        var path = Path.Combine(Folder, "sweep.csv.gz");
        using (var text = new StreamWriter(new GZipStream(File.Create(path), CompressionLevel.Fastest)))
            text.Write(Log("HoloLens 2,60", "HoloLens 2,60"));

        Assert.That(SweepTable.Read(path, out _).Select(row => row.RenderMs), Is.EqualTo(new[] { 5.5, 5.5 }));
    }

    [Test]
    public void Read_UncompressedFileNamedGz_ThrowsWithTheRemedy()
    {
        var path = Path.Combine(Folder, "sweep.csv.gz");
        File.WriteAllText(path, Log("HoloLens 2,60"));

        Assert.That(() => SweepTable.Read(path, out _), Throws.TypeOf<InputException>().With.Message.EqualTo(MotionFileMessages.NotGzip(path)));
    }

    [Test]
    public void DisplayHz_ReportedAfterSomeFrames_ReturnsTheRate()
    {
        var rows = SweepTable.Read(Write("sweep.csv", [Log("HoloLens 2,", "HoloLens 2,", "HoloLens 2,60")]), out _);

        Assert.That((SweepTable.Device(rows), SweepTable.DisplayHz(rows)), Is.EqualTo(("HoloLens 2", 60)));
        Assert.That(SweepTable.DisplayHz([rows[0]]), Is.Zero, "no row gives the rate");
    }

    static readonly string[][] Mixed =
    [
        ["HoloLens 2,60", "Quest 3,60", ":3: " + SweepFileMessages.TwoHeadsets("HoloLens 2", "Quest 3")],
        ["HoloLens 2,60", "HoloLens 2,72", ":3: " + SweepFileMessages.TwoRates(60, 72)],
    ];

    [TestCaseSource(nameof(Mixed))]
    public void Read_LogFromTwoHeadsetsOrDisplayRates_Throws(string first, string second, string named)
    {
        var path = Write("sweep.csv", [Log(first, second)]);

        Assert.That(() => SweepTable.Read(path, out _), Throws.TypeOf<InputException>().With.Message.EqualTo(path + named));
    }
}
