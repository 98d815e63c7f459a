using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class CalibrationOutputTests : CalibrationFolder
{
    static readonly LatencyProfile Profile = new(40, 1, "HoloLens 2", 60, DateTime.UnixEpoch, CalibrationMethod.Nudge, 4);
    static readonly CalibrationPageData Page = new("title", "result", []);

    // A folder in the place of a file cannot be written, also not by the administrator.
    [TestCase("calibration.html")]
    [TestCase("profile.json")]
    [TestCase("pairs.csv")]
    public void At_FileOfAnEarlierRunIsNotWritable_Throws(string name)
    {
        Directory.CreateDirectory(Path.Combine(Out, name));

        Assert.That(() => CalibrationOutput.At(Out, hasPairs: true), Throws.TypeOf<InputException>().With.Message.StartsWith("--out: "));
    }

    [Test]
    public void At_TableIsNotAnOutput_IsNotChecked()
    {
        Directory.CreateDirectory(Path.Combine(Out, "pairs.csv"));

        Assert.That(() => CalibrationOutput.At(Out), Throws.Nothing);
    }

    [Test]
    public void At_FilesOfAnEarlierRun_KeepsThem()
    {
        CalibrationOutput.At(Out).Write(Profile, Page);
        var before = File.ReadAllText(ProfilePath);

        CalibrationOutput.At(Out);

        Assert.That(File.ReadAllText(ProfilePath), Is.EqualTo(before));
        Assert.That(Directory.GetFiles(Out), Has.Length.EqualTo(2));
    }

    [Test]
    public void WritePairs_Table_IsReadWithItsOrigin()
    {
        var output = CalibrationOutput.At(Out, hasPairs: true);
        var conditions = new DisplayConditions("A, \"B\"", 59.94, "Vulkan", rewritesBeforeRender: true);
        var origin = new PairOrigin(RenderTimeSourceKind.GpuCompletion, conditions);

        output.WritePairs([new MeasuredPicture("1.png", 5, 4.5, 40), new MeasuredPicture("2.png", 5, null, 41)], origin);

        var (pairs, read) = PairTable.Read(output.PairsPath);
        Assert.That(pairs, Is.EqualTo(new[] { new MeasuredPicture("1.png", 5, 4.5, 40) }));
        Assert.That(read, Is.EqualTo(origin));
    }

    [Test]
    public void Write_Interrupted_WritesTheProfileBesideTheExistingOne()
    {
        var output = CalibrationOutput.At(Out);
        Assert.That(output.Write(Profile, Page, isInterrupted: true), Is.EqualTo(ProfilePath));
        var before = File.ReadAllText(ProfilePath);

        Assert.That(output.Write(Profile, Page, isInterrupted: true), Is.EqualTo(output.InterruptedProfilePath));
        Assert.That(File.ReadAllText(ProfilePath), Is.EqualTo(before));
        Assert.That(LatencyProfileFile.Load(output.InterruptedProfilePath).Device, Is.EqualTo("HoloLens 2"));
    }

    // The temporary file of the profile leads to a full disk. A failure of the disk is not invalid input.
    [Test]
    [Platform("Linux")]
    public void Write_FullDisk_ThrowsAFailure()
    {
        var output = CalibrationOutput.At(Out);
        File.CreateSymbolicLink(ProfilePath + ".new", "/dev/full");

        Assert.That(() => output.Write(Profile, Page), Throws.TypeOf<IOException>().With.Message.Contains(ProfilePath));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void At_LinkWithoutATarget_WritesTheTarget()
    {
        CalibrationOutput.At(Out);
        File.CreateSymbolicLink(Path.Combine(Out, "calibration.html"), "../page.html");

        CalibrationOutput.At(Out).Write(Profile, Page);

        Assert.That(File.ReadAllText(Path.Combine(Folder, "page.html")), Does.Contain("title"));
    }

    [Test]
    public void WritePairs_Interrupted_WritesTheTableBesideTheExistingOne()
    {
        var output = CalibrationOutput.At(Out, hasPairs: true);
        var origin = new PairOrigin(RenderTimeSourceKind.GpuCompletion, new DisplayConditions("HoloLens 2"));
        MeasuredPicture[] complete = [new("1.png", 5, 4.5, 40), new("2.png", 5, 4.6, 40)];
        output.WritePairs(complete, origin, isInterrupted: true);

        output.WritePairs(complete[..1], origin, isInterrupted: true);

        Assert.That(PairTable.Read(output.PairsPath).Pairs, Is.EqualTo(complete));
        Assert.That(PairTable.Read(output.InterruptedPairsPath).Pairs, Is.EqualTo(complete[..1]));
    }

    // A sweep's log lacks the values that the headset does not know at first.
    [Test]
    public void Read_ValueMissingInSomeRows_TakesItFromTheOthers()
    {
        using var file = new TemporaryFile("render_ms,visu_ms,source,display_hz\n5,40,,\n5,40,gpu_completion,59.94\n5,40,gpu_completion,\n", ".csv");

        var (pairs, origin) = PairTable.Read(file.Path);

        Assert.That((pairs.Count, origin.Source, origin.Conditions.DisplayHz), Is.EqualTo((3, RenderTimeSourceKind.GpuCompletion, 59.94)));
    }

    [Test]
    public void Write_PageIsNotWritable_ThrowsAndKeepsTheProfile()
    {
        var output = CalibrationOutput.At(Out);
        Directory.CreateDirectory(output.PagePath);

        Assert.That(() => output.Write(Profile, Page), Throws.TypeOf<InputException>().With.Message.StartsWith("--out: " + output.PagePath));
        Assert.That(LatencyProfileFile.Load(ProfilePath).Visualisation.Length.TotalMilliseconds, Is.EqualTo(40));
    }
}
