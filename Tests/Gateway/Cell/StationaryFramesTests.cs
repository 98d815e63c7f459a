using Nowpose.Frames;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests the publication of a file with stationary objects.</summary>
public class StationaryFramesTests
{
    string _folder, _path;

    [SetUp]
    public void SetUp()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-stationary-").FullName;
        _path = Path.Combine(_folder, "stationary-objects.json");
    }

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    void Save(params FrameTransform[] frames) => StationaryFrameFile.Save(_path, new TransformsMessage(frames));

    async Task<(int Status, string Output, string Errors)> CheckAsync() => await CapturedConsole.OfAsync(
        () => Nowpose.Gateway.CommandLine.RunAsync(["serve", "--check", "--stationary", _path, "--ws-port", "0", "--sync-port", "0"]).Bounded());

    [Test]
    public async Task Publish_FramesFromTheFile_ReachEachClientOnSubscribe()
    {
        Save(Frame("belt", x: 0.5), Frame("fixture", "belt", 0.25));
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();

        StationaryFrames.Publish(_path, StationaryFrames.Load(_path), source);

        foreach (var _ in new[] { 1, 2 })
        {
            using var headset = await RawRosbridgeClient.ConnectAsync(gateway);
            await headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.TfStatic, RosTopics.TransformsType));
            Assert.That((await headset.ReceiveAsync()).Transforms.Text(), Is.EqualTo("belt=0.5 fixture=0.25"));
        }
    }

    [Test]
    public async Task Check_ValidFile_ListsItsFrames()
    {
        Save(Frame("belt"), Frame("fixture", "belt"));

        var (status, output, errors) = await CheckAsync();

        Assert.That(status, Is.EqualTo(0), errors);
        Assert.That(output, Does.Contain($"stationary {_path} (2 frames)"));
    }

    [Test]
    public async Task Check_CycleInTheFile_IsReportedInOneLine()
    {
        Save(Frame("belt", "fixture"), Frame("fixture", "belt"));

        var (status, _, errors) = await CheckAsync();

        Assert.That(status, Is.EqualTo(2));
        Assert.That(
            CapturedConsole.Lines(errors),
            Is.EqualTo(new[]
            {
                $"nowpose-gateway: {_path}: {CellMessageFaults.Of(CellMessageFaults.Frame("fixture", "belt"), DropReason.FrameCycle)}",
            }));
    }

    [Test]
    public async Task Check_WrongFieldInTheFile_IsReportedWithFrameFieldAndValue()
    {
        Save(Frame("belt"), Frame("fixture", x: 0.25));
        File.WriteAllText(_path, File.ReadAllText(_path).Replace("\"x\": 0.25", "\"x\": \"q\""));

        var (status, _, errors) = await CheckAsync();

        Assert.That(status, Is.EqualTo(2));
        Assert.That(CapturedConsole.Lines(errors).Single(), Does.EndWith(
            ": " + FrameMessages.OfFrame("fixture", FrameMessages.WrongField("transform.translation.x", "\"q\"", FrameMessages.FiniteNumber))));
    }

    [Test]
    public async Task Serve_FileInvalidOrMissing_EndsAndReportsTheLine([Values] bool isMissing)
    {
        if (!isMissing) File.WriteAllText(_path, "{\n\"transforms\": [3]}");

        var (status, _, errors) = await CapturedConsole.OfAsync(
            () => Nowpose.Gateway.CommandLine.RunAsync(["serve", "--stationary", _path, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.EqualTo(2));
        Assert.That(CapturedConsole.Lines(errors).Single(), Does.Match(MessagePattern.Of(isMissing
            ? FileMessages.NotRead(_path, MessagePattern.Any)
            : FrameMessages.FileLine(_path, 2, FrameMessages.NotTransforms(DropReason.WrongType)))));
    }

    [Test]
    public async Task Publish_ClientSendsAFrameFromTheFile_IsRefused()
    {
        Save(Frame("belt"));
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        StationaryFrames.Publish(_path, StationaryFrames.Load(_path), source);
        using var other = await RawRosbridgeClient.ConnectAsync(gateway);

        await other.SendAsync(TfStatic(Frame("belt", x: 3)));

        Assert.That((await other.ReceiveTextAsync()), Does.Contain("frame belt"));
    }
}
