using System.Text;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Protocol;

/// <summary>Tests the allocations of reading a cell's messages if their sources repeat the same names.</summary>
[NonParallelizable] // measures allocations
public class CellReaderAllocationTests
{
    const int Rounds = 200;

    static readonly string LongParent = new string('r', 32) + "/" + new string('ü', 128);

    static readonly ControlTime Stamp = ControlTime.FromSeconds(5000);

    static string Frames(string topic) => RosbridgeWriter.Publish(
        topic, new TransformsMessage([.. Enumerable.Range(0, 100).Select(i => new FrameTransform(Stamp, i == 0 ? LongParent : "belt", "box" + i, i, 0.1, -2e-3, 0, 0, 0.6, 0.8))]),
        RosTimeForm.Sec);

    static string Signals(int first) => RosbridgeWriter.Publish(
        RosTopics.Signals, new SignalsMessage(Stamp, [.. Enumerable.Range(first, 20).Select(i => new SignalValue("signal" + i, i))]), RosTimeForm.Secs);

    static string State(int robot) => RosbridgeWriter.Publish(
        $"/arm{robot}/joint_states", new JointStateMessage(Stamp, ["a", "arm" + robot], [0.5, 1]), RosTimeForm.Sec).Insert(1, $"\"id\":{robot},");

    [Test]
    public void TryRead_RepeatedNames_AllocatesNothing()
    {
        byte[][] texts =
        [
            .. new[] { Frames(RosTopics.Tf), Frames(RosTopics.TfStatic) }.Concat(Enumerable.Range(0, 20).Select(Signals))
                .Concat(Enumerable.Range(0, 16).Select(State)).Select(Encoding.UTF8.GetBytes),
        ];
        var reader = new RosbridgeReader();
        for (var i = 0; i < 3; i++) ReadAll(reader, texts);

        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < Rounds; i++) ReadAll(reader, texts);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(Rounds), "reading allocates less than a byte per round");
    }

    static void ReadAll(RosbridgeReader reader, byte[][] texts)
    {
        foreach (var text in texts)
        {
            if (!reader.TryRead(text, out var message, out var reason)) throw new InvalidOperationException(reason.ToString());
            message.JointState?.Release();
            message.Transforms?.Release();
            message.Signals?.Release();
        }
    }
}
